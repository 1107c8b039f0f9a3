import assert from "node:assert/strict";
import { test } from "node:test";
import { unpackGraph } from "../src/data/graph";
import { Camera } from "../src/player/camera";
import { condense } from "../src/player/condense";
import { findEvents } from "../src/player/events";
import { compressIndices } from "../src/player/gif";
import { countInside, measureSteps, traffic, waiting } from "../src/player/measures";
import { SvgPen } from "../src/player/pen";
import { Timeline } from "../src/player/timeline";
import { describeTime } from "../src/player/words";
import { Track } from "../src/player/track";
import { graphOf, packRectangle, stepsOf } from "./fixtures";

const kLine = graphOf(5, [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 4],
]);
const kSquare = graphOf(4, [
    [0, 1],
    [1, 2],
    [2, 3],
    [0, 3],
]);

test("condensing starts every move as early as it can", () => {
    // Robot 1 waits for vertex 1 until robot 0 leaves it, and may then enter it in the same step.
    const steps = condense(stepsOf([[[0, 1, 2]], [[0, 2, 3]], [[1, 0, 1]], [[1, 1, 2]]]), 5, 2);
    assert.deepEqual([...steps.ends], [2, 4]);
    assert.deepEqual([...steps.robots], [0, 1, 0, 1]);
    assert.deepEqual([...steps.to], [2, 1, 3, 2]);
});

test("condensing keeps a rotation in one step", () => {
    const steps = condense(
        stepsOf([
            [[3, 5, 4]],
            [
                [0, 0, 1],
                [1, 1, 2],
                [2, 2, 0],
            ],
        ]),
        6,
        4,
    );
    assert.deepEqual([...steps.ends], [4]);
});

test("nothing condenses to nothing", () => {
    assert.equal(condense(stepsOf([]), 3, 1).ends.length, 0);
});

test("robots are found at any time", () => {
    const timeline = new Timeline(
        Uint32Array.of(0, 4),
        stepsOf([
            [[0, 0, 1]],
            [
                [0, 1, 2],
                [1, 4, 3],
            ],
            [[1, 3, 4]],
        ]),
    );
    assert.equal(timeline.length, 3);
    assert.deepEqual(timeline.at(0, 0), { from: 0, to: 0, share: 0 });
    assert.deepEqual(timeline.at(0, 0.25), { from: 0, to: 1, share: 0.25 });
    assert.deepEqual(timeline.at(0, 1), { from: 1, to: 1, share: 0 });
    assert.deepEqual(timeline.at(0, 2.5), { from: 2, to: 2, share: 0 });
    assert.deepEqual(timeline.at(1, 0.5), { from: 4, to: 4, share: 0 });
    assert.deepEqual(timeline.at(1, 2.5), { from: 3, to: 4, share: 0.5 });
    assert.deepEqual(timeline.at(1, 3), { from: 4, to: 4, share: 0 });
    assert.deepEqual(timeline.trail(0, 2.5, 10), [2, 1, 0]);
    assert.deepEqual(timeline.trail(0, 1.5, 1), [1]);
});

test("a replay of a random walk finds the same positions as the timeline", () => {
    const graph = unpackGraph(packRectangle(8, 8));
    let random = 7;
    const next = (below: number): number => (random = (random * 48271) % 2147483647) % below;
    const places = [0, 20, 40, 63];
    const starts = Uint32Array.from(places);
    const history: number[][] = [[...places]];
    const steps: [number, number, number][][] = [];
    for (let step = 0; step < 200; ++step) {
        const moves: [number, number, number][] = [];
        places.forEach((from, robot) => {
            if (next(2) === 0) return;
            const degree = graph.offsets[from + 1] - graph.offsets[from];
            const to = graph.neighbors[graph.offsets[from] + next(degree)];
            moves.push([robot, from, to]);
            places[robot] = to;
        });
        if (moves.length === 0) continue;
        steps.push(moves);
        history.push([...places]);
    }
    const timeline = new Timeline(starts, stepsOf(steps));
    history.forEach((there, time) =>
        there.forEach((vertex, robot) => assert.equal(timeline.at(robot, time).from, vertex)),
    );
});

test("a valid solution has no conflicts", () => {
    assert.deepEqual(
        findEvents(
            kLine,
            Uint32Array.of(0, 2),
            stepsOf([
                [
                    [1, 2, 3],
                    [0, 0, 1],
                ],
                [[0, 1, 2]],
            ]),
        ),
        [],
    );
});

test("conflicts of every kind are found and named", () => {
    const texts = (starts: number[], steps: [number, number, number][][], graph = kLine): string[] =>
        findEvents(graph, Uint32Array.from(starts), stepsOf(steps)).map(
            ({ step, kind, text }) => `${step} ${kind}: ${text}`,
        );
    assert.deepEqual(texts([0, 1], [[[0, 0, 1]]]), ["0 conflict: robots 1 and 0 are both on vertex 1"]);
    assert.deepEqual(
        texts(
            [0, 2],
            [
                [
                    [0, 0, 1],
                    [1, 2, 1],
                ],
            ],
        ),
        ["0 conflict: robots 0 and 1 are both on vertex 1"],
    );
    assert.deepEqual(
        texts(
            [0, 1],
            [
                [
                    [0, 0, 1],
                    [1, 1, 0],
                ],
            ],
        ),
        ["0 conflict: robots 0 and 1 swap along an edge"],
    );
    assert.deepEqual(texts([0], [[[0, 0, 3]]]), ["0 conflict: robot 0 goes from 0 to 3, where no edge is"]);
    assert.deepEqual(texts([0], [[[0, 0, 1]], [[0, 2, 3]]]), [
        "1 conflict: robot 0 is on vertex 1, not on 2",
    ]);
    assert.deepEqual(
        texts(
            [0],
            [
                [
                    [0, 0, 1],
                    [0, 1, 2],
                ],
            ],
        ),
        ["0 conflict: robot 0 moves twice in one step", "0 conflict: robot 0 is on vertex 0, not on 1"],
    );
});

test("rotations are found, chains are none", () => {
    const turn = findEvents(
        kSquare,
        Uint32Array.of(0, 1, 2, 3),
        stepsOf([
            [
                [0, 0, 1],
                [1, 1, 2],
                [2, 2, 3],
                [3, 3, 0],
            ],
        ]),
    );
    assert.deepEqual(
        turn.map(({ kind, robots }) => [kind, robots]),
        [["rotation", [0, 1, 2, 3]]],
    );
    assert.deepEqual(
        findEvents(
            kLine,
            Uint32Array.of(0, 1, 2),
            stepsOf([
                [
                    [0, 0, 1],
                    [1, 1, 2],
                    [2, 2, 3],
                ],
            ]),
        ),
        [],
    );
});

const kCase = { name: "line", graph: kLine, starts: Uint32Array.of(0, 4), goals: Uint32Array.of(2, 4) };

test("measures follow the steps", () => {
    const steps = stepsOf([
        [
            [0, 0, 1],
            [1, 4, 3],
        ],
        [[0, 1, 2]],
        [[1, 3, 4]],
    ]);
    const { atGoal, moving } = measureSteps(kCase, steps);
    assert.deepEqual([...atGoal], [1, 0, 1, 2]);
    assert.deepEqual([...moving], [2, 1, 1]);
    assert.deepEqual([...countInside(kCase, steps, Uint8Array.of(0, 0, 0, 1, 1))], [1, 1, 1, 1]);
    assert.deepEqual([...traffic(5, steps)], [0, 1, 1, 1, 1]);
    assert.deepEqual([...waiting(kCase, steps)], [0, 0, 0, 1, 0]);
});

test("events are reached in both directions", () => {
    const instance = {
        name: "",
        graph: kSquare,
        starts: Uint32Array.of(0, 1, 2),
        goals: Uint32Array.of(0, 1, 2),
    };
    const turn: [number, number, number][] = [
        [0, 0, 1],
        [1, 1, 2],
        [2, 2, 0],
    ];
    const playable = { run: 0, case: 0, sequential: true, optimized: false };
    const graph = graphOf(3, [
        [0, 1],
        [1, 2],
        [0, 2],
    ]);
    const track = new Track(
        playable,
        "steps",
        { ...instance, graph },
        stepsOf([
            turn,
            [
                [0, 1, 2],
                [1, 2, 0],
                [2, 0, 1],
            ],
        ]),
    );
    assert.equal(track.nextEvent(0, 1)?.step, 0);
    assert.equal(track.nextEvent(0.5, 1)?.step, 1);
    assert.equal(track.nextEvent(1.5, 1), null);
    assert.equal(track.nextEvent(1.5, -1)?.step, 0);
    assert.equal(
        describeTime(track, 0.5, 1),
        "Step 0 of 2, 3 of 3 robots at their goals, 3 move next, robot 1 is 50 % of the way from vertex 1 to 2, its goal is 1.",
    );
});

test("a camera that zooms keeps the point under the pointer", () => {
    const camera = new Camera();
    camera.fit({ left: 0, top: 0, right: 100, bottom: 50 }, 400, 400, 0);
    assert.equal(camera.scale, 4);
    const x = (130 - camera.offsetX) / camera.scale;
    camera.zoom(3, 130, 70);
    assert.ok(Math.abs(camera.screenX(x) - 130) < 1e-9);
    camera.zoom(1e9, 0, 0);
    assert.ok(camera.scale <= 4 * 400 + 1e-6);
});

test("texts in SVG files stay texts", () => {
    const pen = new SvgPen();
    pen.clear(10, 10, "#fff");
    pen.text(1, 2, '<script>&"', "#000", 3);
    const svg = pen.svg("</title><script>");
    assert.ok(!svg.includes("<script>"));
    assert.ok(svg.includes("&lt;script&gt;&amp;&quot;"));
});

/** The usual decoder of GIF's LZW. */
function decompress(bytes: number[]): number[] {
    const data: number[] = [];
    for (let at = 0; bytes[at] !== 0; at += bytes[at] + 1)
        data.push(...bytes.slice(at + 1, at + 1 + bytes[at]));
    let bit = 0;
    const read = (width: number): number => {
        let code = 0;
        for (let i = 0; i < width; ++i, ++bit) code |= ((data[bit >> 3] >> (bit & 7)) & 1) << i;
        return code;
    };
    const result: number[] = [];
    let table: number[][] = [];
    let width = 9;
    let previous: number[] | null = null;
    for (;;) {
        const code = read(width);
        if (code === 257) return result;
        if (code === 256) {
            table = [...Array.from({ length: 256 }, (_, i) => [i]), [], []];
            width = 9;
            previous = null;
            continue;
        }
        const entry: number[] = table[code] ?? [...previous!, previous![0]];
        if (previous) table.push([...previous, entry[0]]);
        if (table.length === 1 << width && width < 12) ++width;
        result.push(...entry);
        previous = entry;
    }
}

test("frames of GIFs can be decoded", () => {
    let random = 3;
    const noise = Uint8Array.from({ length: 30_000 }, () => (random = (random * 48271) % 2147483647) % 200);
    for (const indices of [
        Uint8Array.of(5),
        new Uint8Array(5000),
        Uint8Array.from({ length: 70_000 }, (_, i) => (i * i) % 7),
        noise,
    ])
        assert.deepEqual(decompress(compressIndices(indices)), [...indices]);
});
