// A real browser, the built program, and what tests of pages need of them.
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type BrowserContext, type CDPSession, type Page, chromium } from "playwright-core";

const kBrowsers = [
    process.env.CHROMIUM ?? "",
    "/usr/bin/chromium",
    "/usr/bin/chromium-browser",
    "/usr/bin/google-chrome",
];

export const browserPath = kBrowsers.find((path) => path !== "" && existsSync(path));

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

    private session: CDPSession | null = null;

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
        return new Browser(context, context.pages()[0], profile);
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

    /** The pixels of a canvas, in short. */
    async pixels(selector: string): Promise<string> {
        await this.settle();
        return this.page
            .locator(selector)
            .first()
            .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
    }

    /** Seconds of processor time that the page's main thread has had. */
    async processorTime(): Promise<number> {
        if (!this.session) {
            this.session = await this.context.newCDPSession(this.page);
            await this.session.send("Performance.enable", { timeDomain: "threadTicks" });
        }
        const { metrics } = await this.session.send("Performance.getMetrics");
        return metrics.find(({ name }) => name === "TaskDuration")?.value ?? 0;
    }
}
