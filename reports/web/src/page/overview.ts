// The first thing that is seen: what was found, the numbers by planner, and where they come from.
import type { Campaign, Runs } from "../data/campaign";
import { groupBy, middleOf } from "../charts/groups";
import { Answers, type Outcome, commonInstances } from "../data/answers";
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

    /** What each planner answered, and its medians on the instances that all of them solved. */
    private planners(): HTMLElement {
        const { runs } = this;
        const measures = kMeasures.filter(
            ([name]) => runs.has(name) && runs.column(name).numbers?.some((value) => value !== null),
        );
        const answers = new Answers(runs).of(Array.from({ length: runs.count }, (_, run) => run));
        const common = commonInstances(answers);
        const byPlanner = groupBy(answers, ({ planner }) => planner);
        const rows = this.campaign.about.planners
            .filter(({ name }) => byPlanner.has(name))
            .map(({ name }) => {
                const own = byPlanner.get(name)!;
                const count = (outcome: Outcome): string =>
                    String(own.filter((answer) => answer.outcome === outcome).length);
                const compared = common.planners.includes(name)
                    ? own.filter(({ instance }) => common.instances.has(instance))
                    : [];
                const medians = measures.map(([measure]) => {
                    const values = compared
                        .map((answer) => answer.cost(measure))
                        .filter((value) => value !== null);
                    const middle = middleOf(values);
                    if (!middle) return "";
                    return measure === "time" ? formatSeconds(middle.median) : formatNumber(middle.median);
                });
                const rule = runs.has("rule") ? runs.text("rule", own[0].runs[0]) : "";
                const counted = own.filter(({ counts }) => counts).length;
                return el(
                    "tr",
                    {},
                    el("th", { scope: "row" }, name),
                    ...[
                        rule,
                        `${count("solved")} of ${counted}`,
                        count("proved"),
                        count("doesNotApply"),
                        count("failed"),
                        ...medians,
                    ].map((text) => el("td", {}, text)),
                );
            });
        const headings = ["planner", "rule", "solved", "proved", "not applicable", "failed"];
        const who = byPlanner.size === common.planners.length ? "all planners" : common.planners.join(", ");
        return el(
            "table",
            { class: "summary" },
            el(
                "caption",
                {},
                "Distinct instances; solved: of those that have a solution under the planner's motion rule and to which " +
                    "it applies. " +
                    (common.planners.length === 0
                        ? "No two planners have solved enough of the same for medians side by side: compare them in the charts."
                        : `Medians over the ${common.instances.size} instances that ${who} solved.`),
            ),
            el(
                "thead",
                {},
                el(
                    "tr",
                    {},
                    ...[...headings, ...measures.map(([, title]) => title)].map((text) =>
                        el("th", { scope: "col" }, text),
                    ),
                ),
            ),
            el("tbody", {}, ...rows),
        );
    }
}
