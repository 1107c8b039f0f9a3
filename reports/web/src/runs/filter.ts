// Which runs are shown, in which order. Numbers take comparisons (>10, <=0.5, 10..20, =3), texts take words.
import type { Column, Runs } from "../data/campaign";

export interface Order {
    column: string;
    isDescending: boolean;
}

type Test = (run: number) => boolean;

const kNumber = "(-?\\d+(?:\\.\\d+)?(?:e-?\\d+)?)";
const kComparison = new RegExp(`^(<=|>=|<|>|=|!=)\\s*${kNumber}$`, "i");
const kRange = new RegExp(`^${kNumber}?\\s*\\.\\.\\s*${kNumber}?$`, "i");

/** What a filter asks of a column; null where it asks for nothing. Case does not matter. */
export function columnTest(column: Column, filter: string): Test | null {
    const text = filter.trim().toLowerCase();
    if (text === "") return null;
    return column.numbers ? numberTest(column.numbers, text) : textTest(column, text);
}

function numberTest(numbers: (number | null)[], text: string): Test {
    const compared = text.match(kComparison);
    if (compared) {
        const limit = Number(compared[2]);
        const holds = {
            "<": (value: number) => value < limit,
            "<=": (value: number) => value <= limit,
            ">": (value: number) => value > limit,
            ">=": (value: number) => value >= limit,
            "=": (value: number) => value === limit,
            "!=": (value: number) => value !== limit,
        }[compared[1]]!;
        return (run) => numbers[run] !== null && holds(numbers[run]!);
    }
    const range = text.match(kRange);
    if (range) {
        const least = range[1] === undefined ? -Infinity : Number(range[1]);
        const most = range[2] === undefined ? Infinity : Number(range[2]);
        return (run) => numbers[run] !== null && numbers[run]! >= least && numbers[run]! <= most;
    }
    const exact = Number(text);
    if (!Number.isNaN(exact)) return (run) => numbers[run] === exact;
    return (run) => String(numbers[run] ?? "").includes(text);
}

/** Each distinct text is looked at once. */
function textTest(column: Column, text: string): Test {
    const isNegated = text.startsWith("!") && text.length > 1;
    const word = isNegated ? text.slice(1) : text;
    const holds = column.texts.map((candidate) => candidate.toLowerCase().includes(word) !== isNegated);
    return (run) => holds[column.rows[run]];
}

/** Every word must stand in some text of the run. */
export function searchTest(runs: Runs, search: string): Test | null {
    const words = search.trim().toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length === 0) return null;
    const columns = runs.columns.filter((column) => !column.numbers);
    const found = words.map((word) =>
        columns.map((column) => ({
            rows: column.rows,
            holds: column.texts.map((text) => text.toLowerCase().includes(word)),
        })),
    );
    return (run) => found.every((of) => of.some(({ rows, holds }) => holds[rows[run]]));
}

/** The runs that pass all tests, in their order or by a column; empty cells come last. */
export function selectRuns(runs: Runs, tests: (Test | null)[], order: Order | null): Uint32Array {
    const active = tests.filter((test) => test !== null);
    const selected = new Uint32Array(runs.count);
    let count = 0;
    for (let run = 0; run < runs.count; ++run) if (active.every((test) => test(run))) selected[count++] = run;
    const result = selected.slice(0, count);
    if (!order || !runs.has(order.column)) return result;
    const keys = sortKeys(runs.column(order.column), runs.count);
    const sign = order.isDescending ? -1 : 1;
    return result.sort((a, b) => {
        if (keys[a] === keys[b]) return a - b;
        if (Number.isNaN(keys[a]) || Number.isNaN(keys[b]))
            return Number.isNaN(keys[a]) ? (Number.isNaN(keys[b]) ? a - b : 1) : -1;
        return sign * (keys[a] - keys[b]);
    });
}

/** Numbers by which runs are put in order; not a number where the cell is empty. */
function sortKeys(column: Column, count: number): Float64Array {
    const keys = new Float64Array(count);
    if (column.numbers) {
        for (let run = 0; run < count; ++run) keys[run] = column.numbers[run] ?? NaN;
        return keys;
    }
    const compare = new Intl.Collator("en", { numeric: true }).compare;
    const order = column.texts.map((_, i) => i).sort((a, b) => compare(column.texts[a], column.texts[b]));
    const places = new Float64Array(column.texts.length);
    order.forEach((text, place) => (places[text] = column.texts[text] === "" ? NaN : place));
    for (let run = 0; run < count; ++run) keys[run] = places[column.rows[run]];
    return keys;
}
