// A real browser, the built program, and what tests of pages need of them.
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type BrowserContext, type CDPSession, type Page, chromium } from "playwright-core";
import { slowness } from "./slowness";

const kBrowsers = [
    process.env.CHROMIUM ?? "",
    "/usr/bin/chromium",
    "/usr/bin/chromium-browser",
    "/usr/bin/google-chrome",
];

export const browserPath = kBrowsers.find((path) => path !== "" && existsSync(path));

interface Watched {
    nameOfControl: (control: Element) => string;
    tellDriven: (name: string) => void;
}

/** Runs in the page before its own script. Controls of which there are many of a kind share a name. */
function watchControls(): void {
    const page = window as unknown as Watched;
    page.nameOfControl = (control) => {
        const kinds: [string, string][] = [
            [".table .head button", "sort"],
            [".filters input", "filter"],
            [".menu input", "column"],
            [".chart-legend input", "planner"],
            [".chip", "status"],
            [".panel canvas", "picture"],
            [".play", "play"],
        ];
        const kind = kinds.find(([selector]) => control.matches(selector));
        return (
            kind?.[1] ??
            control.getAttribute("aria-label") ??
            control.closest("label, button, summary")?.textContent ??
            ""
        );
    };
    for (const type of ["click", "change", "input", "keydown", "pointerdown"])
        addEventListener(
            type,
            ({ target }) => {
                const control = (target as Element).closest?.("button, select, input, summary, [tabindex]");
                if (control) page.tellDriven(page.nameOfControl(control));
            },
            { capture: true },
        );
}

export class Scratch {
    readonly path = mkdtempSync(join(tmpdir(), "mrppsim-explorer-"));

    /** Runs mrppsim here; throws where it does not end as expected. */
    mrppsim(words: string[], code = 0): string {
        const program = process.env.MRPP_PROGRAM;
        if (!program) throw new Error("MRPP_PROGRAM does not say where mrppsim is");
        const result = spawnSync(program, words, { cwd: this.path, encoding: "utf8" });
        if (result.status !== code)
            throw new Error(`mrppsim ${words.join(" ")} ended with ${result.status}: ${result.stderr}`);
        return result.stdout;
    }

    remove(): void {
        rmSync(this.path, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
    }
}

export class Browser {
    readonly complaints: string[] = []; // errors, dialogs, and requests for anything but the page itself
    private readonly driven = new Set<string>(); // names of the controls that had a click, a key or a change

    private session: CDPSession | null = null;
    private readonly slowness = slowness();

    private constructor(
        private readonly context: BrowserContext,
        readonly page: Page,
        private readonly profile: string,
    ) {
        page.on("console", (message) => {
            if (message.type() === "error" || message.type() === "warning")
                this.complaints.push(`console: ${message.text()}`);
        });
        page.on("pageerror", (error) => this.complaints.push(`error: ${error.stack}`));
        page.on("dialog", (dialog) => {
            this.complaints.push(`dialog: ${dialog.message()}`);
            void dialog.dismiss();
        });
        page.on("request", (request) => {
            const isPage = request.isNavigationRequest() && request.url().startsWith("file:");
            if (!isPage && !/^(data|blob):/.test(request.url()))
                this.complaints.push(`request: ${request.url()}`);
        });
    }

    static async start(): Promise<Browser> {
        const profile = mkdtempSync(join(tmpdir(), "mrppsim-browser-"));
        const context = await chromium.launchPersistentContext(profile, {
            executablePath: browserPath,
            headless: true,
            viewport: { width: 1280, height: 800 },
            args: [
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-quic",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
            ],
        });
        context.setDefaultTimeout(Number(process.env.MRPP_PATIENCE ?? 60_000));
        const browser = new Browser(context, context.pages()[0], profile);
        await context.exposeFunction("tellDriven", (name: string) => browser.driven.add(name));
        await context.addInitScript(watchControls);
        return browser;
    }

    async stop(): Promise<void> {
        await this.context.close();
        rmSync(this.profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
    }

    /** Opens a page from its file; a change of what stands after # alone does not load it again. */
    async open(file: string, hash = ""): Promise<void> {
        await this.page.goto("about:blank");
        await this.page.goto(`file://${file}#${hash}`);
        await this.page.waitForSelector("[role=tab]");
    }

    /** Goes to another view of the page that is open, as a link in it would. */
    async go(hash: string): Promise<void> {
        await this.page.evaluate((to) => (location.hash = to), hash);
        await this.settle();
    }

    /** Controls in sight, inside an element, that nothing in this file has driven. */
    async undriven(selector: string): Promise<string[]> {
        const names = await this.page
            .locator(selector)
            .evaluate((element) =>
                [...element.querySelectorAll("button, select, input, summary, [tabindex]")]
                    .filter((control) => (control as HTMLElement).offsetParent !== null)
                    .map((control) => (window as unknown as Watched).nameOfControl(control)),
            );
        return [...new Set(names)].filter((name) => !this.driven.has(name));
    }

    async text(selector: string): Promise<string> {
        return (await this.page.locator(selector).first().textContent()) ?? "";
    }

    /** Waits until the player has drawn; returns what it says in words. */
    async readout(): Promise<string> {
        await this.page.waitForFunction(() => (document.querySelector(".readout")?.textContent ?? "") !== "");
        await this.settle();
        return this.text(".readout");
    }

    /** Two frames: whatever was asked for is drawn then. */
    async settle(): Promise<void> {
        await this.page.evaluate(
            () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
        );
    }

    /** What tells the pixels of a canvas from others. */
    async pixels(selector: string): Promise<string> {
        await this.settle();
        const data = await this.page
            .locator(selector)
            .first()
            .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
        return createHash("sha256").update(data).digest("hex");
    }

    /** Fingers go down, move from place to place, and are lifted. */
    async touch(places: [number, number][][]): Promise<void> {
        const session = await this.context.newCDPSession(this.page);
        await session.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 2 });
        for (const [i, fingers] of places.entries())
            await session.send("Input.dispatchTouchEvent", {
                type: i === 0 ? "touchStart" : "touchMove",
                touchPoints: fingers.map(([x, y], id) => ({ x, y, id })),
            });
        await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
        await session.send("Emulation.setTouchEmulationEnabled", { enabled: false });
        await session.detach();
    }

    /** Seconds of processor time that the page's main thread has had, of a usual machine. */
    async processorTime(): Promise<number> {
        if (!this.session) {
            this.session = await this.context.newCDPSession(this.page);
            await this.session.send("Performance.enable", { timeDomain: "threadTicks" });
        }
        const { metrics } = await this.session.send("Performance.getMetrics");
        return (metrics.find(({ name }) => name === "TaskDuration")?.value ?? 0) / this.slowness;
    }
}
