// One solution at one time: what stands still beneath, goals, trails and robots above it.
import type { Case } from "../data/campaign";
import { kUnit } from "../data/graph";
import { type Theme, textColorOn } from "../page/theme";
import { Base, type BaseOptions } from "./base";
import type { Camera } from "./camera";
import { CanvasPen, type Pen } from "./pen";
import type { Timeline } from "./timeline";

export interface SceneOptions extends BaseOptions {
    goals: boolean;
    trails: boolean;
    followed: number; // robot, or −1
    marked: number[]; // robots of the event at this time
    markColor: string;
}

const kRobotRadius = 0.36 * kUnit;
const kSmallestRadius = 1.7; // pixels
const kTrailMoves = 12;

export class Scene {
    private readonly base: Base;
    private still: HTMLCanvasElement | null = null; // the base as it was drawn last
    private stillKey: unknown[] = [];

    constructor(
        readonly instance: Case,
        private readonly timeline: Timeline,
        private readonly robotColors: string[],
    ) {
        this.base = new Base(instance.graph);
    }

    /** Where a robot is at a time, in the graph's numbers. */
    place(robot: number, time: number): { x: number; y: number } {
        const { x, y } = this.instance.graph;
        const { from, to, share } = this.timeline.at(robot, time);
        return { x: x[from] + (x[to] - x[from]) * share, y: y[from] + (y[to] - y[from]) * share };
    }

    /** On a canvas of that many pixels a CSS pixel, whose context is scaled already. */
    drawOn(
        context: CanvasRenderingContext2D,
        pixels: number,
        camera: Camera,
        theme: Theme,
        options: SceneOptions,
        time: number,
    ): void {
        const width = context.canvas.width / pixels;
        const height = context.canvas.height / pixels;
        const key = [
            theme,
            options.blocks,
            options.heat,
            camera.scale,
            camera.offsetX,
            camera.offsetY,
            width,
            height,
            pixels,
        ];
        if (!this.still || key.some((part, i) => part !== this.stillKey[i])) {
            this.still ??= document.createElement("canvas");
            this.still.width = context.canvas.width;
            this.still.height = context.canvas.height;
            const below = this.still.getContext("2d", { alpha: false })!;
            below.scale(pixels, pixels);
            this.base.draw(new CanvasPen(below), camera, theme, options, width, height);
            this.stillKey = key;
        }
        context.drawImage(this.still, 0, 0, width, height);
        this.drawMoving(new CanvasPen(context), camera, theme, options, time, width, height);
    }

    draw(
        pen: Pen,
        camera: Camera,
        theme: Theme,
        options: SceneOptions,
        time: number,
        width: number,
        height: number,
    ): void {
        this.base.draw(pen, camera, theme, options, width, height);
        this.drawMoving(pen, camera, theme, options, time, width, height);
    }

    /** The robot whose drawing is at that place of the screen, or −1. */
    robotAt(screenX: number, screenY: number, camera: Camera, time: number): number {
        const reach = Math.max(kRobotRadius * camera.scale, 6);
        let nearest = -1;
        let least = reach * reach;
        for (let robot = 0; robot < this.timeline.robotCount; ++robot) {
            const { x, y } = this.place(robot, time);
            const distance = (camera.screenX(x) - screenX) ** 2 + (camera.screenY(y) - screenY) ** 2;
            if (distance <= least) {
                least = distance;
                nearest = robot;
            }
        }
        return nearest;
    }

    private drawMoving(
        pen: Pen,
        camera: Camera,
        theme: Theme,
        options: SceneOptions,
        time: number,
        width: number,
        height: number,
    ): void {
        const radius = Math.max(kRobotRadius * camera.scale, kSmallestRadius);
        const isSeen = (x: number, y: number): boolean =>
            x > -radius && y > -radius && x < width + radius && y < height + radius;
        if (options.goals) this.drawGoals(pen, camera, radius, isSeen);
        if (options.trails) this.drawTrails(pen, camera, radius, time);
        if (options.followed >= 0) this.drawFollowed(pen, camera, theme, options.followed, radius, time);
        const { graph, goals } = this.instance;
        const kNumbersFrom = 7.5; // pixels of radius
        const kOutlineFrom = 3;
        for (let robot = 0; robot < this.timeline.robotCount; ++robot) {
            const { from, to, share } = this.timeline.at(robot, time);
            const x = camera.screenX(graph.x[from] + (graph.x[to] - graph.x[from]) * share);
            const y = camera.screenY(graph.y[from] + (graph.y[to] - graph.y[from]) * share);
            if (!isSeen(x, y)) continue;
            const color = this.robotColors[robot];
            const outline = radius >= kOutlineFrom ? theme.outline : null;
            if (from === to && from === goals[robot]) pen.square(x, y, radius * 0.9, color, outline, 1);
            else pen.circle(x, y, radius, color, outline, 1);
            if (radius >= kNumbersFrom)
                pen.text(x, y, String(robot), textColorOn(color), radius * (robot > 99 ? 0.85 : 1.05));
        }
        for (const robot of options.marked) {
            const { x, y } = this.place(robot, time);
            pen.circle(
                camera.screenX(x),
                camera.screenY(y),
                Math.max(radius * 1.5, 9),
                null,
                options.markColor,
                3,
            );
        }
    }

    private drawGoals(
        pen: Pen,
        camera: Camera,
        radius: number,
        isSeen: (x: number, y: number) => boolean,
    ): void {
        const { graph, goals } = this.instance;
        const width = Math.max(radius * 0.25, 1);
        for (let robot = 0; robot < goals.length; ++robot) {
            const x = camera.screenX(graph.x[goals[robot]]);
            const y = camera.screenY(graph.y[goals[robot]]);
            if (isSeen(x, y)) pen.square(x, y, radius * 0.9, null, this.robotColors[robot], width);
        }
    }

    private drawTrails(pen: Pen, camera: Camera, radius: number, time: number): void {
        for (let robot = 0; robot < this.timeline.robotCount; ++robot)
            this.drawPath(pen, camera, robot, time, kTrailMoves, radius * 0.7, 0.45);
    }

    /** The way so far of one robot and a line to its goal. */
    private drawFollowed(
        pen: Pen,
        camera: Camera,
        theme: Theme,
        robot: number,
        radius: number,
        time: number,
    ): void {
        if (robot >= this.timeline.robotCount) return;
        const { graph, goals } = this.instance;
        const { x, y } = this.place(robot, time);
        this.drawPath(pen, camera, robot, time, Infinity, Math.max(radius * 0.45, 2), 0.85);
        const toX = camera.screenX(graph.x[goals[robot]]);
        const toY = camera.screenY(graph.y[goals[robot]]);
        pen.polyline([camera.screenX(x), camera.screenY(y), toX, toY], theme.text, 1, 0.6);
        pen.circle(toX, toY, Math.max(radius * 1.3, 7), null, theme.text, 1.5);
        pen.circle(camera.screenX(x), camera.screenY(y), Math.max(radius * 1.5, 9), null, theme.text, 2.5);
    }

    private drawPath(
        pen: Pen,
        camera: Camera,
        robot: number,
        time: number,
        moves: number,
        width: number,
        opacity: number,
    ): void {
        const { graph } = this.instance;
        const now = this.place(robot, time);
        const points = [camera.screenX(now.x), camera.screenY(now.y)];
        for (const vertex of this.timeline.trail(robot, time, moves))
            points.push(camera.screenX(graph.x[vertex]), camera.screenY(graph.y[vertex]));
        if (points.length > 4 || now.x !== graph.x[this.timeline.at(robot, time).from])
            pen.polyline(points, this.robotColors[robot], width, opacity);
    }
}
