// One run in detail: how it ended and why, how to repeat it, everything that was measured, and its solution.
import type { Campaign, Runs } from "../data/campaign";
import { button, el } from "../page/dom";
import type { State } from "../page/state";
import { columnTitle, formatCell, runName, statusClass } from "./format";

export class RunDetails {
    readonly element = el("aside", { class: "details", "aria-label": "The chosen run" });

    constructor(
        private readonly campaign: Campaign,
        private readonly runs: Runs,
        private readonly state: State,
    ) {}

    /** \param run −1 for none */
    show(run: number): void {
        const { runs } = this;
        if (run < 0 || run >= runs.count) {
            this.element.replaceChildren(
                el("p", { class: "hint" }, "Choose a run to see everything about it."),
            );
            return;
        }
        const status = runs.text("status", run);
        const reason = runs.text("reason", run);
        const cells = runs.columns
            .map((column) => ({ column, text: formatCell(column, run) }))
            .filter(
                ({ column, text }) =>
                    text !== "" && !["status", "reason", "run_key", "planner", "case"].includes(column.name),
            );
        this.element.replaceChildren(
            el("h2", {}, runName(runs, run)),
            el("p", { class: `status ${statusClass(status)}` }, status),
            ...(reason === "" ? [] : [el("p", { class: "reason" }, reason)]),
            this.player(run),
            ...this.replay(run),
            el(
                "dl",
                {},
                ...cells.flatMap(({ column, text }) => [
                    el("dt", { title: column.help || null }, columnTitle(column)),
                    el("dd", {}, text),
                ]),
            ),
        );
    }

    private player(run: number): HTMLElement {
        const index = this.campaign.playableIndex(run);
        if (index < 0) {
            const absence = this.runs.absence(run);
            return el("p", { class: "hint" }, `It cannot be played: ${absence}.`);
        }
        const { playable } = this.campaign.about;
        const others = playable
            .map((one, i) => ({ one, i }))
            .filter(({ one, i }) => i !== index && one.case === playable[index].case);
        const open = (slots: string[]): void =>
            this.state.set({ view: "player", p: slots, t: null, follow: null }, true);
        const bar = el(
            "div",
            { class: "bar" },
            button("▶ Play", "Watch this solution", () => open([`${index}:steps`])),
        );
        if (playable[index].optimized)
            bar.append(
                button(
                    "Before and after",
                    "Watch it one after another, condensed and optimized, side by side",
                    () =>
                        this.state.set(
                            {
                                view: "player",
                                p: [`${index}:moves`, `${index}:steps`, `${index}:optimized-steps`],
                                sync: "share",
                                t: null,
                                follow: null,
                            },
                            true,
                        ),
                ),
            );
        if (others.length > 0)
            bar.append(
                button("Compare planners", "Watch it beside those of other planners", () =>
                    open([`${index}:steps`, ...others.slice(0, 3).map(({ i }) => `${i}:steps`)]),
                ),
            );
        return bar;
    }

    /** The page lies in the campaign's folder, unless it was taken elsewhere. */
    private replay(run: number): HTMLElement[] {
        const key = this.runs.text("run_key", run);
        if (!this.campaign.hasPlan || key === "") return [];
        const folder =
            location.protocol === "file:"
                ? decodeURIComponent(location.pathname).replace(/\/[^/]*$/, "")
                : ".";
        const command = `mrppsim replay ${quoted(folder)} ${quoted(key)}`;
        const copy = button(
            "Copy",
            "Copy the command that repeats this run",
            () => void navigator.clipboard?.writeText(command),
        );
        return [el("p", { class: "replay" }, el("code", {}, command), copy)];
    }
}

/** As a shell takes it. */
export function quoted(word: string): string {
    return /^[A-Za-z0-9_./:=+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}
