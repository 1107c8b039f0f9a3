// Large pages: how many bytes they have and how quickly they answer. Limits are of processor time, since
// other programs may keep the machine busy; what was measured is said in words.
import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { browser, picture, report, scratch } from "./campaignPage";
import { enlarged } from "./largePage";

describe("size and speed", () => {
    /** Opens the table of so many runs and returns the page's size in bytes. */
    async function openLarge(count: number): Promise<number> {
        const file = join(scratch.path, `${count}.html`);
        writeFileSync(file, enlarged(readFileSync(report, "utf8"), count));
        await browser.open(file, "view=runs");
        await browser.page.waitForSelector(".body .row");
        return readFileSync(file).length;
    }

    test("10 000 runs: size and filtering", async (context) => {
        const bytes = await openLarge(10_000);
        assert.ok(bytes < 5e6, `${bytes} bytes`);
        const filters: [string, string][] = [
            ["Filter Planner", "img"],
            ["Filter Robots", ">30"],
            ["Search all texts of the runs", "room solved"],
        ];
        const start = await browser.processorTime();
        const times: number[] = [];
        for (const [label, text] of filters) {
            const took = await browser.page.getByLabel(label).evaluate((field, value) => {
                const begin = performance.now();
                (field as HTMLInputElement).value = value;
                field.dispatchEvent(new Event("input"));
                document.body.getBoundingClientRect(); // and lays it out
                return performance.now() - begin;
            }, text);
            times.push(took);
            assert.match(await browser.text(".count"), /^[1-9]\d* of 10000 runs$/);
        }
        const each = ((await browser.processorTime()) - start) / filters.length;
        context.diagnostic(
            `${bytes} bytes; filters took ${times.map((time) => time.toFixed(1)).join(", ")} ms, ${(1000 * each).toFixed(1)} ms of processor each`,
        );
        assert.ok(each < 0.1, `${each} s of processor a filter`);
    });

    test("100 000 rows scroll", async (context) => {
        const bytes = await openLarge(100_000);
        const start = await browser.processorTime();
        const [frames, seconds, rows] = await browser.page.evaluate(async () => {
            const table = document.querySelector(".table")!;
            const begin = performance.now();
            let most = 0;
            const kFrames = 60;
            for (let frame = 1; frame <= kFrames; ++frame) {
                table.scrollTop = (frame * (table.scrollHeight - table.clientHeight)) / kFrames;
                await new Promise(requestAnimationFrame);
                most = Math.max(most, table.querySelectorAll(".body .row").length);
            }
            return [kFrames, (performance.now() - begin) / 1000, most];
        });
        const each = ((await browser.processorTime()) - start) / frames;
        assert.ok(rows < 100, `${rows} rows are elements`);
        await browser.settle();
        assert.equal(await browser.page.locator(".body .row[aria-rowindex='100002']").count(), 1);
        context.diagnostic(
            `${bytes} bytes; ${(frames / seconds).toFixed(1)} frames a second, ${(1000 * each).toFixed(1)} ms of processor each`,
        );
        assert.ok(each < 1 / 30, `${each} s of processor a frame`);
    });

    test("600 robots on a large map", async (context) => {
        const map = join(process.env.MRPP_SHARED_DATA ?? "", "movingai/bg512/AR0603SR.map");
        if (!existsSync(map)) return context.skip("the map AR0603SR is not here");
        writeFileSync(
            join(scratch.path, "large.yaml"),
            `problems:\n  - public_benchmark: {map: ${JSON.stringify(map)}, robots: 600}\nplanners: [push_and_swap]\noptimizers: [redundancy_removal]\nreports: [html]\n`,
        );
        scratch.mrppsim(["run", "large.yaml", "-o", "large", "--quiet"]);
        const file = join(scratch.path, "large/report.html");
        const bytes = readFileSync(file).length;
        assert.ok(bytes < 3e6, `${bytes} bytes`);
        await browser.open(file, "view=player");
        await browser.page.waitForFunction(
            () => (document.querySelector(".readout")?.textContent ?? "") !== "",
        );
        const first = await browser.page.evaluate(() => performance.now());
        const start = await browser.processorTime();
        const [frames, seconds] = await browser.page.evaluate(async () => {
            (document.querySelector(".play") as HTMLElement).click();
            const begin = performance.now();
            let count = 0;
            while (performance.now() - begin < 2000) {
                await new Promise(requestAnimationFrame);
                ++count;
            }
            return [count, (performance.now() - begin) / 1000];
        });
        const each = ((await browser.processorTime()) - start) / frames;
        await picture("large");
        context.diagnostic(
            `${bytes} bytes; first frame after ${Math.round(first)} ms; ` +
                `${(frames / seconds).toFixed(1)} frames a second, ${(1000 * each).toFixed(1)} ms of processor each`,
        );
        assert.ok(each < 1 / 30, `${each} s of processor a frame`);
    });
});
