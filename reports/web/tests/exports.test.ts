// What the player's and the charts' buttons write are files that browsers can show, and they show something.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { browser, exported, report } from "./campaignPage";

interface Decoded {
    width: number;
    height: number;
    seconds?: number; // of a video
    frames: { colors: number; sum: number; milliseconds: number }[]; // distinct colours, their sum
}

async function kept(name: string, button: RegExp): Promise<Buffer> {
    const bytes = await exported(button);
    const folder = process.env.MRPP_PICTURES;
    if (folder) writeFileSync(join(folder, name), bytes);
    return bytes;
}

/** Frames of a picture, as the browser decodes it. */
async function decoded(bytes: Buffer, type: string): Promise<Decoded> {
    return browser.page.evaluate(
        async ([data, kind]) => {
            const binary = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
            const frameOf = (
                source: CanvasImageSource,
                width: number,
                height: number,
                milliseconds: number,
            ) => {
                const canvas = new OffscreenCanvas(width, height);
                const context = canvas.getContext("2d")!;
                context.drawImage(source, 0, 0, width, height);
                const pixels = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
                return {
                    colors: new Set(pixels).size,
                    sum: pixels.reduce((sum, pixel) => (sum * 31 + pixel) % 4294967291, 0),
                    milliseconds,
                };
            };
            if (kind === "image/svg+xml" || kind === "image/png") {
                const image = new Image();
                image.src = URL.createObjectURL(new Blob([binary], { type: kind }));
                await image.decode();
                const { naturalWidth: width, naturalHeight: height } = image;
                return { width, height, frames: [frameOf(image, width, height, 0)] };
            }
            if (kind === "image/gif") {
                const decoder = new ImageDecoder({ data: binary, type: kind });
                await decoder.tracks.ready;
                await decoder.completed;
                const { frameCount } = decoder.tracks.selectedTrack!;
                const frames = [];
                let [width, height] = [0, 0];
                for (let frameIndex = 0; frameIndex < frameCount; ++frameIndex) {
                    const { image } = await decoder.decode({ frameIndex });
                    [width, height] = [image.displayWidth, image.displayHeight];
                    frames.push(frameOf(image, width, height, (image.duration ?? 0) / 1000));
                    image.close();
                }
                return { width, height, frames };
            }
            const video = document.createElement("video");
            video.src = URL.createObjectURL(new Blob([binary], { type: kind }));
            const happened = (what: string): Promise<unknown> =>
                new Promise((resolve) => video.addEventListener(what, resolve, { once: true }));
            video.muted = true;
            video.load();
            await happened("loadeddata");
            const { videoWidth: width, videoHeight: height } = video;
            const frames = [];
            for (const share of [0, 0.5, 0.95]) {
                video.currentTime = share * video.duration;
                await happened("seeked");
                frames.push(frameOf(video, width, height, video.currentTime * 1000));
            }
            return { width, height, frames, seconds: video.duration };
        },
        [bytes.toString("base64"), type],
    );
}

const sums = ({ frames }: Decoded): number[] => frames.map(({ sum }) => sum);

test("a frame as PNG and as SVG is the picture of the page", async () => {
    await browser.open(report, "view=player&t=4");
    await browser.readout();
    const box = (await browser.page.locator(".panel canvas").boundingBox())!;
    const png = await decoded(await kept("export.png", /^This frame as PNG/), "image/png");
    assert.equal(png.width, Math.round(box.width - 2), "the canvas without its border");
    assert.ok(png.height > box.height, "the caption stands above it");
    assert.ok(png.frames[0].colors > 8, `${png.frames[0].colors} colours`);
    const svg = await decoded(await kept("export.svg", /^This frame as SVG/), "image/svg+xml");
    assert.deepEqual([svg.width, svg.height], [Math.round(box.width - 2), Math.round(box.height - 2)]);
    assert.ok(svg.frames[0].colors > 8, `${svg.frames[0].colors} colours`);
});

test("panels side by side become one picture", async () => {
    await browser.open(report, "view=player&t=4&p=0:steps~1:steps&heat=traffic");
    await browser.readout();
    const boxes = await browser.page
        .locator(".panel canvas")
        .evaluateAll((all) => all.map(({ clientWidth }) => clientWidth));
    const png = await decoded(await kept("export-two.png", /^This frame as PNG/), "image/png");
    assert.equal(png.width, boxes[0] + boxes[1] + 8);
});

test("the animation as GIF has its frames, which differ, for as long as it plays", async () => {
    await browser.open(report, "view=player&speed=10");
    const steps = Number((await browser.readout()).match(/^Step 0 of (\d+)/)![1]);
    const gif = await decoded(await kept("export.gif", /^The animation as GIF/), "image/gif");
    assert.equal(gif.width, 720);
    assert.equal(gif.frames.length, Math.round((steps / 10) * 12));
    assert.ok(new Set(sums(gif)).size > 0.9 * gif.frames.length, "frames differ");
    assert.ok(gif.frames.every(({ colors }) => colors > 8));
    const most = gif.frames.slice(0, -1).reduce((sum, { milliseconds }) => sum + milliseconds, 0);
    assert.ok(Math.abs(most - (1000 * steps) / 10) < 500, `${most} ms`);
});

test("the animation as WebM plays for as long as it should", async () => {
    await browser.open(report, "view=player&speed=30");
    const steps = Number((await browser.readout()).match(/^Step 0 of (\d+)/)![1]);
    const box = (await browser.page.locator(".panel canvas").boundingBox())!;
    const webm = await decoded(await kept("export.webm", /^The animation as WebM/), "video/webm");
    assert.equal(webm.width, 2 * Math.ceil((box.width - 2) / 2));
    assert.equal(new Set(sums(webm)).size, 3);
    assert.ok(webm.frames.every(({ colors }) => colors > 8));
    assert.ok(Math.abs(webm.seconds! - steps / 30) < 0.1, `${webm.seconds} s`);
});

test("an export can be cancelled", async () => {
    await browser.open(report, "view=player&speed=0.25&t=3");
    const before = await browser.readout();
    await browser.page.getByRole("button", { name: /^The animation as GIF/ }).click();
    const progress = browser.page.getByLabel("Progress of the export");
    await progress.waitFor({ state: "visible" });
    await browser.page.getByRole("button", { name: "Cancel the export" }).click();
    await progress.waitFor({ state: "hidden" });
    assert.equal(await browser.readout(), before, "the player is where it was");
});

test("a chart as PNG has its planners beneath", async () => {
    await browser.open(report, "view=charts&theme=dark");
    await browser.settle();
    const chart = await browser.page
        .locator(".plot canvas")
        .evaluate((canvas) => (canvas as HTMLCanvasElement).height);
    const png = await decoded(await kept("export-chart.png", /^This chart as PNG/), "image/png");
    assert.ok(png.height > chart + 3 * 20, `${png.height}`);
    assert.ok(png.frames[0].colors > 8);
});

test("no export is left out of these tests", async () => {
    await browser.open(report, "view=player");
    await browser.readout();
    assert.deepEqual(
        (await browser.undriven("#view-player")).filter((name) => /^(This|The animation)/.test(name)),
        [],
    );
});
