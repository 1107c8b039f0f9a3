// The solution's course under the player: robots at their goals, robots that move, occupancy of what is
// shown, and events; it is also where the time is chosen.
import { el } from "../page/dom";
import type { Theme } from "../page/theme";
import { legendEntry } from "./key";
import { countInside } from "./measures";
import { counted } from "./words";
import type { Track } from "./track";

/** What is shown. The first track has all its curves, the others their robots at goals. */
export interface Course {
    tracks: Track[];
    shares: number[]; // of the strip's width, for each track
    seen: Uint8Array | null; // marks of the vertices that are shown; null where all are
    theme: Theme;
}

interface Curve {
    name: string;
    color: string;
    values: ArrayLike<number>;
    most: number;
    share: number; // of the width
    dash: number; // pixels; 0 for a line without gaps
}

export class Strip {
    readonly canvas = el("canvas", {
        class: "strip",
        role: "slider",
        tabindex: 0,
        "aria-label": "Time",
        "aria-valuemin": 0,
    });
    readonly legend = el("p", { class: "legend" });
    private readonly context = this.canvas.getContext("2d")!;
    private picture: HTMLCanvasElement | null = null; // all but the mark of the present time
    private pictureKey: unknown[] = [];

    constructor(onSeek: (share: number) => void) {
        const seek = (event: PointerEvent): void => {
            const share = (event.offsetX - 1) / Math.max(this.canvas.clientWidth - 2, 1);
            onSeek(Math.min(Math.max(share, 0), 1));
        };
        this.canvas.addEventListener("pointerdown", (event) => {
            this.canvas.setPointerCapture(event.pointerId);
            seek(event);
        });
        this.canvas.addEventListener("pointermove", (event) => {
            if (event.buttons & 1) seek(event);
        });
    }

    draw(course: Course, time: number, length: number): void {
        const pixels = Math.min(devicePixelRatio || 1, 2);
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (width === 0) return;
        const { tracks, shares, seen, theme } = course;
        const key = [...tracks, ...shares, seen, theme, width, height, pixels];
        if (
            !this.picture ||
            key.length !== this.pictureKey.length ||
            key.some((part, i) => part !== this.pictureKey[i])
        ) {
            this.canvas.width = width * pixels;
            this.canvas.height = height * pixels;
            this.picture = document.createElement("canvas");
            this.picture.width = this.canvas.width;
            this.picture.height = this.canvas.height;
            const context = this.picture.getContext("2d")!;
            context.scale(pixels, pixels);
            this.paint(context, course, width, height);
            this.pictureKey = key;
        }
        this.context.setTransform(1, 0, 0, 1, 0, 0);
        this.context.drawImage(this.picture, 0, 0);
        this.context.scale(pixels, pixels);
        this.context.fillStyle = theme.text;
        this.context.fillRect(((width - 2) * time) / Math.max(length, 1), 0, 2, height);
        this.canvas.setAttribute("aria-valuemax", String(length));
        this.canvas.setAttribute("aria-valuenow", String(Math.floor(time)));
        this.canvas.setAttribute("aria-valuetext", `step ${Math.floor(time)} of ${length}`);
    }

    private paint(context: CanvasRenderingContext2D, course: Course, width: number, height: number): void {
        const { theme, shares } = course;
        const [track] = course.tracks;
        context.fillStyle = theme.cell;
        context.fillRect(0, 0, width, height);
        const curves = curvesOf(course);
        for (const curve of curves) paintCurve(context, curve, width, height);
        let last = -1;
        for (const event of track.events) {
            const x = Math.round(
                1 + ((width - 2) * shares[0] * (event.step + 0.5)) / Math.max(track.length, 1),
            );
            if (x === last && event.kind === "rotation") continue;
            last = x;
            context.fillStyle = event.kind === "conflict" ? theme.conflict : theme.rotation;
            context.fillRect(x - 1, event.kind === "conflict" ? 0 : height - 7, 2, 7);
        }
        this.legend.replaceChildren(
            ...curves.map(({ name, color, most, dash }) =>
                legendEntry(color, `${name} (top: ${most})`, dash),
            ),
        );
        const conflicts = track.events.filter((event) => event.kind === "conflict").length;
        const rotations = track.events.length - conflicts;
        if (conflicts > 0) this.legend.append(legendEntry(theme.conflict, counted(conflicts, "conflict")));
        if (rotations > 0) this.legend.append(legendEntry(theme.rotation, counted(rotations, "rotation")));
    }
}

function curvesOf({ tracks, shares, seen, theme }: Course): Curve[] {
    const [track] = tracks;
    const { atGoal, moving } = track.measures;
    const robots = track.instance.starts.length;
    const vertices = seen ? seen.reduce((sum, mark) => sum + mark, 0) : track.instance.graph.vertexCount;
    const inside = seen
        ? countInside(track.instance, track.steps, seen)
        : new Uint32Array(track.length + 1).fill(robots);
    const percent = (count: number): number => Math.round((1000 * count) / Math.max(vertices, 1)) / 10;
    const busiest = moving.reduce((most, count) => Math.max(most, count), 1);
    const fullest = inside.reduce((most, count) => Math.max(most, count), 0);
    const goalColor = theme.isDark ? "#56b4e9" : "#0072b2";
    const whole = { share: shares[0], dash: 0 };
    return [
        { name: "robots at their goals", color: goalColor, values: atGoal, most: robots, ...whole },
        {
            name: "robots that move",
            color: theme.isDark ? "#e69f00" : "#b35900",
            values: moving,
            most: busiest,
            ...whole,
        },
        {
            name: `occupancy of ${seen ? "what is shown" : "the graph"}, robots a vertex, in %`,
            color: theme.isDark ? "#cc79a7" : "#8a3d68",
            values: Float64Array.from(inside, percent),
            most: Math.max(percent(fullest), 0.1),
            ...whole,
        },
        ...tracks.slice(1).map((other, i) => ({
            name: `at their goals in solution ${i + 2}`,
            color: goalColor,
            values: other.measures.atGoal,
            most: robots,
            share: shares[i + 1],
            dash: [7, 4, 2][i],
        })),
    ];
}

/** Where many steps share a pixel, their range is drawn. */
function paintCurve(context: CanvasRenderingContext2D, curve: Curve, width: number, height: number): void {
    const kMargin = 3;
    const count = curve.values.length;
    const across = (width - 2) * curve.share;
    const place = (value: number): number => height - kMargin - ((height - 2 * kMargin) * value) / curve.most;
    context.beginPath();
    const kSteps = Math.min(count, Math.max(Math.round(across), 1));
    for (let column = 0; column < kSteps; ++column) {
        const first = Math.floor((count * column) / kSteps);
        const end = Math.max(Math.floor((count * (column + 1)) / kSteps), first + 1);
        let least = Infinity;
        let most = -Infinity;
        for (let i = first; i < end; ++i) {
            least = Math.min(least, curve.values[i]);
            most = Math.max(most, curve.values[i]);
        }
        const x = 1 + (across * column) / Math.max(kSteps - 1, 1);
        context.lineTo(x, place(least));
        if (most > least) context.lineTo(x, place(most));
    }
    context.strokeStyle = curve.color;
    context.lineWidth = 1.4;
    context.setLineDash(curve.dash === 0 ? [] : [curve.dash, curve.dash]);
    context.stroke();
}
