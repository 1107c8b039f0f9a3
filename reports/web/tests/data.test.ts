import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { ByteReader, fromBase64, inflate } from "../src/data/bytes";
import { Campaign } from "../src/data/campaign";
import { hasEdge, unpackGraph } from "../src/data/graph";
import { unpackRobots, unpackSolution } from "../src/data/solution";
import { Bytes, packRectangle, packSteps } from "./fixtures";

test("numbers of every size come back", () => {
    const numbers = [0, 1, 127, 128, 16383, 16384, 2 ** 32 - 1, 2 ** 32, Number.MAX_SAFE_INTEGER];
    const writer = new Bytes();
    for (const number of numbers) writer.number(number);
    const reader = new ByteReader(writer.array());
    assert.deepEqual(
        numbers.map(() => reader.number()),
        numbers,
    );
    assert.equal(reader.left, 0);
    assert.throws(() => reader.number(), /end too early/);
});

test("differences in both directions come back", () => {
    const pairs: [number, number][] = [
        [5, 3],
        [3, 5],
        [0, 0],
        [0, 1],
        [1_000_000, 0],
        [0, 1_000_000],
    ];
    const writer = new Bytes();
    for (const [value, expected] of pairs) writer.difference(value, expected);
    const reader = new ByteReader(writer.array());
    for (const [value, expected] of pairs) assert.equal(reader.difference(expected), value);
});

test("what the program packs is inflated", async () => {
    assert.equal(new TextDecoder().decode(await inflate(fromBase64("eNpLBAAAYgBi"))), "a");
});

test("solutions come back with their steps", () => {
    const steps = unpackSolution(
        packSteps([
            [[0, 5, 6]],
            [
                [1, 9, 5],
                [2, 6, 7],
                [0, 7, 9],
            ],
            [[1, 5, 4]],
            [[1, 4, 3]],
        ]),
    );
    assert.deepEqual([...steps.robots], [0, 1, 2, 0, 1, 1]);
    assert.deepEqual([...steps.from], [5, 9, 6, 7, 5, 4]);
    assert.deepEqual([...steps.to], [6, 5, 7, 9, 4, 3]);
    assert.deepEqual([...steps.ends], [1, 4, 5, 6]);
    assert.throws(() => unpackSolution(Uint8Array.from([2, 0, 0])), /unknown format/);
    assert.throws(() => unpackSolution(Uint8Array.from([1, 3, 0, 0])), /end too early/);
});

test("starts and goals come back", () => {
    const bytes = new Bytes()
        .number(2)
        .difference(7, 0)
        .difference(3, 7)
        .difference(1, 0)
        .difference(9, 1)
        .array();
    const { starts, goals } = unpackRobots(bytes);
    assert.deepEqual(
        [[...starts], [...goals]],
        [
            [7, 3],
            [1, 9],
        ],
    );
});

test("a map of cells is known as one, with its neighbours", () => {
    const graph = unpackGraph(packRectangle(10, 8));
    assert.equal(graph.vertexCount, 80);
    assert.equal(graph.edgeCount, 10 * 7 + 9 * 8);
    assert.equal(graph.isGrid, true);
    assert.deepEqual([...graph.neighbors.slice(graph.offsets[11], graph.offsets[12])], [1, 10, 12, 21]);
    assert.equal(hasEdge(graph, 9, 10), false);
    assert.equal(hasEdge(graph, 10, 11), true);
    assert.ok(graph.y[0] < graph.y[10], "y grows downwards");
});

test("columns of the results keep numbers, texts and reasons", async () => {
    const pack = (value: unknown): string => deflateSync(JSON.stringify(value)).toString("base64");
    const blocks: Record<string, string> = {
        explorer: JSON.stringify({
            title: "t",
            facts: [],
            provenance: [],
            plan: "p",
            planners: [],
            runCount: 3,
            cases: [],
            playable: [{ run: 2, case: 0, sequential: true, optimized: false }],
            robotColors: [],
        }),
        runs: pack({
            columns: [
                { name: "time", numbers: [0.5, null, 2] },
                { name: "status", texts: ["solved", "timeout"], rows: [0, 1, 0] },
            ],
            absences: { texts: ["", "why"], rows: [0, 1, 0] },
        }),
    };
    const campaign = new Campaign((id) => blocks[id]);
    const runs = await campaign.runs();
    assert.equal(runs.number("time", 0), 0.5);
    assert.equal(runs.number("time", 1), null);
    assert.equal(runs.text("status", 1), "timeout");
    assert.equal(runs.absence(1), "why");
    assert.equal(campaign.playableIndex(2), 0);
    assert.equal(campaign.playableIndex(0), -1);
    assert.throws(() => runs.column("nothing"), /no column nothing/);
});
