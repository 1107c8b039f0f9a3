// The charts and what is chosen for them.
import type { Campaign, Runs } from "../data/campaign";
import { numericColumns } from "../data/campaign";
import { button, checkbox, choice, download, el, fileName, setOptions } from "../page/dom";
import type { State } from "../page/state";
import { type Theme, curveColor } from "../page/theme";
import { columnTitle } from "../runs/format";
import {
    type ChartKind,
    type ChartSettings,
    buildChart,
    isSwept,
    kProblem,
    kSuccess,
    problemOf,
    problemsOf,
} from "./model";
import { Plot, drawMarker } from "./plot";

const kKinds: [ChartKind, string][] = [
    ["sweep", "medians and quartiles"],
    ["cactus", "cactus"],
    ["scatter", "scatter, a dot a run"],
    ["versus", "one planner against another"],
];

export class ChartsView {
    readonly element = el("section", { class: "charts", "aria-label": "Charts" });
    private readonly place = el("div", { class: "chart" });
    private readonly legend = el("div", { class: "chart-legend", role: "group", "aria-label": "Planners" });
    private readonly caption = el("p", { class: "caption" });
    private readonly selects: Record<"kind" | "x" | "y" | "problem" | "first" | "second", HTMLSelectElement>;
    private readonly labels: Record<string, HTMLElement> = {};
    private readonly logX: HTMLInputElement;
    private readonly logY: HTMLInputElement;
    private plot: Plot | null = null;

    constructor(
        private readonly campaign: Campaign,
        private readonly runs: Runs,
        private readonly state: State,
        private theme: Theme,
    ) {
        const { planners } = campaign.about;
        const numeric = numericColumns(runs).map((column): [string, string] => [
            column.name,
            columnTitle(column),
        ]);
        const select = (key: string, label: string, options: [string, string][]): HTMLSelectElement => {
            this.labels[key] = choice(label, options, "", (value) => state.set({ [key]: value }));
            return this.labels[key].querySelector("select")!;
        };
        const names = planners.map(({ name }, i): [string, string] => [String(i), name]);
        this.selects = {
            kind: select("chart", "Chart", kKinds),
            y: select("y", "Measure", [...numeric, [kSuccess, "Instances solved (%)"]]),
            x: select("x", "Against", [
                ["sweep_value", "the swept variable"],
                [kProblem, "problems side by side"],
                ...numeric,
            ]),
            problem: select("problem", "Problem", []),
            first: select("a", "Across", names),
            second: select("b", "Up", names),
        };
        const log = (key: string, label: string): HTMLInputElement => {
            this.labels[key] = checkbox(label, false, (checked) => state.set({ [key]: checked }));
            return this.labels[key].querySelector("input")!;
        };
        this.logX = log("logx", "Logarithmic across");
        this.logY = log("logy", "Logarithmic up");
        this.element.append(
            el(
                "div",
                { class: "controls", role: "group", "aria-label": "What the chart shows" },
                ...Object.values(this.labels),
                button("PNG", "This chart as PNG", () => this.save()),
            ),
            this.legend,
            this.place,
            this.caption,
        );
        new ResizeObserver(() => this.plot?.resize(Math.max(this.place.clientWidth, 320))).observe(
            this.place,
        );
    }

    setTheme(theme: Theme): void {
        this.theme = theme;
        if (this.plot && !this.element.hidden) this.show();
    }

    show(): void {
        if (this.runs.count === 0) {
            this.element.replaceChildren(el("p", {}, "No run is finished yet."));
            return;
        }
        const settings = this.settings();
        this.showChoices(settings);
        const model = buildChart(this.runs, this.campaign.about.planners, settings);
        this.logX.checked = this.state.flag(
            "logx",
            !model.xNames && settings.kind !== "cactus" && isWide(model.dots.map(({ x }) => x)),
        );
        this.logY.checked = this.state.flag("logy", isWide(model.dots.map(({ y }) => y)));
        this.plot?.destroy();
        this.plot = new Plot(this.campaign.about.planners, model, this.theme, {
            logX: this.logX.checked && !model.xNames,
            logY: this.logY.checked,
            height: Math.min(Math.max(innerHeight - 300, 320), 640),
            onDot: (run) => this.state.set({ view: "runs", run }, true),
        });
        this.place.replaceChildren(this.plot.element);
        this.plot.draw();
        const title = `${model.yTitle}${model.xTitle ? ` against ${model.xTitle}` : ""}`;
        this.plot.element.setAttribute("role", "img");
        this.plot.element.setAttribute(
            "aria-label",
            `${title}. ${model.curves.map(({ name }) => name).join("; ")}`,
        );
        const howTo = "Drag to enlarge a part, double-click for the whole; a click on a dot goes to its run.";
        this.caption.textContent = `${model.caption} ${howTo}`;
        this.showLegend(settings, new Map(model.curves.map(({ planner, name }) => [planner, name])));
    }

    private settings(): ChartSettings {
        const { state, runs } = this;
        const swept = isSwept(runs);
        const planners = this.campaign.about.planners.map((_, i) => i);
        const hidden = (state.list("hide") ?? []).map(Number);
        const kinds = kKinds.map(([kind]) => kind);
        const kind = state.get("chart", "sweep") as ChartKind;
        const has = (column: string): boolean =>
            column === kSuccess || column === kProblem || runs.has(column);
        const x = state.get("x", swept ? "sweep_value" : kProblem);
        const y = state.get(
            "y",
            runs.column("path_length").numbers?.some((value) => value !== null) ? "path_length" : "time",
        );
        const isKind = kinds.includes(kind);
        return {
            kind: isKind ? kind : "sweep",
            x: !has(x) || (kind === "scatter" && x === kProblem) ? "robots" : x,
            y: !has(y) || (kind !== "sweep" && y === kSuccess) ? "time" : y,
            problem: state.get("problem", swept ? problemOf(runs, 0) : ""),
            planners: planners.filter((planner) => !hidden.includes(planner)),
            first: state.number("a", 0),
            second: state.number("b", Math.min(1, planners.length - 1)),
        };
    }

    private showChoices(settings: ChartSettings): void {
        const problems = problemsOf(this.runs).map((problem): [string, string] => [problem, problem]);
        setOptions(this.selects.problem, [["", "all"], ...problems], settings.problem);
        settings.problem = this.selects.problem.value;
        for (const key of ["kind", "x", "y"] as const) this.selects[key].value = settings[key];
        this.selects.first.value = String(settings.first);
        this.selects.second.value = String(settings.second);
        const isVersus = settings.kind === "versus";
        this.labels.a.hidden = this.labels.b.hidden = !isVersus;
        this.labels.x.hidden = isVersus || settings.kind === "cactus";
    }

    /** The planners, each of which can be taken out. */
    private showLegend(settings: ChartSettings, names: Map<number, string>): void {
        this.legend.hidden = settings.kind === "versus";
        this.legend.replaceChildren(
            ...this.campaign.about.planners.map(({ name, color, marker }, i) => {
                const box = checkbox(names.get(i) ?? name, settings.planners.includes(i), (checked) => {
                    const hidden = this.campaign.about.planners
                        .map((_, other) => other)
                        .filter((other) => (other === i ? !checked : !settings.planners.includes(other)));
                    this.state.set({ hide: hidden.length === 0 ? null : hidden.map(String) });
                });
                box.querySelector("input")!.after(swatch(curveColor(color, this.theme), marker));
                return box;
            }),
        );
    }

    private save(): void {
        this.plot?.picture()?.toBlob((blob) => {
            if (blob) download(`${fileName(this.campaign.about.title, "chart")}.png`, blob);
        });
    }
}

/** More than two decades: then an axis is logarithmic unless the user says otherwise. */
function isWide(values: number[]): boolean {
    const positive = values.filter((value) => value > 0);
    return (
        positive.reduce((a, b) => Math.max(a, b), 0) >
        100 * positive.reduce((a, b) => Math.min(a, b), Infinity)
    );
}

function swatch(color: string, marker: number): HTMLCanvasElement {
    const canvas = el("canvas", { width: 32, height: 32, class: "marker", "aria-hidden": true });
    drawMarker(canvas.getContext("2d")!, marker, 16, 16, 10, color);
    return canvas;
}
