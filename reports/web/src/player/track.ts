// A run's solution in one of the ways in which it can be watched, with all that is known about it.
import type { Campaign, Case, Playable } from "../data/campaign";
import type { Steps } from "../data/solution";
import { condense } from "./condense";
import { type Event, findEvents } from "./events";
import { type Measures, measureSteps, traffic, waiting } from "./measures";
import { Timeline } from "./timeline";

export type Kind = "steps" | "moves" | "optimized-steps" | "optimized-moves";

export const kKindNames: Record<Kind, string> = {
    steps: "condensed",
    moves: "one after another",
    "optimized-steps": "optimized, condensed",
    "optimized-moves": "optimized, one after another",
};

export function kindsOf(playable: Playable): Kind[] {
    if (!playable.sequential) return ["steps"];
    return playable.optimized ? ["steps", "moves", "optimized-steps", "optimized-moves"] : ["steps", "moves"];
}

export function kindName(kind: Kind, playable: Playable): string {
    return playable.sequential ? kKindNames[kind] : "as given";
}

export interface Heat {
    values: Float64Array; // a number a vertex
    most: number;
}

export class Track {
    readonly timeline: Timeline;
    readonly measures: Measures;
    private foundEvents: Event[] | null = null;
    private readonly heats = new Map<string, Heat>();

    constructor(
        readonly playable: Playable,
        readonly kind: Kind,
        readonly instance: Case,
        readonly steps: Steps,
    ) {
        this.timeline = new Timeline(instance.starts, steps);
        this.measures = measureSteps(instance, steps);
    }

    static async load(campaign: Campaign, index: number, kind: Kind): Promise<Track> {
        const playable = campaign.about.playable[index];
        const instance = await campaign.case(playable.case);
        const solution = await campaign.solution(index, kind.startsWith("optimized"));
        const steps =
            playable.sequential && kind.endsWith("steps")
                ? condense(solution, instance.graph.vertexCount, instance.starts.length)
                : solution;
        return new Track(playable, kind, instance, steps);
    }

    get length(): number {
        return this.timeline.length;
    }

    /** In the order of steps. Found when they are asked for first. */
    get events(): Event[] {
        this.foundEvents ??= findEvents(this.instance.graph, this.instance.starts, this.steps);
        return this.foundEvents;
    }

    /** The first event that begins after a time, or the last before it. */
    nextEvent(time: number, direction: 1 | -1): Event | null {
        const shownAt = (event: Event): number => event.step + kEventShare;
        const later = this.events.filter((event) => direction * (shownAt(event) - time) > 1e-6);
        return later[direction === 1 ? 0 : later.length - 1] ?? null;
    }

    heat(kind: string): Heat | null {
        if (kind !== "traffic" && kind !== "waiting") return null;
        let heat = this.heats.get(kind);
        if (!heat) {
            const values =
                kind === "traffic"
                    ? traffic(this.instance.graph.vertexCount, this.steps)
                    : waiting(this.instance, this.steps);
            heat = { values, most: values.reduce((most, value) => Math.max(most, value), 1) };
            this.heats.set(kind, heat);
        }
        return heat;
    }
}

/** How far into its step an event is looked at: half-way along the edges. */
export const kEventShare = 0.5;
