// node build.mjs OUTPUT_FOLDER
//
// Bundles src/ into one page without data, explorer.html, and writes it as ExplorerTemplate.cpp too. The
// page allows nothing but its own script and style, each named by its hash. Licences of what is bundled stay
// in it.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2] ?? join(here, "build");

async function bundle(entry) {
    return build({
        entryPoints: [join(here, entry)],
        bundle: true,
        minify: true,
        format: "iife",
        target: ["chrome109", "firefox115", "safari16.4"],
        charset: "utf8",
        legalComments: "inline",
        logLevel: "warning",
        metafile: true,
        write: false,
        outdir: output,
    });
}

// Of every package that has a file in the bundle.
function licences(metafiles) {
    const packages = new Set();
    for (const metafile of metafiles)
        for (const input of Object.keys(metafile.inputs)) {
            const found = input.match(/^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//);
            if (found) packages.add(found[1]);
        }
    return [...packages]
        .sort()
        .map((folder) => {
            const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
            return `${name} ${version} (${license})\n\n${readFileSync(join(folder, "LICENSE"), "utf8").trim()}\n`;
        })
        .join("\n\n");
}

// Inside <script> and <style> nothing may look like their end.
function checked(text, element) {
    if (new RegExp(`</${element}`, "i").test(text) || text.includes("<!--"))
        throw new Error(`the ${element} holds text that ends it`);
    return text;
}

const hash = (text) => `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;
const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");

const script = await bundle("src/main.ts");
const style = await bundle("src/style.css");
const js = checked(script.outputFiles[0].text, "script");
const css = checked(style.outputFiles[0].text, "style");
const policy = [
    "default-src 'none'",
    `script-src ${hash(js)}`,
    `style-src ${hash(css)}`,
    "img-src data: blob:",
    "media-src blob:",
    "base-uri 'none'",
    "form-action 'none'",
].join("; ");

// The icon is given as none: browsers would otherwise ask a server for one.
const page = `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="referrer" content="no-referrer">
<link rel="icon" href="data:,">
<title>MRPPSim</title>
<style>${css}</style>
</head>
<body>
<noscript>This page shows its charts, tables and animations by a script of its own, which the browser has switched off.</noscript>
<main id="page"></main>
<template id="licences"><pre>${escaped(licences([script.metafile, style.metafile]))}</pre></template>
<!-- data -->
<script>${js}</script>
</body>
</html>
`;

// Compilers bound the length of a literal, so that a long one is given in parts.
function literals(text) {
    const parts = [];
    for (let at = 0; at < text.length; at += 8000) parts.push(text.slice(at, at + 8000));
    for (let i = 1; i < parts.length; ++i)
        if (/[\uDC00-\uDFFF]/.test(parts[i][0])) {
            parts[i - 1] += parts[i][0];
            parts[i] = parts[i].slice(1);
        }
    return parts.map((part) => `    R"~~~~(${part})~~~~"`).join("\n");
}

mkdirSync(output, { recursive: true });
writeFileSync(join(output, "explorer.html"), page);
writeFileSync(
    join(output, "ExplorerTemplate.cpp"),
    `// Written by reports/web/build.mjs.
#include "reports/explorer/ExplorerTemplate.h"

namespace mrpp
{

std::string_view explorerTemplate()
{
    static constexpr char kPage[] =
${literals(page)};
    return {kPage, sizeof kPage - 1};
}

} // namespace mrpp
`,
);
