// The buttons that make files of what the player shows.
import { button, download, el, fileName } from "../page/dom";
import type { Theme } from "../page/theme";
import { type Recording, type Shown, canEncodeVideo, composed, gifOf, pngOf, svgOf, webmOf } from "./export";
import type { Marks } from "./view";

export interface Stage {
    shown: () => Shown[];
    theme: () => Theme;
    marks: (panel: number) => Marks;
    name: () => string; // of the case
    length: () => number;
    speed: () => number;
    time: () => number;
    drawAt: (time: number) => void;
}

export class Exporter {
    readonly element = el("div", { class: "bar", role: "group", "aria-label": "Export" });
    private readonly progress = el("progress", { max: 1, value: 0, "aria-label": "Progress of the export" });
    private readonly failure = el("output", { class: "quiet" });
    private readonly cancel: HTMLButtonElement;
    private isCancelled = false;

    constructor(private readonly stage: Stage) {
        this.cancel = button("Cancel", "Cancel the export", () => (this.isCancelled = true));
        this.element.append(
            el("span", { class: "quiet" }, "Export"),
            button("PNG", "This frame as PNG", () => void this.savePng()),
            button("SVG", "This frame as SVG", () => this.saveSvg()),
            button("GIF", "The animation as GIF", () => void this.saveGif()),
            this.progress,
            this.cancel,
            this.failure,
        );
        if (canEncodeVideo())
            this.progress.before(
                button("WebM", "The animation as WebM, at the chosen speed", () => void this.saveWebm()),
            );
        this.showProgress(false);
    }

    private showProgress(isShown: boolean): void {
        this.progress.hidden = this.cancel.hidden = !isShown;
        this.progress.value = 0;
    }

    private frameName(): string {
        return fileName(this.stage.name(), String(Math.floor(this.stage.time())));
    }

    private async savePng(): Promise<void> {
        download(`${this.frameName()}.png`, await pngOf(composed(this.stage.shown(), this.stage.theme())));
    }

    private saveSvg(): void {
        this.stage.shown().forEach(({ panel, caption }, i) => {
            const suffix = i === 0 ? "" : `-${i + 1}`;
            const svg = svgOf(panel, this.stage.theme(), this.stage.marks(i), caption);
            download(`${this.frameName()}${suffix}.svg`, svg);
        });
    }

    /** As many frames as the animation needs at its speed, within bounds. */
    private saveGif(): Promise<void> {
        const kFramesASecond = 12;
        const kMostFrames = 240;
        const seconds = this.stage.length() / this.stage.speed();
        const frames = Math.min(Math.max(Math.round(seconds * kFramesASecond), 2), kMostFrames);
        const hundredths = Math.max(Math.round((100 * seconds) / frames), 4);
        return this.save("gif", (recording) => gifOf(recording, frames, Math.min(hundredths, 50)));
    }

    private saveWebm(): Promise<void> {
        const kMostSeconds = 60;
        const seconds = Math.min(this.stage.length() / this.stage.speed(), kMostSeconds);
        return this.save("webm", (recording) => webmOf(recording, seconds));
    }

    private async save(
        extension: string,
        make: (recording: Recording) => Promise<Blob | null>,
    ): Promise<void> {
        const time = this.stage.time();
        this.isCancelled = false;
        this.showProgress(true);
        this.failure.textContent = "";
        try {
            const file = await make({
                length: this.stage.length(),
                pictureAt: (at, mostPixels) => {
                    this.stage.drawAt(at);
                    return composed(this.stage.shown(), this.stage.theme(), mostPixels);
                },
                onProgress: (share) => (this.progress.value = share),
                isCancelled: () => this.isCancelled,
            });
            if (file) download(`${fileName(this.stage.name())}.${extension}`, file);
        } catch (error) {
            this.failure.textContent = `This browser could not make the file: ${String(error)}`;
        } finally {
            this.showProgress(false);
            this.stage.drawAt(time);
        }
    }
}
