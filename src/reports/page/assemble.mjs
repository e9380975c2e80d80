// Puts style and scripts into page.html: node assemble.mjs FOLDER_OF_NODE_MODULES FILE.
// Title and report stay open, for the program to fill in.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [modules, file] = process.argv.slice(2);
const own = (name) => readFileSync(new URL(name, import.meta.url), "utf8");
const bundle = (path) =>
  readFileSync(join(modules, path), "utf8").replace(/^\/\/# sourceMappingURL=.*$/gm, "");

const themes = ["words", "page", "charts", "drawing", "audit", "cost", "ladder", "start"];
const scripts = [
  bundle("vega/build/vega.min.js"),
  bundle("vega-lite/build/vega-lite.min.js"),
  bundle("vega-embed/build/vega-embed.min.js"),
  `(() => {\n"use strict";\n${themes.map((name) => own(`${name}.js`)).join("\n")}})();\n`,
];
if (scripts.some((text) => /<\/script|<!--/i.test(text)))
  throw new Error("a script holds the end of its own element");

// Only these scripts may run, no handler in an attribute, and nothing may be fetched.
const hashes = scripts.map((text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`);
const policy = `default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; script-src ${hashes.join(" ")}`;

const parts = {
  POLICY: policy,
  STYLE: own("page.css"),
  SCRIPTS: scripts.map((text) => `<script>${text}</script>`).join("\n"),
};
writeFileSync(file, own("page.html").replace(/@(POLICY|STYLE|SCRIPTS)@/g, (_, name) => parts[name]));
