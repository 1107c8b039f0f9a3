// From moves one after another to steps, as framework/evaluation/Condense.h does it under the rule
// `following`: every move starts as early as its robot's own moves and the earlier visits of its target
// allow.
import type { Steps } from "../data/solution";

export function condense(solution: Steps, vertexCount: number, robotCount: number): Steps {
    const ready = new Uint32Array(robotCount); // the first step in which the robot can move
    const open = new Uint32Array(vertexCount); // the first step in which the vertex can be entered
    const stepOf = new Uint32Array(solution.robots.length);
    let makespan = 0;
    let first = 0;
    for (const end of solution.ends) {
        let step = 0;
        for (let i = first; i < end; ++i)
            step = Math.max(step, ready[solution.robots[i]], open[solution.to[i]]);
        for (let i = first; i < end; ++i) {
            ready[solution.robots[i]] = step + 1;
            open[solution.from[i]] = step;
            stepOf[i] = step;
        }
        if (end > first) makespan = Math.max(makespan, step + 1);
        first = end;
    }
    return sortedBySteps(solution, stepOf, makespan);
}

function sortedBySteps(solution: Steps, stepOf: Uint32Array, makespan: number): Steps {
    const ends = new Uint32Array(makespan);
    for (const step of stepOf) ++ends[step];
    let begin = 0;
    for (let step = 0; step < makespan; ++step) {
        const size = ends[step];
        ends[step] = begin; // where the step begins; its end once its moves are placed
        begin += size;
    }
    const count = stepOf.length;
    const steps = {
        robots: new Uint32Array(count),
        from: new Uint32Array(count),
        to: new Uint32Array(count),
        ends,
    };
    for (let i = 0; i < count; ++i) {
        const place = ends[stepOf[i]]++;
        steps.robots[place] = solution.robots[i];
        steps.from[place] = solution.from[i];
        steps.to[place] = solution.to[i];
    }
    return steps;
}
