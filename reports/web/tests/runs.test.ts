import assert from "node:assert/strict";
import { test } from "node:test";
import { quartiles } from "../src/charts/groups";
import { type ChartSettings, buildChart } from "../src/charts/model";
import { Runs } from "../src/data/campaign";
import { quoted } from "../src/runs/details";
import { columnTest, searchTest, selectRuns } from "../src/runs/filter";
import { formatNumber, formatSeconds } from "../src/runs/format";
import { State } from "../src/page/state";
import { labelled, logarithmicTicks } from "../src/charts/ticks";

const texts = (...values: string[]): { texts: string[]; rows: number[] } => ({
    texts: values,
    rows: values.map((_, i) => i),
});

/** Two planners on two sweep points with two repetitions each; the second planner fails at the second point. */
function campaign(): Runs {
    const points = [0, 0, 0, 0, 1, 1, 1, 1];
    const planners = [0, 1, 0, 1, 0, 1, 0, 1];
    return new Runs(8, {
        columns: [
            {
                name: "case",
                ...texts(
                    "m/p/1/0",
                    "m/p/1/0",
                    "m/p/1/1",
                    "m/p/1/1",
                    "m/p/2/0",
                    "m/p/2/0",
                    "m/p/2/1",
                    "m/p/2/1",
                ),
            },
            { name: "model", texts: ["m"], rows: points.map(() => 0) },
            { name: "problem", texts: ["p"], rows: points.map(() => 0) },
            { name: "sweep_variable", texts: ["robots"], rows: points.map(() => 0) },
            { name: "sweep_value", numbers: points.map((point) => 10 * (point + 1)) },
            { name: "planner", texts: ["Alpha", "beta"], rows: planners },
            { name: "status", texts: ["solved", "timeout"], rows: [0, 0, 0, 0, 0, 1, 0, 1] },
            { name: "time", unit: "s", numbers: [1, 4, 3, 5, 10, null, 20, null] },
        ],
        absences: { texts: [""], rows: points.map(() => 0) },
    });
}

const kPlanners = ["Alpha", "beta"].map((name) => ({ name, color: "#000000", dashes: "solid", marker: 7 }));
const kSettings: ChartSettings = {
    kind: "sweep",
    x: "sweep_value",
    y: "time",
    problem: "",
    planners: [0, 1],
    first: 0,
    second: 1,
};

test("quartiles are those of the program", () => {
    assert.deepEqual(quartiles([4, 1, 3, 2]), { low: 1.75, median: 2.5, high: 3.25, count: 4 });
    assert.deepEqual(quartiles([7]), { low: 7, median: 7, high: 7, count: 1 });
    assert.equal(quartiles([]), null);
});

test("a sweep has medians, and gaps where no more than half of the instances were solved", () => {
    const { curves, dots } = buildChart(campaign(), kPlanners, kSettings);
    assert.deepEqual(
        curves.map(({ x, y }) => ({ x, y })),
        [
            { x: [10, 20], y: [2, 15] },
            { x: [10, 20], y: [4.5, null] },
        ],
    );
    assert.deepEqual(curves[0].low, [null, null], "two instances make no band");
    assert.deepEqual(
        curves.map(({ name }) => name),
        ["Alpha: 4 of 4 instances solved", "beta: 2 of 4 instances solved"],
    );
    assert.deepEqual(
        dots.map(({ run }) => run),
        [0, 1, 2, 3, 4, 6],
    );
});

test("the success rate counts every run", () => {
    const { curves, dots } = buildChart(campaign(), kPlanners, { ...kSettings, y: "success_rate" });
    assert.deepEqual(
        curves.map(({ y }) => y),
        [
            [100, 100],
            [100, 0],
        ],
    );
    assert.equal(dots.length, 0);
});

test("a cactus sorts the solved runs", () => {
    const { curves, xTitle } = buildChart(campaign(), kPlanners, { ...kSettings, kind: "cactus" });
    assert.deepEqual(
        curves.map(({ x, y }) => ({ x, y })),
        [
            { x: [1, 2, 3, 4], y: [1, 3, 10, 20] },
            { x: [1, 2], y: [4, 5] },
        ],
    );
    assert.equal(xTitle, "Instances solved (of 4)");
});

test("one planner against another keeps the cases that only one solved, beyond all costs", () => {
    const { dots, guides } = buildChart(campaign(), kPlanners, { ...kSettings, kind: "versus" });
    assert.deepEqual(
        dots.map(({ x, y, planner }) => [x, y, planner]),
        [
            [1, 4, 0],
            [3, 5, 0],
            [10, 27, 0],
            [20, 27, 0],
        ],
    );
    assert.equal(guides.length, 3);
});

test("problems stand side by side", () => {
    const { xNames, marks } = buildChart(campaign(), kPlanners, { ...kSettings, x: "problem" });
    assert.deepEqual(xNames, ["p, 10", "p, 20"]);
    assert.deepEqual(
        marks.map(({ median }) => median),
        [2, 4.5, 15],
    );
});

test("a planner that is taken out is not shown", () => {
    assert.deepEqual(
        buildChart(campaign(), kPlanners, { ...kSettings, planners: [1] }).curves.map(
            ({ planner }) => planner,
        ),
        [1],
    );
});

const select = (column: string, filter: string): number[] => {
    const runs = campaign();
    return [...selectRuns(runs, [columnTest(runs.column(column), filter)], null)];
};

test("filters of numbers compare", () => {
    assert.deepEqual(select("time", ">4"), [3, 4, 6]);
    assert.deepEqual(select("time", "<= 3"), [0, 2]);
    assert.deepEqual(select("time", "3..5"), [1, 2, 3]);
    assert.deepEqual(select("time", "10.."), [4, 6]);
    assert.deepEqual(select("time", "4"), [1]);
    assert.deepEqual(select("time", "!=4"), [0, 2, 3, 4, 6]);
    assert.deepEqual(select("time", ""), [0, 1, 2, 3, 4, 5, 6, 7]);
});

test("filters of texts ignore case and can be turned round", () => {
    assert.deepEqual(select("planner", "ALPHA"), [0, 2, 4, 6]);
    assert.deepEqual(select("planner", "!alpha"), [1, 3, 5, 7]);
});

test("searching wants every word somewhere", () => {
    const runs = campaign();
    assert.deepEqual([...selectRuns(runs, [searchTest(runs, "beta timeout")], null)], [5, 7]);
    assert.equal(searchTest(runs, "  "), null);
});

test("sorting keeps empty cells last, in both directions", () => {
    const runs = campaign();
    assert.deepEqual(
        [...selectRuns(runs, [], { column: "time", isDescending: false })],
        [0, 2, 1, 3, 4, 6, 5, 7],
    );
    assert.deepEqual(
        [...selectRuns(runs, [], { column: "time", isDescending: true })],
        [6, 4, 3, 1, 2, 0, 5, 7],
    );
    assert.deepEqual(
        [...selectRuns(runs, [], { column: "planner", isDescending: true })].slice(0, 4),
        [1, 3, 5, 7],
    );
});

test("numbers are short and exact where they are whole", () => {
    assert.equal(formatNumber(1234), "1234");
    assert.equal(formatNumber(1234567), "1\u2009234\u2009567");
    assert.equal(formatNumber(0.123456), "0.1235");
    assert.equal(formatSeconds(0.0000123), "12.3 µs");
    assert.equal(formatSeconds(0.25), "250 ms");
    assert.equal(formatSeconds(90), "90 s");
    assert.equal(formatSeconds(300), "5 min");
});

test("words are quoted as shells take them", () => {
    assert.equal(quoted("/a/b-c_1.2"), "/a/b-c_1.2");
    assert.equal(quoted("it's $HOME"), "'it'\\''s $HOME'");
});

test("the state survives the address", () => {
    const place = { hash: "" };
    const state = new State(place);
    const seen: string[][] = [];
    state.onChange((changed) => seen.push([...changed]));
    state.set({ view: "runs", q: "a b&c=d", columns: ["time", "status"], goals: false, run: 7 });
    const again = new State({ hash: place.hash });
    assert.equal(again.get("q", ""), "a b&c=d");
    assert.deepEqual(again.list("columns"), ["time", "status"]);
    assert.equal(again.flag("goals", true), false);
    assert.equal(again.number("run", -1), 7);
    state.set({ view: "runs" });
    state.set({ q: null });
    assert.deepEqual(
        seen.map((changed) => changed.length),
        [5, 1],
    );
});

test("ticks of logarithmic axes are powers of ten and their multiples, on whatever range", () => {
    assert.deepEqual(logarithmicTicks(0.8, 3), [0.8, 0.9, 1, 2, 3]);
    assert.deepEqual(logarithmicTicks(1e-9, 1e3).length, 13, "powers alone on long axes");
    for (const min of [9.8e-3, 0.3, 1, 76.9, 999.999])
        for (const factor of [1.01, 7, 140, 1e5, 1e12]) {
            const ticks = logarithmicTicks(min, min * factor);
            assert.ok(
                ticks.every((tick, i) => tick >= min && tick <= min * factor && !(tick <= ticks[i - 1])),
            );
            assert.ok(labelled(ticks, 5).filter((tick) => tick !== null).length <= 5);
        }
    const decades = logarithmicTicks(1, 100);
    assert.deepEqual(
        labelled(decades, 8).filter((tick) => tick !== null),
        [1, 2, 5, 10, 20, 50, 100],
    );
});
