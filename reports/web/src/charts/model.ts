// What a chart shows, whatever draws it: curves with bands, marks with their quartiles, and a dot for each
// run.
import type { PlannerStyle, Runs } from "../data/campaign";
import { type Answer, Answers, comparedInstances, valuesOf } from "../data/answers";
import { columnTitle } from "../runs/format";
import { type Middle, groupBy, middleOf } from "./groups";

export type ChartKind = "sweep" | "cactus" | "scatter" | "versus";

export const kSuccess = "success_rate";
export const kProblem = "problem"; // as an x axis of names

export interface ChartSettings {
    kind: ChartKind;
    x: string;
    y: string;
    problem: string; // "model/problem"; empty for all
    planners: number[]; // indices of those that are shown
    first: number; // planners that are compared by "versus"
    second: number;
}

export interface Points {
    x: number[];
    y: (number | null)[];
    low: (number | null)[]; // of a band; may be empty
    high: (number | null)[];
}

const kMedians =
    "medians over the same instances for all planners shown, no answer standing above all costs (none where no more than " +
    "half were solved)";

const kNoPoints: Points = { x: [], y: [], low: [], high: [] };

export interface Curve extends Points {
    name: string;
    planner: number;
}

export interface Mark extends Middle {
    planner: number;
    x: number;
}

export interface Dot {
    run: number;
    x: number;
    y: number;
    planner: number;
    text: string;
}

export interface ChartModel {
    xTitle: string;
    yTitle: string;
    xIsTime: boolean; // seconds
    yIsTime: boolean;
    yIsPercent: boolean;
    xNames: string[] | null; // of the places 0, 1, … where the axis has names
    curves: Curve[];
    marks: Mark[];
    dots: Dot[];
    guides: [number, number, number, number][]; // lines x1, y1, x2, y2
    caption: string;
}

export function problemOf(runs: Runs, run: number): string {
    return `${runs.text("model", run)}/${runs.text("problem", run)}`;
}

export function problemsOf(runs: Runs): string[] {
    return [...groupBy(runIndices(runs), (run) => problemOf(runs, run)).keys()];
}

export function isSwept(runs: Runs): boolean {
    return runs.text("sweep_variable", 0) !== "" && new Set(runs.column("sweep_value").numbers).size > 1;
}

export function buildChart(runs: Runs, planners: PlannerStyle[], settings: ChartSettings): ChartModel {
    return new Builder(runs, planners, settings).build();
}

function runIndices(runs: Runs): number[] {
    return Array.from({ length: runs.count }, (_, run) => run);
}

class Builder {
    private readonly plannerOf: (run: number) => number;
    private readonly chosen: number[]; // runs of the problem and planners that are shown
    private readonly answers: Answers;

    constructor(
        private readonly runs: Runs,
        private readonly planners: PlannerStyle[],
        private readonly settings: ChartSettings,
    ) {
        this.answers = new Answers(runs);
        const numbers = new Map(planners.map(({ name }, i) => [name, i]));
        this.plannerOf = (run) => numbers.get(runs.text("planner", run)) ?? -1;
        const shown = settings.kind === "versus" ? [settings.first, settings.second] : settings.planners;
        this.chosen = runIndices(runs).filter(
            (run) =>
                (settings.problem === "" || problemOf(runs, run) === settings.problem) &&
                shown.includes(this.plannerOf(run)),
        );
    }

    build(): ChartModel {
        switch (this.settings.kind) {
            case "sweep":
                return this.settings.x === kProblem ? this.comparison() : this.sweep();
            case "cactus":
                return this.cactus();
            case "scatter":
                return this.scatter();
            case "versus":
                return this.versus();
        }
    }

    private isSolved(run: number): boolean {
        return this.runs.text("status", run) === "solved";
    }

    private title(column: string): string {
        if (column === kSuccess) return "Instances solved (%)";
        if (column === "sweep_value") {
            const names = new Set(this.chosen.map((run) => this.runs.text("sweep_variable", run)));
            return [...names].join(", ").replaceAll("_", " ") || "sweep value";
        }
        const known = this.runs.column(column);
        return known.unit === "s" ? known.title : columnTitle(known);
    }

    /** A cost of a solved run; nothing of the others. */
    private cost(run: number): number | null {
        return this.isSolved(run) ? this.runs.number(this.settings.y, run) : null;
    }

    private text(run: number): string {
        return `${this.runs.text("planner", run)} on ${this.runs.text("case", run)}`;
    }

    private count(answers: Answer[]): string {
        const counted = answers.filter(({ counts }) => counts).length;
        return `${answers.filter(({ solved }) => solved).length} of ${counted} instances solved`;
    }

    /** What is shown of each planner at one place: its costs on the instances that all are compared on, or its success. */
    private summaries(runs: number[]): Map<number, Middle | null> {
        const answers = this.answers.of(runs);
        const compared = comparedInstances(answers);
        const { y } = this.settings;
        return new Map(
            [...groupBy(answers, ({ runs: [run] }) => this.plannerOf(run))].map(([planner, own]) => {
                if (y !== kSuccess) return [planner, middleOf(valuesOf(this.runs, own, compared, y))];
                const counted = own.filter(({ counts }) => counts).length;
                const percent = (100 * own.filter(({ solved }) => solved).length) / counted;
                return [planner, counted === 0 ? null : { low: percent, median: percent, high: percent }];
            }),
        );
    }

    private dots(xOf: (run: number) => number | null): Dot[] {
        if (this.settings.y === kSuccess) return [];
        return this.chosen.flatMap((run) => {
            const x = xOf(run);
            const y = this.cost(run);
            return x === null || y === null
                ? []
                : [{ run, x, y, planner: this.plannerOf(run), text: this.text(run) }];
        });
    }

    /** A curve for each planner that is shown; its name says how many instances it solved. */
    private curves(points: (answers: Answer[], planner: number) => Points): Curve[] {
        const byPlanner = groupBy(this.answers.of(this.chosen), ({ runs: [run] }) => this.plannerOf(run));
        return [...byPlanner].map(([planner, answers]) => ({
            name: `${this.planners[planner].name}: ${this.count(answers)}`,
            planner,
            ...points(answers, planner),
        }));
    }

    private sweep(): ChartModel {
        const { x, y } = this.settings;
        const placeOf = (run: number): number | null => this.runs.number(x, run);
        const placed = this.chosen.filter((run) => placeOf(run) !== null);
        const places = [...groupBy(placed, (run) => placeOf(run)!)]
            .sort(([a], [b]) => a - b)
            .map(([place, there]) => ({ place, summaries: this.summaries(there) }));
        const curves = this.curves((_, planner) => {
            const own = places.filter(({ summaries }) => summaries.has(planner));
            const middles = own.map(({ summaries }) => summaries.get(planner) ?? null);
            return {
                x: own.map(({ place }) => place),
                y: middles.map((middle) => middle?.median ?? null),
                low: middles.map((middle) => middle?.low ?? null),
                high: middles.map((middle) => middle?.high ?? null),
            };
        });
        return {
            ...this.empty(this.title(x), this.title(y)),
            curves,
            dots: this.dots(placeOf),
            caption: `Lines: ${kMedians}; bands: quartiles, of five instances or more; dots: solved runs.`,
        };
    }

    /** Planners beside each other at each problem (and sweep point). */
    private comparison(): ChartModel {
        const placeOf = (run: number): string => {
            const value = this.runs.number("sweep_value", run);
            return this.runs.text("problem", run) + (value === null ? "" : `, ${value}`);
        };
        const names = [...groupBy(this.chosen, placeOf).keys()];
        const places = new Map(names.map((name, i) => [name, i]));
        const shown = this.settings.planners;
        const beside = (planner: number): number =>
            ((shown.indexOf(planner) + 1) / (shown.length + 1) - 0.5) * 0.8;
        const xOf = (run: number): number => places.get(placeOf(run))! + beside(this.plannerOf(run));
        const marks = [...groupBy(this.chosen, placeOf)].flatMap(([name, there]): Mark[] =>
            [...this.summaries(there)].flatMap(([planner, middle]) =>
                middle ? [{ planner, x: places.get(name)! + beside(planner), ...middle }] : [],
            ),
        );
        return {
            ...this.empty("", this.title(this.settings.y)),
            xNames: names,
            curves: this.curves(() => kNoPoints),
            marks,
            dots: this.dots(xOf),
            caption: `Marks: ${kMedians}; bars: quartiles, of five instances or more; dots: solved runs.`,
        };
    }

    /** How many instances a planner solves when each may cost so much. */
    private cactus(): ChartModel {
        const dots: Dot[] = [];
        const instances = groupBy(this.answers.of(this.chosen), ({ instance }) => instance);
        const all = [...instances.values()].filter((own) => !own.every(({ unsolvable }) => unsolvable)).length;
        const costOf = (answer: Answer): number | null => answer.cost(this.settings.y);
        const curves = this.curves((answers, planner) => {
            const solved = answers
                .filter((answer) => costOf(answer) !== null)
                .sort((a, b) => costOf(a)! - costOf(b)!);
            const points = solved.map((answer, i) => ({
                run: answer.runs[0],
                x: i + 1,
                y: costOf(answer)!,
                planner,
                text: this.text(answer.runs[0]),
            }));
            for (const point of points) dots.push(point);
            return { ...kNoPoints, x: points.map(({ x }) => x), y: points.map(({ y }) => y) };
        });
        return {
            ...this.empty(`Instances solved (of ${all})`, `${this.title(this.settings.y)}, at most`),
            curves,
            dots,
            caption:
                "Each planner's solved instances, cheapest first: further right means more solved, lower means cheaper.",
        };
    }

    private scatter(): ChartModel {
        const { x, y } = this.settings;
        const dots = this.dots((run) => this.runs.number(x, run));
        return {
            ...this.empty(this.title(x), this.title(y)),
            curves: this.curves(() => kNoPoints),
            dots,
            caption: `${dots.length} solved runs, a dot each.`,
        };
    }

    /** Two planners on the same cases. */
    private versus(): ChartModel {
        const { first, second, y } = this.settings;
        const costs = this.chosen.map((run) => this.cost(run)).filter((value) => value !== null);
        const most = costs.reduce((a, b) => Math.max(a, b), 0) || 1;
        const least = costs.reduce((a, b) => Math.min(a, b), most);
        const kBeyond = 1.35; // where those stand that were not solved
        const dots: Dot[] = [];
        let missing = 0;
        for (const there of groupBy(this.answers.of(this.chosen), ({ instance }) => instance).values()) {
            const a = there.find(({ runs: [run] }) => this.plannerOf(run) === first);
            const b = there.find(({ runs: [run] }) => this.plannerOf(run) === second);
            if (!a || !b) continue;
            const x = a.cost(y);
            const value = b.cost(y);
            if (x === null && value === null) continue;
            if (x === null || value === null) ++missing;
            const winner = x === null || (value !== null && value < x) ? second : first;
            dots.push({
                run: b.runs[0],
                x: x ?? most * kBeyond,
                y: value ?? most * kBeyond,
                planner: winner,
                text: this.runs.text("case", b.runs[0]),
            });
        }
        const title = (planner: number): string => `${this.planners[planner]?.name ?? ""}: ${this.title(y)}`;
        return {
            ...this.empty(title(first), title(second)),
            dots,
            guides: [
                [least, least, most, most],
                ...(missing > 0
                    ? ([
                          [least, most * kBeyond, most * kBeyond, most * kBeyond],
                          [most * kBeyond, least, most * kBeyond, most * kBeyond],
                      ] as [number, number, number, number][])
                    : []),
            ],
            caption:
                `${dots.length} instances, a dot each in the colour of the planner that did better (the first where they ` +
                "are equal); below the diagonal it is the second." +
                (missing > 0
                    ? ` ${missing} dots on the outer lines: one of the two did not solve the instance.`
                    : ""),
        };
    }

    private empty(xTitle: string, yTitle: string): ChartModel {
        const { kind, x, y } = this.settings;
        const isTime = (column: string): boolean =>
            this.runs.has(column) && this.runs.column(column).unit === "s";
        const xIsTime = kind === "versus" ? isTime(y) : kind !== "cactus" && isTime(x);
        return {
            xTitle,
            yTitle,
            xIsTime,
            yIsTime: isTime(y),
            yIsPercent: y === kSuccess,
            xNames: null,
            curves: [],
            marks: [],
            dots: [],
            guides: [],
            caption: "",
        };
    }
}
