// The first thing that is seen: what was found, the numbers by planner, and where they come from.
import type { Campaign, Runs } from "../data/campaign";
import { groupBy, quartiles } from "../charts/groups";
import { el } from "./dom";
import { formatNumber, formatSeconds } from "../runs/format";

const kMeasures: [string, string][] = [
    ["time", "time"],
    ["path_length", "path length"],
    ["makespan", "makespan"],
    ["optimized_path_length", "path length, optimized"],
    ["optimized_makespan", "makespan, optimized"],
];

export class Overview {
    readonly element = el("section", { class: "overview", "aria-label": "Overview" });

    constructor(
        private readonly campaign: Campaign,
        private readonly runs: Runs,
    ) {
        const { facts, provenance, plan } = campaign.about;
        const licences = document.querySelector<HTMLTemplateElement>("#licences");
        this.element.append(
            ...facts.map((fact) => el("p", { class: "fact" }, fact)),
            this.planners(),
            el("h2", {}, "Where the results come from"),
            el("dl", {}, ...provenance.flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)])),
            ...(plan === ""
                ? []
                : [el("details", {}, el("summary", {}, "The plan"), el("pre", { class: "plan" }, plan))]),
            el(
                "details",
                {},
                el("summary", {}, "Licences of what this page carries"),
                ...(licences ? [licences.content.cloneNode(true)] : []),
            ),
        );
    }

    /** Medians over the solved runs of all problems, beside the number of runs that they stand for. */
    private planners(): HTMLElement {
        const { runs } = this;
        const all = Array.from({ length: runs.count }, (_, run) => run);
        const measures = kMeasures.filter(
            ([name]) => runs.has(name) && runs.column(name).numbers?.some((value) => value !== null),
        );
        const groups = groupBy(all, (run) => runs.text("planner", run));
        const rows = this.campaign.about.planners
            .filter(({ name }) => groups.has(name))
            .map(({ name }) => {
                const solved = groups.get(name)!.filter((run) => runs.text("status", run) === "solved");
                const medians = measures.map(([measure]) => {
                    const summary = quartiles(
                        solved.map((run) => runs.number(measure, run)).filter((value) => value !== null),
                    );
                    if (!summary) return "";
                    return measure === "time" ? formatSeconds(summary.median) : formatNumber(summary.median);
                });
                return el(
                    "tr",
                    {},
                    el("th", { scope: "row" }, name),
                    el("td", {}, `${solved.length} of ${groups.get(name)!.length}`),
                    ...medians.map((text) => el("td", {}, text)),
                );
            });
        return el(
            "table",
            { class: "summary" },
            el(
                "caption",
                {},
                "Medians over the solved runs of all problems: compare planners in the charts, problem by problem.",
            ),
            el(
                "thead",
                {},
                el(
                    "tr",
                    {},
                    ...["planner", "solved", ...measures.map(([, title]) => title)].map((text) =>
                        el("th", { scope: "col" }, text),
                    ),
                ),
            ),
            el("tbody", {}, ...rows),
        );
    }
}
