// The player: robots are where solutions say, and every control does something.
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { browser, picture, report, scratch } from "./campaignPage";

type Move = { step: number; robot: number; from: number; to: number };

function movesOf(file: string): Move[] {
    const rows = readFileSync(join(scratch.path, file), "utf8").trim().split("\n").slice(1);
    return rows.map((row) => {
        const [step, robot, from, to] = row.split(",").map(Number);
        return { step, robot, from, to };
    });
}

/** Where a robot is after so many steps. */
function placeAfter(moves: Move[], robot: number, steps: number): number {
    const own = moves.filter((move) => move.robot === robot);
    const done = own.filter((move) => move.step < steps);
    return done.length > 0 ? done[done.length - 1].to : own[0].from;
}

/** The vertex that the page names for the robot that is followed. */
async function shownPlaces(): Promise<number[]> {
    return [...(await browser.readout()).matchAll(/on vertex (\d+)/g)].map((match) => Number(match[1]));
}

async function goToStep(step: number): Promise<void> {
    await browser.page.getByLabel("Step", { exact: true }).fill(String(step));
    await browser.page.getByLabel("Step", { exact: true }).press("Enter");
    await browser.page.waitForFunction(
        (wanted) => document.querySelector(".readout")?.textContent?.startsWith(`Step ${wanted} of`),
        step,
    );
}

describe("player", () => {
    const press = (name: string | RegExp): Promise<void> =>
        browser.page.getByRole("button", { name }).first().click();

    test("robots are where the solution says", async () => {
        const index = (await movesOfCase("public_benchmark/room/robots=40/0")).index;
        const moves = movesOf("out/solutions/public_benchmark/room/robots=40/0.push_and_swap.csv");
        await browser.open(report, `view=player&p=${index}:moves`);
        await browser.readout();
        const length = moves[moves.length - 1].step + 1;
        for (const robot of [0, 7, 39]) {
            await browser.page.getByLabel("Robot to follow").fill(String(robot));
            await browser.page.getByLabel("Robot to follow").press("Enter");
            for (const step of [0, 1, 17, 100, Math.floor(length / 2), length - 1, length]) {
                await goToStep(step);
                assert.deepEqual(
                    await shownPlaces(),
                    [placeAfter(moves, robot, step)],
                    `robot ${robot} after step ${step}`,
                );
            }
        }
    });

    test("a condensed solution is the program's own schedule, and lengths are those of the table", async () => {
        scratch.mrppsim([
            "generate",
            "grid",
            "--side",
            "8",
            "--graph",
            "g.map",
            "--robots",
            "12",
            "--instance",
            "g.scen",
            "--solvable",
        ]);
        scratch.mrppsim([
            "solve",
            "--graph",
            "g.map",
            "--instance",
            "g.scen",
            "--planner",
            "push_and_rotate",
            "--solution",
            "moves.csv",
            "--schedule",
            "steps.csv",
        ]);
        scratch.mrppsim([
            "view",
            "--graph",
            "g.map",
            "--instance",
            "g.scen",
            "--solution",
            "moves.csv",
            "--solution",
            "steps.csv",
            "-o",
            "view.html",
        ]);
        const schedule = movesOf("steps.csv");
        const length = schedule[schedule.length - 1].step + 1;
        await browser.open(join(scratch.path, "view.html"), "p=0:steps~1:steps&follow=3");
        assert.match(await browser.readout(), new RegExp(`^Step 0 of ${length},.* · Step 0 of ${length},`));
        for (let step = 0; step <= length; step += Math.max(1, Math.floor(length / 9))) {
            await goToStep(step);
            const place = placeAfter(schedule, 3, step);
            assert.deepEqual(await shownPlaces(), [place, place]);
        }
    });

    test("every control does something", async () => {
        const { index, optimized } = await movesOfCase("public_benchmark/room/robots=20/0");
        assert.ok(optimized);
        await browser.open(report, `view=player&p=${index}:steps&follow=3`);
        await browser.readout();
        const canvas = ".panel canvas";
        const changes = async (
            what: string,
            act: () => Promise<unknown>,
            selector = canvas,
        ): Promise<void> => {
            const old = await browser.pixels(selector);
            await act();
            assert.notEqual(await browser.pixels(selector), old, what);
        };
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
        await changes("traffic", () => page.getByLabel("Heat", { exact: true }).selectOption("traffic"));
        await changes("waiting", () => page.getByLabel("Heat", { exact: true }).selectOption("waiting"));
        await picture("player-heat");
        await page.getByLabel("Heat", { exact: true }).selectOption("none");
        await changes("larger", () => press(/^Larger/));
        await changes("smaller", () => press(/^Smaller/));
        await changes("larger again", () => press(/^Larger/));
        await changes("everything", () => press(/^Show everything/));
        await changes("wheel", async () => {
            await page.locator(canvas).hover();
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
        await press(/^Take this solution away/);
        await page.waitForFunction(() => document.querySelectorAll(".panel").length === 1);
        const cases = page.getByLabel("Case", { exact: true });
        await cases.selectOption({ index: 0 });
        await page.waitForFunction(() =>
            document.querySelector(".readout")?.textContent?.includes("of 3 robots"),
        );
        await picture("player-graph");
    });

    test("no control is left out of these tests", async () => {
        await browser.open(report, "view=player");
        await browser.readout();
        const names = await browser.page
            .locator("#view-player")
            .locator("button, select, input, [tabindex]")
            .evaluateAll((elements) =>
                elements
                    .filter((element) => (element as HTMLElement).offsetParent !== null)
                    .map(
                        (element) =>
                            element.getAttribute("aria-label") ??
                            element.closest("label")?.textContent?.slice(0, 12) ??
                            "",
                    ),
            );
        assert.equal(names.filter((name) => name === "").length, 0, "all have names");
        assert.equal(names.length, 27, names.join("; "));
    });

    test("keys play, step, enlarge and follow", async () => {
        await browser.open(report, "view=player");
        await browser.readout();
        const page = browser.page;
        await page.locator(".panel canvas").focus();
        for (const [key, start] of [
            ["ArrowRight", "Step 1 of"],
            ["ArrowRight", "Step 2 of"],
            ["ArrowLeft", "Step 1 of"],
            ["End", "Step "],
            ["Home", "Step 0 of"],
        ]) {
            await page.keyboard.press(key);
            assert.ok((await browser.readout()).startsWith(start), key);
        }
        for (const key of [
            "+",
            "-",
            "ArrowUp",
            "ArrowDown",
            "Shift+ArrowLeft",
            "0",
            "n",
            "p",
            "]",
            "[",
            "k",
            "k",
            "Escape",
        ])
            await page.keyboard.press(key);
        await page.waitForURL(/speed=/);
        await page.keyboard.press(" ");
        await page.waitForFunction(() =>
            document.querySelector(".play")?.getAttribute("aria-label")?.startsWith("Pause"),
        );
        await page.keyboard.press(" ");
        await page.waitForFunction(() =>
            document.querySelector(".play")?.getAttribute("aria-label")?.startsWith("Play"),
        );
    });

    test("a robot that is clicked is followed; two fingers enlarge", async () => {
        await browser.open(report, "view=player&goals=0");
        await browser.readout();
        const box = (await browser.page.locator(".panel canvas").boundingBox())!;
        const followed = (): Promise<string> => browser.page.getByLabel("Robot to follow").inputValue();
        for (let y = 10; y < box.height && (await followed()) === ""; y += 16)
            for (let x = 10; x < box.width && (await followed()) === ""; x += 16)
                await browser.page.mouse.click(box.x + x, box.y + y);
        assert.match(await followed(), /^\d+$/);
        const old = await browser.pixels(".panel canvas");
        await browser.page.locator(".panel canvas").evaluate((canvas) => {
            const send = (type: string, id: number, x: number): void => {
                canvas.dispatchEvent(
                    new PointerEvent(type, {
                        pointerId: id,
                        pointerType: "touch",
                        clientX: x,
                        clientY: 300,
                        bubbles: true,
                    }),
                );
            };
            canvas.setPointerCapture = () => undefined;
            send("pointerdown", 2, 400);
            send("pointerdown", 3, 500);
            send("pointermove", 3, 700);
            send("pointerup", 3, 700);
            send("pointerup", 2, 400);
        });
        assert.notEqual(await browser.pixels(".panel canvas"), old);
    });

    test("frames and animations become files", async () => {
        await browser.open(report, "view=player&t=4&speed=20");
        await browser.readout();
        const begins: [string, RegExp, string][] = [
            ["This frame as PNG", /^\x89PNG/, "png"],
            ["This frame as SVG", /^<svg [\s\S]*<\/svg>\n$/, "svg"],
            ["The animation as GIF", /^GIF89a[\s\S]*;$/, "gif"],
            ["The animation as WebM", /^\x1aE\xdf\xa3/, "webm"],
        ];
        for (const [name, start, extension] of begins) {
            const [file] = await Promise.all([
                browser.page.waitForEvent("download"),
                press(new RegExp(`^${name}`)),
            ]);
            assert.ok(file.suggestedFilename().endsWith(`.${extension}`));
            const path = join(scratch.path, `export.${extension}`);
            await file.saveAs(path);
            assert.match(readFileSync(path, "latin1"), start, extension);
            if (process.env.MRPP_PICTURES)
                copyFileSync(path, join(process.env.MRPP_PICTURES, `export.${extension}`));
        }
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
