// Values as people read them.
import type { Column, Runs } from "../data/campaign";
import { textOf } from "../data/campaign";

export function formatNumber(value: number): string {
    if (Number.isInteger(value))
        return Math.abs(value) < 10_000
            ? String(value)
            : value.toLocaleString("en").replaceAll(",", "\u2009");
    return String(Number(value.toPrecision(4)));
}

/** Seconds with a unit that keeps the number short. */
export function formatSeconds(seconds: number): string {
    const units: [number, string][] = [
        [60, "min"],
        [1, "s"],
        [1e-3, "ms"],
        [1e-6, "µs"],
    ];
    const [size, unit] = units.find(([least]) => seconds >= least * (least === 60 ? 2 : 1)) ?? [1e-6, "µs"];
    return `${formatNumber(seconds / size)} ${unit}`;
}

export function formatCell(column: Column, run: number): string {
    const number = column.numbers?.[run];
    if (column.numbers === null) return textOf(column, run);
    if (number === null || number === undefined) return "";
    return column.unit === "s" ? formatSeconds(number) : formatNumber(number);
}

/** "Path length (moves)". */
export function columnTitle(column: Column): string {
    const isSaid = column.unit === "" || column.title.toLowerCase().startsWith(column.unit);
    return isSaid ? column.title : `${column.title} (${column.unit})`;
}

export function runName(runs: Runs, run: number): string {
    return `${runs.text("planner", run)} on ${runs.text("case", run)}`;
}

/** A class of style.css for each way in which a run ends. */
export function statusClass(status: string): string {
    const known = [
        "solved",
        "partial",
        "gave_up",
        "timeout",
        "memory_limit",
        "crash",
        "invalid",
        "infeasible",
        "unsupported",
    ];
    return `status-${known.includes(status) ? status : "other"}`;
}
