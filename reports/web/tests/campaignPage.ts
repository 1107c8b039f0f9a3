// A real campaign's page, opened from file:// in a real browser: import this in a test file, and its tests
// have both. A picture of each view is left in the folder MRPP_PICTURES, if that is given.
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before } from "node:test";
import { Browser, Scratch, browserPath } from "./browser";

if (!browserPath) {
    console.log("skipped: there is no chromium; ./setup.sh installs it");
    process.exit(77);
}

export const kName = "<img src=x onerror=alert(1)>";
const kPlan = `
campaign: explorer
repetitions: 2
problems:
  - small_benchmark: [tree, polygon]
  - public_benchmark: {map: room.map, robots: [20, 40]}
planners:
  - push_and_swap
  - {planner: push_and_rotate, name: "${kName}"}
  - bibox
optimizers: [redundancy_removal]
reports: [csv, html]
keep: {solutions: true}
`;

export const scratch = new Scratch();
export let browser: Browser;
export let report: string;

export async function picture(name: string): Promise<void> {
    const folder = process.env.MRPP_PICTURES;
    if (folder) await browser.page.screenshot({ path: join(folder, `${name}.png`) });
}

export interface Move {
    step: number;
    robot: number;
    from: number;
    to: number;
}

/** Of a solution or schedule in the scratch folder. */
export function movesOf(file: string): Move[] {
    const rows = readFileSync(join(scratch.path, file), "utf8").trim().split("\n").slice(1);
    return rows.map((row) => {
        const [step, robot, from, to] = row.split(",").map(Number);
        return { step, robot, from, to };
    });
}

/** Where a robot is after so many steps; undefined before its first move. */
export function placeAfter(moves: Move[], robot: number, steps: number): number | undefined {
    return moves.filter((move) => move.robot === robot && move.step < steps).at(-1)?.to;
}

/** The file that a button gives. */
export async function exported(button: RegExp): Promise<Buffer> {
    const [file] = await Promise.all([
        browser.page.waitForEvent("download"),
        browser.page.getByRole("button", { name: button }).first().click(),
    ]);
    const path = join(scratch.path, file.suggestedFilename());
    await file.saveAs(path);
    return readFileSync(path);
}

before(async () => {
    copyFileSync(join(process.env.MRPP_SOURCE!, "yaml/plans/quickstart.map"), join(scratch.path, "room.map"));
    writeFileSync(join(scratch.path, "plan.yaml"), kPlan);
    scratch.mrppsim(["run", "plan.yaml", "-o", "out", "--quiet"]);
    report = join(scratch.path, "out/report.html");
    browser = await Browser.start();
});

after(async () => {
    await browser?.stop();
    scratch.remove();
});

afterEach(() => {
    assert.deepEqual(browser.complaints.splice(0), []);
});
