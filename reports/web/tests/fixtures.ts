// Small graphs and packers for the tests; the packers are the reverse of what is tested, written anew.
import type { Graph } from "../src/data/graph";
import type { Steps } from "../src/data/solution";

export class Bytes {
    readonly bytes: number[] = [];

    number(value: number): this {
        for (; value >= 128; value = Math.floor(value / 128)) this.bytes.push((value % 128) | 128);
        this.bytes.push(value);
        return this;
    }

    difference(value: number, expected: number): this {
        const delta = value - expected;
        return this.number(delta >= 0 ? 2 * delta : -2 * delta - 1);
    }

    array(): Uint8Array {
        return Uint8Array.from(this.bytes);
    }
}

type Move = [robot: number, from: number, to: number];

/** Each inner list is a step. */
export function stepsOf(steps: Move[][]): Steps {
    const moves = steps.flat();
    let end = 0;
    return {
        robots: Uint32Array.from(moves, ([robot]) => robot),
        from: Uint32Array.from(moves, ([, from]) => from),
        to: Uint32Array.from(moves, ([, , to]) => to),
        ends: Uint32Array.from(steps, (step) => (end += step.length)),
    };
}

export function packSteps(steps: Move[][]): Uint8Array {
    const writer = new Bytes().number(1);
    const moves = steps.flat();
    writer.number(moves.length).number(steps.filter((step) => step.length > 1).length);
    let at = 0;
    let end = 0;
    for (const step of steps) {
        if (step.length > 1) {
            writer.number(at - end).number(step.length);
            end = at + step.length;
        }
        at += step.length;
    }
    const places = new Map<number, number>();
    let last = 0;
    for (const [robot, from, to] of moves) {
        writer
            .difference(robot, last)
            .difference(from, places.get(robot) ?? 0)
            .difference(to, from);
        places.set(robot, to);
        last = robot;
    }
    return writer.array();
}

/** Cells of a rectangle, row by row, as GraphBlock.h packs them. */
export function packRectangle(columns: number, rows: number): Uint8Array {
    const count = columns * rows;
    const edges: [number, number][] = [];
    for (let v = 0; v < count; ++v) {
        if ((v % columns) + 1 < columns) edges.push([v, v + 1]);
        if (v + columns < count) edges.push([v, v + columns]);
    }
    const writer = new Bytes().number(count).number(edges.length);
    let [x, y] = [0, 0];
    for (let v = 0; v < count; ++v) {
        const [nextX, nextY] = [64 * (v % columns), 64 * (rows - 1 - Math.floor(v / columns))];
        writer.difference(nextX, x).difference(nextY, y);
        [x, y] = [nextX, nextY];
    }
    for (let v = 0; v < count; ++v) {
        const larger = edges.filter(([a]) => a === v).map(([, b]) => b);
        writer.number(larger.length);
        let previous = v;
        for (const neighbor of larger) {
            writer.number(neighbor - previous);
            previous = neighbor;
        }
    }
    for (let i = 0; i < edges.length; ++i) writer.difference(0, 0);
    return writer.number(1).number(count).array();
}

/** A graph of these edges, all at one place. */
export function graphOf(vertexCount: number, edges: [number, number][]): Graph {
    const around = Array.from({ length: vertexCount }, (_, v) =>
        edges.flatMap(([a, b]) => (a === v ? [b] : b === v ? [a] : [])).sort((a, b) => a - b),
    );
    let end = 0;
    return {
        vertexCount,
        edgeCount: edges.length,
        x: new Float32Array(vertexCount),
        y: new Float32Array(vertexCount),
        edges: Uint32Array.from(edges.flat()),
        blockOf: new Uint32Array(edges.length),
        blockSizes: Uint32Array.from([vertexCount]),
        offsets: Uint32Array.from([0, ...around.map((list) => (end += list.length))]),
        neighbors: Uint32Array.from(around.flat()),
        isGrid: false,
    };
}
