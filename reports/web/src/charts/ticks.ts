// Where a logarithmic axis has its lines and numbers.

/** Powers of ten and, on short axes, their multiples, all between two positive numbers. */
export function logarithmicTicks(min: number, max: number): number[] {
    const decades = Math.log10(max / min);
    const multiples = decades > 8 ? [1] : [1, 2, 3, 4, 5, 6, 7, 8, 9];
    const ticks: number[] = [];
    for (let exponent = Math.floor(Math.log10(min)); exponent <= Math.log10(max); ++exponent)
        for (const multiple of multiples) {
            const tick = Number(`${multiple}e${exponent}`);
            if (tick >= min && tick <= max) ticks.push(tick);
        }
    return ticks;
}

/** The ticks that have numbers, at most so many: the others become null. */
export function labelled(ticks: number[], most: number): (number | null)[] {
    const beginning = (tick: number): string => tick.toExponential()[0];
    for (const kept of ["123456789", "1235", "125", "1"]) {
        const chosen = ticks.map((tick) => (kept.includes(beginning(tick)) ? tick : null));
        if (chosen.filter((tick) => tick !== null).length <= most) return chosen;
    }
    const powers = ticks.filter((tick) => beginning(tick) === "1");
    const every = Math.ceil(powers.length / most);
    const chosen = powers.filter((_, i) => i % every === 0);
    return ticks.map((tick) => (chosen.includes(tick) ? tick : null));
}
