// Colours of what is drawn on canvases, light and dark; those of the page itself are in style.css.

export interface Theme {
    isDark: boolean;
    background: string; // of drawings: walls of a map
    cell: string; // free cells and vertices
    edge: string;
    text: string;
    faint: string; // grid lines of charts
    outline: string; // around robots
    conflict: string;
    rotation: string;
    isthmus: string;
    blocks: string[]; // tints, one after another
}

const kLight: Theme = {
    isDark: false,
    background: "#dfe3e8",
    cell: "#ffffff",
    edge: "#a3abb5",
    text: "#1c2128",
    faint: "#d9dde2",
    outline: "#1c2128",
    conflict: "#c40018",
    rotation: "#7a3fb0",
    isthmus: "#d55e00",
    blocks: ["#cfe6f5", "#d3efe2", "#f6e3c1", "#f1dbe8", "#dce3ff", "#e9ecc9"],
};

const kDark: Theme = {
    isDark: true,
    background: "#14171c",
    cell: "#2b313a",
    edge: "#5a6472",
    text: "#e8ecf1",
    faint: "#363d47",
    outline: "#0b0d10",
    conflict: "#ff5a6a",
    rotation: "#c79bff",
    isthmus: "#ff8f3f",
    blocks: ["#1f4560", "#1d4f3d", "#5a4419", "#54304a", "#34407a", "#4b4f1f"],
};

const darkIsPreferred = matchMedia("(prefers-color-scheme: dark)");

/** The user's choice where there is one ("light", "dark"), else the system's. */
export function themeOf(choice: string): Theme {
    const isDark = choice === "dark" || (choice !== "light" && darkIsPreferred.matches);
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    return isDark ? kDark : kLight;
}

export function onSystemTheme(listener: () => void): void {
    darkIsPreferred.addEventListener("change", listener);
}

/** A planner's colour: black curves would vanish on dark ground. */
export function curveColor(color: string, theme: Theme): string {
    return theme.isDark && color === "#000000" ? "#ffffff" : color;
}

export function channels(color: string): [number, number, number] {
    const number = parseInt(color.slice(1), 16);
    return [number >> 16, (number >> 8) & 255, number & 255];
}

/** Black or white, whichever reads better on that colour. */
export function textColorOn(color: string): string {
    const [red, green, blue] = channels(color);
    return 0.299 * red + 0.587 * green + 0.114 * blue > 0.55 * 255 ? "#000000" : "#ffffff";
}

// Some colours of the map "viridis", which grows lighter evenly and is told apart by colour-blind readers.
export const kRamp = ["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#fde725"];

/** A colour for a share from 0 to 1. */
export function rampColor(share: number): [number, number, number] {
    const at = Math.min(Math.max(share, 0), 1) * (kRamp.length - 1);
    const below = Math.min(Math.floor(at), kRamp.length - 2);
    const part = at - below;
    const [from, to] = [channels(kRamp[below]), channels(kRamp[below + 1])];
    return from.map((low, i) => Math.round(low * (1 - part) + to[i] * part)) as [number, number, number];
}

export function cssColor([red, green, blue]: [number, number, number]): string {
    return `rgb(${red},${green},${blue})`;
}
