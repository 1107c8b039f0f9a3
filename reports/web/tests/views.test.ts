// The overview, the charts and the table of runs, driven as a user would.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import type { Browser } from "./browser";
import { browser, kName, picture, report, scratch } from "./campaignPage";

describe("overview", () => {
    test("says what was found, with names as text", async () => {
        await browser.open(report);
        assert.equal(await browser.page.title(), "explorer – MRPPSim");
        const names = await browser.page.locator(".summary tbody th").allTextContents();
        assert.deepEqual(
            names,
            ["push_and_swap", kName, "bibox"].filter((name) => names.includes(name)),
        );
        assert.ok(names.includes(kName));
        assert.equal(await browser.page.locator("img").count(), 0);
        await browser.page.getByText("The plan", { exact: true }).click();
        assert.ok((await browser.text(".plan")).includes(kName));
        await browser.page.getByText("Licences of what this page carries").click();
        assert.match(
            await browser.text("details pre:not(.plan)"),
            /uplot.*MIT[\s\S]*Permission is hereby granted/,
        );
        await picture("overview");
    });

    test("keeps the name as text in every other view", async () => {
        for (const hash of ["view=charts", "view=runs&run=1", "view=player"]) {
            await browser.open(report, hash);
            await browser.settle();
            assert.equal(await browser.page.locator("img").count(), 0);
            assert.ok(
                (await browser.page.locator(`#view-${hash.split(/[=&]/)[1]}`).innerText()).includes(
                    "<img src=x",
                ),
            );
        }
    });
});

describe("charts", () => {
    const select = (label: string): ReturnType<Browser["page"]["getByLabel"]> =>
        browser.page.getByLabel(label, { exact: true });

    test("every chart of every choice can be drawn", async () => {
        await browser.open(report, "view=charts");
        let last = "";
        for (const [kind, measure] of [
            ["sweep", "success_rate"],
            ["sweep", "time"],
            ["cactus", "time"],
            ["scatter", "makespan"],
            ["versus", "path_length"],
        ]) {
            await select("Chart").selectOption(kind);
            await select("Measure").selectOption(measure);
            const now = await browser.pixels(".plot canvas");
            assert.notEqual(now, last, `${kind} ${measure}`);
            last = now;
            await picture(`chart-${kind}-${measure}`);
        }
        await select("Across").selectOption("1");
        await select("Up").selectOption("0");
        assert.notEqual(await browser.pixels(".plot canvas"), last);
        await select("Chart").selectOption("sweep");
        await select("Problem").selectOption("public_benchmark/room");
        await select("Against").selectOption("robots");
        last = await browser.pixels(".plot canvas");
        await select("Logarithmic across").check();
        assert.notEqual(await browser.pixels(".plot canvas"), last);
        last = await browser.pixels(".plot canvas");
        await select("Logarithmic up").setChecked(!(await select("Logarithmic up").isChecked()));
        assert.notEqual(await browser.pixels(".plot canvas"), last);
        last = await browser.pixels(".plot canvas");
        await browser.page.locator(".chart-legend input").first().uncheck();
        assert.notEqual(await browser.pixels(".plot canvas"), last);
        await browser.page.waitForURL(/hide=0/);
    });

    test("dragging enlarges a part, a double click shows the whole again", async () => {
        await browser.open(report, "view=charts&chart=scatter&x=robots&y=time&problem=");
        const whole = await browser.pixels(".plot canvas");
        const box = (await browser.page.locator(".u-over").boundingBox())!;
        const { mouse } = browser.page;
        await mouse.move(box.x + 0.2 * box.width, box.y + 0.2 * box.height);
        await mouse.down();
        await mouse.move(box.x + 0.6 * box.width, box.y + 0.7 * box.height, { steps: 4 });
        await mouse.up();
        assert.notEqual(await browser.pixels(".plot canvas"), whole);
        assert.ok(await browser.page.locator("#view-charts").isVisible(), "the drag is not a click on a dot");
        await mouse.dblclick(box.x + 5, box.y + 5);
        await mouse.move(0, 0);
        assert.equal(await browser.pixels(".plot canvas"), whole);
    });

    test("the address brings back the same chart", async () => {
        await browser.open(report, "view=charts&chart=cactus&y=makespan");
        assert.equal(await select("Chart").inputValue(), "cactus");
        assert.equal(await select("Measure").inputValue(), "makespan");
    });

    test("pointing names the run, a click goes to it, and the way back leads back", async () => {
        await browser.open(report, "view=charts&chart=cactus&y=path_length&logy=0");
        await browser.settle();
        const box = (await browser.page.locator(".u-over").boundingBox())!;
        let named = "";
        search: for (let y = box.height - 4; y > 0; y -= 8)
            for (let x = 4; x < box.width; x += 8) {
                await browser.page.mouse.move(box.x + x, box.y + y);
                if (!(await browser.page.locator(".tip").isHidden())) {
                    named = await browser.text(".tip");
                    break search;
                }
            }
        assert.match(named, / on (small|public)_benchmark\//);
        await browser.page.mouse.down();
        await browser.page.mouse.up();
        await browser.page.waitForSelector("#view-runs:not([hidden])");
        assert.ok(named.startsWith(await browser.text(".details h2")));
        await browser.page.goBack();
        await browser.page.waitForSelector("#view-charts:not([hidden])");
    });
});

describe("runs", () => {
    const count = (): Promise<string> => browser.text(".count");
    const firstRow = (): Promise<string[]> =>
        browser.page.locator(".body .row").first().locator("[role=gridcell]").allTextContents();

    test("sort, filter, search, chips and columns", async () => {
        await browser.open(report, "view=runs");
        assert.equal(await count(), "24 runs");
        await browser.page
            .getByRole("button", { name: /^Path length \(moves\)/ })
            .first()
            .click();
        await browser.page
            .getByRole("button", { name: /^Path length \(moves\)/ })
            .first()
            .click();
        assert.equal(
            await browser.page.locator("[data-column=path_length]").first().getAttribute("aria-sort"),
            "descending",
        );
        const planners = browser.page.getByLabel("Filter Planner");
        await planners.fill("<img");
        assert.equal(await count(), "8 of 24 runs");
        await browser.page.getByLabel("Filter Robots").fill(">=20");
        assert.equal(await count(), "4 of 24 runs");
        assert.ok((await firstRow()).includes(kName));
        await planners.fill("");
        await browser.page.getByLabel("Filter Robots").fill("");
        await browser.page.getByLabel("Search all texts of the runs").fill("polygon push_and_swap");
        assert.equal(await count(), "2 of 24 runs");
        await browser.page.getByLabel("Search all texts of the runs").fill("");
        await browser.page.locator(".chip", { hasText: "unsupported" }).click();
        const failed = Number((await browser.text(".chip[aria-pressed=true]")).split(" ")[1]);
        assert.equal(await count(), `${failed} of 24 runs`);
        await picture("runs");
        await browser.page.locator(".chip", { hasText: "unsupported" }).click();
        await browser.page.locator(".columns summary").click();
        await browser.page.locator(".menu").getByLabel("Edges", { exact: true }).check();
        assert.equal(await browser.page.locator("[role=columnheader][data-column=edges]").count(), 1);
        await browser.page.waitForURL(/columns=/);
    });

    test("arrow keys go through the runs; a run tells everything and can be repeated", async () => {
        await browser.open(report, "view=runs&sort=planner");
        await browser.page.locator("[role=grid]").focus();
        for (let i = 0; i < 9; ++i) await browser.page.keyboard.press("ArrowDown");
        await browser.page.waitForSelector(".details h2");
        assert.equal(await browser.page.locator(".row[aria-selected=true]").count(), 1);
        const rowAfter = async (key: string): Promise<number> => {
            await browser.page.keyboard.press(key);
            const row = browser.page.locator(".row[aria-selected=true]");
            return Number(await row.getAttribute("aria-rowindex")) - 3;
        };
        assert.equal(await rowAfter("Home"), 0);
        assert.equal(await rowAfter("ArrowDown"), 1);
        assert.ok((await rowAfter("PageDown")) > 5);
        assert.ok((await rowAfter("PageUp")) < 5);
        assert.equal(await rowAfter("End"), 23);
        const command = await browser.text(".replay code");
        assert.ok(command.startsWith(`mrppsim replay ${scratch.path}/out `), command);
        scratch.mrppsim(command.split(" ").slice(1));
        await browser.page.getByRole("button", { name: "Copy the command" }).click();
    });

    test("a run that cannot be played says why, one that can is played", async () => {
        await browser.open(report, "view=runs&status=unsupported");
        await browser.page.locator(".body .row").first().click();
        assert.match(await browser.text(".details"), /It cannot be played: it has no solution/);
        assert.notEqual(await browser.text(".details .reason"), "");
        await browser.open(report, "view=runs&f.repetition=1&status=solved");
        await browser.page.locator(".body .row").first().click();
        assert.match(await browser.text(".details"), /explorer: \{solutions: first\}/);
        await browser.open(report, "view=runs&f.repetition=0&status=solved&sort=-robots");
        await browser.page.locator(".body .row").first().click();
        await browser.page.getByRole("button", { name: "Watch it one after another" }).click();
        assert.equal((await browser.readout()).split(" · ").length, 3);
        await picture("before-and-after");
        await browser.page.goBack();
        await browser.page.getByRole("button", { name: "Watch it beside those of other planners" }).click();
        await browser.page.waitForFunction(() => [2, 3].includes(document.querySelectorAll(".panel").length));
        await picture("planners");
        await browser.page.goBack();
        await browser.page.getByRole("button", { name: "Watch this solution" }).click();
        await browser.page.waitForFunction(() => document.querySelectorAll(".panel").length === 1);
    });
});

describe("looks", () => {
    test("dark and light, narrow and printed", async () => {
        await browser.open(report, "view=player");
        await browser.readout();
        const light = await browser.pixels(".panel canvas");
        await browser.page.getByLabel("Colours").selectOption("dark");
        assert.notEqual(await browser.pixels(".panel canvas"), light);
        await picture("dark");
        const dark = await browser.pixels(".panel canvas");
        const print = (event: string): Promise<unknown> =>
            browser.page.evaluate((name) => dispatchEvent(new Event(name)), event);
        await print("beforeprint");
        assert.equal(await browser.pixels(".panel canvas"), light, "paper is white");
        await print("afterprint");
        assert.equal(await browser.pixels(".panel canvas"), dark);
        await browser.page.emulateMedia({ colorScheme: "dark" });
        await browser.page.getByLabel("Colours").selectOption("");
        await picture("dark-system");
        await browser.page.emulateMedia({ colorScheme: "light" });
        await browser.page.setViewportSize({ width: 420, height: 800 });
        for (const view of [
            "overview",
            "charts",
            "runs",
            "player&p=0:steps~0:moves~1:steps~1:moves",
            "player",
        ]) {
            await browser.open(report, `view=${view}`);
            await browser.settle();
            const across = await browser.page.evaluate(() => document.documentElement.scrollWidth);
            assert.ok(across <= 421, `${view} is ${across} wide`);
            await picture(`narrow-${view.split("&")[0]}`);
        }
        await browser.page.setViewportSize({ width: 1280, height: 800 });
        await browser.open(report, "view=runs");
        const pdf = await browser.page.pdf();
        const path = join(scratch.path, "print.pdf");
        writeFileSync(path, pdf);
        if (process.env.MRPP_PICTURES) writeFileSync(join(process.env.MRPP_PICTURES, "print.pdf"), pdf);
        assert.match(
            execFileSync("pdftotext", ["-layout", path, "-"], { encoding: "utf8" }),
            /Planner[\s\S]*bibox[\s\S]*biconnecte/,
        );
    });
});

describe("everything", () => {
    test("tabs are reached by clicks and keys, and the way back leads back", async () => {
        await browser.open(report);
        const { page } = browser;
        const seen = (): Promise<string | null> =>
            page.locator("[role=tabpanel]:not([hidden])").getAttribute("id");
        for (const view of ["charts", "runs", "player", "overview"]) {
            await page.locator(`#tab-${view}`).click();
            assert.equal(await seen(), `view-${view}`);
        }
        for (const view of ["charts", "runs"]) {
            await page.keyboard.press("ArrowRight");
            assert.equal(await seen(), `view-${view}`);
        }
        await page.keyboard.press("ArrowLeft");
        assert.equal(await seen(), "view-charts");
        await page.goBack();
        assert.equal(await seen(), "view-runs");
    });

    test("no control is left out of these tests", async () => {
        for (const hash of ["overview", "charts", "charts&chart=versus", "runs&run=0"]) {
            await browser.open(report, `view=${hash}`);
            if (hash.startsWith("runs")) await browser.page.locator(".columns summary").click();
            await browser.settle();
            const left = (await browser.undriven("#page")).filter((name) => name !== "This chart as PNG");
            assert.deepEqual(left, [], hash); // that one is in exports.test.ts
        }
    });
});
