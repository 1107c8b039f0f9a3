// Buttons, selects and fields of the player. What is to be kept goes to the address; the rest is told at
// once.
import { button, checkbox, choice, el, setOptions } from "../page/dom";
import type { State } from "../page/state";

export type Control =
    | "play"
    | "first"
    | "last"
    | "back"
    | "forward"
    | "step"
    | "previous-event"
    | "next-event"
    | "fit"
    | "zoom-in"
    | "zoom-out"
    | "speed";

export const kSpeeds = [0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000];

const kHeats: [string, string][] = [
    ["none", "none"],
    ["traffic", "moves over a vertex"],
    ["waiting", "steps of waiting on a vertex"],
];

export function heatName(kind: string): string {
    return kHeats.find(([name]) => name === kind)?.[1] ?? "";
}

export class PlayerControls {
    readonly element = el("div", {
        class: "controls",
        role: "group",
        "aria-label": "Controls of the player",
    });
    private readonly play: HTMLButtonElement;
    private readonly stepField = el("input", { type: "number", min: 0, value: 0, "aria-label": "Step" });
    private readonly lengthText = el("span");
    private readonly followField = el("input", {
        type: "number",
        min: 0,
        placeholder: "none",
        "aria-label": "Robot to follow",
    });
    private readonly speedSelect: HTMLSelectElement;
    private readonly heatSelect: HTMLSelectElement;
    private readonly syncSelect: HTMLSelectElement;
    private readonly flags: [string, boolean, HTMLInputElement][] = [];

    constructor(
        private readonly state: State,
        private readonly tell: (control: Control) => void,
    ) {
        const act = (label: string, name: string, control: Control): HTMLButtonElement =>
            button(label, name, () => tell(control));
        this.play = act("▶", "Play (space)", "play");
        this.play.classList.add("play");
        this.stepField.addEventListener("change", () => tell("step"));
        this.followField.addEventListener("change", () =>
            state.set({
                follow:
                    this.followField.value === ""
                        ? null
                        : Math.max(0, Math.floor(Number(this.followField.value))),
            }),
        );
        const speed = choice(
            "Speed",
            [["auto", "automatic"], ...kSpeeds.map((s): [string, string] => [String(s), `${s} steps/s`])],
            "auto",
            (value) => state.set({ speed: value === "auto" ? null : value }),
        );
        const heat = choice("Heat", kHeats, "none", (value) =>
            state.set({ heat: value === "none" ? null : value }),
        );
        const sync = choice(
            "In step by",
            [
                ["step", "step"],
                ["share", "share of the whole"],
            ],
            "step",
            (value) => state.set({ sync: value === "step" ? null : value }),
        );
        this.speedSelect = speed.querySelector("select")!;
        this.heatSelect = heat.querySelector("select")!;
        this.syncSelect = sync.querySelector("select")!;
        const flag = (key: string, label: string, otherwise: boolean): HTMLElement => {
            const box = checkbox(label, otherwise, (checked) =>
                state.set({ [key]: checked === otherwise ? null : checked }),
            );
            this.flags.push([key, otherwise, box.querySelector("input")!]);
            return box;
        };
        this.element.append(
            act("|◀", "To the beginning (Home)", "first"),
            act("‹", "A step back (←)", "back"),
            this.play,
            act("›", "A step on (→)", "forward"),
            act("▶|", "To the end (End)", "last"),
            el("label", { class: "choice" }, el("span", {}, "Step"), this.stepField, this.lengthText),
            act("‹ !", "To the conflict or rotation before (p)", "previous-event"),
            act("! ›", "To the next conflict or rotation (n)", "next-event"),
            speed,
            act("+", "Larger (+)", "zoom-in"),
            act("−", "Smaller (−)", "zoom-out"),
            act("Fit", "Show everything (0)", "fit"),
            el("label", { class: "choice" }, el("span", {}, "Follow robot"), this.followField),
            flag("goals", "Goals", true),
            flag("trails", "Trails", false),
            flag("blocks", "Blocks and isthmuses", false),
            heat,
            sync,
        );
        this.reread();
    }

    /** Shows what the address says. */
    reread(): void {
        const { state } = this;
        const speed = state.get("speed", "auto");
        this.speedSelect.value = speed === "auto" || kSpeeds.includes(Number(speed)) ? speed : "auto";
        this.heatSelect.value = state.get("heat", "none");
        if (this.heatSelect.selectedIndex < 0) setOptions(this.heatSelect, kHeats, "none");
        this.syncSelect.value = state.get("sync", "step") === "share" ? "share" : "step";
        const follow = state.number("follow", -1);
        this.followField.value = follow < 0 ? "" : String(follow);
        for (const [key, otherwise, box] of this.flags) box.checked = state.flag(key, otherwise);
        this.tell("speed");
    }

    /** Steps a second: the user's choice, or such that all takes about half a minute. */
    speed(length: number): number {
        const chosen = this.state.number("speed", 0);
        if (chosen > 0) return chosen;
        const kSeconds = 30;
        return Math.max(length / kSeconds, 2);
    }

    get step(): number {
        return Number(this.stepField.value) || 0;
    }

    setLengths(steps: number, robots: number): void {
        this.stepField.max = String(steps);
        this.lengthText.textContent = `of ${steps}`;
        this.followField.max = String(robots - 1);
    }

    setTime(time: number): void {
        if (document.activeElement !== this.stepField) this.stepField.value = String(Math.floor(time));
    }

    setRunning(isRunning: boolean): void {
        this.play.textContent = isRunning ? "❚❚" : "▶";
        const name = isRunning ? "Pause (space)" : "Play (space)";
        this.play.title = name;
        this.play.setAttribute("aria-label", name);
    }
}
