// What the page carries: a description at once, everything else unpacked when it is asked for.
import { fromBase64, inflate } from "./bytes";
import { type Graph, unpackGraph } from "./graph";
import { type Steps, unpackRobots, unpackSolution } from "./solution";

export interface PlannerStyle {
    name: string;
    color: string;
    dashes: string; // gnuplot's: "solid", "(12,5)"
    marker: number; // gnuplot's filled point types 5, 7, 9, 11, 13, 15
}

export interface Playable {
    run: number;
    case: number;
    sequential: boolean;
    optimized: boolean;
}

interface Description {
    title: string;
    facts: string[];
    provenance: [string, string][];
    plan: string;
    planners: PlannerStyle[];
    runCount: number;
    cases: { name: string; graph: number; robots: number }[];
    playable: Playable[];
    robotColors: string[];
}

interface TextData {
    texts: string[];
    rows: number[];
}

/** A column of the results: numbers (null: there is none), or texts. */
export interface Column {
    name: string;
    title: string;
    unit: string;
    help: string;
    lowerIsBetter: boolean;
    numbers: (number | null)[] | null;
    texts: string[]; // the distinct ones, where numbers is null
    rows: number[]; // which of them each run has
}

export interface Case {
    name: string;
    graph: Graph;
    starts: Uint32Array;
    goals: Uint32Array;
}

export class Runs {
    readonly columns: Column[];
    private readonly byName = new Map<string, Column>();

    constructor(
        readonly count: number,
        data: { columns: (Partial<Column> & { name: string })[]; absences: TextData },
    ) {
        this.columns = data.columns.map((column) => ({
            title: column.name.charAt(0).toUpperCase() + column.name.slice(1).replaceAll("_", " "),
            unit: "",
            help: "",
            lowerIsBetter: true,
            numbers: null,
            texts: [],
            rows: [],
            ...column,
        }));
        for (const column of this.columns) this.byName.set(column.name, column);
        this.absences = data.absences;
    }

    private readonly absences: TextData;

    column(name: string): Column {
        const column = this.byName.get(name);
        if (!column) throw new RangeError(`there is no column ${name}`);
        return column;
    }

    has(name: string): boolean {
        return this.byName.has(name);
    }

    number(name: string, run: number): number | null {
        return this.column(name).numbers?.[run] ?? null;
    }

    text(name: string, run: number): string {
        return textOf(this.column(name), run);
    }

    /** Why the run cannot be played; empty where it can. */
    absence(run: number): string {
        return this.absences.texts[this.absences.rows[run]] ?? "";
    }
}

export function textOf(column: Column, run: number): string {
    if (!column.numbers) return column.texts[column.rows[run]];
    const number = column.numbers[run];
    return number === null ? "" : String(number);
}

/** The columns that are numbers of which some run has any. */
export function numericColumns(runs: Runs): Column[] {
    return runs.columns.filter((column) => column.numbers?.some((number) => number !== null));
}

export class Campaign {
    readonly about: Description;
    private readonly graphs = new Map<number, Promise<Graph>>();
    private readonly playableOfRun = new Map<number, number>();

    constructor(private readonly block: (id: string) => string) {
        this.about = JSON.parse(block("explorer")) as Description;
        this.about.playable.forEach((playable, i) => this.playableOfRun.set(playable.run, i));
    }

    static ofDocument(): Campaign {
        return new Campaign((id) => {
            const element = document.getElementById(id);
            if (!element) throw new RangeError(`the page has no ${id}`);
            return element.textContent ?? "";
        });
    }

    /** Whether the page is about a campaign, not about single solutions. */
    get hasPlan(): boolean {
        return this.about.plan !== "";
    }

    async runs(): Promise<Runs> {
        const text = new TextDecoder().decode(await this.unpacked("runs"));
        return new Runs(this.about.runCount, JSON.parse(text));
    }

    /** Index of the run among those that can be played, or −1. */
    playableIndex(run: number): number {
        return this.playableOfRun.get(run) ?? -1;
    }

    async case(index: number): Promise<Case> {
        const { name, graph } = this.about.cases[index];
        let unpacking = this.graphs.get(graph);
        if (!unpacking) {
            unpacking = this.unpacked(`graph${graph}`).then(unpackGraph);
            this.graphs.set(graph, unpacking);
        }
        const robots = unpackRobots(await this.unpacked(`case${index}`));
        return { name, graph: await unpacking, ...robots };
    }

    async solution(playable: number, optimized: boolean): Promise<Steps> {
        return unpackSolution(await this.unpacked(`${optimized ? "optimized" : "solution"}${playable}`));
    }

    private async unpacked(id: string): Promise<Uint8Array> {
        return inflate(fromBase64(this.block(id)));
    }
}
