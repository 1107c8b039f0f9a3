// The player: every control and every key does what it says.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { browser, picture, report, scratch } from "./campaignPage";

const kCanvas = ".panel canvas";

async function goToStep(step: number): Promise<void> {
    await browser.page.getByLabel("Step", { exact: true }).fill(String(step));
    await browser.page.getByLabel("Step", { exact: true }).press("Enter");
    await waitForReadout(`Step ${step} of`);
}

async function waitForReadout(start: string): Promise<void> {
    await browser.page.waitForFunction(
        (wanted) => document.querySelector(".readout")?.textContent?.startsWith(wanted),
        start,
    );
}

/** The step of the first solution that the page names. */
async function step(): Promise<number> {
    return Number((await browser.readout()).match(/^Step (\d+) of/)![1]);
}

async function changes(what: string, act: () => Promise<unknown>, selector = kCanvas): Promise<void> {
    const old = await browser.pixels(selector);
    await act();
    assert.notEqual(await browser.pixels(selector), old, what);
}

async function keeps(what: string, act: () => Promise<unknown>): Promise<void> {
    const old = await browser.pixels(kCanvas);
    await act();
    assert.equal(await browser.pixels(kCanvas), old, what);
}

describe("player", () => {
    const press = (name: string | RegExp): Promise<void> =>
        browser.page.getByRole("button", { name }).first().click();

    test("every control does something", async () => {
        const { index, optimized } = await movesOfCase("public_benchmark/room/robots=20/0");
        assert.ok(optimized);
        await browser.open(report, `view=player&p=${index}:steps&follow=3`);
        await browser.readout();
        const page = browser.page;
        await changes("forward", () => press(/^A step on/));
        assert.match(await browser.readout(), /^Step 1 of/);
        await changes("back", () => press(/^A step back/));
        await changes("end", () => press(/^To the end/));
        assert.match(await browser.readout(), /20 of 20 robots at their goals/);
        await changes("beginning", () => press(/^To the beginning/));
        await page.getByLabel("Speed", { exact: true }).selectOption("5");
        await changes("play", async () => {
            await press(/^Play/);
            await page.waitForFunction(
                () => !document.querySelector(".readout")?.textContent?.startsWith("Step 0 of"),
            );
        });
        await press(/^Pause/);
        await goToStep(9);
        await changes("trails", () => page.getByLabel("Trails", { exact: true }).check());
        await changes("goals", () => page.getByLabel("Goals", { exact: true }).uncheck());
        await changes("blocks", () => page.getByLabel("Blocks and isthmuses", { exact: true }).check());
        assert.match(await browser.text(".legend ~ .legend"), /isthmuses.*blocks/);
        await changes("traffic", () => page.getByLabel("Heat", { exact: true }).selectOption("traffic"));
        assert.match(await browser.text(".legend ~ .legend"), /^moves over a vertex: 1 to \d+, logarithmic$/);
        await changes("waiting", () => page.getByLabel("Heat", { exact: true }).selectOption("waiting"));
        await picture("player-heat");
        await page.getByLabel("Heat", { exact: true }).selectOption("none");
        await changes("larger", () => press(/^Larger/));
        await changes("smaller", () => press(/^Smaller/));
        await changes("larger again", () => press(/^Larger/));
        await changes("everything", () => press(/^Show everything/));
        await changes("wheel", async () => {
            await page.locator(kCanvas).hover();
            await page.mouse.wheel(0, -400);
        });
        await changes("dragging", async () => {
            await page.mouse.down();
            await page.mouse.move(500, 300, { steps: 3 });
            await page.mouse.up();
        });
        await press(/^Show everything/);
        await press(/^To the next conflict/);
        assert.equal(await browser.text(".words"), "There is no later conflict or rotation.");
        await press(/^To the conflict or rotation before/);
        await changes(
            "clicking the strip",
            () => page.locator(".strip").click({ position: { x: 300, y: 20 } }),
            ".strip",
        );

        await press(/^Show another solution beside/);
        await page.waitForFunction(() => document.querySelectorAll(".panel").length === 2);
        await page.getByLabel("Solution", { exact: true }).nth(1).selectOption(`${index}:optimized-steps`);
        await page.getByLabel("In step by", { exact: true }).selectOption("share");
        await goToStep(3);
        await picture("player-compare");
        assert.match(await browser.text(".legend"), /at their goals in solution 2/);
        await press(/^Take this solution away/);
        await page.waitForFunction(() => document.querySelectorAll(".panel").length === 1);
        const cases = page.getByLabel("Case", { exact: true });
        await cases.selectOption({ index: 0 });
        await page.waitForFunction(() =>
            document.querySelector(".readout")?.textContent?.includes("of 3 robots"),
        );
        await picture("player-graph");
    });

    test("every key does what it says", async () => {
        const { index } = await movesOfCase("public_benchmark/room/robots=20/0");
        await browser.open(report, `view=player&p=${index}:steps`);
        await browser.readout();
        const { page } = browser;
        const key = (name: string): Promise<void> => page.keyboard.press(name);
        const stepAfter = async (name: string): Promise<number> => {
            await key(name);
            return step();
        };
        await page.locator(kCanvas).focus();
        assert.equal(await stepAfter("ArrowRight"), 1);
        assert.equal(await stepAfter("ArrowRight"), 2);
        assert.equal(await stepAfter("ArrowLeft"), 1);
        const last = await stepAfter("End");
        assert.match(await browser.readout(), new RegExp(`^Step ${last} of ${last},`));
        assert.equal(await stepAfter("Home"), 0);
        for (const [there, back] of [
            ["+", "-"],
            ["ArrowUp", "ArrowDown"],
            ["Shift+ArrowLeft", "Shift+ArrowRight"],
        ]) {
            await keeps(`${there} and ${back}`, async () => {
                await changes(there, () => key(there));
                await key(back);
            });
        }
        await key("+");
        await changes("0", () => key("0"));
        await page.locator(".strip").focus();
        const kTwentieth = Math.floor(last / 20);
        assert.equal(await stepAfter("ArrowUp"), kTwentieth);
        assert.equal(await stepAfter("ArrowRight"), kTwentieth + 1);
        assert.equal(await stepAfter("ArrowDown"), Math.floor(kTwentieth + 1 - last / 20));
        const speed = page.getByLabel("Speed", { exact: true });
        await speed.selectOption("10");
        await page.locator(".strip").focus();
        await key("]");
        assert.equal(await speed.inputValue(), "20");
        await key("[");
        await key("[");
        assert.equal(await speed.inputValue(), "5");
        for (const name of [" ", "k"]) {
            await key(name);
            await page.waitForFunction(() => document.querySelector(".play")?.textContent === "❚❚");
            await key(name);
            await page.waitForFunction(() => document.querySelector(".play")?.textContent === "▶");
        }
        const follow = page.getByLabel("Robot to follow");
        await follow.fill("3");
        await follow.press("Enter");
        await page.waitForURL(/follow=3/);
        await page.locator(kCanvas).focus();
        await key("Escape");
        assert.equal(await follow.inputValue(), "");
    });

    test("a robot that is clicked is followed; two fingers enlarge, one moves", async () => {
        await browser.open(report, "view=player&goals=0");
        await browser.readout();
        const box = (await browser.page.locator(kCanvas).boundingBox())!;
        const followed = (): Promise<string> => browser.page.getByLabel("Robot to follow").inputValue();
        for (let y = 10; y < box.height && (await followed()) === ""; y += 16)
            await browser.page.mouse.click(box.x + box.width / 2, box.y + y); // the tree's trunk
        assert.match(await followed(), /^\d+$/);
        await browser.page.mouse.click(box.x + 3, box.y + 3);
        assert.equal(await followed(), "", "a click beside all robots follows nobody");

        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        await keeps("enlarging and double-clicking", async () => {
            await changes("two fingers", () =>
                browser.touch([
                    [
                        [x - 40, y],
                        [x + 40, y],
                    ],
                    [
                        [x - 90, y],
                        [x + 90, y],
                    ],
                    [
                        [x - 140, y],
                        [x + 140, y],
                    ],
                ]),
            );
            await changes("one finger", () =>
                browser.touch([[[x, y]], [[x + 50, y + 20]], [[x + 90, y + 40]]]),
            );
            await browser.page.mouse.dblclick(box.x + 3, box.y + 3);
        });
    });

    test("the strip is scrubbed", async () => {
        await browser.open(report, "view=player");
        await browser.readout();
        const box = (await browser.page.locator(".strip").boundingBox())!;
        const { mouse } = browser.page;
        await mouse.move(box.x + 1, box.y + 20);
        await mouse.down();
        const seen: number[] = [];
        for (const share of [0.25, 0.5, 0.75, 1]) {
            await mouse.move(box.x + 1 + share * (box.width - 2), box.y + 20);
            seen.push(await step());
        }
        await mouse.up();
        const last = seen[3];
        assert.match(await browser.readout(), new RegExp(`^Step ${last} of ${last},`));
        assert.deepEqual(
            seen,
            [0.25, 0.5, 0.75, 1].map((share) => Math.floor(share * last)),
        );
    });

    test("conflicts and rotations are found and reached", async () => {
        const vertices = [0, 1, 2, 3].map((v) => `<node id="v${v}"/>`).join("");
        const edges = [0, 1, 2, 3].map((v) => `<edge source="v${v}" target="v${(v + 1) % 4}"/>`).join("");
        writeFileSync(
            join(scratch.path, "ring.graphml"),
            `<graphml xmlns="http://graphml.graphdrawing.org/xmlns"><graph edgedefault="undirected">${vertices}${edges}</graph></graphml>`,
        );
        writeFileSync(
            join(scratch.path, "ring.csv"),
            "step,robot,from,to\n0,0,0,1\n0,1,1,2\n0,2,2,3\n0,3,3,0\n1,0,1,2\n",
        );
        const agents = [0, 1, 2, 3].map((v) => `agent: start = ${v}, goal = ${(v + 1) % 4}\n`).join("");
        writeFileSync(join(scratch.path, "ring.instance"), `graph = ring.graphml\n${agents}`);
        scratch.mrppsim(["view", "--instance", "ring.instance", "--solution", "ring.csv", "-o", "ring.html"]);
        await browser.open(join(scratch.path, "ring.html"));
        assert.match(await browser.text("figcaption"), /ring\.csv \(invalid\), as given/);
        await press(/^To the next conflict/);
        assert.equal(await browser.text(".words"), "Step 1: robots 0, 1, 2, 3 turn in a cycle.");
        await browser.page.keyboard.press("n");
        assert.equal(await browser.text(".words"), "Step 2: robots 1 and 0 are both on vertex 2.");
        await picture("conflict");
        await press(/^To the conflict or rotation before/);
        assert.match(await browser.text(".words"), /turn in a cycle/);
        assert.match(await browser.text(".legend"), /1 conflict1 rotation$/);
    });

    test("no control is left out of these tests", async () => {
        await browser.open(report, "view=player");
        await browser.readout();
        await browser.page.getByRole("button", { name: /^Show another solution/ }).click();
        await browser.page.waitForFunction(() => document.querySelectorAll(".panel").length === 2);
        assert.deepEqual(
            (await browser.undriven("#view-player")).filter(
                (name) => !/^(This frame|The animation)/.test(name),
            ),
            [], // the others are in exports.test.ts
        );
    });

    /** Index of push_and_swap's solution of a case. */
    async function movesOfCase(name: string): Promise<{ index: number; optimized: boolean }> {
        const html = readFileSync(report, "utf8");
        const about = JSON.parse(html.match(/id="explorer">(.*)<\/script>/)![1]);
        const inCase = about.cases.findIndex((one: { name: string }) => one.name === name);
        const index = about.playable.findIndex((one: { case: number }) => one.case === inCase);
        return { index, optimized: about.playable[index].optimized };
    }
});
