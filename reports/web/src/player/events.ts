// What is worth a look: conflicts, which no motion rule allows, and rotations, closed cycles of robots that
// turn at once.
import { type Graph, hasEdge } from "../data/graph";
import type { Steps } from "../data/solution";

export interface Event {
    step: number;
    kind: "conflict" | "rotation";
    robots: number[];
    text: string;
}

const kNobody = -1;
export const kMostEvents = 100_000;

export function findEvents(graph: Graph, starts: Uint32Array, steps: Steps): Event[] {
    return new Replay(graph, starts, steps).events;
}

class Replay {
    readonly events: Event[] = [];
    private readonly places: Uint32Array; // of each robot
    private readonly occupant: Int32Array; // of each vertex
    private readonly moveOf: Int32Array; // each robot's in this step, or −1

    constructor(
        private readonly graph: Graph,
        starts: Uint32Array,
        private readonly steps: Steps,
    ) {
        this.places = starts.slice();
        this.occupant = new Int32Array(graph.vertexCount).fill(kNobody);
        starts.forEach((vertex, robot) => (this.occupant[vertex] = robot));
        this.moveOf = new Int32Array(starts.length).fill(kNobody);
        let first = 0;
        for (let step = 0; step < steps.ends.length && this.events.length < kMostEvents; ++step) {
            this.replay(step, first, steps.ends[step]);
            first = steps.ends[step];
        }
    }

    private replay(step: number, first: number, end: number): void {
        const { robots, from, to } = this.steps;
        for (let i = first; i < end; ++i) this.checkAlone(step, i);
        for (let i = first; i < end; ++i) this.checkSwap(step, i);
        if (end - first > 2) this.findRotations(step, first, end);

        for (let i = first; i < end; ++i)
            if (this.occupant[from[i]] === robots[i]) this.occupant[from[i]] = kNobody;
        for (let i = first; i < end; ++i) {
            const other = this.occupant[to[i]];
            if (other !== kNobody && other !== robots[i])
                this.conflict(
                    step,
                    [other, robots[i]],
                    `robots ${other} and ${robots[i]} are both on vertex ${to[i]}`,
                );
            this.occupant[to[i]] = robots[i];
            this.places[robots[i]] = to[i];
        }
        for (let i = first; i < end; ++i) this.moveOf[robots[i]] = kNobody;
    }

    /** A move by itself: its robot is there, has one move a step, and goes along an edge. */
    private checkAlone(step: number, i: number): void {
        const robot = this.steps.robots[i];
        const from = this.steps.from[i];
        const to = this.steps.to[i];
        if (this.moveOf[robot] !== kNobody)
            this.conflict(step, [robot], `robot ${robot} moves twice in one step`);
        this.moveOf[robot] = i;
        if (this.places[robot] !== from)
            this.conflict(step, [robot], `robot ${robot} is on vertex ${this.places[robot]}, not on ${from}`);
        else if (!hasEdge(this.graph, from, to))
            this.conflict(step, [robot], `robot ${robot} goes from ${from} to ${to}, where no edge is`);
    }

    private checkSwap(step: number, i: number): void {
        const robot = this.steps.robots[i];
        const other = this.occupant[this.steps.to[i]];
        if (other === kNobody || other <= robot || this.moveOf[other] === kNobody) return;
        if (this.steps.to[this.moveOf[other]] === this.steps.from[i])
            this.conflict(step, [robot, other], `robots ${robot} and ${other} swap along an edge`);
    }

    /** Each robot's target is held by the next one, until the first comes round again. */
    private findRotations(step: number, first: number, end: number): void {
        const seen = new Set<number>();
        for (let i = first; i < end; ++i) {
            const cycle: number[] = [];
            let robot = this.steps.robots[i];
            while (robot !== kNobody && this.moveOf[robot] !== kNobody && !seen.has(robot)) {
                seen.add(robot);
                cycle.push(robot);
                robot = this.occupant[this.steps.to[this.moveOf[robot]]];
            }
            const start = cycle.indexOf(robot);
            if (start < 0 || cycle.length - start < 3) continue;
            const robots = cycle.slice(start);
            this.events.push({
                step,
                kind: "rotation",
                robots,
                text: `robots ${robots.slice(0, 8).join(", ")}${robots.length > 8 ? ", …" : ""} turn in a cycle`,
            });
        }
    }

    private conflict(step: number, robots: number[], text: string): void {
        this.events.push({ step, kind: "conflict", robots, text });
    }
}
