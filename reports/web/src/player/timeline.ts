// Where each robot is at any time, found without replaying: scrubbing costs what one frame costs.
import type { Steps } from "../data/solution";

/** On the way from one vertex to another; both are the same where the robot stands. */
export interface Position {
    from: number;
    to: number;
    share: number; // of the way, 0 … 1
}

export class Timeline {
    readonly length: number; // steps
    private readonly offsets: Uint32Array; // each robot's part of times and places
    private readonly times: Uint32Array; // the steps in which it moves, ascending
    private readonly places: Uint32Array; // and where to

    constructor(
        private readonly starts: Uint32Array,
        steps: Steps,
    ) {
        this.length = steps.ends.length;
        this.offsets = new Uint32Array(starts.length + 1);
        for (const robot of steps.robots) ++this.offsets[robot + 1];
        for (let robot = 0; robot < starts.length; ++robot) this.offsets[robot + 1] += this.offsets[robot];
        this.times = new Uint32Array(steps.robots.length);
        this.places = new Uint32Array(steps.robots.length);
        const next = this.offsets.slice(0, starts.length);
        let i = 0;
        for (let step = 0; step < this.length; ++step)
            for (; i < steps.ends[step]; ++i) {
                const place = next[steps.robots[i]]++;
                this.times[place] = step;
                this.places[place] = steps.to[i];
            }
    }

    get robotCount(): number {
        return this.starts.length;
    }

    /** At a time from 0 to length: whole numbers are between steps. */
    at(robot: number, time: number): Position {
        const step = Math.floor(time);
        const done = this.movesBefore(robot, step);
        const from = this.placeAfter(robot, done);
        const isMoving = done < this.offsets[robot + 1] && this.times[done] === step && time > step;
        return isMoving ? { from, to: this.places[done], share: time - step } : { from, to: from, share: 0 };
    }

    /** The vertices that a robot stood on last, the present one first, at most so many. */
    trail(robot: number, time: number, count: number): number[] {
        const done = this.movesBefore(robot, Math.floor(time));
        const vertices: number[] = [];
        for (let i = done; i >= this.offsets[robot] && vertices.length < count; --i)
            vertices.push(this.placeAfter(robot, i));
        return vertices;
    }

    /** Index behind the robot's last move in a step before this one. */
    private movesBefore(robot: number, step: number): number {
        let low = this.offsets[robot];
        let high = this.offsets[robot + 1];
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.times[middle] < step) low = middle + 1;
            else high = middle;
        }
        return low;
    }

    private placeAfter(robot: number, moves: number): number {
        return moves === this.offsets[robot] ? this.starts[robot] : this.places[moves - 1];
    }
}
