// The pages in a browser: node page_test.mjs, with RAYAUDIT the program and CHROMIUM the browser.
// Ends with 77, skipped, where the packages of the test could not be fetched.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { climb_report, cost_report } from "./made_by_hand.mjs";

const playwright = await import("playwright-core").catch(() => process.exit(77));
const flags = ["--disable-dev-shm-usage", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];
const folder = mkdtempSync(join(tmpdir(), "rayaudit-page-"));
const file = (name) => join(folder, name);
setTimeout(() => process.exit(1), 280_000).unref();
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

const report_of = (html) => /(<script type="application\/json" id="report">)(.*?)(<\/script>)/s.exec(html);
const escaped = (text) => text.replace(/[<>&]/g, (c) => `\\u00${c.charCodeAt(0).toString(16)}`);

/** The page of the audit with the data of another report. */
function with_report(report, name) {
  const html = readFileSync(file("audit.html"), "utf8");
  const [, open, , close] = report_of(html);
  writeFileSync(file(name), html.replace(report_of(html)[0], () => open + escaped(JSON.stringify(report)) + close));
  return name;
}

/** Lets the program write a page. */
function written(name, ...words) {
  const ended = spawnSync(process.env.RAYAUDIT, [...words, "--report", `html=${file(name)}`], { encoding: "utf8" });
  if (/has no html reports/.test(ended.stderr)) process.exit(77);
  assert.equal(ended.status, 0, ended.stderr);
}

let browser;
before(async () => {
  written("audit.html", "audit", "*/float", "*/double", "--shape", "sphere,cone", "--family", "anywhere,grazing,tangent", "--cases", "500");
  written("measured.html", "cost", "textbook/*", "certified/*", "--shape", "disk,sphere", "--family", "anywhere,grazing", "--cases", "256", "--rounds", "3");
  written("climbed.html", "ladder", "textbook/float", "certified/float", "--shape", "sphere", "--cases", "256");
  browser = await playwright.chromium.launch({ executablePath: process.env.CHROMIUM, chromiumSandbox: false, args: flags });
});
after(() => browser?.close());

/** Opens a page, lets a visitor act on it, and holds that it was quiet and fetched nothing. */
async function visit(name, act, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...options });
  page.setDefaultTimeout(20_000);
  const said = [], fetched = [];
  page.on("console", (message) => said.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => said.push(error.stack));
  page.on("request", (request) => fetched.push(request.url()));
  const url = pathToFileURL(file(name)).href;
  try {
    await page.goto(url);
    await act(page);
  } finally {
    await page.close();
  }
  assert.deepEqual(said, []);
  assert.deepEqual(fetched.filter((each) => !each.startsWith("data:")), [url]);
}

/** How many marks that can be seen a chart has. */
const marks = (page, id) => page.evaluate(async (chart) => {
  await window.rayaudit.draw(chart);
  const drawn = new DOMParser().parseFromString(await window.rayaudit.views[chart].toSVG(), "image/svg+xml");
  const long = [...drawn.querySelectorAll(".role-mark path")].filter((path) => path.getAttribute("d")?.length > 8);
  return long.filter((path) => !/NaN|Infinity/.test(path.getAttribute("d"))).length;
}, id);

/** Waits for a chart to be drawn. */
const drawn = (page, id) => page.evaluate(async (chart) => void (await window.rayaudit.draw(chart)), id);

/** What a chart has of steps and words. */
const drawn_by = async (page, id) => {
  await drawn(page, id);
  return {
    steps: await page.locator(`#${id} .mark-line.role-mark path`).count(),
    words: await page.locator(`#${id} .mark-text.role-mark text`).allTextContents(),
    labels: await page.locator(`#${id} .role-axis-label text`).allTextContents(),
    caption: await page.locator(`figure:has(#${id}) figcaption`).textContent(),
  };
};

/** The rows of the figures under a chart, opened by the keyboard. */
async function in_figures(page, id) {
  await drawn(page, id);
  const details = page.locator(`figure:has(#${id}) .in-figures`);
  assert.equal(await details.locator("table").count(), 0, `${id} before it is opened`);
  await details.locator("summary").press("Enter");
  await details.locator("table").waitFor();
  return () => details.locator("tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
}

const charts_of = (page) => page.evaluate(() => [...document.querySelectorAll(".chart")].map(({ id }) => id));
const too_wide = (page) => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);

test("a page is small, and can be used within two seconds", async () => {
  assert.ok(statSync(file("audit.html")).size < 1_300_000, `${statSync(file("audit.html")).size} bytes`);
  await visit("audit.html", async (page) => assert.ok((await page.evaluate(() => window.rayaudit.interactive)) < 2000));
});

test("every chart has marks", async () => {
  with_report(cost_report(), "cost.html");
  with_report(climb_report(), "ladder.html");
  const charts = { "audit.html": ["wrong-by-margin", "errors"], "cost.html": ["front"], "ladder.html": ["ladder-errors", "ladder-wrong", "ladder-margins"] };
  for (const [name, ids] of Object.entries(charts))
    await visit(name, async (page) => {
      for (const id of ids) assert.ok((await marks(page, id)) >= 3, `${id} in ${name}`);
    });
});

test("the pages of a cost and a ladder that were measured have all that they are read for", async () => {
  await visit("measured.html", async (page) => {
    assert.ok((await marks(page, "front")) >= 2);
    const told = await page.textContent("main");
    assert.match(told, /from textbook\/\S+ to \S+: [\d.]+ times the time/);
    assert.match(told, /certified\/double/);
  });
  await visit("climbed.html", async (page) => {
    for (const id of ["ladder-errors", "ladder-wrong", "ladder-margins"]) assert.ok((await marks(page, id)) >= 2, id);
    assert.match(await page.textContent("main"), /textbook\/float/);
  });
});

test("what the cases force is drawn in a ladder whose first subject has no errors", async () => {
  const ladder = climb_report();
  await visit(with_report(ladder, "bare.html"), async (page) => {
    assert.ok((await marks(page, "ladder-errors")) >= 3);
    assert.equal(await page.locator('#ladder-errors .role-mark path[stroke-dasharray="6,4"]').count(), 1);
  });
  ladder.climbs = ladder.climbs.slice(0, 1);
  await visit(with_report(ladder, "barest.html"), async (page) => {
    await page.waitForSelector("#ladder-errors .nothing");
    assert.ok((await marks(page, "ladder-margins")) >= 2);
  });
});

test("a click on a cell shows its findings, with a case line and what explains it", async () => {
  await visit("audit.html", async (page) => {
    await page.selectOption("select", "sphere");
    await page.click('#heat-map button[aria-label^="textbook/float, grazing"]');
    const told = await page.textContent("#cell");
    assert.match(told, /textbook\/float on sphere, family grazing/);
    assert.match(told, /of 500 answers are wrong/);
    assert.match(told, /false (hit|miss): /);
    assert.match(told, /sphere (-?0x[\da-f.]+p[+-]\d+ ){4}ray (-?0x[\da-f.]+p[+-]\d+ ){6}(hit|miss)/);
    assert.match(told, /rayaudit explain --subject textbook\/float 'sphere /);
    assert.equal(await page.locator("#cell svg.view").count(), 2);
    assert.ok((await page.locator("#cell svg.view .mark").count()) >= 3);
  });
});

test("the arrow keys and Enter show the findings of a cell too", async () => {
  await visit("audit.html", async (page) => {
    await page.selectOption("select", "cone");
    await page.focus('#heat-map button[aria-label^="textbook/float, anywhere"]');
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    assert.match(await page.textContent("#cell h3"), /^textbook\/double on cone, family grazing$/);
    assert.match(await page.textContent("#cell"), /cone -?0x/);
    assert.equal(await page.locator('#heat-map button[tabindex="0"]').count(), 1);
  });
});

test("each case of a cell can be drawn, and each finding leads to its cell", async () => {
  await visit("audit.html", async (page) => {
    await page.locator("td button:visible", { hasText: "show" }).last().click();
    await page.locator("#cell .draw").last().click();
    const title = await page.textContent("#cell .picture h4");
    assert.ok(title.includes(await page.locator("#cell .findings strong").last().textContent()));
  });
});

test("a case line can be copied", async () => {
  await visit("audit.html", async (page) => {
    await page.locator("#cell .copy").first().click();
    await page.waitForFunction(() => /copied|selected/.test(document.querySelector("#cell .copy").textContent));
  });
});

test("text from the data never becomes markup", async () => {
  const evil = "<img src=x onerror=document.title='broken'>/float";
  const audit = JSON.parse(report_of(readFileSync(file("audit.html"), "utf8"))[2]);
  audit.subjects[0].name = evil;
  audit.families[0].about = audit.command = evil;
  audit.lines = audit.lines.map(([line, roots]) => [line + evil, roots]);
  const cost = cost_report(), ladder = climb_report();
  cost.cells[0].ways[0].subject = cost.cells[0].steps[0].text = cost.absent[0].why = evil;
  ladder.climbs[1].subject = ladder.family.about = ladder.climbs[1].broken.case = evil;
  for (const [name, report] of Object.entries({ audit, cost, ladder }))
    await visit(with_report(report, `evil-${name}.html`), async (page) => {
      for (const id of await charts_of(page)) await marks(page, id);
      if (name === "audit") await page.locator("#heat-map button").first().click();
      assert.ok((await page.textContent("main")).includes(evil), name);
      assert.equal(await page.locator("img").count(), 0);
      assert.equal(await page.title(), "rayaudit audit");
    });
});

test("no page scrolls sideways on a phone, on paper or with all subjects shown", async () => {
  for (const name of ["audit.html", "cost.html", "ladder.html"])
    await visit(name, async (page) => {
      for (const ticks of await page.locator("details.ticks summary").all()) await ticks.click();
      for (const id of await charts_of(page)) await marks(page, id);
      assert.equal(await too_wide(page), 0, name);
      await page.emulateMedia({ media: "print" });
      await page.setViewportSize({ width: 718, height: 1000 });  // A4 within its margins
      assert.equal(await too_wide(page), 0, `${name} on paper`);
      assert.ok(await page.locator(".cell, .figure").first().isVisible());
    }, { viewport: { width: 360, height: 700 } });
});

test("a dark page has dark paper, and charts with light letters", async () => {
  await visit("audit.html", async (page) => {
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(20, 21, 23)");
    await marks(page, "errors");
    assert.equal(await page.locator("#errors .role-axis-label text").first().getAttribute("fill"), "#e8e8e8");
  }, { colorScheme: "dark" });
});

test("headings are in order, and every control has a name", async () => {
  for (const name of ["audit.html", "cost.html", "ladder.html"])
    await visit(name, async (page) => {
      const levels = await page.evaluate(() => [...document.querySelectorAll("h1,h2,h3,h4")].map(({ tagName }) => Number(tagName[1])));
      levels.forEach((level, i) => assert.ok(level <= (levels[i - 1] ?? 0) + 1, `${name}: ${levels}`));
      const nameless = await page.evaluate(() => [...document.querySelectorAll("select, input, button, [role=region]")]
        .filter((each) => !each.labels?.length && !each.textContent.trim() && !each.getAttribute("aria-label")).length);
      assert.equal(nameless, 0, name);
    });
});

test("another shape, family and measure redraw the charts", async () => {
  await visit("audit.html", async (page) => {
    const first = await page.evaluate(async () => (await window.rayaudit.draw("errors")).toSVG());
    await page.selectOption("section:has(#errors) label:has-text('Family') select", "grazing");
    const then = await page.evaluate(async () => (await window.rayaudit.draw("errors")).toSVG());
    assert.notEqual(first, then);
  });
  await visit("cost.html", async (page) => {
    await page.selectOption("label:has-text('Cases') select", "hard cases");
    assert.match(await page.textContent("main"), /sphere, hard cases/);
    await page.selectOption("label:has-text('Height') select", "error");
    assert.ok((await marks(page, "front")) >= 3);
    assert.match(await page.textContent("#front"), /in units of float/);
  });
});

test("the front is a line by wrong answers, and by error points alone, infinity in a band of its own", async () => {
  await visit("cost.html", async (page) => {
    const by_wrong = await drawn_by(page, "front");
    assert.equal(by_wrong.steps, 1);
    assert.ok(by_wrong.labels.includes("0 of 4,096") && !by_wrong.labels.includes("inf"), by_wrong.labels);
    assert.match(by_wrong.caption, /by wrong answers first and then by error\. .* cannot be told apart\.$/);
    await page.selectOption("label:has-text('Height') select", "error");
    const by_error = await drawn_by(page, "front");
    assert.equal(by_error.steps, 0);
    assert.ok(by_error.labels.includes("inf"), by_error.labels);
    assert.match(by_error.caption, /Left out, for no error of their own was measured: 1\.$/);
  });
});

test("a cost tells what could not be measured, and what of its times is not the answering", async () => {
  await visit("cost.html", async (page) => {
    const told = await page.textContent("main");
    assert.match(told, /\*\/float128: this compiler has no such number/);
    assert.match(told, /up to 2\.25 ns of each are spent on reading a case and writing an answer/);
    assert.match(told, /1,024 timed, fewer of dear ways/);
  });
});

/** The words of a chart that reach beyond it. */
const cut_off = (page, id) => page.evaluate((chart) => {
  const box = document.querySelector(`#${chart} svg`).getBoundingClientRect();
  return [...document.querySelectorAll(`#${chart} .mark-text.role-mark text`)].filter((text) => {
    const { left, right } = text.getBoundingClientRect();
    return left < box.left || right > box.right;
  }).map(({ textContent }) => textContent);
}, id);

test("on a phone the front has numbers, those of the table; wider it has names; neither is cut off", async () => {
  const cost = cost_report();
  for (const { ways } of cost.cells) {
    ways.forEach((way, i) => (way.subject = `a_name_that_takes_half_of_a_chart_or_more+${i}/float`));
    ways[3].ns = [190, 200, 210];
  }
  with_report(cost, "long.html");
  for (const width of [360, 390, 541, 640, 1280])
    await visit("long.html", async (page) => {
      const { words } = await drawn_by(page, "front");
      const rows = await page.locator("table:has-text('times the fastest') tr:has(strong)").evaluateAll((all) => all.map((row) => [...row.children].slice(0, 2).map((cell) => cell.textContent)));
      assert.deepEqual(rows.map(([, number]) => number), ["1", "2", "3"]);
      assert.deepEqual(words.sort(), rows.map(([name, number]) => (width < 500 ? number : name)).sort());
      assert.deepEqual(await cut_off(page, "front"), [], `at ${width}`);
    }, { viewport: { width, height: 800 } });
});

test("charts are told in figures too, by the keyboard, filled when opened and with what is chosen", async () => {
  await visit("ladder.html", async (page) => {
    const errors = await in_figures(page, "ladder-errors");
    assert.deepEqual((await errors())[0], ["k", "textbook/float", "handout/float", "the case forces, float"]);
    assert.deepEqual((await errors())[3], ["3", "64", "8", "2.83"]);
    await page.selectOption("label:has-text('Height') select", "own max");
    await drawn(page, "ladder-errors");
    assert.deepEqual((await errors())[3], ["3", "3.75", "3.75"]);
    assert.deepEqual((await (await in_figures(page, "ladder-wrong"))())[6], ["6", "0 of 1,024 (0 %)", "36 of 1,024 (3.52 %)", "36 of 1,024 (3.52 %)"]);
    assert.deepEqual((await (await in_figures(page, "ladder-margins"))())[8].slice(0, 3), ["8", "1", "0.25"]);
  });
  await visit("audit.html", async (page) => {
    for (const id of ["wrong-by-margin", "errors"]) {
      const rows = await (await in_figures(page, id))();
      assert.ok(rows.length > 2 && rows[0].includes("textbook/float"), `${id}: ${rows.join("; ")}`);
      assert.match(rows[1].concat(rows[2]).join(" "), /\d of [\d,]+ (hits )?\(/);
    }
  });
});

test("what the mouse is told of a line has the words of what is drawn", async () => {
  const tip = async (page, id, path) => {
    await drawn(page, id);
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.locator(`#${id} ${path}`).first().hover({ force: true });
    await page.waitForSelector("#vg-tooltip-element.visible");
    return page.textContent("#vg-tooltip-element");
  };
  await visit("ladder.html", async (page) => {
    assert.match(await tip(page, "ladder-errors", ".mark-symbol.role-mark path"), /largest error, ulps/);
    assert.match(await tip(page, "ladder-wrong", ".mark-symbol.role-mark path"), /wrong.* of 1,024/);
  });
  await visit("audit.html", async (page) => assert.match(await tip(page, "wrong-by-margin", ".mark-symbol.role-mark path"), /wrong.* of /));
});

test("what subjects are held to is told once where it is the same, else of each", async () => {
  const ladder = climb_report();
  await visit(with_report(ladder, "ladder.html"), async (page) => {
    assert.match(await page.textContent("header"), /held tomax_forced 64/);
    assert.equal(await page.locator("th", { hasText: "held to" }).count(), 0);
  });
  ladder.climbs[1].held_to = "wrong 0";
  await visit(with_report(ladder, "promises.html"), async (page) => {
    assert.doesNotMatch(await page.textContent("header"), /held to/);
    assert.equal(await page.locator("th", { hasText: "held to" }).count(), 1);
    assert.equal(await page.locator("td", { hasText: /^wrong 0$/ }).count(), 1);
  });
});
