// node test.mjs NAME…
//
// Bundles tests/NAME.test.ts and runs them with Node's own test runner; `types` checks the types of all
// sources. Ends with 77 where a test says that it cannot be run here.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const run = (...words) => spawnSync(process.execPath, words, { stdio: "inherit" }).status ?? 1;

for (const name of process.argv.slice(2)) {
    if (name === "types") {
        const code = run(join(here, "node_modules/typescript/bin/tsc"), "-p", here);
        if (code !== 0) process.exit(code);
        continue;
    }
    const outfile = join(here, "bundled", `${name}.test.mjs`);
    await build({
        entryPoints: [join(here, "tests", `${name}.test.ts`)],
        bundle: true,
        platform: "node",
        format: "esm",
        external: ["playwright-core"],
        outfile,
        logLevel: "warning",
    });
    // Global in Node.js 22; a flag of 20.
    const flag = "--experimental-websocket";
    const code = run(...(process.allowedNodeEnvironmentFlags.has(flag) ? [flag] : []), outfile);
    if (code !== 0) process.exit(code);
}
