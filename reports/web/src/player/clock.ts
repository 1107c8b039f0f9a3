// The time of the player, in steps, and whether it runs.

export class Clock {
    time = 0;
    length = 0;
    speed = 2; // steps a second
    private running = false;
    private last = 0;
    private frame = 0;

    /** \param onTick told after every change of the time while it runs, and when it stops */
    constructor(private readonly onTick: () => void) {}

    get isRunning(): boolean {
        return this.running;
    }

    start(): void {
        if (this.running || this.length === 0) return;
        if (this.time >= this.length) this.time = 0;
        this.running = true;
        this.last = performance.now();
        this.frame = requestAnimationFrame((now) => this.tick(now));
    }

    stop(): void {
        if (!this.running) return;
        this.running = false;
        cancelAnimationFrame(this.frame);
        this.onTick();
    }

    seek(time: number): void {
        this.time = Math.min(Math.max(time, 0), this.length);
    }

    private tick(now: number): void {
        if (!this.running) return;
        this.seek(this.time + (Math.max(now - this.last, 0) / 1000) * this.speed);
        this.last = now;
        if (this.time >= this.length) {
            this.stop();
            return;
        }
        this.onTick();
        this.frame = requestAnimationFrame((next) => this.tick(next));
    }
}
