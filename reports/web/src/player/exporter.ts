// The buttons that make files of what the player shows.
import { button, download, el, fileName } from "../page/dom";
import type { Theme } from "../page/theme";
import { type Recording, canRecordVideo, gifOf, pngOf, svgOf, webmOf } from "./export";
import type { Panel } from "./panel";
import type { SceneOptions } from "./scene";

export interface Stage {
    panels: () => Panel[];
    theme: () => Theme;
    options: (panel: number) => SceneOptions;
    name: () => string; // of the case
    length: () => number;
    speed: () => number;
    time: () => number;
    drawAt: (time: number) => void;
}

export class Exporter {
    readonly element = el("div", { class: "bar", role: "group", "aria-label": "Export" });
    private readonly progress = el("progress", { max: 1, value: 0, "aria-label": "Progress of the export" });
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
        );
        if (canRecordVideo())
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
        download(`${this.frameName()}.png`, await pngOf(this.stage.panels(), this.stage.theme()));
    }

    private saveSvg(): void {
        this.stage.panels().forEach((panel, i) => {
            const suffix = i === 0 ? "" : `-${i + 1}`;
            const svg = svgOf(
                panel,
                this.stage.theme(),
                this.stage.options(i),
                panel.canvas.getAttribute("aria-label") ?? "",
            );
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
        return this.save("gif", (recording) =>
            gifOf(this.stage.panels(), this.stage.theme(), recording, frames, Math.min(hundredths, 50)),
        );
    }

    private saveWebm(): Promise<void> {
        const kMostSeconds = 60;
        const seconds = Math.min(this.stage.length() / this.stage.speed(), kMostSeconds);
        return this.save("webm", (recording) =>
            webmOf(this.stage.panels(), this.stage.theme(), recording, seconds),
        );
    }

    private async save(
        extension: string,
        make: (recording: Recording) => Promise<Blob | null>,
    ): Promise<void> {
        const time = this.stage.time();
        this.isCancelled = false;
        this.showProgress(true);
        const file = await make({
            length: this.stage.length(),
            draw: (at) => this.stage.drawAt(at),
            onProgress: (share) => (this.progress.value = share),
            isCancelled: () => this.isCancelled,
        });
        this.showProgress(false);
        this.stage.drawAt(time);
        if (file) download(`${fileName(this.stage.name())}.${extension}`, file);
    }
}
