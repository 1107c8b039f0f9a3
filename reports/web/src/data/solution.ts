// Solutions as framework/store/SolutionCodec.h packs them: moves in order, cut into steps of moves that
// happen at once (an action of one move, or a rotation).
import { ByteReader } from "./bytes";

export interface Steps {
    robots: Uint32Array; // of each move
    from: Uint32Array;
    to: Uint32Array;
    ends: Uint32Array; // of each step: the index behind its last move
}

const kFormat = 1;

export function unpackSolution(bytes: Uint8Array): Steps {
    const reader = new ByteReader(bytes);
    if (reader.byte() !== kFormat) throw new RangeError("the solution has an unknown format");
    const moveCount = reader.number();
    const groupCount = reader.number();
    const robots = new Uint32Array(moveCount);
    const from = new Uint32Array(moveCount);
    const to = new Uint32Array(moveCount);

    const ends: number[] = [];
    let end = 0;
    for (let group = 0; group < groupCount; ++group) {
        const first = end + reader.number();
        while (end < first) ends.push(++end);
        end = first + reader.number();
        ends.push(end);
    }
    while (end < moveCount) ends.push(++end);

    const places = new Map<number, number>();
    let robot = 0;
    for (let i = 0; i < moveCount; ++i) {
        robots[i] = robot = reader.difference(robot);
        from[i] = reader.difference(places.get(robot) ?? 0);
        to[i] = reader.difference(from[i]);
        places.set(robot, to[i]);
    }
    return { robots, from, to, ends: Uint32Array.from(ends) };
}

export function unpackRobots(bytes: Uint8Array): { starts: Uint32Array; goals: Uint32Array } {
    const reader = new ByteReader(bytes);
    const count = reader.number();
    const list = (): Uint32Array => {
        const places = new Uint32Array(count);
        let previous = 0;
        for (let i = 0; i < count; ++i) places[i] = previous = reader.difference(previous);
        return places;
    };
    return { starts: list(), goals: list() };
}
