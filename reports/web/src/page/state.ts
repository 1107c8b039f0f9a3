// What is shown, kept in the address after #, so that a view can be linked and the way back works.

export type View = "overview" | "charts" | "runs" | "player";

export class State {
    private parameters: URLSearchParams;
    private written = 0; // when, in milliseconds
    private pending: ReturnType<typeof setTimeout> | undefined;
    private readonly listeners: ((changed: Set<string>) => void)[] = [];

    constructor(private readonly place: Location | { hash: string } = location) {
        this.parameters = State.parse(place.hash);
    }

    private static parse(hash: string): URLSearchParams {
        return new URLSearchParams(hash.replace(/^#/, ""));
    }

    get(key: string, otherwise: string): string {
        return this.parameters.get(key) ?? otherwise;
    }

    number(key: string, otherwise: number): number {
        const value = Number(this.parameters.get(key) ?? NaN);
        return Number.isFinite(value) ? value : otherwise;
    }

    flag(key: string, otherwise: boolean): boolean {
        const value = this.parameters.get(key);
        return value === null ? otherwise : value === "1";
    }

    list(key: string): string[] | null {
        const value = this.parameters.get(key);
        return value === null ? null : value === "" ? [] : value.split("~");
    }

    /** Takes new values; null takes one away. Tells the listeners which have changed. */
    set(values: Record<string, string | number | boolean | string[] | null>, isStep = false): void {
        const changed = new Set<string>();
        for (const [key, value] of Object.entries(values)) {
            const text =
                value === null
                    ? null
                    : Array.isArray(value)
                      ? value.join("~")
                      : typeof value === "boolean"
                        ? value
                            ? "1"
                            : "0"
                        : String(value);
            if (text === this.parameters.get(key)) continue;
            changed.add(key);
            if (text === null) this.parameters.delete(key);
            else this.parameters.set(key, text);
        }
        if (changed.size === 0) return;
        this.write(isStep);
        for (const listener of this.listeners) listener(changed);
    }

    /** Browsers bear few changes of the address a second: the last of a quick series is written later. */
    private write(isStep: boolean): void {
        const kPause = 100; // milliseconds
        const wait = isStep ? 0 : this.written + kPause - Date.now();
        if (wait > 0) {
            this.pending ??= setTimeout(() => this.write(false), wait);
            return;
        }
        clearTimeout(this.pending);
        this.pending = undefined;
        this.written = Date.now();
        const hash = `#${this.parameters.toString()}`;
        if (typeof history === "undefined") this.place.hash = hash;
        else if (isStep) history.pushState(null, "", hash);
        else history.replaceState(null, "", hash);
    }

    /** The address has changed from outside: a link, or the way back. */
    reread(): void {
        clearTimeout(this.pending);
        this.pending = undefined;
        const old = this.parameters;
        this.parameters = State.parse(this.place.hash);
        const changed = new Set<string>();
        for (const key of new Set([...old.keys(), ...this.parameters.keys()]))
            if (old.get(key) !== this.parameters.get(key)) changed.add(key);
        if (changed.size > 0) for (const listener of this.listeners) listener(changed);
    }

    onChange(listener: (changed: Set<string>) => void): void {
        this.listeners.push(listener);
    }
}
