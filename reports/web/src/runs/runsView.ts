// All runs: the table with its search and its choice of columns, and one run in detail.
import type { Campaign, Runs } from "../data/campaign";
import { checkbox, el } from "../page/dom";
import type { State } from "../page/state";
import { RunDetails } from "./details";
import { type Order, columnTest, searchTest, selectRuns } from "./filter";
import { statusClass } from "./format";
import { RunTable } from "./table";

const kUsualColumns = [
    "problem",
    "sweep_value",
    "repetition",
    "planner",
    "status",
    "robots",
    "time",
    "path_length",
    "makespan",
    "optimized_path_length",
    "optimized_makespan",
    "sum_of_costs",
    "memory",
    "reason",
];

export class RunsView {
    readonly element = el("section", { class: "runs", "aria-label": "Runs" });
    private readonly table: RunTable;
    private readonly details: RunDetails;
    private readonly search = el("input", {
        type: "search",
        "aria-label": "Search all texts of the runs",
        placeholder: "Search",
    });
    private readonly count = el("output", { class: "count", "aria-live": "polite" });
    private readonly statuses = el("div", { class: "chips", role: "group", "aria-label": "How runs ended" });

    constructor(
        campaign: Campaign,
        private readonly runs: Runs,
        private readonly state: State,
    ) {
        this.table = new RunTable({
            onSort: (column) => this.sortBy(column),
            onFilter: (column, filter) => state.set({ [`f.${column}`]: filter === "" ? null : filter }),
            onOpen: (run) => state.set({ run }),
        });
        this.details = new RunDetails(campaign, runs, state);
        this.search.addEventListener("input", () =>
            state.set({ q: this.search.value === "" ? null : this.search.value }),
        );
        this.element.append(
            el("div", { class: "bar" }, this.search, this.statuses, this.columnChoice(), this.count),
            el("div", { class: "split" }, this.table.element, this.details.element),
        );
        addEventListener("beforeprint", () => this.table.showFirst(500));
        addEventListener("afterprint", () => this.show());
    }

    show(): void {
        const { state, runs } = this;
        const order = this.order();
        const names =
            state.list("columns") ?? kUsualColumns.filter((name) => runs.has(name) && hasValues(runs, name));
        const columns = names.filter((name) => runs.has(name)).map((name) => runs.column(name));
        const filterOf = (column: string): string => state.get(`f.${column}`, "");
        this.table.setColumns(columns, filterOf, order);
        if (document.activeElement !== this.search) this.search.value = state.get("q", "");
        const tests = runs.columns.map((column) => columnTest(column, filterOf(column.name)));
        const status = state.get("status", "");
        if (status !== "") tests.push((run) => runs.text("status", run) === status);
        const selected = selectRuns(runs, [...tests, searchTest(runs, state.get("q", ""))], order);
        this.table.setRuns(selected);
        this.count.textContent =
            selected.length === runs.count
                ? `${runs.count} runs`
                : `${selected.length} of ${runs.count} runs`;
        this.showStatuses(status);
        const run = state.number("run", -1);
        this.table.select(run);
        if (run >= 0 && run < runs.count) this.table.reveal(run);
        this.details.show(run);
    }

    private order(): Order | null {
        const text = this.state.get("sort", "");
        return text === "" ? null : { column: text.replace(/^-/, ""), isDescending: text.startsWith("-") };
    }

    /** Ascending, descending, as it was. */
    private sortBy(column: string): void {
        const now = this.state.get("sort", "");
        this.state.set({ sort: now === column ? `-${column}` : now === `-${column}` ? null : column });
    }

    private showStatuses(chosen: string): void {
        const { texts, rows } = this.runs.column("status");
        const counts = new Map<string, number>();
        for (const row of rows) counts.set(texts[row], (counts.get(texts[row]) ?? 0) + 1);
        this.statuses.replaceChildren(
            ...[...counts].map(([status, count]) => {
                const chip = el(
                    "button",
                    {
                        type: "button",
                        class: `chip ${statusClass(status)}`,
                        "aria-pressed": status === chosen,
                    },
                    `${status} ${count}`,
                );
                chip.addEventListener("click", () =>
                    this.state.set({ status: status === chosen ? null : status }),
                );
                return chip;
            }),
        );
    }

    private columnChoice(): HTMLElement {
        const list = el("div", { class: "menu" });
        const menu = el("details", { class: "columns" }, el("summary", {}, "Columns"), list);
        menu.addEventListener("toggle", () => {
            const chosen = this.state.list("columns") ?? kUsualColumns;
            list.replaceChildren(
                ...this.runs.columns.map((column) =>
                    checkbox(column.title, chosen.includes(column.name), (checked) =>
                        this.chooseColumn(column.name, checked),
                    ),
                ),
            );
        });
        return menu;
    }

    private chooseColumn(name: string, isChosen: boolean): void {
        const now = this.state.list("columns") ?? kUsualColumns;
        const order = this.runs.columns.map((column) => column.name);
        const next = order.filter((other) => (other === name ? isChosen : now.includes(other)));
        this.state.set({ columns: next });
    }
}

function hasValues(runs: Runs, name: string): boolean {
    const column = runs.column(name);
    return column.numbers
        ? column.numbers.some((number) => number !== null)
        : column.texts.some((text) => text !== "");
}
