// The player: one or more solutions of a case side by side, in step, with everything that steers them.
import type { Campaign, Runs } from "../data/campaign";
import { button, choice, el, setOptions } from "../page/dom";
import type { State } from "../page/state";
import type { Theme } from "../page/theme";
import { Clock } from "./clock";
import { Exporter } from "./exporter";
import { type Control, PlayerControls, heatName, kSpeeds } from "./controls";
import { keyOf } from "./key";
import { Panel } from "./panel";
import { Strip } from "./strip";
import { type Kind, Track, kEventShare, kindName, kindsOf } from "./track";
import type { Marks } from "./view";
import { counted, describeTime } from "./words";

interface Slot {
    panel: Panel;
    index: number; // among what can be played
    kind: Kind;
    element: HTMLElement;
}

export class PlayerView {
    readonly element = el("section", { class: "player", "aria-label": "Player" });
    private readonly clock = new Clock(() => this.onTick());
    private readonly strip: Strip;
    private readonly controls: PlayerControls;
    private readonly exporter: Exporter;
    private readonly row = el("div", { class: "panels" });
    private readonly key = el("p", { class: "legend" });
    private readonly words = el("p", { class: "words", "aria-live": "polite" });
    private readonly readout = el("output", { class: "readout" });
    private readonly caseChoice = choice("Case", [], "", (value) => this.choose(Number(value)));
    private slots: Slot[] = [];
    private marked: number[] = []; // robots of the event that was jumped to
    private markedKind: "conflict" | "rotation" = "conflict";
    private seen: Uint8Array | null = null;
    private isDirty = false;
    private lastWords = 0;
    private loading = 0; // counts what is asked for, so that only the last answer is shown

    constructor(
        private readonly campaign: Campaign,
        private readonly runs: Runs,
        private readonly state: State,
        private theme: Theme,
    ) {
        this.strip = new Strip((share) => this.seek(share * this.clock.length));
        this.controls = new PlayerControls(state, (control) => this.onControl(control));
        this.exporter = new Exporter({
            shown: () => this.slots.map((slot) => ({ panel: slot.panel, caption: this.captionOf(slot) })),
            theme: () => this.theme,
            marks: (i) => this.marks(this.slots[i]),
            name: () => this.caseName(),
            length: () => this.clock.length,
            speed: () => this.clock.speed,
            time: () => this.clock.time,
            drawAt: (time) => {
                this.clock.stop();
                this.clock.seek(time);
                this.drawPanels();
            },
        });
        this.controls.element.append(this.exporter.element);
        this.element.append(
            el(
                "div",
                { class: "bar" },
                this.caseChoice,
                button("+ Compare", "Show another solution beside", () => this.addSlot()),
            ),
            this.row,
            this.strip.canvas,
            this.strip.legend,
            this.key,
            this.controls.element,
            this.words,
            this.readout,
        );
        this.element.addEventListener("keydown", (event) => this.onKey(event));
        new ResizeObserver(() => this.onResize()).observe(this.row);
    }

    /** Shows what the address says: when the view comes into sight, and when the address has changed. */
    async show(): Promise<void> {
        const { playable, cases } = this.campaign.about;
        if (playable.length === 0) {
            this.element.replaceChildren(
                el("p", {}, "No solution is in this page. The plan's key `explorer` says which are."),
            );
            return;
        }
        const wanted = (this.state.list("p") ?? []).map((text) => text.split(":"));
        let slots = wanted
            .map(([index, kind]) => ({ index: Number(index), kind: kind as Kind }))
            .filter(({ index, kind }) => playable[index] && kindsOf(playable[index]).includes(kind));
        if (slots.length === 0) slots = [{ index: 0, kind: "steps" as Kind }];
        const inCase = playable[slots[0].index].case;
        slots = slots.filter(({ index }) => playable[index].case === inCase);
        const options = cases.map(({ name, robots }, i): [string, string] => [
            String(i),
            `${name} (${robots} robots)`,
        ]);
        setOptions(this.caseChoice.querySelector("select")!, options, String(inCase));
        this.controls.reread();

        const isSame =
            slots.length === this.slots.length &&
            slots.every(({ index, kind }, i) => this.slots[i].index === index && this.slots[i].kind === kind);
        if (!isSame) {
            const request = ++this.loading;
            this.clock.stop();
            this.element.setAttribute("aria-busy", "true");
            const tracks = await Promise.all(
                slots.map(({ index, kind }) => Track.load(this.campaign, index, kind)),
            );
            if (request !== this.loading) return;
            this.element.removeAttribute("aria-busy");
            this.fill(slots, tracks);
        }
        if (!this.clock.isRunning) this.seek(this.state.number("t", 0));
    }

    setTheme(theme: Theme): void {
        this.theme = theme;
        this.drawNow();
    }

    /** Out of sight nothing has to move. */
    hide(): void {
        this.clock.stop();
    }

    private fill(slots: { index: number; kind: Kind }[], tracks: Track[]): void {
        while (this.slots.length > slots.length) this.slots.pop()!.element.remove();
        slots.forEach(({ index, kind }, i) => {
            if (!this.slots[i]) this.slots.push(this.makeSlot());
            const slot = this.slots[i];
            slot.index = index;
            slot.kind = kind;
            this.labelSlot(slot, tracks[i], slots.length > 1);
            slot.panel.show(tracks[i]);
        });
        this.clock.length = Math.max(...tracks.map(({ length }) => length));
        this.controls.setLengths(this.clock.length, tracks[0].instance.starts.length);
        this.clock.speed = this.controls.speed(this.clock.length);
        this.onCamera(this.slots[0].panel);
    }

    private makeSlot(): Slot {
        const panel = new Panel(this.campaign.about.robotColors, {
            onCamera: (from) => this.onCamera(from),
            onPick: (robot) => this.state.set({ follow: robot < 0 ? null : robot }),
        });
        const element = el("figure", { class: "panel" }, el("figcaption"), panel.canvas);
        this.row.append(element);
        return { panel, index: 0, kind: "steps", element };
    }

    /** Which solution a panel shows, to be chosen among those of the case. */
    private labelSlot(slot: Slot, track: Track, canBeRemoved: boolean): void {
        const { playable } = this.campaign.about;
        const siblings = playable
            .map((one, i) => ({ one, i }))
            .filter(({ one }) => one.case === track.playable.case);
        const options = siblings.flatMap(({ one, i }) =>
            kindsOf(one).map((kind): [string, string] => [
                `${i}:${kind}`,
                `${this.runName(one.run)}, ${kindName(kind, one)}`,
            ]),
        );
        const select = choice("Solution", options, `${slot.index}:${slot.kind}`, (value) => {
            this.setSlots(
                this.slots.map((other) => (other === slot ? value : `${other.index}:${other.kind}`)),
            );
        });
        const moves = track.steps.robots.length;
        const size = `${counted(moves, "move")} in ${counted(track.length, "step")}`;
        const caption = slot.element.querySelector("figcaption")!;
        caption.replaceChildren(select, el("span", { class: "size" }, size));
        if (canBeRemoved)
            caption.append(
                button("×", "Take this solution away", () =>
                    this.setSlots(
                        this.slots
                            .filter((other) => other !== slot)
                            .map((other) => `${other.index}:${other.kind}`),
                    ),
                ),
            );
        const name = `${this.runName(track.playable.run)}, ${kindName(slot.kind, track.playable)}, ${size}`;
        slot.panel.canvas.setAttribute("aria-label", name);
    }

    private runName(run: number): string {
        const status = this.runs.text("status", run);
        const repetition = this.runs.number("repetition", run) ?? 0;
        const name = this.runs.text("planner", run) + (repetition > 0 ? ` #${repetition}` : "");
        return status === "solved" ? name : `${name} (${status})`;
    }

    private captionOf({ panel, kind }: Slot): string {
        const track = panel.track!;
        const name = `${this.runName(track.playable.run)}, ${kindName(kind, track.playable)}`;
        return `${name}: step ${Math.floor(this.trackTime(track))} of ${track.length}`;
    }

    private caseName(): string {
        return this.campaign.about.cases[this.campaign.about.playable[this.slots[0]?.index ?? 0].case].name;
    }

    private setSlots(slots: string[]): void {
        this.state.set({ p: slots });
    }

    private choose(inCase: number): void {
        const index = this.campaign.about.playable.findIndex((one) => one.case === inCase);
        this.state.set({ p: [`${index}:steps`], t: null, follow: null }, true);
    }

    /** Another solution of the case that is not shown yet. */
    private addSlot(): void {
        const { playable } = this.campaign.about;
        const shown = this.slots.map(({ index, kind }) => `${index}:${kind}`);
        const inCase = playable[this.slots[0].index].case;
        const all = playable.flatMap((one, i) =>
            one.case === inCase ? kindsOf(one).map((kind) => `${i}:${kind}`) : [],
        );
        const order = [...all.filter((key) => key.endsWith(":steps")), ...all];
        const kMost = 4;
        const next = order.find((key) => !shown.includes(key)) ?? shown[0];
        if (shown.length < kMost) this.setSlots([...shown, next]);
    }

    private onControl(control: Control): void {
        const first = this.slots[0]?.panel.track;
        if (!first) return;
        switch (control) {
            case "play":
                if (this.clock.isRunning) this.clock.stop();
                else this.clock.start();
                this.controls.setRunning(this.clock.isRunning);
                break;
            case "first":
                return this.seek(0);
            case "last":
                return this.seek(this.clock.length);
            case "back":
                return this.seek(Math.ceil(this.clock.time) - 1);
            case "forward":
                return this.seek(Math.floor(this.clock.time) + 1);
            case "step":
                return this.seek(this.controls.step);
            case "previous-event":
                return this.jump(first, -1);
            case "next-event":
                return this.jump(first, 1);
            case "fit":
                this.slots.forEach(({ panel }) => panel.fit());
                break;
            case "zoom-in":
                return this.slots[0].panel.zoom(1.5);
            case "zoom-out":
                return this.slots[0].panel.zoom(1 / 1.5);
            case "speed":
                this.clock.speed = this.controls.speed(this.clock.length);
                break;
        }
        this.redraw();
    }

    private jump(track: Track, direction: 1 | -1): void {
        const event = track.nextEvent(this.trackTime(track), direction);
        if (!event) {
            this.words.textContent = `There is no ${direction === 1 ? "later" : "earlier"} conflict or rotation.`;
            return;
        }
        const time = event.step + kEventShare;
        this.seek(this.isByShare() ? (time / Math.max(track.length, 1)) * this.clock.length : time);
        this.marked = event.robots;
        this.markedKind = event.kind;
        this.redraw();
        this.words.textContent = `Step ${event.step + 1}: ${event.text}.`;
    }

    private seek(time: number): void {
        this.clock.stop();
        this.clock.seek(time);
        this.marked = [];
        this.state.set({ t: this.clock.time === 0 ? null : Math.round(this.clock.time * 1000) / 1000 });
        this.controls.setRunning(false);
        this.redraw();
    }

    private isByShare(): boolean {
        return this.state.get("sync", "step") === "share";
    }

    /** The solutions' own time: the same step, or the same share of their length. */
    private trackTime(track: Track): number {
        if (!this.isByShare()) return Math.min(this.clock.time, track.length);
        return (this.clock.time / Math.max(this.clock.length, 1)) * track.length;
    }

    private onTick(): void {
        if (this.clock.isRunning) {
            this.marked = [];
            this.drawPanels();
            this.drawStrip();
            const kWordsEvery = 100; // milliseconds
            if (performance.now() - this.lastWords > kWordsEvery) this.say();
            return;
        }
        this.controls.setRunning(false);
        this.state.set({ t: Math.round(this.clock.time * 1000) / 1000 });
        this.redraw();
    }

    /** All panels of one graph show the same part of it. */
    private onCamera(from: Panel): void {
        for (const { panel } of this.slots) if (panel !== from) panel.lookLike(from);
        this.seen = from.seenVertices();
        this.redraw();
    }

    private onResize(): void {
        for (const { panel } of this.slots) panel.resize();
        this.seen = this.slots[0]?.panel.seenVertices() ?? null;
        this.redraw();
    }

    /** Once before the next frame, however often it is asked for. */
    private redraw(): void {
        if (this.isDirty) return;
        this.isDirty = true;
        requestAnimationFrame(() => {
            this.isDirty = false;
            this.drawNow();
        });
    }

    private drawNow(): void {
        this.drawPanels();
        this.drawStrip();
        this.showKey();
        this.say();
    }

    private marks(slot: Slot): Marks {
        const track = slot.panel.track!;
        return {
            goals: this.state.flag("goals", true),
            trails: this.state.flag("trails", false),
            blocks: this.state.flag("blocks", false),
            ...this.heat(track),
            followed: this.state.number("follow", -1),
            marked: slot === this.slots[0] ? this.marked : [],
            markColor: this.theme[this.markedKind],
        };
    }

    /** On one scale for all solutions that are shown. */
    private heat(track: Track): { heat: Float64Array | null; heatMost: number } {
        const kind = this.state.get("heat", "none");
        const most = this.slots.map(({ panel }) => panel.track!.heat(kind)?.most ?? 1);
        return { heat: track.heat(kind)?.values ?? null, heatMost: Math.max(...most) };
    }

    private drawPanels(): void {
        for (const slot of this.slots)
            slot.panel.draw(this.trackTime(slot.panel.track!), this.theme, this.marks(slot));
    }

    private drawStrip(): void {
        if (this.slots.length === 0) return;
        const tracks = this.slots.map(({ panel }) => panel.track!);
        const shares = tracks.map(({ length }) =>
            this.isByShare() ? 1 : length / Math.max(this.clock.length, 1),
        );
        const { seen, theme } = this;
        this.strip.draw({ tracks, shares, seen, theme }, this.clock.time, this.clock.length);
    }

    private showKey(): void {
        if (this.slots.length === 0) return;
        const what = heatName(this.state.get("heat", "none"));
        this.key.replaceChildren(...keyOf(this.marks(this.slots[0]), what, this.theme));
    }

    private say(): void {
        this.lastWords = performance.now();
        this.readout.setAttribute("aria-live", this.clock.isRunning ? "off" : "polite");
        const followed = this.state.number("follow", -1);
        this.controls.setTime(this.clock.time);
        const tracks = this.slots.map(({ panel }) => panel.track!);
        this.readout.textContent = tracks
            .map((track) => describeTime(track, this.trackTime(track), followed))
            .join(" · ");
    }

    private onKey(event: KeyboardEvent): void {
        const target = event.target as HTMLElement;
        if (event.ctrlKey || event.metaKey || event.altKey || target.closest("input, select, textarea"))
            return;
        if (target.closest("button") && (event.key === " " || event.key === "Enter")) return;
        const speeds = kSpeeds.map(String);
        const changeSpeed = (by: number): void => {
            const at = speeds.indexOf(this.state.get("speed", "auto"));
            const from = at >= 0 ? at : kSpeeds.findIndex((speed) => speed >= this.clock.speed);
            this.state.set({ speed: speeds[Math.min(Math.max(from + by, 0), speeds.length - 1)] });
        };
        const panel = this.slots[0]?.panel;
        const isPanel = target === panel?.canvas || this.slots.some((slot) => slot.panel.canvas === target);
        const kPan = 60; // pixels
        const pan = (dx: number, dy: number): void => panel?.pan(dx * kPan, dy * kPan);
        const actions: Record<string, () => void> = {
            " ": () => this.onControl("play"),
            k: () => this.onControl("play"),
            ArrowRight: () => (event.shiftKey && isPanel ? pan(-1, 0) : this.onControl("forward")),
            ArrowLeft: () => (event.shiftKey && isPanel ? pan(1, 0) : this.onControl("back")),
            ArrowUp: () => (isPanel ? pan(0, 1) : this.seek(this.clock.time + this.clock.length / 20)),
            ArrowDown: () => (isPanel ? pan(0, -1) : this.seek(this.clock.time - this.clock.length / 20)),
            Home: () => this.onControl("first"),
            End: () => this.onControl("last"),
            n: () => this.onControl("next-event"),
            p: () => this.onControl("previous-event"),
            "+": () => this.onControl("zoom-in"),
            "=": () => this.onControl("zoom-in"),
            "-": () => this.onControl("zoom-out"),
            "0": () => this.onControl("fit"),
            "]": () => changeSpeed(1),
            "[": () => changeSpeed(-1),
            Escape: () => this.state.set({ follow: null }),
        };
        const action = actions[event.key];
        if (!action) return;
        event.preventDefault();
        action();
    }
}
