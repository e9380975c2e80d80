// The README's pictures, taken from pages that the program wrote:
// node pictures.mjs FOLDER, with RAYAUDIT the program and CHROMIUM the browser.
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const pictures = [
  { name: "front", chart: "front", command: ["cost", "--shape", "sphere"] },
  {
    name: "ladder", chart: "ladder-errors", height: "own max",
    command: ["ladder", "textbook/double", "unit_space/double", "closest_approach/double", "certified/double", "--family", "far", "--shape", "sphere"],
  },
];

const folder = mkdtempSync(join(tmpdir(), "rayaudit-pictures-"));
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, chromiumSandbox: false, args: ["--disable-dev-shm-usage", "--disable-gpu"] });
try {
  for (const { name, chart, command, height } of pictures) {
    const html = join(folder, `${name}.html`);
    const made = spawnSync(process.env.RAYAUDIT, [...command, "--report", `html=${html}`], { encoding: "utf8" });
    if (made.status !== 0) throw new Error(made.stderr);
    const page = await browser.newPage({ viewport: { width: 900, height: 900 } });
    await page.goto(pathToFileURL(html).href);
    if (height) await page.getByLabel("Height").selectOption(height);
    const drawn = await page.evaluate(async (id) => (await window.rayaudit.draw(id)).toSVG(), chart);
    // On a page of either colour the picture brings its own paper.
    writeFileSync(join(process.argv[2], `${name}.svg`), drawn.replace(/(<svg[^>]*>)/, '$1<rect width="100%" height="100%" fill="white"/>') + "\n");
    await page.close();
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
