/**
 * How many times as long this machine takes as those on which the limits of processor time were set, by a walk
 * through 4 MB in random order; 1 … 4, so that it excuses no defect. The same as tests/support/CpuClock.h.
 */
export function slowness(): number {
    const usual = 0.08; // seconds
    const cells = 1 << 20;
    const next = Uint32Array.from({ length: cells }, (_, i) => i);
    const begin = process.cpuUsage();
    let state = 1;
    for (let i = cells - 1; i > 0; --i) {
        // One cycle through all (S. Sattolo, 1986); numbers by G. Marsaglia's xorshift.
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        const j = (state >>> 0) % i;
        [next[i], next[j]] = [next[j], next[i]];
    }
    let at = 0;
    for (let i = 0; i < cells; ++i) at = next[at];
    const { user, system } = process.cpuUsage(begin);
    const taken = at === 0 ? (user + system) / 1e6 : usual;
    return Math.min(4, Math.max(1, taken / usual));
}
