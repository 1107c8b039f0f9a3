// One solution at one time: what stands still beneath, goals, trails and robots above it.
import type { Case } from "../data/campaign";
import { kUnit } from "../data/graph";
import { textColorOn } from "../page/theme";
import { Base } from "./base";
import type { Camera, Point } from "./camera";
import { CanvasPen, type Pen } from "./pen";
import type { Timeline } from "./timeline";
import type { View } from "./view";

const kRobotRadius = 0.36 * kUnit;
const kSmallestRadius = 1.7; // pixels
const kTrailMoves = 12;
const kOnHeat = "#ffffff"; // around robots: their colours alone would not be seen on heat

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
    place(robot: number, time: number): Point {
        const { x, y } = this.instance.graph;
        const { from, to, share } = this.timeline.at(robot, time);
        return { x: x[from] + (x[to] - x[from]) * share, y: y[from] + (y[to] - y[from]) * share };
    }

    /** On a canvas of that many pixels a CSS pixel, whose context is scaled already. */
    drawOn(context: CanvasRenderingContext2D, pixels: number, view: View, time: number): void {
        const { camera, theme, width, height } = view;
        const { scale, offsetX, offsetY } = camera;
        const { blocks, heat, heatMost } = view;
        const key = [theme, blocks, heat, heatMost, scale, offsetX, offsetY, width, height, pixels];
        if (!this.still || key.some((part, i) => part !== this.stillKey[i])) {
            this.still ??= document.createElement("canvas");
            this.still.width = context.canvas.width;
            this.still.height = context.canvas.height;
            const below = this.still.getContext("2d", { alpha: false })!;
            below.scale(pixels, pixels);
            this.base.draw(new CanvasPen(below), view);
            this.stillKey = key;
        }
        context.drawImage(this.still, 0, 0, width, height);
        this.drawMoving(new CanvasPen(context), view, time);
    }

    draw(pen: Pen, view: View, time: number): void {
        this.base.draw(pen, view);
        this.drawMoving(pen, view, time);
    }

    /** The robot whose drawing is at that place of the screen, or −1. */
    robotAt(screen: Point, camera: Camera, time: number): number {
        const reach = Math.max(kRobotRadius * camera.scale, 6);
        let nearest = -1;
        let least = reach * reach;
        for (let robot = 0; robot < this.timeline.robotCount; ++robot) {
            const { x, y } = camera.screen(this.place(robot, time));
            const distance = (x - screen.x) ** 2 + (y - screen.y) ** 2;
            if (distance <= least) {
                least = distance;
                nearest = robot;
            }
        }
        return nearest;
    }

    private drawMoving(pen: Pen, view: View, time: number): void {
        const { camera } = view;
        const radius = Math.max(kRobotRadius * camera.scale, kSmallestRadius);
        if (view.goals) this.drawGoals(pen, view, radius);
        const count = this.timeline.robotCount;
        if (view.trails)
            for (let robot = 0; robot < count; ++robot)
                this.drawPath(pen, camera, this.timeline.trail(robot, time, kTrailMoves), robot, time, {
                    width: radius * 0.7,
                    opacity: 0.45,
                });
        if (view.followed >= 0 && view.followed < count) this.drawFollowed(pen, view, radius, time);
        this.drawRobots(pen, view, radius, time);
        for (const robot of view.marked) {
            const { x, y } = camera.screen(this.place(robot, time));
            pen.circle(x, y, Math.max(radius * 1.5, 9), { stroke: view.markColor, width: 3 });
        }
    }

    private drawGoals(pen: Pen, view: View, radius: number): void {
        const width = Math.max(radius * 0.25, 1);
        for (let robot = 0; robot < this.timeline.robotCount; ++robot) {
            const at = this.goal(robot, view.camera);
            if (isSeen(at, view, radius))
                pen.square(at.x, at.y, radius * 0.9, { stroke: this.robotColors[robot], width });
        }
    }

    private drawRobots(pen: Pen, view: View, radius: number, time: number): void {
        const { theme, camera } = view;
        const kNumbersFrom = 7.5; // pixels of radius
        const kOutlineFrom = 3;
        const stroke = view.heat ? kOnHeat : radius >= kOutlineFrom ? theme.outline : undefined;
        for (let robot = 0; robot < this.timeline.robotCount; ++robot) {
            const at = camera.screen(this.place(robot, time));
            if (!isSeen(at, view, radius)) continue;
            const fill = this.robotColors[robot];
            const { from, to } = this.timeline.at(robot, time);
            const isThere = from === to && from === this.instance.goals[robot];
            if (isThere) pen.square(at.x, at.y, radius * 0.9, { fill, stroke });
            else pen.circle(at.x, at.y, radius, { fill, stroke });
            if (radius >= kNumbersFrom)
                pen.text(at.x, at.y, String(robot), textColorOn(fill), radius * (robot > 99 ? 0.85 : 1.05));
        }
    }

    /** The way so far of one robot and a line to its goal. */
    private drawFollowed(pen: Pen, { camera, theme, followed }: View, radius: number, time: number): void {
        const at = camera.screen(this.place(followed, time));
        const to = this.goal(followed, camera);
        const way = this.timeline.trail(followed, time, Infinity);
        this.drawPath(pen, camera, way, followed, time, { width: Math.max(radius * 0.45, 2), opacity: 0.85 });
        pen.polyline([at.x, at.y, to.x, to.y], theme.text, 1, 0.6);
        pen.circle(to.x, to.y, Math.max(radius * 1.3, 7), { stroke: theme.text, width: 1.5 });
        pen.circle(at.x, at.y, Math.max(radius * 1.5, 9), { stroke: theme.text, width: 2.5 });
    }

    /** Through vertices, from where the robot is now. */
    private drawPath(
        pen: Pen,
        camera: Camera,
        vertices: number[],
        robot: number,
        time: number,
        look: { width: number; opacity: number },
    ): void {
        const { graph } = this.instance;
        const points = [
            this.place(robot, time),
            ...vertices.map((vertex) => ({ x: graph.x[vertex], y: graph.y[vertex] })),
        ].map((point) => camera.screen(point));
        const coordinates = points.flatMap(({ x, y }) => [x, y]);
        if (points.length > 2 || points[0].x !== points[1].x || points[0].y !== points[1].y)
            pen.polyline(coordinates, this.robotColors[robot], look.width, look.opacity);
    }

    /** On the screen. */
    private goal(robot: number, camera: Camera): Point {
        const { graph, goals } = this.instance;
        return camera.screen({ x: graph.x[goals[robot]], y: graph.y[goals[robot]] });
    }
}

function isSeen({ x, y }: Point, { width, height }: View, radius: number): boolean {
    return x > -radius && y > -radius && x < width + radius && y < height + radius;
}
