// The page of an audit: who is wrong where, how often at which margin, by how much, and on which case.

function audit_page(report, show) {
  const { subjects, families, shapes, audits } = report;
  const counted = (audit) => Object.fromEntries(report.verdicts.map((name, i) => [name, audit.verdicts[i]]));
  const cells = new Map();
  for (const audit of audits) {
    Object.assign(audit, { subject: subjects[audit.subject], family: families[audit.family].id, shape: shapes[audit.shape] });
    audit.counts = counted(audit);
    audit.wrong = report.wrong_verdicts.reduce((sum, verdict) => sum + audit.verdicts[verdict], 0);
    cells.set(`${audit.shape} ${audit.family} ${audit.subject.name}`, audit);
  }
  const of = (subject, shape, family) => cells.get(`${shape} ${family} ${subject}`);
  const here = {
    report, audits, of,
    shape: choice(report.findings[0] ? shapes[report.findings[0].shape] : audits[0].shape),
    family: choice("all families"),
    measure: choice("both"),
    cell: choice(null),
    subjects: choice(first_subjects(subjects)),
  };
  const difficulty = report.difficulty == null ? null : `difficulty ${report.difficulty}`;
  show(
    heading(report, "Float routines held against exact arithmetic, case by case: who is wrong where, by how much, and on which case.", [
      ["command", report.command ? element("code", {}, report.command) : null],
      ["cases", `${grouped(report.cases)} for each subject, shape and family${difficulty ? `, ${difficulty}` : ""}`],
      ["audits", `${grouped(audits.length)}: ${subjects.length} subjects, ${shapes.length} shapes, ${families.length} families`],
    ]),
    heat_section(here),
    margin_section(here),
    error_section(here),
    findings_section(here));
  const worst = report.findings[0];
  if (worst) here.cell.set(of(subjects[worst.subject].name, shapes[worst.shape], families[worst.family].id));
  else here.cell.set(audits[0]);
}

/** The subjects that charts show at first: one a routine, in float where there is one. */
function first_subjects(subjects) {
  const floats = subjects.filter(({ format }) => format === "float");
  return (floats.length ? floats : subjects).slice(0, hues().length).map(({ name }) => name);
}

// The heat map.

const measures = {
  both: "wrong answers; where there are none, the largest error",
  wrong: "wrong answers",
  ulp: "largest error of t, in ulps",
  forced: "largest error of t, in units of what the case forces",
  margin: "largest margin of a wrong answer",
};

/** The step of colour from 0 to 6 of a value between two powers of ten, 0 for none. */
const step_of = (x, least, most) =>
  !(x > 0) ? 0 : Math.min(6, Math.max(1, 1 + Math.floor((5.999 * (Math.log10(x) - least)) / (most - least))));

/** What a cell shows by a measure: its words, and its class of colour. */
function shown(audit, measure) {
  const share = audit.wrong / audit.cases;
  const size = (x, most) => ({ words: magnitude(x), colour: x == null ? "none" : `cool-${step_of(number(x), 0, most)}` });
  const wrong = { words: audit.wrong ? `${percent(audit.wrong, audit.cases)}%` : "0", colour: audit.wrong ? `warm-${step_of(share, -4, 0)}` : "cool-0" };
  if (measure === "wrong") return wrong;
  if (measure === "ulp") return size(audit.ulp?.[2], 8);
  if (measure === "forced") return size(audit.forced?.[2], 8);
  if (measure === "margin")
    return audit.margin == null ? { words: "–", colour: "none" } : { words: magnitude(audit.margin), colour: `warm-${step_of(number(audit.margin), 0, 16)}` };
  return audit.wrong ? wrong : size(audit.ulp?.[2], 8);
}

const legends = {
  both: "Orange: in per cent of the cases a wrong answer is given, stronger where more are wrong (each step is 4.6 times as many). Blue: no answer is wrong, and the number is the largest error of t in ulps of the subject's own format, stronger where larger.",
  wrong: "Orange: in per cent of the cases a wrong answer is given, stronger where more are wrong (each step is 4.6 times as many). Plain: none is wrong.",
  ulp: "Blue: the largest error of t in ulps of the subject's own format, stronger where larger (each step is 21 times as large). Half an ulp is as good as can be.",
  forced: "Blue: the largest error of t in units of what rounding the numbers of the case once would do to it, stronger where larger. 1 is as good as any routine can promise.",
  margin: "Orange: the largest margin at which an answer is wrong, in units of rounding u, stronger where larger. A few u may be excused; 1e6 u is a defect.",
};

function heat_section(here) {
  const place = element("div", {});
  const legend = element("p", { class: "about" });
  const scale = element("div", { class: "scale", "aria-hidden": "true" });
  const draw_map = () => {
    place.replaceChildren(heat_map(here));
    legend.textContent = legends[here.measure.value];
    const kinds = { both: ["cool", "warm"], wrong: ["warm"], margin: ["warm"] }[here.measure.value] ?? ["cool"];
    scale.replaceChildren(...kinds.map((kind) => element("span", {}, range(1, 6).map((i) => element("i", { class: `${kind}-${i}` })))));
  };
  here.shape.watch(draw_map);
  here.measure.watch(draw_map);
  draw_map();
  return section(
    "Who is wrong where",
    "A row for each subject, a column for each family of cases. Choose a cell, by a click or by the arrow keys and Enter, to see its findings.",
    controls(
      select("Shape", here.shape, here.report.shapes.map((name) => [name, name])),
      select("Colour", here.measure, Object.entries(measures))),
    place, element("div", { class: "legend" }, scale, legend), cell_panel(here));
}

/** A name that a narrow column may break behind its slash or underscores. */
const breakable = (name) => name.split(/(?<=[/_])/).flatMap((part) => [part, element("wbr")]);

function heat_map(here) {
  const { shape, measure, report } = here;
  const on_shape = here.audits.filter((audit) => audit.shape === shape.value);
  const families = report.families.map(({ id }) => id).filter((id) => on_shape.some(({ family }) => family === id));
  const subjects = report.subjects.filter((subject) => on_shape.some((audit) => audit.subject === subject));
  const button = (audit) => {
    const { words, colour } = shown(audit, measure.value);
    const told = `${audit.subject.name}, ${audit.family}: ${percent(audit.wrong, audit.cases)} % wrong, largest error ${magnitude(audit.ulp?.[2])} ulps`;
    const made = element("button", { type: "button", class: `cell ${colour}`, tabindex: "-1", "aria-label": told, title: told,
      "aria-pressed": String(here.cell.value === audit), onclick: () => here.cell.set(audit) }, words);
    made.audit = audit;
    return made;
  };
  const row = (subject) => element("tr", {}, element("th", { scope: "row" }, breakable(subject.name)), families.map((family) => {
    const audit = here.of(subject.name, shape.value, family);
    return element("td", {}, audit ? button(audit) : null);
  }));
  const about = Object.fromEntries(report.families.map(({ id, about }) => [id, about]));
  const map = element(
    "table", { class: "heat", id: "heat-map" },
    element("caption", {}, `${shape.value}: ${measures[measure.value]}`),
    element("thead", {}, element("tr", {}, element("td", {}), families.map((id) =>
      element("th", { scope: "col", title: about[id] }, element("span", {}, id))))),
    element("tbody", {}, subjects.map(row)));
  walked_by_arrows(map);
  return element("div", { class: "scrolling", role: "region", "aria-label": "heat map" }, map);
}

/** One cell is in the order of Tab; the arrow keys go from there. */
function walked_by_arrows(map) {
  const rows = [...map.querySelectorAll("tbody tr")].map((tr) => [...tr.querySelectorAll("td")].map((td) => td.firstChild));
  const buttons = rows.flat().filter(Boolean);
  const first = buttons.find((button) => button.getAttribute("aria-pressed") === "true") ?? buttons[0];
  if (first) first.tabIndex = 0;
  map.addEventListener("focusin", ({ target }) => {
    for (const button of buttons) button.tabIndex = button === target ? 0 : -1;
  });
  map.addEventListener("keydown", (event) => {
    const step = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] }[event.key];
    if (!step) return;
    let y = rows.findIndex((row) => row.includes(event.target)), x = rows[y]?.indexOf(event.target);
    do [y, x] = [y + step[0], x + step[1]];
    while (rows[y]?.[x] === null);
    if (!rows[y]?.[x]) return;
    rows[y][x].focus();
    event.preventDefault();
  });
}

// The findings of one cell.

function cell_panel(here) {
  const panel = element("div", { class: "panel", id: "cell", "aria-live": "polite" });
  here.cell.watch((audit) => {
    if (audit.shape !== here.shape.value) here.shape.set(audit.shape);
    for (const button of document.querySelectorAll("#heat-map button"))
      button.setAttribute("aria-pressed", String(button.audit === audit));
    panel.replaceChildren(...cell_findings(here, audit));
  });
  return panel;
}

function cell_findings(here, audit) {
  const { report } = here;
  const title = element("h3", {}, `${audit.subject.name} on ${audit.shape}, family ${audit.family}`);
  const family = report.families.find(({ id }) => id === audit.family);
  const none = `None of ${grouped(audit.cases)} answers is wrong: less than ${magnitude(300 / audit.cases)} % are, at 95 % confidence.`;
  const some = `${grouped(audit.wrong)} of ${grouped(audit.cases)} answers are wrong (${percent(audit.wrong, audit.cases)} %)` +
    `${audit.margin == null ? "." : `, at a margin of up to ${magnitude(audit.margin)} u.`}`;
  const errors = audit.ulp
    ? `Error of t: half of the hits within ${magnitude(audit.ulp[0])} ulps, 99 % within ${magnitude(audit.ulp[1])}, all within ${magnitude(audit.ulp[2])}; ` +
      `at most ${magnitude(audit.forced?.[2])} times what the case forces.`
    : "No error of t was measured: there was no hit at the right root.";
  const touches = audit.counts.touch ? ` Touches, a matter of convention: ${grouped(audit.counts.touch)}.` : "";
  const declared = audit.subject.declares ? ` It declares ${audit.subject.declares}.` : "";
  const findings = audit.outcomes.map(([verdict, claim, count, margin, line, cause]) => ({
    words: `${spaced(report.verdicts[verdict])}: ${report.verdict_words[verdict]}${report.claim_words[claim]}`,
    detail: `${grouped(count)} of ${grouped(audit.cases)}; ${margin == null ? "" : `margin up to ${magnitude(margin)} u; `}cause: ${cause}`,
    count, line,
  })).sort((a, b) => b.count - a.count);
  if (audit.largest != null)
    findings.push({ words: "the largest error of t", detail: `${magnitude(audit.ulp[2])} ulps`, line: audit.largest });
  const picture = element("div", { class: "picture" });
  const items = findings.map((finding) => finding_item(here, audit, finding, picture));
  if (items.length) items[0].draw();
  return [
    title,
    element("p", {}, `${family.about.charAt(0).toUpperCase()}${family.about.slice(1)}. ${audit.wrong ? some : none} ${errors}${touches}${declared}`),
    picture,
    element("ol", { class: "findings" }, items.map(({ item }) => item)),
  ];
}

function finding_item(here, audit, { words, detail, line }, picture) {
  const [text, crossings] = here.report.lines[line];
  const button = element("button", { type: "button", "aria-pressed": "false" }, "draw this case");
  const draw_it = () => {
    for (const other of picture.parentElement?.querySelectorAll(".draw") ?? []) other.setAttribute("aria-pressed", "false");
    button.setAttribute("aria-pressed", "true");
    picture.replaceChildren(element("h4", {}, `The case: ${words}`), drawing(text, crossings));
  };
  button.className = "draw";
  button.addEventListener("click", draw_it);
  const item = element(
    "li", {},
    element("strong", {}, words), element("p", {}, detail, " ", button),
    copied("case", text), copied("explain", explain_command(here.report, audit.subject.name, text)));
  return { item, draw: draw_it };
}

function explain_command(report, subject, line) {
  const quoted = (word) => (/^[\w./:+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
  const declared = Object.entries(report.convention).filter(([, stance]) => stance !== "either");
  const convention = declared.length ? ` --convention ${declared.map((pair) => pair.join("=")).join(",")}` : "";
  const brought = report.subjects.find(({ name }) => name === subject)?.brought_by;
  return `rayaudit explain --subject ${quoted(subject)}${brought ? ` ${brought}` : ""}${convention} '${line}'`;
}

// Curves and histograms: several subjects, one shape, one family or all.

/** The audits of a subject that the choices name. */
const chosen_audits = (here, subject) => here.audits.filter((audit) =>
  audit.subject.name === subject && audit.shape === here.shape.value &&
  (here.family.value === "all families" || audit.family === here.family.value));

function chart_controls(here, ...ids) {
  const families = () => ["all families", ...unique(here.audits.filter(({ shape }) => shape === here.shape.value).map(({ family }) => family))].map((id) => [id, id]);
  const family = select("Family", here.family, families);
  here.shape.watch(() => {
    if (!families().some(([id]) => id === here.family.value)) here.family.set("all families");
    family.fill();
    redraw(...ids);
  });
  here.family.watch(() => redraw(...ids));
  here.subjects.watch(() => redraw(...ids));
  return controls(
    select("Shape", here.shape, here.report.shapes.map((name) => [name, name])), family,
    boxes("Subjects", here.subjects, here.report.subjects.map(({ name }) => name)));
}

/** Sums of [key, ...figures] by key. */
function summed(lists) {
  const sums = new Map();
  for (const [key, ...figures] of lists) {
    const sum = sums.get(key) ?? figures.map(() => 0);
    sums.set(key, sum.map((x, i) => x + figures[i]));
  }
  return [...sums].sort(([a], [b]) => a - b);
}

/** [exponent, cases, wrong] of an audit, in steps of two octaves. */
const margins_of = ({ curve }) => range(0, curve.length / 3 - 1).map((i) => [2 * Math.floor(curve[3 * i] / 2), curve[3 * i + 1], curve[3 * i + 2]]);

const few_margins = 8;

function margin_section(here) {
  const id = "wrong-by-margin";
  const specify = () => {
    const points = here.subjects.value.flatMap((subject) =>
      summed(chosen_audits(here, subject).flatMap(margins_of))
        .filter(([, [cases]]) => cases >= few_margins)
        .map(([exponent, [cases, wrong]]) => ({ subject, margin: 2 ** (exponent + 1), share: wrong / cases, told: `${grouped(wrong)} of ${grouped(cases)} (${percent(wrong, cases)} %)` })));
    if (!points.length) return "No margin was measured here.";
    const axis = with_zero(points.map(({ share }) => 100 * share), "wrong, per cent", "none");
    for (const point of points) point.y = axis.place(100 * point.share);
    return lines_by(points, here, { field: "margin", title: "margin of the case, in u (how far its numbers must move for another truth)", scale: { type: "log", nice: false }, axis: log_axis(points.map(({ margin }) => margin)) }, axis, ["margin, u", "wrong"]);
  };
  return section(
    "How often wrong, at which margin",
    "A case of margin 1 u turns by rounding its numbers once; a good line falls to none within a few u, and one that stays up on the right is a defect.",
    chart_controls(here, id),
    chart(id, `Share of wrong answers against the margin of the case, in steps of two octaves; steps of fewer than ${few_margins} cases are left out.`, specify));
}

/** Octaves beyond these are told together, so that the others can be seen. */
const least_octave = -7, most_octave = 40;

/** [exponent, hits] of an audit. */
const octaves_of = ({ ulps }) => ulps.slice(1).map((count, i) => [Math.min(most_octave, Math.max(least_octave, ulps[0] + i)), count]);

/** The share of the hits of a subject in every octave, from the least to the most that has any. */
function shares_by_octave(subject, audits) {
  const octaves = new Map(summed(audits.flatMap(octaves_of)));
  const all = [...octaves.values()].reduce((sum, [count]) => sum + count, 0);
  return all === 0 ? [] : range(least_octave, Math.max(...octaves.keys()) + 1).map((exponent) => {
    const [count] = octaves.get(exponent) ?? [0];
    return { subject, error: 2 ** exponent, share: (100 * count) / all, told: `${grouped(count)} of ${grouped(all)} hits (${percent(count, all)} %)` };
  });
}

function error_section(here) {
  const id = "errors";
  const specify = () => {
    const points = here.subjects.value.flatMap((subject) => shares_by_octave(subject, chosen_audits(here, subject)));
    if (!points.length) return "No hit was at the right root here.";
    const axis = with_zero(points.map(({ share }) => share), "hits, per cent", "none");
    for (const point of points) point.y = axis.place(point.share);
    return lines_by(points, here, { field: "error", title: "error of t, in ulps of the subject's own format", scale: { type: "log", nice: false }, axis: log_axis(points.map(({ error }) => error)) }, axis, ["ulps, from", "hits with that error"], { interpolate: "step-after", point: false, strokeWidth: 1.8 });
  };
  return section(
    "How large the errors are",
    "Further to the left is better: below half an ulp t is rounded correctly. The tail on the right is what a maximum is made of.",
    chart_controls(here, id),
    chart(id, "Errors of t of hits at the right root, in octaves of ulps; the first step holds all that are smaller, the last all that are larger.", specify));
}

/** Lines of points by subject, over x; words are those of x and of what is drawn. */
function lines_by(points, here, x, axis, words, mark = {}) {
  const names = here.subjects.value.filter((name) => points.some(({ subject }) => subject === name));
  return {
    figures: () => lines_in_figures(points, names, x.field, words),
    layer: [
      axis.band,
      {
        data: { values: points },
        mark: { type: "line", strokeWidth: 2, point: { size: 36, filled: true, strokeDash: [1, 0] }, ...mark },
        encoding: {
          x: { type: "quantitative", ...x },
          y: axis.y,
          ...series(names, here.report.subjects),
          tooltip: [{ field: "subject", title: "subject" }, { field: x.field, title: words[0], format: ".3~g" }, { field: "told", title: words[1] }],
        },
      },
    ],
  };
}

// Every finding.

const first_rows = 25;

function findings_section(here) {
  const { report } = here;
  const show_cell = (finding) => {
    here.cell.set(here.of(report.subjects[finding.subject].name, report.shapes[finding.shape], report.families[finding.family].id));
    document.getElementById("cell").scrollIntoView({ block: "start" });
  };
  const families = (finding) => finding.families.slice(0, 3).map(([family, wrong, cases]) =>
    `${percent(wrong, cases)}% of ${report.families[family].id}`).join(", ") +
    (finding.families.length > 3 ? `, less of ${finding.families.length - 3} more` : "");
  const rows = report.findings.map((finding, i) => ({ ...finding, rank: i + 1 }));
  const columns = [
    ["", ({ rank }) => String(rank), true],
    ["verdict", (finding) => element("span", {}, element("strong", {}, `${spaced(report.verdicts[finding.verdict])} by ${finding.routine}`),
      ` ${report.verdict_words[finding.verdict]}${report.claim_words[finding.claim]}`)],
    ["shape", ({ shape }) => report.shapes[shape]],
    ["in", ({ numbers }) => numbers.map(spaced).join(", ")],
    ["most afflicted", families],
    ["wrong", ({ wrong }) => grouped(wrong), true],
    ["margin, u", ({ margin }) => magnitude(margin), true],
    ["main cause", ({ cause }) => cause],
    ["case", (finding) => element("button", { type: "button", onclick: () => show_cell(finding) }, "show")],
  ];
  return section(
    "All findings",
    "Worst first, by how far from any other truth they occur: what a routine does, on which shape, how much of which family, and why, by experiment.",
    rows.length ? table(`The first ${Math.min(rows.length, first_rows)} of ${rows.length} findings`, columns, rows.slice(0, first_rows)) : element("p", {}, "None."),
    rows.length > first_rows
      ? element("details", {}, element("summary", {}, `The other ${rows.length - first_rows}`), table("The other findings", columns, rows.slice(first_rows)))
      : null);
}
