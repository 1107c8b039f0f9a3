// Frames and animations as files. All panels stand side by side in them, as on the page.
import type { Theme } from "../page/theme";
import { GifWriter } from "./gif";
import type { Panel } from "./panel";
import { SvgPen } from "./pen";
import type { SceneOptions } from "./scene";

const kGap = 8;

/** The panels' canvases beside each other, as they are now; at most so many pixels wide. */
export function composed(panels: Panel[], theme: Theme, mostPixels = Infinity): HTMLCanvasElement {
    const width = panels.reduce((sum, panel) => sum + panel.canvas.width, kGap * (panels.length - 1));
    const height = panels.reduce((most, panel) => Math.max(most, panel.canvas.height), 0);
    const factor = Math.min(1, mostPixels / width);
    const picture = document.createElement("canvas");
    picture.width = Math.max(Math.round(width * factor), 1);
    picture.height = Math.max(Math.round(height * factor), 1);
    const context = picture.getContext("2d", { alpha: false, willReadFrequently: true })!;
    context.fillStyle = theme.cell;
    context.fillRect(0, 0, picture.width, picture.height);
    let left = 0;
    for (const { canvas } of panels) {
        context.drawImage(canvas, left * factor, 0, canvas.width * factor, canvas.height * factor);
        left += canvas.width + kGap;
    }
    return picture;
}

export function pngOf(panels: Panel[], theme: Theme): Promise<Blob> {
    return new Promise((resolve, reject) =>
        composed(panels, theme).toBlob(
            (blob) => (blob ? resolve(blob) : reject(new Error("no picture"))),
            "image/png",
        ),
    );
}

/** One panel as vectors. */
export function svgOf(panel: Panel, theme: Theme, options: SceneOptions, title: string): Blob {
    const pen = new SvgPen();
    panel.drawWith(pen, theme, options);
    return new Blob([pen.svg(title)], { type: "image/svg+xml" });
}

export interface Recording {
    length: number; // the time at which the animation ends
    draw: (time: number) => void; // brings the panels to a time
    onProgress: (share: number) => void;
    isCancelled: () => boolean;
}

const nextTask = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** The whole animation, in so many frames. */
export async function gifOf(
    panels: Panel[],
    theme: Theme,
    recording: Recording,
    frames: number,
    hundredths: number,
): Promise<Blob | null> {
    const kMostPixels = 720;
    const frame = (i: number): ImageData => {
        recording.draw((recording.length * i) / Math.max(frames - 1, 1));
        const picture = composed(panels, theme, kMostPixels);
        return picture.getContext("2d")!.getImageData(0, 0, picture.width, picture.height);
    };
    const samples = [0, Math.floor(frames / 2), frames - 1].map(frame);
    const writer = new GifWriter(
        samples[0].width,
        samples[0].height,
        samples.map(({ data }) => data),
    );
    for (let i = 0; i < frames; ++i) {
        writer.addFrame(frame(i).data, i === frames - 1 ? 150 : hundredths);
        recording.onProgress((i + 1) / frames);
        await nextTask();
        if (recording.isCancelled()) return null;
    }
    return writer.finish();
}

export function canRecordVideo(): boolean {
    return typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported("video/webm");
}

/** The animation as it plays, for so many seconds. */
export async function webmOf(
    panels: Panel[],
    theme: Theme,
    recording: Recording,
    seconds: number,
): Promise<Blob | null> {
    const kFramesASecond = 30;
    const target = composed(panels, theme);
    const context = target.getContext("2d")!;
    const recorder = new MediaRecorder(target.captureStream(kFramesASecond), { mimeType: "video/webm" });
    const pieces: Blob[] = [];
    recorder.addEventListener("dataavailable", (event) => pieces.push(event.data));
    const stopped = new Promise((resolve) => recorder.addEventListener("stop", resolve));
    recorder.start();
    const start = performance.now();
    for (let share = 0; share < 1 && !recording.isCancelled();) {
        await new Promise(requestAnimationFrame);
        share = Math.min((performance.now() - start) / (1000 * seconds), 1);
        recording.draw(recording.length * share);
        context.drawImage(composed(panels, theme), 0, 0);
        recording.onProgress(share);
    }
    recorder.stop();
    await stopped;
    return recording.isCancelled() ? null : new Blob(pieces, { type: "video/webm" });
}
