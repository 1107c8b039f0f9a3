// A table of any number of rows, of which only those in sight are elements.
import type { Column } from "../data/campaign";
import { el } from "../page/dom";
import { columnTitle, formatCell, statusClass } from "./format";
import type { Order } from "./filter";

export const kRowHeight = 26; // pixels, as in style.css

export interface TableEvents {
    onSort: (column: string) => void;
    onFilter: (column: string, filter: string) => void;
    onOpen: (run: number) => void;
}

export class RunTable {
    readonly element = el("div", { class: "table", role: "grid", tabindex: 0, "aria-label": "Runs" });
    private readonly head = el("div", { class: "head", role: "rowgroup" });
    private readonly body = el("div", { class: "body", role: "rowgroup" });
    private columns: Column[] = [];
    private runs: Uint32Array = new Uint32Array();
    private selected = -1; // run
    private readonly rows = new Map<number, HTMLElement>(); // that are elements now, by their position

    constructor(private readonly events: TableEvents) {
        this.element.append(this.head, this.body);
        this.element.addEventListener("scroll", () => this.show(), { passive: true });
        this.element.addEventListener("keydown", (event) => this.onKey(event));
        this.body.addEventListener("click", (event) => {
            const row = (event.target as HTMLElement).closest<HTMLElement>(".row");
            if (row) this.open(Number(row.dataset.run));
        });
        new ResizeObserver(() => this.show()).observe(this.element);
    }

    setColumns(columns: Column[], filters: (column: string) => string, order: Order | null): void {
        const isSame =
            columns.length === this.columns.length &&
            columns.every((column, i) => column === this.columns[i]);
        this.columns = columns;
        const widths = columns.map(widthOf);
        this.element.style.setProperty("--columns", widths.map((width) => `${width}px`).join(" "));
        const shares = widths.map((width) => `minmax(0, ${width}fr)`); // of a sheet of paper
        this.element.style.setProperty("--shares", shares.join(" "));
        this.element.setAttribute("aria-colcount", String(columns.length));
        if (!isSame) {
            this.head.replaceChildren(
                el("div", { class: "row", role: "row" }, ...columns.map((column) => this.headCell(column))),
                el(
                    "div",
                    { class: "row filters", role: "row" },
                    ...columns.map((column) => this.filterCell(column, filters(column.name))),
                ),
            );
            this.clear();
        }
        for (const cell of this.head.querySelectorAll<HTMLElement>("[role=columnheader]")) {
            const isSorted = order?.column === cell.dataset.column;
            cell.setAttribute(
                "aria-sort",
                !isSorted ? "none" : order!.isDescending ? "descending" : "ascending",
            );
        }
        for (const field of this.head.querySelectorAll<HTMLInputElement>(".filters input"))
            if (document.activeElement !== field) field.value = filters(field.dataset.column!);
    }

    setRuns(runs: Uint32Array): void {
        this.runs = runs;
        this.element.setAttribute("aria-rowcount", String(runs.length + 2));
        this.body.style.height = `${runs.length * kRowHeight}px`;
        this.clear();
        this.show();
    }

    select(run: number): void {
        this.selected = run;
        for (const row of this.rows.values())
            row.setAttribute("aria-selected", String(Number(row.dataset.run) === run));
    }

    /** Brings a run into sight. */
    reveal(run: number): void {
        const position = this.runs.indexOf(run);
        if (position < 0) return;
        const top = position * kRowHeight;
        const height = this.element.clientHeight - this.head.offsetHeight;
        if (top < this.element.scrollTop || top + kRowHeight > this.element.scrollTop + height)
            this.element.scrollTop = top - height / 2;
        this.show();
    }

    /** Makes the first rows elements, in sight or not: for paper. */
    showFirst(count: number): void {
        this.clear();
        this.element.scrollTop = 0;
        for (let position = 0; position < Math.min(count, this.runs.length); ++position)
            this.fill(this.makeRow(), position);
    }

    private clear(): void {
        this.rows.clear();
        this.body.replaceChildren();
    }

    /** Rows in sight, and some around them. */
    private show(): void {
        const kAround = 8;
        const first = Math.max(Math.floor(this.element.scrollTop / kRowHeight) - kAround, 0);
        const count = Math.ceil(this.element.clientHeight / kRowHeight) + 2 * kAround;
        const end = Math.min(first + count, this.runs.length);
        const spare: HTMLElement[] = [];
        for (const [position, row] of this.rows)
            if (position < first || position >= end) {
                spare.push(row);
                this.rows.delete(position);
            }
        for (let position = first; position < end; ++position)
            if (!this.rows.has(position)) this.fill(spare.pop() ?? this.makeRow(), position);
        for (const row of spare) row.remove();
    }

    private makeRow(): HTMLElement {
        const cells = this.columns.map((column) =>
            el("div", { role: "gridcell", class: column.numbers ? "number" : null }),
        );
        const row = el("div", { class: "row", role: "row" }, ...cells);
        this.body.append(row);
        return row;
    }

    /** Makes an element the row at that position, whatever it was before. */
    private fill(row: HTMLElement, position: number): void {
        const run = this.runs[position];
        row.dataset.run = String(run);
        row.setAttribute("aria-rowindex", String(position + 3));
        row.setAttribute("aria-selected", String(run === this.selected));
        row.style.transform = `translateY(${position * kRowHeight}px)`;
        this.columns.forEach((column, i) => {
            const cell = row.children[i] as HTMLElement;
            const text = formatCell(column, run);
            cell.textContent = text;
            if (column.name === "status") cell.className = `status ${statusClass(text)}`;
            if (!column.numbers) cell.title = text;
        });
        this.rows.set(position, row);
    }

    private headCell(column: Column): HTMLElement {
        const sort = el(
            "button",
            { type: "button", title: column.help || `Sort by ${column.title}` },
            columnTitle(column),
        );
        sort.addEventListener("click", () => this.events.onSort(column.name));
        return el(
            "div",
            { role: "columnheader", "data-column": column.name, class: column.numbers ? "number" : null },
            sort,
        );
    }

    private filterCell(column: Column, filter: string): HTMLElement {
        const field = el("input", {
            type: "search",
            value: filter,
            "data-column": column.name,
            "aria-label": `Filter ${column.title}`,
            placeholder: column.numbers ? ">10, 5..8" : "word, !word",
        });
        field.addEventListener("input", () => this.events.onFilter(column.name, field.value));
        return el("div", { role: "gridcell" }, field);
    }

    private open(run: number): void {
        this.select(run);
        this.events.onOpen(run);
    }

    private onKey(event: KeyboardEvent): void {
        if ((event.target as HTMLElement).closest("input, button")) return;
        const page = Math.max(
            Math.floor((this.element.clientHeight - this.head.offsetHeight) / kRowHeight) - 1,
            1,
        );
        const steps: Record<string, number> = {
            ArrowDown: 1,
            ArrowUp: -1,
            PageDown: page,
            PageUp: -page,
            Home: -Infinity,
            End: Infinity,
        };
        const by = steps[event.key];
        if (by === undefined || this.runs.length === 0) return;
        event.preventDefault();
        const at = this.runs.indexOf(this.selected);
        const position = Math.min(Math.max((at < 0 ? -1 : at) + by, 0), this.runs.length - 1);
        this.open(this.runs[position]);
        this.reveal(this.runs[position]);
    }
}

function widthOf(column: Column): number {
    const forTitle = columnTitle(column).length * 8 + 30;
    if (column.numbers) return Math.max(96, forTitle);
    const kMostLooked = 200;
    const longest = column.texts
        .slice(0, kMostLooked)
        .reduce((most, text) => Math.max(most, text.length), column.title.length);
    const forBold = column.name === "status" ? 30 : 0;
    return Math.min(Math.max(forTitle, longest * 8.2 + 26 + forBold), 300);
}
