// The player's picture in words: what a screen reader says, and what can be read off exactly.
import type { Track } from "./track";

export function describeTime(track: Track, time: number, followed: number): string {
    const step = Math.floor(time);
    const robots = track.instance.starts.length;
    const parts = [
        `Step ${step} of ${track.length}`,
        `${track.measures.atGoal[step]} of ${robots} robots at their goals`,
        `${step < track.length ? track.measures.moving[step] : 0} move next`,
    ];
    if (followed >= 0 && followed < robots) {
        const { from, to, share } = track.timeline.at(followed, time);
        const goal = track.instance.goals[followed];
        const place =
            from === to
                ? `on vertex ${from}`
                : `${Math.round(share * 100)} % of the way from vertex ${from} to ${to}`;
        parts.push(
            `robot ${followed} is ${place}${from === to && from === goal ? ", its goal" : `, its goal is ${goal}`}`,
        );
    }
    return `${parts.join(", ")}.`;
}

export function counted(count: number, thing: string): string {
    return `${count} ${thing}${count === 1 ? "" : "s"}`;
}
