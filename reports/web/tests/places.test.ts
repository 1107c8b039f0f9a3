// Robots are drawn where solutions say, in each of the four ways in which a solution can be watched.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { browser, exported, movesOf, placeAfter, scratch, type Move } from "./campaignPage";

const kSide = 10;
const kRobots = 25;
let page: string;
let starts: number[];
let makespans: { makespan: number; optimized_makespan: number };

before(() => {
    scratch.mrppsim(
        `generate grid --side ${kSide} --graph g.map --robots ${kRobots} --instance g.scen --solvable`.split(
            " ",
        ),
    );
    scratch.mrppsim(
        (
            "solve --graph g.map --instance g.scen --planner push_and_rotate --json solved.json --solution moves.csv " +
            "--schedule steps.csv --optimized-solution optimized.csv"
        ).split(" "),
    );
    makespans = JSON.parse(readFileSync(join(scratch.path, "solved.json"), "utf8"));
    const rows = readFileSync(join(scratch.path, "g.scen"), "utf8").trim().split("\n").slice(1);
    starts = rows.map((row) => {
        const [x, y] = row.split("\t").slice(4, 6).map(Number);
        return y * kSide + x;
    });
    writeFileSync(
        join(scratch.path, "places.yaml"),
        "problems:\n  - fully_controlled: {graph: g.map, instance: g.scen}\nplanners: [push_and_rotate]\n" +
            "optimizers: [redundancy_removal]\nreports: [html]\nrepetitions: 1\n",
    );
    scratch.mrppsim("run places.yaml -o places --quiet".split(" "));
    page = join(scratch.path, "places/report.html");
});

/** Where the frame that is shown has each robot's number, from its SVG file. */
async function drawnPlaces(): Promise<number[][]> {
    const places: number[][] = [];
    const svg = (await exported(/^This frame as SVG/)).toString("utf8");
    for (const [, x, y, robot] of svg.matchAll(/<text x="([\d.]+)" y="([\d.]+)"[^>]*>(\d+)<\/text>/g))
        places[Number(robot)] = [Number(x), Number(y)];
    return places;
}

/** Checks every robot's place on the screen: a cell has one size everywhere. */
async function checkFrame(moves: Move[], step: number, cell: number, corner: number[]): Promise<void> {
    const drawn = await drawnPlaces();
    assert.equal(drawn.length, kRobots);
    starts.forEach((start, robot) => {
        const vertex = placeAfter(moves, robot, step) ?? start;
        const wanted = [corner[0] + cell * (vertex % kSide), corner[1] + cell * Math.floor(vertex / kSide)];
        for (const i of [0, 1])
            assert.ok(Math.abs(drawn[robot][i] - wanted[i]) < 0.1, `robot ${robot} after step ${step}`);
    });
}

/** The size of a cell and the place of vertex 0, from the starts. */
async function gridOnScreen(): Promise<[number, number[]]> {
    const drawn = await drawnPlaces();
    const other = starts.findIndex((start) => start % kSide !== starts[0] % kSide);
    const cell = (drawn[other][0] - drawn[0][0]) / ((starts[other] % kSide) - (starts[0] % kSide));
    return [
        cell,
        [drawn[0][0] - cell * (starts[0] % kSide), drawn[0][1] - cell * Math.floor(starts[0] / kSide)],
    ];
}

for (const [kind, file] of [
    ["moves", "moves.csv"],
    ["steps", "steps.csv"],
    ["optimized-moves", "optimized.csv"],
])
    test(`robots are drawn where ${file} says`, async () => {
        const moves = movesOf(file);
        const length = moves[moves.length - 1].step + 1;
        await browser.open(page, `view=player&p=0:${kind}`);
        assert.ok((await browser.readout()).startsWith(`Step 0 of ${length},`));
        const [cell, corner] = await gridOnScreen();
        assert.ok(cell > 20, `${cell} pixels a cell`);
        for (const step of [1, Math.floor(length / 2), length - 1, length]) {
            await browser.go(`view=player&p=0:${kind}&t=${step}`);
            assert.ok((await browser.readout()).startsWith(`Step ${step} of ${length},`));
            await checkFrame(moves, step, cell, corner);
        }
        await browser.go(`view=player&p=0:${kind}&t=0.5`);
        const [first] = moves;
        const half = (await drawnPlaces())[first.robot];
        const [from, to] = [first.from, first.to].map((v) => [v % kSide, Math.floor(v / kSide)]);
        for (const i of [0, 1])
            assert.ok(Math.abs(half[i] - (corner[i] + (cell * (from[i] + to[i])) / 2)) < 0.1, "half-way");
    });

test("the optimized solution is condensed to the makespan that the results name", async () => {
    await browser.open(page, `view=player&p=0:steps~0:optimized-steps&t=${makespans.optimized_makespan}`);
    const said = (await browser.readout()).split(" · ");
    assert.match(said[0], new RegExp(`of ${makespans.makespan},`));
    assert.match(
        said[1],
        new RegExp(
            `^Step ${makespans.optimized_makespan} of ${makespans.optimized_makespan}, ${kRobots} of ${kRobots} `,
        ),
    );
});

test("the robot that is followed is named with its vertex", async () => {
    const moves = movesOf("steps.csv");
    for (const [robot, step] of [
        [0, 3],
        [7, 11],
        [kRobots - 1, 20],
    ]) {
        await browser.go(`view=player&p=0:steps&follow=${robot}&t=${step}`);
        const vertex = placeAfter(moves, robot, step) ?? starts[robot];
        assert.match(await browser.readout(), new RegExp(`robot ${robot} is on vertex ${vertex},`));
    }
});
