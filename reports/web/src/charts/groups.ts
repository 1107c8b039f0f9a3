// Runs summed up as reports/Aggregate.h does it: quartiles over the solved runs, beside how many they stand
// for.

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
        return sorted[below] + (position - below) * (sorted[above] - sorted[below]);
    };
    return { low: quantile(0.25), median: quantile(0.5), high: quantile(0.75), count: values.length };
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
