// Order statistics as framework/statistics/Quantiles.h has them. An infinite value stands for no answer.

export interface Quartiles {
    low: number;
    median: number;
    high: number;
    count: number;
}

/** By linear interpolation between order statistics. Null for an empty sample. */
export function quartiles(values: number[]): Quartiles | null {
    if (values.length === 0) return null;
    const sorted = [...values].sort((a, b) => a - b);
    const quantile = (share: number): number => {
        const position = share * (sorted.length - 1);
        const below = Math.floor(position);
        const above = Math.min(below + 1, sorted.length - 1);
        if (position === below || sorted[above] === sorted[below]) return sorted[below]; // ∞ − ∞ is no number
        return sorted[below] + (position - below) * (sorted[above] - sorted[below]);
    };
    return { low: quantile(0.25), median: quantile(0.5), high: quantile(0.75), count: values.length };
}

/** What may be shown of values of which some are infinite: the median while it is finite, quartiles of five or more. */
export interface Middle {
    low: number | null;
    median: number;
    high: number | null;
}

export function middleOf(values: number[]): Middle | null {
    const summary = quartiles(values);
    if (!summary || !Number.isFinite(summary.median)) return null;
    const kLeastForBand = 5;
    const hasBand = summary.count >= kLeastForBand && Number.isFinite(summary.high);
    return {
        low: hasBand ? summary.low : null,
        median: summary.median,
        high: hasBand ? summary.high : null,
    };
}

export function groupBy<Item, Key>(items: Iterable<Item>, keyOf: (item: Item) => Key): Map<Key, Item[]> {
    const groups = new Map<Key, Item[]>();
    for (const item of items) {
        const key = keyOf(item);
        const group = groups.get(key);
        if (group) group.push(item);
        else groups.set(key, [item]);
    }
    return groups;
}
