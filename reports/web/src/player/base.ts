// What does not move: the cells of a map or the vertices and edges of a graph, its blocks and isthmuses, and
// heat.
import { type Graph, kUnit } from "../data/graph";
import { type Theme, channels, cssColor, rampColor } from "../page/theme";
import type { Pen } from "./pen";
import type { View } from "./view";

/** A vertex' size in the graph's unit, and on the screen where it would vanish. */
export const kVertexRadius = 0.3 * kUnit;

export class Base {
    private picture: HTMLCanvasElement | null = null; // of a grid: one pixel a cell
    private pictureKey: unknown[] = [];
    private readonly left: number;
    private readonly top: number;

    constructor(private readonly graph: Graph) {
        this.left = graph.x.reduce((least, x) => Math.min(least, x), Infinity);
        this.top = graph.y.reduce((least, y) => Math.min(least, y), Infinity);
    }

    draw(pen: Pen, view: View): void {
        pen.clear(view.width, view.height, this.graph.isGrid ? view.theme.background : view.theme.cell);
        if (this.graph.isGrid) this.drawCells(pen, view);
        else this.drawGraph(pen, view);
    }

    private drawCells(pen: Pen, view: View): void {
        const { camera, theme, width, height } = view;
        const picture = this.cells(view);
        const cell = kUnit * camera.scale;
        const x = camera.screenX(this.left) - cell / 2;
        const y = camera.screenY(this.top) - cell / 2;
        pen.image(picture, x, y, picture.width * cell, picture.height * cell);
        const kLinesFrom = 14; // pixels a cell
        if (cell < kLinesFrom) return;
        const lines: number[] = [];
        for (
            let at = x + Math.max(0, Math.floor(-x / cell)) * cell;
            at <= Math.min(width, x + picture.width * cell);
            at += cell
        )
            lines.push(at, Math.max(y, 0), at, Math.min(y + picture.height * cell, height));
        for (
            let at = y + Math.max(0, Math.floor(-y / cell)) * cell;
            at <= Math.min(height, y + picture.height * cell);
            at += cell
        )
            lines.push(Math.max(x, 0), at, Math.min(x + picture.width * cell, width), at);
        pen.lines(lines, theme.background, 1);
    }

    private cells(view: View): HTMLCanvasElement {
        const key = [view.theme, view.blocks, view.heat, view.heatMost];
        if (this.picture && key.every((part, i) => part === this.pictureKey[i])) return this.picture;
        const { graph } = this;
        const columns = graph.x.reduce((most, x) => Math.max(most, (x - this.left) / kUnit), 0) + 1;
        const rows = graph.y.reduce((most, y) => Math.max(most, (y - this.top) / kUnit), 0) + 1;
        const picture = document.createElement("canvas");
        picture.width = columns;
        picture.height = rows;
        const context = picture.getContext("2d")!;
        const pixels = context.createImageData(columns, rows);
        const colors = this.vertexColors(view);
        for (let v = 0; v < graph.vertexCount; ++v) {
            const at = 4 * (((graph.y[v] - this.top) / kUnit) * columns + (graph.x[v] - this.left) / kUnit);
            pixels.data.set(colors(v), at);
            pixels.data[at + 3] = 255;
        }
        context.putImageData(pixels, 0, 0);
        this.picture = picture;
        this.pictureKey = key;
        return picture;
    }

    private vertexColors({
        theme,
        blocks,
        heat,
        heatMost,
    }: View): (vertex: number) => [number, number, number] {
        const plain = channels(theme.cell);
        if (heat) {
            const share = (vertex: number): number => Math.log1p(heat[vertex]) / Math.log1p(heatMost);
            return (vertex) => (heat[vertex] > 0 ? rampColor(share(vertex)) : plain);
        }
        if (!blocks) return () => plain;
        const tints = this.tints(theme).map((tint) => (tint === null ? plain : channels(tint)));
        return (vertex) => tints[vertex];
    }

    private drawGraph(pen: Pen, view: View): void {
        const { camera, theme, width, height, blocks, heat } = view;
        const { graph } = this;
        const seen = camera.seen(width, height);
        const isSeen = (v: number): boolean =>
            graph.x[v] > seen.left - kUnit &&
            graph.x[v] < seen.right + kUnit &&
            graph.y[v] > seen.top - kUnit &&
            graph.y[v] < seen.bottom + kUnit;
        const byColor = new Map<string, number[]>();
        for (let edge = 0; edge < graph.edgeCount; ++edge) {
            const a = graph.edges[2 * edge];
            const b = graph.edges[2 * edge + 1];
            if (!isSeen(a) && !isSeen(b)) continue;
            const color = blocks ? this.edgeColor(edge, theme) : theme.edge;
            let lines = byColor.get(color);
            if (!lines) byColor.set(color, (lines = []));
            lines.push(
                camera.screenX(graph.x[a]),
                camera.screenY(graph.y[a]),
                camera.screenX(graph.x[b]),
                camera.screenY(graph.y[b]),
            );
        }
        const thin = Math.min(Math.max(0.07 * kUnit * camera.scale, 0.6), 3);
        for (const [color, lines] of byColor)
            pen.lines(
                lines,
                color,
                color === theme.isthmus ? 2.5 * thin : blocks && color !== theme.edge ? 3.5 * thin : thin,
            );

        const radius = kVertexRadius * camera.scale;
        const kSmallest = 1.6;
        if (radius < kSmallest && !heat) return;
        const colors = heat ? this.vertexColors(view) : null;
        for (let v = 0; v < graph.vertexCount; ++v)
            if (isSeen(v))
                pen.circle(
                    camera.screenX(graph.x[v]),
                    camera.screenY(graph.y[v]),
                    Math.max(radius, kSmallest),
                    { fill: colors ? cssColor(colors(v)) : theme.cell, stroke: theme.edge, width: thin },
                );
    }

    private edgeColor(edge: number, theme: Theme): string {
        const block = this.graph.blockOf[edge];
        return this.graph.blockSizes[block] === 2 ? theme.isthmus : theme.blocks[block % theme.blocks.length];
    }

    /** A vertex has the tint of its largest block; isthmuses are those that lie in blocks of two alone. */
    private tints(theme: Theme): (string | null)[] {
        const { graph } = this;
        const largest = new Int32Array(graph.vertexCount).fill(-1);
        graph.blockOf.forEach((block, edge) => {
            for (const v of [graph.edges[2 * edge], graph.edges[2 * edge + 1]])
                if (largest[v] < 0 || graph.blockSizes[block] > graph.blockSizes[largest[v]])
                    largest[v] = block;
        });
        return Array.from(largest, (block) =>
            block < 0
                ? null
                : graph.blockSizes[block] === 2
                  ? theme.isthmus
                  : theme.blocks[block % theme.blocks.length],
        );
    }
}
