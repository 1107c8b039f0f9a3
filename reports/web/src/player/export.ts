// Frames and animations as files. All panels stand side by side in them, as on the page.
import type { Theme } from "../page/theme";
import { GifWriter } from "./gif";
import type { Panel } from "./panel";
import { SvgPen } from "./pen";
import type { Marks } from "./view";
import { type VideoChunk, webmFile } from "./webm";

/** A panel and the words above it. */
export interface Shown {
    panel: Panel;
    caption: string;
}

/** The panels beside each other with their captions, as they are now; at most so many pixels wide. */
export function composed(shown: Shown[], theme: Theme, mostPixels = Infinity): HTMLCanvasElement {
    const kGap = 8;
    const full = shown.reduce((sum, { panel }) => sum + panel.canvas.width, kGap * (shown.length - 1));
    const factor = Math.min(1, mostPixels / full);
    const kLetters = 13 * Math.max(factor * Math.min(devicePixelRatio || 1, 2), 0.8);
    const top = Math.round(1.6 * kLetters);
    const picture = document.createElement("canvas");
    picture.width = Math.max(Math.round(full * factor), 1);
    const tallest = shown.reduce((most, { panel }) => Math.max(most, panel.canvas.height), 0);
    picture.height = top + Math.max(Math.round(tallest * factor), 1);
    const context = picture.getContext("2d", { alpha: false, willReadFrequently: true })!;
    context.fillStyle = theme.cell;
    context.fillRect(0, 0, picture.width, picture.height);
    context.font = `${kLetters}px system-ui, sans-serif`;
    context.textBaseline = "middle";
    let left = 0;
    for (const { panel, caption } of shown) {
        const [width, height] = [panel.canvas.width * factor, panel.canvas.height * factor];
        context.fillStyle = theme.text;
        context.fillText(caption, left + 4, top / 2, width - 8);
        context.drawImage(panel.canvas, left, top, width, height);
        left += width + kGap * factor;
    }
    return picture;
}

export function pngOf(picture: HTMLCanvasElement): Promise<Blob> {
    return new Promise((resolve, reject) =>
        picture.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture"))), "image/png"),
    );
}

/** One panel as vectors. */
export function svgOf(panel: Panel, theme: Theme, marks: Marks, title: string): Blob {
    const pen = new SvgPen();
    panel.drawWith(pen, theme, marks);
    return new Blob([pen.svg(title)], { type: "image/svg+xml" });
}

export interface Recording {
    length: number; // the time at which the animation ends
    pictureAt: (time: number, mostPixels?: number) => HTMLCanvasElement;
    onProgress: (share: number) => void;
    isCancelled: () => boolean;
}

const nextTask = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** The whole animation, in so many frames. */
export async function gifOf(recording: Recording, frames: number, hundredths: number): Promise<Blob | null> {
    const kMostPixels = 720;
    const frame = (i: number): ImageData => {
        const time = (recording.length * i) / Math.max(frames - 1, 1);
        const picture = recording.pictureAt(time, kMostPixels);
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

/** Browsers encode video on pages from files, but not all of them do. */
export function canEncodeVideo(): boolean {
    return typeof VideoEncoder !== "undefined";
}

/** The animation as it plays, for so many seconds, however long it takes to make it. */
export async function webmOf(recording: Recording, seconds: number): Promise<Blob | null> {
    const kFramesASecond = 30;
    const kKeyEvery = 60; // frames
    const kQueue = 4; // frames that wait for the encoder
    const { width: across, height: down } = recording.pictureAt(0);
    const [width, height] = [2 * Math.ceil(across / 2), 2 * Math.ceil(down / 2)]; // codecs like them even
    const target = new OffscreenCanvas(width, height);
    const context = target.getContext("2d", { alpha: false })!;
    const chunks: VideoChunk[] = [];
    const encoder = new VideoEncoder({
        output: (chunk) => {
            const data = new Uint8Array(chunk.byteLength);
            chunk.copyTo(data);
            const milliseconds = Math.round(chunk.timestamp / 1000);
            chunks.push({ milliseconds, isKey: chunk.type === "key", data });
        },
        error: () => undefined, // encode() and flush() throw it
    });
    encoder.configure({ codec: "vp8", width, height, bitrate: 6_000_000, framerate: kFramesASecond });
    const count = Math.max(Math.round(seconds * kFramesASecond), 2);
    for (let i = 0; i < count && !recording.isCancelled(); ++i) {
        context.drawImage(recording.pictureAt((recording.length * i) / (count - 1)), 0, 0);
        const frame = new VideoFrame(target, { timestamp: Math.round((i * 1e6) / kFramesASecond) });
        encoder.encode(frame, { keyFrame: i % kKeyEvery === 0 });
        frame.close();
        recording.onProgress((i + 1) / count);
        do await nextTask();
        while (encoder.encodeQueueSize > kQueue);
    }
    if (!recording.isCancelled()) await encoder.flush();
    encoder.close();
    const milliseconds = (1000 * count) / kFramesASecond;
    return recording.isCancelled() ? null : webmFile({ codec: "V_VP8", width, height, milliseconds }, chunks);
}
