// A chart model drawn by uPlot: axes, curves and bands are uPlot's; marks and dots are drawn above them, and
// the dot nearest to the pointer has its run named.
import uPlot from "uplot";
import type { PlannerStyle } from "../data/campaign";
import { el } from "../page/dom";
import { type Theme, curveColor } from "../page/theme";
import { formatNumber, formatSeconds } from "../runs/format";
import { labelled, logarithmicTicks } from "./ticks";
import type { ChartModel, Dot } from "./model";

export interface PlotOptions {
    logX: boolean;
    logY: boolean;
    height: number;
    onDot: (run: number) => void;
}

interface Range {
    min: number;
    max: number;
}

export class Plot {
    readonly element = el("div", { class: "plot" });
    private readonly tip = el("div", { class: "tip", hidden: true });
    private chart: uPlot | null = null;
    private nearest: Dot | null = null;

    constructor(
        private readonly planners: PlannerStyle[],
        readonly model: ChartModel,
        private readonly theme: Theme,
        private readonly options: PlotOptions,
    ) {}

    /** To be called when the element is in the page. */
    draw(): void {
        const x = this.range("x");
        const y = this.range("y");
        if (!x || !y) {
            this.element.replaceChildren(
                el(
                    "p",
                    { class: "hint" },
                    "There is nothing to show: no run of this choice has such values.",
                ),
            );
            return;
        }
        this.chart = new uPlot(this.chartOptions(x, y), this.data(), this.element);
        const { over } = this.chart;
        over.append(this.tip);
        over.addEventListener("mousemove", (event) => this.point(event.offsetX, event.offsetY));
        over.addEventListener("mouseleave", () => this.point(-1e9, -1e9));
        over.addEventListener("click", () => {
            if (this.nearest) this.options.onDot(this.nearest.run);
        });
    }

    resize(width: number): void {
        this.chart?.setSize({ width, height: this.options.height });
    }

    destroy(): void {
        this.chart?.destroy();
        this.element.remove();
    }

    /** The chart on its ground with its planners beneath: a picture that can stand alone. */
    picture(): HTMLCanvasElement | null {
        const chart = this.element.querySelector("canvas");
        if (!chart) return null;
        const pixels = devicePixelRatio || 1;
        const kLine = 22 * pixels;
        const named = this.model.curves;
        const picture = el("canvas", {
            width: chart.width,
            height: chart.height + kLine * (named.length + 0.5),
        });
        const context = picture.getContext("2d", { alpha: false })!;
        context.fillStyle = this.theme.cell;
        context.fillRect(0, 0, picture.width, picture.height);
        context.drawImage(chart, 0, 0);
        context.font = `${13 * pixels}px system-ui, sans-serif`;
        context.textBaseline = "middle";
        named.forEach(({ name, planner }, i) => {
            const y = chart.height + kLine * (i + 0.5);
            const color = curveColor(this.planners[planner].color, this.theme);
            drawMarker(context, this.planners[planner].marker, 30 * pixels, y, 5 * pixels, color);
            context.fillStyle = this.theme.text;
            context.fillText(name, 44 * pixels, y);
        });
        return picture;
    }

    /** What there is to show in one direction, with a margin; null where there is nothing. */
    private range(axis: "x" | "y"): Range | null {
        const isLog = axis === "x" ? this.options.logX : this.options.logY;
        if (axis === "x" && this.model.xNames) return { min: -0.5, max: this.model.xNames.length - 0.5 };
        let min = Infinity;
        let max = -Infinity;
        const add = (value: number | null): void => {
            if (value === null || (isLog && value <= 0)) return;
            min = Math.min(min, value);
            max = Math.max(max, value);
        };
        for (const dot of this.model.dots) add(dot[axis]);
        for (const mark of this.model.marks)
            for (const value of axis === "x" ? [mark.x] : [mark.low ?? mark.median, mark.high ?? mark.median])
                add(value);
        for (const curve of this.model.curves) for (const value of curve[axis]) add(value);
        for (const guide of this.model.guides) for (const i of axis === "x" ? [0, 2] : [1, 3]) add(guide[i]);
        if (min > max) return null;
        if (isLog) return { min: min / 1.3, max: max * 1.3 };
        if (axis === "y" && this.model.yIsPercent) return { min: -3, max: 103 };
        const kFromZero = 0.35; // axes begin at 0 where that costs no more of the picture
        if (min > 0 && min < kFromZero * max) min = 0;
        const margin = max > min ? (max - min) * 0.04 : Math.max(Math.abs(max) * 0.1, 0.5);
        return { min: min === 0 ? 0 : min - margin, max: max + margin };
    }

    /** All curves over the union of their places: x, then y, low and high of each curve. */
    private data(): uPlot.AlignedData {
        const places = [...new Set(this.model.curves.flatMap(({ x }) => x))].sort((a, b) => a - b);
        const index = new Map(places.map((place, i) => [place, i]));
        const spread = (x: number[], values: (number | null)[]): (number | null | undefined)[] => {
            const column: (number | null | undefined)[] = new Array(places.length).fill(undefined);
            x.forEach(
                (place, i) =>
                    (column[index.get(place)!] =
                        this.options.logY && (values[i] ?? 0) <= 0 ? null : (values[i] ?? null)),
            );
            return column;
        };
        return [
            places,
            ...this.model.curves.flatMap(({ x, y, low, high }) => [
                spread(x, y),
                spread(x, low),
                spread(x, high),
            ]),
        ] as uPlot.AlignedData;
    }

    private chartOptions(x: Range, y: Range): uPlot.Options {
        const { theme, model, options } = this;
        const color = (planner: number): string => curveColor(this.planners[planner].color, theme);
        const series: uPlot.Series[] = [{}];
        const bands: uPlot.Band[] = [];
        model.curves.forEach(({ name, planner }, i) => {
            const stroke = color(planner);
            const hidden: uPlot.Series = {
                show: true,
                stroke: "transparent",
                width: 0,
                points: { show: false },
            };
            series.push({
                label: name,
                stroke,
                width: 2,
                dash: dashesOf(this.planners[planner].dashes),
                points: { show: false },
                spanGaps: false,
            });
            series.push(hidden, { ...hidden });
            bands.push({ series: [3 * i + 3, 3 * i + 2], fill: `${stroke}26` });
        });
        // uPlot's own ticks of logarithmic axes never end on some ranges.
        const axis = (label: string, isTime: boolean, isLog: boolean): uPlot.Axis => ({
            ...(isLog
                ? {
                      splits: (_, __, min, max) => logarithmicTicks(min, max),
                      filter: (u, splits, index) => labelled(splits, roomFor(u, index)),
                  }
                : {}),
            label,
            labelSize: 26,
            stroke: theme.text,
            grid: { stroke: theme.faint, width: 1 },
            ticks: { stroke: theme.faint, width: 1 },
            values: (_, splits) => splits.map((value) => (value === null ? "" : valueText(value, isTime))),
        });
        const xAxis = axis(model.xTitle, model.xIsTime, options.logX);
        if (model.xNames) {
            const names = model.xNames;
            const longest = names.reduce((most, name) => Math.max(most, shortened(name).length), 0);
            Object.assign(xAxis, {
                label: undefined,
                splits: (u: uPlot) =>
                    names.map((_, i) => i).filter((i) => i % everyName(u, names.length) === 0),
                values: (_: uPlot, splits: number[]) => splits.map((i) => shortened(names[i])),
                rotate: -40,
                size: 30 + longest * 5,
                space: 1,
                grid: { show: false },
            });
        }
        return {
            width: Math.max(this.element.clientWidth, 320),
            height: options.height,
            padding: [12, model.xNames ? 70 : 16, 0, 0],
            scales: {
                x: { time: false, auto: false, distr: options.logX ? 3 : 1, range: asAsked, ...x },
                y: { auto: false, distr: options.logY ? 3 : 1, range: asAsked, ...y },
            },
            axes: [xAxis, { ...axis(model.yTitle, model.yIsTime, options.logY), size: 74 }],
            series,
            bands,
            legend: { show: false },
            cursor: {
                x: false,
                y: false,
                points: { show: false },
                drag: { x: true, y: true, uni: 20 },
                bind: {
                    dblclick: (u) => () => {
                        u.batch(() => {
                            u.setScale("x", x);
                            u.setScale("y", y);
                        });
                        return null;
                    },
                },
            },
            hooks: { draw: [(u) => this.drawAbove(u)] },
        };
    }

    private drawAbove(u: uPlot): void {
        const { ctx, bbox } = u;
        const pixels = devicePixelRatio || 1;
        ctx.save();
        ctx.beginPath();
        ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
        ctx.clip();
        const at = (x: number, y: number): [number, number] => [
            u.valToPos(x, "x", true),
            u.valToPos(y, "y", true),
        ];
        const color = (planner: number): string => curveColor(this.planners[planner].color, this.theme);
        ctx.strokeStyle = this.theme.text;
        ctx.globalAlpha = 0.5;
        ctx.setLineDash([4 * pixels, 4 * pixels]);
        for (const [x1, y1, x2, y2] of this.model.guides) {
            ctx.beginPath();
            ctx.moveTo(...at(x1, y1));
            ctx.lineTo(...at(x2, y2));
            ctx.stroke();
        }
        ctx.setLineDash([]);
        const isCrowded = this.model.dots.length > 2000;
        ctx.globalAlpha = isCrowded ? 0.35 : 0.75;
        for (const dot of this.model.dots) {
            const [x, y] = at(dot.x, dot.y);
            if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
            drawMarker(
                ctx,
                this.planners[dot.planner].marker,
                x,
                y,
                (isCrowded ? 2 : 3) * pixels,
                color(dot.planner),
            );
        }
        ctx.globalAlpha = 1;
        for (const { planner, x, low, median, high } of this.model.marks) {
            ctx.strokeStyle = color(planner);
            ctx.lineWidth = 2 * pixels;
            ctx.beginPath();
            ctx.moveTo(...at(x, low ?? median));
            ctx.lineTo(...at(x, high ?? median));
            ctx.stroke();
            drawMarker(ctx, this.planners[planner].marker, ...at(x, median), 5.5 * pixels, color(planner));
        }
        for (const { planner, x, y } of this.model.curves)
            x.forEach((place, i) => {
                if (y[i] !== null && x.length <= 60)
                    drawMarker(
                        ctx,
                        this.planners[planner].marker,
                        ...at(place, y[i]!),
                        4.5 * pixels,
                        color(planner),
                    );
            });
        ctx.restore();
    }

    /** Names the run of the dot that is nearest to a place of the drawing, if one is near. */
    private point(left: number, top: number): void {
        const u = this.chart!;
        const kReach = 14; // pixels
        let least = kReach * kReach;
        this.nearest = null;
        for (const dot of this.model.dots) {
            const distance = (u.valToPos(dot.x, "x") - left) ** 2 + (u.valToPos(dot.y, "y") - top) ** 2;
            if (distance < least) {
                least = distance;
                this.nearest = dot;
            }
        }
        this.tip.hidden = !this.nearest;
        u.over.style.cursor = this.nearest ? "pointer" : "crosshair";
        if (!this.nearest) return;
        const { x, y, text } = this.nearest;
        const across = this.model.xNames ? "" : `${valueText(x, this.model.xIsTime)}, `;
        this.tip.textContent = `${text}: ${across}${valueText(y, this.model.yIsTime)}`;
        const toLeft = u.valToPos(x, "x") > u.over.clientWidth / 2;
        this.tip.style.left = toLeft ? "auto" : `${u.valToPos(x, "x") + 12}px`;
        this.tip.style.right = toLeft ? `${u.over.clientWidth - u.valToPos(x, "x") + 12}px` : "auto";
        this.tip.style.top = `${Math.max(u.valToPos(y, "y") - 30, 0)}px`;
    }
}

const asAsked: uPlot.Range.Function = (_, min, max) => [min, max];

/** How many numbers an axis has room for. */
function roomFor(u: uPlot, axis: number): number {
    const kRoom = [80, 36]; // CSS pixels across, up
    const size = (axis === 0 ? u.bbox.width : u.bbox.height) / devicePixelRatio;
    return Math.max(Math.floor(size / kRoom[axis]), 1);
}

/** One name in so many has room. */
function everyName(u: uPlot, count: number): number {
    const kRoom = 16; // CSS pixels
    return Math.max(Math.ceil((kRoom * count * devicePixelRatio) / Math.max(u.bbox.width, 1)), 1);
}

function shortened(name: string): string {
    const kLongest = 24;
    return name.length > kLongest ? `${name.slice(0, kLongest - 1)}…` : name;
}

function valueText(value: number, isTime: boolean): string {
    return isTime && value !== 0 ? formatSeconds(value) : formatNumber(value);
}

/** gnuplot's "(12,5)" as lengths. */
function dashesOf(dashes: string): number[] {
    return (dashes.match(/\d+/g) ?? []).map((length) => Number(length) * 0.7);
}

/** gnuplot's filled markers: 5 square, 7 circle, 9 and 11 triangles, 13 diamond, 15 pentagon. */
export function drawMarker(
    ctx: CanvasRenderingContext2D,
    marker: number,
    x: number,
    y: number,
    radius: number,
    color: string,
): void {
    ctx.fillStyle = color;
    ctx.beginPath();
    if (marker === 7) ctx.arc(x, y, radius, 0, 2 * Math.PI);
    else {
        const [corners, turn] = { 5: [4, 0.125], 9: [3, 0.25], 11: [3, 0.75], 13: [4, 0.25], 15: [5, 0.25] }[
            marker
        ] ?? [4, 0.125];
        for (let corner = 0; corner < corners; ++corner) {
            const angle = 2 * Math.PI * (turn + corner / corners);
            ctx.lineTo(x + 1.2 * radius * Math.cos(angle), y - 1.2 * radius * Math.sin(angle));
        }
        ctx.closePath();
    }
    ctx.fill();
}
