// The same page in Firefox: every view is shown and drawn, robots stand where they stand in Chromium's tests,
// exports are made.
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { Scratch } from "./browser";
import { Firefox, firefoxPath } from "./firefox";

if (!firefoxPath || typeof WebSocket === "undefined") {
    console.log(
        `skipped: there is no ${firefoxPath ? "WebSocket in this Node.js" : "firefox-esr or firefox"}`,
    );
    process.exit(77);
}

const scratch = new Scratch();
const report = join(scratch.path, "out/report.html");
let firefox: Firefox;

before(async () => {
    copyFileSync(join(process.env.MRPP_SOURCE!, "yaml/plans/quickstart.map"), join(scratch.path, "room.map"));
    writeFileSync(
        join(scratch.path, "plan.yaml"),
        "problems:\n  - small_benchmark: [tree]\n  - public_benchmark: {map: room.map, robots: [20, 40]}\n" +
            "planners: [push_and_swap, bibox]\nrepetitions: 1\noptimizers: [redundancy_removal]\n" +
            "reports: [html]\nkeep: {solutions: true}\n",
    );
    scratch.mrppsim(["run", "plan.yaml", "-o", "out", "--quiet"]);
    firefox = await Firefox.start();
});

after(async () => {
    await firefox?.stop();
    scratch.remove();
});

afterEach(async () => {
    assert.deepEqual(firefox.complaints.splice(0), []);
    assert.deepEqual(
        firefox.requests.splice(0).filter((url) => !/^(file:.*\/report\.html|about:|data:|blob:)/.test(url)),
        [],
    );
    assert.equal(await firefox.evaluate("JSON.stringify(watched.violations)"), "[]");
});

/** Waits until a canvas shows something: few colours are a blank one. */
const drawn = (selector: string): Promise<void> =>
    firefox.until(`(() => {
        const canvas = document.querySelector(${JSON.stringify(selector)});
        if (!canvas) return false;
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        return new Set(new Uint32Array(data.buffer)).size > 8;
    })()`);

const text = (selector: string): Promise<string> =>
    firefox.evaluate(`document.querySelector(${JSON.stringify(selector)})?.textContent ?? ""`);

async function picture(name: string): Promise<void> {
    const folder = process.env.MRPP_PICTURES;
    if (folder) await firefox.screenshot(join(folder, `firefox-${name}.png`));
}

test("every view is shown", async () => {
    for (const [hash, wanted] of [
        ["view=overview", "Distinct instances"],
        ["view=charts", "push_and_swap: 3 of 3 instances solved"],
        ["view=runs&run=0", "mrppsim replay"],
        ["view=player", "push_and_swap, condensed"],
    ]) {
        await firefox.open(report, hash);
        const view = `#view-${hash.split(/[=&]/)[1]}`;
        await firefox.until(
            `document.querySelector("${view}").textContent.includes(${JSON.stringify(wanted)})`,
        );
        await picture(view.slice(1));
    }
});

test("charts are drawn, in light and dark", async () => {
    for (const theme of ["light", "dark"]) {
        await firefox.open(report, `view=charts&chart=scatter&x=robots&y=time&problem=&theme=${theme}`);
        await drawn(".plot canvas");
        await picture(`chart-${theme}`);
    }
});

test("robots go where the solution says, by keys and by playing", async () => {
    await firefox.open(report, "view=player&p=1:moves&follow=0&trails=1");
    await drawn(".panel canvas");
    const csv = readFileSync(
        join(scratch.path, "out/solutions/public_benchmark/room/robots=20/0.push_and_swap.csv"),
        "utf8",
    );
    const moves = csv
        .trim()
        .split("\n")
        .slice(1)
        .map((row) => row.split(",").map(Number));
    const own = moves.filter(([, robot]) => robot === 0);
    const [step, , , to] = own[Math.floor(own.length / 2)];
    await firefox.open(report, `view=player&p=1:moves&follow=0&t=${step}`);
    await firefox.until(
        `document.querySelector('.readout').textContent.startsWith("Step ${step} of ${moves.length},")`,
    );
    await firefox.evaluate("document.querySelector('.strip').focus()");
    await firefox.press("\uE014"); // →
    await firefox.until(`document.querySelector('.readout').textContent.startsWith("Step ${step + 1} of")`);
    assert.match(await text(".readout"), new RegExp(`robot 0 is on vertex ${to},`));
    await firefox.evaluate("document.querySelector('.play').click()");
    await firefox.until(
        `Number(document.querySelector('.readout').textContent.match(/\\d+/)[0]) > ${step + 3}`,
    );
    await picture("playing");
    await firefox.press("\uE014");
});

test("frames and animations become files", async () => {
    const begins: Record<string, number[]> = {
        PNG: [0x89, 0x50, 0x4e, 0x47],
        SVG: [0x3c, 0x73, 0x76, 0x67],
        GIF: [0x47, 0x49, 0x46, 0x38],
        WebM: [0x1a, 0x45, 0xdf, 0xa3],
    };
    for (const [name, begin] of Object.entries(begins)) {
        await firefox.open(report, "view=player&p=0:steps&speed=20&t=3");
        await firefox.until("document.querySelector('.readout').textContent !== ''");
        const button = `[...document.querySelectorAll("[aria-label=Export] button")].find((b) => b.textContent === "${name}")`;
        await firefox.evaluate(`watched.files.length = 0; ${button}.click()`);
        await firefox.until("watched.files.length > 0");
        const found = await firefox.evaluate<string>(
            "watched.files[0].arrayBuffer().then((b) => JSON.stringify([b.byteLength, ...new Uint8Array(b).slice(0, 4)]))",
        );
        const [size, ...bytes] = JSON.parse(found) as number[];
        assert.deepEqual(bytes, begin, name);
        assert.ok(size > 1000, `${size} bytes of ${name}`);
    }
});
