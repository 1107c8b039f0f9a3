// One solution on a canvas of its own, which can be moved and zoomed by mouse, touch and keys.
import { kUnit } from "../data/graph";
import { el } from "../page/dom";
import type { Theme } from "../page/theme";
import { type Box, Camera, type Point, boundsOf } from "./camera";
import type { Pen } from "./pen";
import { Scene } from "./scene";
import type { Track } from "./track";
import type { Marks, View } from "./view";

const kClick = 4; // pixels that a pointer may move while it clicks

export interface PanelEvents {
    onCamera: (panel: Panel) => void; // the user has moved or zoomed
    onPick: (robot: number) => void; // the user has clicked on a robot (−1: on none)
}

export class Panel {
    readonly canvas = el("canvas", { tabindex: 0, role: "img" });
    readonly camera = new Camera();
    private scene: Scene | null = null;
    private currentTrack: Track | null = null;
    private readonly context = this.canvas.getContext("2d", { alpha: false })!;
    private pixels = 1; // a CSS pixel
    private isFitted = true; // until the user moves the picture
    private box: Box = { left: 0, top: 0, right: 0, bottom: 0 };
    private time = 0;
    private readonly pointers = new Map<number, Point>();
    private moved = 0; // pixels since the pointer went down

    constructor(
        private readonly robotColors: string[],
        private readonly events: PanelEvents,
    ) {
        this.canvas.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
        this.canvas.addEventListener("pointerdown", (event) => this.onDown(event));
        this.canvas.addEventListener("pointermove", (event) => this.onMove(event));
        for (const end of ["pointerup", "pointercancel"] as const)
            this.canvas.addEventListener(end, (event) => this.onUp(event));
        this.canvas.addEventListener("dblclick", () => this.fit());
    }

    get track(): Track | null {
        return this.currentTrack;
    }

    show(track: Track): void {
        const isSameGraph = this.currentTrack?.instance.graph === track.instance.graph;
        this.currentTrack = track;
        this.scene = new Scene(track.instance, track.timeline, this.robotColors);
        if (!isSameGraph) {
            this.box = boundsOf(track.instance.graph.x, track.instance.graph.y);
            this.isFitted = true;
        }
        this.resize();
    }

    /** Follows the size that the page gives to the canvas. */
    resize(): void {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (width === 0 || height === 0) return;
        this.pixels = Math.min(devicePixelRatio || 1, 2);
        this.canvas.width = Math.round(width * this.pixels);
        this.canvas.height = Math.round(height * this.pixels);
        this.context.setTransform(this.pixels, 0, 0, this.pixels, 0, 0);
        if (this.isFitted) this.camera.fit(this.box, width, height, kUnit);
    }

    fit(): void {
        this.isFitted = true;
        this.resize();
        this.events.onCamera(this);
    }

    zoom(factor: number, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2): void {
        this.isFitted = false;
        this.camera.zoom(factor, x, y);
        this.events.onCamera(this);
    }

    pan(dx: number, dy: number): void {
        this.isFitted = false;
        this.camera.pan(dx, dy);
        this.events.onCamera(this);
    }

    /** Takes over what another panel shows. */
    lookLike(other: Panel): void {
        this.isFitted = other.isFitted;
        if (this.isFitted) this.resize();
        else this.camera.copy(other.camera);
    }

    draw(time: number, theme: Theme, marks: Marks): void {
        if (!this.scene || !this.currentTrack || this.canvas.width === 0) return;
        this.time = Math.min(time, this.currentTrack.length);
        if (marks.followed >= 0) this.keepInView(marks.followed);
        this.scene.drawOn(this.context, this.pixels, this.view(theme, marks), this.time);
    }

    /** The same picture by another pen. */
    drawWith(pen: Pen, theme: Theme, marks: Marks): void {
        this.scene?.draw(pen, this.view(theme, marks), this.time);
    }

    private view(theme: Theme, marks: Marks): View {
        const { width, height } = this.canvas;
        return {
            ...marks,
            camera: this.camera,
            theme,
            width: width / this.pixels,
            height: height / this.pixels,
        };
    }

    /** Marks the vertices that are seen; null where all are. */
    seenVertices(): Uint8Array | null {
        if (!this.currentTrack) return null;
        const { x, y, vertexCount } = this.currentTrack.instance.graph;
        const seen = this.camera.seen(this.canvas.clientWidth, this.canvas.clientHeight);
        const marks = new Uint8Array(vertexCount);
        let count = 0;
        for (let v = 0; v < vertexCount; ++v)
            count += marks[v] =
                x[v] >= seen.left && x[v] <= seen.right && y[v] >= seen.top && y[v] <= seen.bottom ? 1 : 0;
        return count === vertexCount ? null : marks;
    }

    private keepInView(robot: number): void {
        if (!this.scene || robot >= this.scene.instance.starts.length) return;
        if (this.isFitted) return; // everything is seen
        const { clientWidth: width, clientHeight: height } = this.canvas;
        const place = this.scene.place(robot, this.time);
        const { x, y } = this.camera.screen(place);
        const kMargin = 0.15;
        const isInside = (at: number, size: number): boolean =>
            at > kMargin * size && at < (1 - kMargin) * size;
        if (!isInside(x, width) || !isInside(y, height)) this.camera.center(place.x, place.y, width, height);
    }

    private onWheel(event: WheelEvent): void {
        event.preventDefault();
        this.zoom(
            Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)),
            event.offsetX,
            event.offsetY,
        );
    }

    private onDown(event: PointerEvent): void {
        this.canvas.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
        if (this.pointers.size === 1) this.moved = 0;
    }

    /** One pointer moves the picture, two zoom it as well. */
    private onMove(event: PointerEvent): void {
        const before = this.pointers.get(event.pointerId);
        if (!before) return;
        const now = { x: event.offsetX, y: event.offsetY };
        this.pointers.set(event.pointerId, now);
        this.moved += Math.abs(now.x - before.x) + Math.abs(now.y - before.y);
        const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
        if (!other) {
            if (this.moved >= kClick) this.pan(now.x - before.x, now.y - before.y);
            return;
        }
        const distance = (a: Point): number => Math.hypot(a.x - other.x, a.y - other.y);
        this.zoom(
            distance(now) / Math.max(distance(before), 1),
            (now.x + other.x) / 2,
            (now.y + other.y) / 2,
        );
        this.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    }

    private onUp(event: PointerEvent): void {
        this.pointers.delete(event.pointerId);
        if (event.type === "pointerup" && this.pointers.size === 0 && this.moved < kClick && this.scene)
            this.events.onPick(
                this.scene.robotAt({ x: event.offsetX, y: event.offsetY }, this.camera, this.time),
            );
    }
}
