// What a planner made of one instance, however often it was asked, as reports/Answer.h has it: copies of an instance
// are one case, no answer stands above all costs, and planners are compared on the same instances.
import { groupBy, quartiles } from "../charts/groups";
import type { Runs } from "./campaign";

const kNoAnswer = Infinity;

export type Outcome = "solved" | "proved" | "doesNotApply" | "failed";

export class Answer {
    constructor(
        private readonly records: Runs,
        readonly planner: string,
        readonly instance: string,
        readonly runs: number[], // on copies of the instance; never empty
    ) {}

    get outcome(): Outcome {
        const ends = this.runs.map((run) => outcomeOf(this.records.text("status", run)));
        return ends.find((end) => 2 * ends.filter((other) => other === end).length > ends.length) ?? "failed";
    }

    get solved(): boolean {
        return this.outcome === "solved";
    }

    /** Known to have no solution under the planner's motion rule. */
    get unsolvable(): boolean {
        return (
            !this.solved &&
            this.runs.some(
                (run) =>
                    this.records.text("status", run) === "infeasible" ||
                    (this.records.has("solvable") && this.records.text("solvable", run) === "no"),
            )
        );
    }

    /** Whether it counts for a success rate. */
    get counts(): boolean {
        return this.outcome !== "doesNotApply" && !this.unsolvable;
    }

    /** Of a solved instance, the median over the copies; null where there is none. */
    cost(column: string): number | null {
        if (!this.solved) return null;
        const values = this.runs
            .map((run) =>
                this.records.text("status", run) === "solved" ? this.records.number(column, run) : kNoAnswer,
            )
            .filter((value) => value !== null);
        const middle = quartiles(values)?.median ?? kNoAnswer;
        return middle === kNoAnswer ? null : middle;
    }
}

function outcomeOf(status: string): Outcome {
    if (status === "solved") return "solved";
    if (status === "infeasible") return "proved";
    return status === "unsupported" ? "doesNotApply" : "failed";
}

export class Answers {
    private readonly fingerprints = new Map<string, string>(); // of cases

    constructor(private readonly records: Runs) {
        if (!records.has("instance_fingerprint")) return;
        for (let run = 0; run < records.count; ++run) {
            const fingerprint = records.text("instance_fingerprint", run);
            if (fingerprint !== "") this.fingerprints.set(records.text("case", run), fingerprint);
        }
    }

    /** One for each planner and instance of these runs. */
    of(runs: number[]): Answer[] {
        const { records } = this;
        return [...groupBy(runs, (run) => records.text("planner", run))].flatMap(([planner, own]) =>
            [...groupBy(own, (run) => this.instanceOf(run))].map(
                ([instance, copies]) => new Answer(records, planner, instance, copies),
            ),
        );
    }

    private instanceOf(run: number): string {
        const name = this.records.text("case", run);
        return this.fingerprints.get(name) ?? `case ${name}`;
    }
}

/** The instances that all of these planners have finished, unless all of them know that there is no solution. */
export function comparedInstances(answers: Answer[]): Set<string> {
    const planners = new Set(answers.map(({ planner }) => planner)).size;
    return new Set(
        [...groupBy(answers, ({ instance }) => instance)]
            .filter(([, there]) => there.length === planners && !there.every(({ unsolvable }) => unsolvable))
            .map(([instance]) => instance),
    );
}

/** Whether no answer is worse than any value: a metric that is better when it is lower, and no lower bound. */
export function isCost(records: Runs, name: string): boolean {
    const column = records.column(name);
    return column.help !== "" && column.lowerIsBetter && !name.endsWith("lower_bound");
}

/** The values of one planner's answers to the compared instances. */
export function valuesOf(records: Runs, answers: Answer[], compared: Set<string>, column: string): number[] {
    const orNothing = isCost(records, column) ? kNoAnswer : null;
    return answers
        .filter(({ instance }) => compared.has(instance))
        .map((answer) => answer.cost(column) ?? (answer.solved ? null : orNothing))
        .filter((value) => value !== null);
}

const kLeastInCommon = 8;

/**
 * Planners that are compared all at once, and the instances that all of them solved: see commonCases() of
 * reports/summary/CaseTable.h. No planner where no two have eight instances in common.
 */
export function commonInstances(answers: Answer[]): { planners: string[]; instances: Set<string> } {
    const solved = new Map(
        [...groupBy(answers, ({ planner }) => planner)].map(([planner, own]) => [
            planner,
            new Set(own.filter((answer) => answer.solved).map(({ instance }) => instance)),
        ]),
    );
    const ofAll = (planners: string[]): string[] => {
        const [first, ...others] = planners.map((planner) => solved.get(planner)!);
        return [...(first ?? [])].filter((instance) => others.every((own) => own.has(instance)));
    };
    const count = (planner: string): number => solved.get(planner)!.size;
    const most = Math.max(0, ...[...solved.values()].map(({ size }) => size));
    let planners = [...solved.keys()].filter((planner) => count(planner) > 0 && 2 * count(planner) >= most);
    while (planners.length > 1 && ofAll(planners).length < kLeastInCommon) {
        const without = (planner: string): string[] => planners.filter((other) => other !== planner);
        const [worst] = [...planners].sort(
            (a, b) =>
                ofAll(without(b)).length - ofAll(without(a)).length ||
                count(a) - count(b) ||
                planners.indexOf(b) - planners.indexOf(a),
        );
        planners = without(worst);
    }
    if (planners.length === 1 && solved.size > 1) planners = [];
    return { planners, instances: new Set(ofAll(planners)) };
}
