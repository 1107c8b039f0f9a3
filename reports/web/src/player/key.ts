// What the colours of a picture mean, where that is not plain.
import { el } from "../page/dom";
import { type Theme, kRamp } from "../page/theme";
import type { Marks } from "./view";

export function keyOf(marks: Marks, what: string, theme: Theme): HTMLElement[] {
    if (marks.heat) return [gradientEntry(kRamp, `${what}: 1 to ${marks.heatMost}, logarithmic`)];
    if (!marks.blocks) return [];
    return [
        legendEntry(theme.isthmus, "isthmuses, where robots cannot pass each other"),
        gradientEntry(theme.blocks, "blocks, a tint each"),
    ];
}

/** \param dash pixels; 0 for a line without gaps */
export function legendEntry(color: string, text: string, dash = 0): HTMLElement {
    const mark = el("span", { class: "swatch", "aria-hidden": true });
    if (dash === 0) mark.style.backgroundColor = color;
    else {
        mark.style.width = `${3 * dash}px`;
        mark.style.background = `repeating-linear-gradient(90deg, ${color} 0 ${dash}px, transparent 0 ${2 * dash}px)`;
    }
    return el("span", { class: "entry" }, mark, text);
}

function gradientEntry(colors: string[], text: string): HTMLElement {
    const mark = el("span", { class: "swatch gradient", "aria-hidden": true });
    mark.style.background = `linear-gradient(90deg, ${colors.join(",")})`;
    return el("span", { class: "entry" }, mark, text);
}
