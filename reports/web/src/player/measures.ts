// How a solution goes on: robots at their goals, robots that move, the occupancy of a part of the graph.
import type { Case } from "../data/campaign";
import type { Steps } from "../data/solution";

export interface Measures {
    atGoal: Uint32Array; // robots at their goals after 0, 1, … steps
    moving: Uint32Array; // moves in each step
}

export function measureSteps({ starts, goals }: Case, steps: Steps): Measures {
    const length = steps.ends.length;
    const atGoal = new Uint32Array(length + 1);
    const moving = new Uint32Array(length);
    let arrived = 0;
    const isThere = new Uint8Array(starts.length);
    for (let robot = 0; robot < starts.length; ++robot)
        arrived += isThere[robot] = starts[robot] === goals[robot] ? 1 : 0;
    atGoal[0] = arrived;
    let i = 0;
    for (let step = 0; step < length; ++step) {
        moving[step] = steps.ends[step] - i;
        for (; i < steps.ends[step]; ++i) {
            const robot = steps.robots[i];
            const now = steps.to[i] === goals[robot] ? 1 : 0;
            arrived += now - isThere[robot];
            isThere[robot] = now;
        }
        atGoal[step + 1] = arrived;
    }
    return { atGoal, moving };
}

/** Robots on the marked vertices after 0, 1, … steps. */
export function countInside({ starts }: Case, steps: Steps, isInside: Uint8Array): Uint32Array {
    const counts = new Uint32Array(steps.ends.length + 1);
    let inside = 0;
    for (const vertex of starts) inside += isInside[vertex];
    counts[0] = inside;
    let i = 0;
    for (let step = 0; step < steps.ends.length; ++step) {
        for (; i < steps.ends[step]; ++i) inside += isInside[steps.to[i]] - isInside[steps.from[i]];
        counts[step + 1] = inside;
    }
    return counts;
}

/** How often each vertex is entered. */
export function traffic(vertexCount: number, steps: Steps): Float64Array {
    const heat = new Float64Array(vertexCount);
    for (const vertex of steps.to) ++heat[vertex];
    return heat;
}

/** For how many steps robots stand on each vertex and will go on; the rest at the end does not count. */
export function waiting({ starts, graph }: Case, steps: Steps): Float64Array {
    const heat = new Float64Array(graph.vertexCount);
    const since = new Float64Array(starts.length); // the step in which the robot's waiting began
    let i = 0;
    for (let step = 0; step < steps.ends.length; ++step)
        for (; i < steps.ends[step]; ++i) {
            heat[steps.from[i]] += step - since[steps.robots[i]];
            since[steps.robots[i]] = step + 1;
        }
    return heat;
}
