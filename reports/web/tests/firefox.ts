// Firefox without a window, driven by WebDriver BiDi (https://w3c.github.io/webdriver-bidi/).
import { type ChildProcess, spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const kFirefoxes = [process.env.FIREFOX ?? "", "/usr/bin/firefox-esr", "/usr/bin/firefox"];

export const firefoxPath = kFirefoxes.find((path) => path !== "" && existsSync(path));

type Json = Record<string, unknown>;

/** Runs in the page before its own script. */
const kWatch = `() => {
    window.watched = { violations: [], files: [] };
    document.addEventListener("securitypolicyviolation", (event) =>
        watched.violations.push(event.violatedDirective + " " + event.blockedURI));
    const create = URL.createObjectURL;
    URL.createObjectURL = (blob) => { watched.files.push(blob); return create.call(URL, blob); };
}`;

export class Firefox {
    readonly complaints: string[] = []; // errors and warnings
    readonly requests: string[] = [];
    private context = "";
    private last = 0;
    private readonly waiting = new Map<
        number,
        { resolve: (value: Json) => void; reject: (error: Error) => void }
    >();

    private constructor(
        private readonly process: ChildProcess,
        private readonly socket: WebSocket,
        private readonly profile: string,
    ) {
        socket.addEventListener("message", ({ data }) => this.onMessage(JSON.parse(String(data))));
    }

    static async start(): Promise<Firefox> {
        const profile = mkdtempSync(join(tmpdir(), "mrppsim-firefox-"));
        const preferences = {
            "app.normandy.enabled": false,
            "browser.download.dir": profile,
            "browser.download.folderList": 2,
            "browser.shell.checkDefaultBrowser": false,
            "datareporting.policy.dataSubmissionEnabled": false,
            "network.captive-portal-service.enabled": false,
            "network.connectivity-service.enabled": false,
        };
        const lines = Object.entries(preferences).map(
            ([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});\n`,
        );
        writeFileSync(join(profile, "user.js"), lines.join(""));
        const words = ["--headless", "--no-remote", "--profile", profile, "--remote-debugging-port", "0"];
        const environment = {
            ...process.env,
            HOME: profile,
            MOZ_HEADLESS_WIDTH: "1280",
            MOZ_HEADLESS_HEIGHT: "900",
        };
        const child = spawn(firefoxPath!, words, { env: environment, stdio: ["ignore", "ignore", "pipe"] });
        try {
            const socket = new WebSocket(`${await addressOf(child)}/session`);
            await new Promise((resolve, reject) => {
                socket.addEventListener("open", resolve);
                socket.addEventListener("error", () => reject(new Error("Firefox does not answer")));
            });
            const firefox = new Firefox(child, socket, profile);
            await firefox.begin();
            return firefox;
        } catch (error) {
            child.kill();
            throw error;
        }
    }

    private async begin(): Promise<void> {
        await this.send("session.new", { capabilities: {} });
        await this.send("session.subscribe", { events: ["log.entryAdded", "network.beforeRequestSent"] });
        const { contexts } = await this.send("browsingContext.getTree", {});
        this.context = (contexts as { context: string }[])[0].context;
        await this.send("script.addPreloadScript", { functionDeclaration: kWatch });
        await this.send("browsingContext.setViewport", {
            context: this.context,
            viewport: { width: 1280, height: 800 },
        });
    }

    async stop(): Promise<void> {
        const ended = new Promise((resolve) => this.process.once("exit", resolve));
        await this.send("browser.close", {}).catch(() => this.process.kill());
        await ended;
        rmSync(this.profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
    }

    async open(file: string, hash: string): Promise<void> {
        const { context } = this;
        await this.send("browsingContext.navigate", { context, url: "about:blank", wait: "complete" });
        await this.send("browsingContext.navigate", {
            context,
            url: `file://${file}#${hash}`,
            wait: "complete",
        });
        await this.until("document.querySelector('[role=tab]') !== null");
    }

    /** The value of an expression, which may be a promise of one; texts, numbers and truths alone. */
    async evaluate<Value>(expression: string): Promise<Value> {
        const { type, result, exceptionDetails } = await this.send("script.evaluate", {
            expression,
            target: { context: this.context },
            awaitPromise: true,
        });
        if (type === "exception") throw new Error((exceptionDetails as { text: string }).text);
        return (result as { value: Value }).value;
    }

    async until(condition: string): Promise<void> {
        const kPatience = Number(process.env.MRPP_PATIENCE ?? 60_000);
        for (const start = Date.now(); Date.now() - start < kPatience; await pause(50))
            if (await this.evaluate<boolean>(condition)) return;
        throw new Error(`never: ${condition}`);
    }

    async screenshot(file: string): Promise<void> {
        const { data } = await this.send("browsingContext.captureScreenshot", { context: this.context });
        writeFileSync(file, Buffer.from(data as string, "base64"));
    }

    async press(...keys: string[]): Promise<void> {
        const actions = keys.flatMap((value) => [
            { type: "keyDown", value },
            { type: "keyUp", value },
        ]);
        await this.send("input.performActions", {
            context: this.context,
            actions: [{ type: "key", id: "keyboard", actions }],
        });
    }

    private send(method: string, params: Json): Promise<Json> {
        const id = ++this.last;
        this.socket.send(JSON.stringify({ id, method, params }));
        return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    }

    private onMessage(message: Json): void {
        if (message.type === "event") {
            const params = message.params as { level?: string; text?: string; request?: { url: string } };
            if (params.request) this.requests.push(params.request.url);
            else if (["error", "warn"].includes(params.level ?? "")) this.complaints.push(params.text ?? "");
            return;
        }
        const waiting = this.waiting.get(message.id as number);
        this.waiting.delete(message.id as number);
        if (message.type === "error") waiting?.reject(new Error(`${message.error}: ${message.message}`));
        else waiting?.resolve(message.result as Json);
    }
}

const pause = (milliseconds: number): Promise<void> =>
    new Promise((resolve) => setTimeout(resolve, milliseconds));

/** What Firefox says where it listens. */
function addressOf(child: ChildProcess): Promise<string> {
    return new Promise((resolve, reject) => {
        let said = "";
        child.stderr!.on("data", (text: Buffer) => {
            said += text.toString();
            const found = said.match(/WebDriver BiDi listening on (ws:\S+)/);
            if (found) resolve(found[1]);
        });
        child.once("error", reject);
        child.once("exit", () => reject(new Error(`Firefox ended: ${said}`)));
    });
}
