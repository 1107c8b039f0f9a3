import assert from "node:assert/strict";
import { test } from "node:test";
import { middleOf, quartiles } from "../src/charts/groups";
import { Answers, commonInstances, comparedInstances, valuesOf } from "../src/data/answers";
import { Runs } from "../src/data/campaign";

interface Row {
    case: string;
    planner: string;
    status?: string;
    time?: number;
    fingerprint?: string;
    solvable?: string;
}

function runsOf(rows: Row[]): Runs {
    const texts = (name: string, values: string[]): object => ({
        name,
        texts: [...new Set(values)],
        rows: values.map((value) => [...new Set(values)].indexOf(value)),
    });
    const columns = [
        texts(
            "case",
            rows.map((row) => row.case),
        ),
        texts(
            "planner",
            rows.map((row) => row.planner),
        ),
        texts(
            "status",
            rows.map((row) => row.status ?? "solved"),
        ),
        texts(
            "instance_fingerprint",
            rows.map((row) => row.fingerprint ?? ""),
        ),
        texts(
            "solvable",
            rows.map((row) => row.solvable ?? "yes"),
        ),
        { name: "time", unit: "s", help: "Wall time.", numbers: rows.map((row) => row.time ?? null) },
    ] as ConstructorParameters<typeof Runs>[1]["columns"];
    return new Runs(rows.length, { columns, absences: { texts: [""], rows: rows.map(() => 0) } });
}

const all = (runs: Runs): number[] => Array.from({ length: runs.count }, (_, run) => run);

test("copies of an instance are one answer, their times' median", () => {
    const runs = runsOf([
        { case: "a/0", planner: "P", time: 1, fingerprint: "x" },
        { case: "a/1", planner: "P", time: 5, fingerprint: "x" },
        { case: "a/2", planner: "P", status: "timeout", fingerprint: "x" },
        { case: "b/0", planner: "P", time: 7, fingerprint: "y" },
    ]);
    const answers = new Answers(runs).of(all(runs));
    assert.deepEqual(
        answers.map((answer) => [answer.runs, answer.cost("time")]),
        [
            [[0, 1, 2], 5], // 1, 5 and a failure above both
            [[3], 7],
        ],
    );
});

test("a proof is no failure, and hopeless instances do not count", () => {
    const runs = runsOf([
        { case: "a", planner: "P", status: "infeasible", solvable: "no" },
        { case: "a", planner: "Q", status: "gave_up", solvable: "no" },
        { case: "b", planner: "P", status: "unsupported" },
        { case: "b", planner: "Q", time: 2 },
    ]);
    const answers = new Answers(runs).of(all(runs));
    assert.deepEqual(
        answers.map(({ planner, outcome, counts }) => [planner, outcome, counts]),
        [
            ["P", "proved", false],
            ["P", "doesNotApply", false],
            ["Q", "failed", false],
            ["Q", "solved", true],
        ],
    );
    assert.equal(comparedInstances(answers).size, 1);
});

test("no answer stands above all costs, and there is no median where half have none", () => {
    const rows = (solved: number): Row[] =>
        [1, 2, 3, 4].map((time) => ({
            case: `c/${time}`,
            planner: "P",
            time,
            status: time <= solved ? "solved" : "timeout",
        }));
    const middle = (solved: number): number | undefined => {
        const runs = runsOf(rows(solved));
        const answers = new Answers(runs).of(all(runs));
        return middleOf(valuesOf(runs, answers, comparedInstances(answers), "time"))?.median;
    };
    assert.equal(middle(4), 2.5);
    assert.equal(middle(3), 2.5);
    assert.equal(middle(2), undefined);
});

test("quartiles of infinite values are no NaN", () => {
    assert.deepEqual(quartiles([1, 2, Infinity, Infinity]), { low: 1.75, median: Infinity, high: Infinity, count: 4 });
    assert.equal(middleOf([1, 2, 3, 4])!.low, null, "four values make no band");
    assert.deepEqual(middleOf([1, 2, 3, 4, Infinity]), { low: 2, median: 3, high: 4 });
});

test("a weak planner does not empty the comparison of the others", () => {
    const rows: Row[] = [];
    for (let i = 0; i < 10; ++i)
        for (const planner of ["strong", "good", "weak"])
            rows.push({
                case: `c/${i}`,
                planner,
                time: 1,
                status: planner === "weak" && i > 0 ? "timeout" : "solved",
            });
    const runs = runsOf(rows);
    const common = commonInstances(new Answers(runs).of(all(runs)));
    assert.deepEqual(common.planners, ["strong", "good"]);
    assert.equal(common.instances.size, 10);
    const few = runsOf(rows.filter(({ case: name }) => Number(name.slice(2)) < 7));
    assert.deepEqual(commonInstances(new Answers(few).of(all(few))).planners, []);
});
