// The page of a ladder: one family, rising difficulty; up to where each subject holds.

const ladder_measures = {
  "ulp max": "largest error, ulps", "ulp p99": "99 % of errors, ulps", "ulp p50": "half of errors, ulps",
  "own max": "largest error of its own", "own p99": "99 % of errors of its own",
  "forced max": "largest error, times the forced", "forced p99": "99 % of errors, times the forced",
};
const ladder_charts = ["ladder-errors", "ladder-wrong", "ladder-margins"];

function ladder_page(report, show) {
  const { climbs, family } = report;
  const shapes = unique(climbs.map(({ shape }) => shape));
  const subjects = unique(climbs.map(({ subject }) => subject)).map((name) => climbs.find(({ subject }) => subject === name))
    .map(({ subject, format }) => ({ name: subject, format }));
  const here = { report: { ...report, subjects }, shape: choice(first_shape(shapes)), measure: choice("ulp max"), subjects: choice(first_subjects(subjects)) };
  const shown = () => climbs.filter(({ shape, subject }) => shape === here.shape.value && here.subjects.value.includes(subject));
  const promises = unique(climbs.map(({ held_to }) => held_to));
  const rows = element("div", {});
  const update_rows = () => rows.replaceChildren(climb_table(climbs.filter(({ shape }) => shape === here.shape.value), here.shape.value, promises.length > 1));
  const shape_control = () => select("Shape", here.shape, shapes.map((name) => [name, name]));
  show(
    heading(report, `Family ${family.id}: ${family.about}. The cases grow harder step by step, by their difficulty k: ${family.difficulty}.`, [
      ["command", report.command ? element("code", {}, report.command) : null],
      ["cases", `${grouped(report.cases)} for each subject, shape and k`],
      ["held to", promises.length > 1 ? null : promises[0]],
    ]),
    section(
      "Errors against difficulty",
      "A stable routine is flat, or rises no faster than the grey dashes: what the cases themselves force.",
      controls(shape_control(), select("Height", here.measure, Object.entries(ladder_measures)), boxes("Subjects", here.subjects, subjects.map(({ name }) => name))),
      chart("ladder-errors", "Error of t of hits at the right root, also where t is wrong. Dashed grey: what rounding the numbers of a case once would do to t (the forced error), in half of the hits. Of its own: in units of the larger of an ulp and the forced error.", () => error_lines(here, shown()))),
    section(
      "Wrong answers against difficulty",
      "A line that leaves the bottom is a subject that has begun to be wrong.",
      controls(shape_control()),
      chart("ladder-wrong", "Wrong answers, in per cent of the cases of each k.", () => wrong_lines(here, shown())),
      chart("ladder-margins", "Beside it, how near the cases are to another truth, in u of their format: half of them (dashed) and a tenth (dotted) lie below the line. Near 1, being wrong may be excused.", () => margin_lines(shown()))),
    section("Who holds up to where", "A slope of 0 is flat, 1 doubles with each k; one like that of the condition follows what the cases force.", controls(shape_control()), rows));
  here.shape.watch(() => (redraw(...ladder_charts), update_rows()));
  here.subjects.watch(() => redraw(...ladder_charts));
  here.measure.watch(() => redraw("ladder-errors"));
  update_rows();
}

const k_axis = { field: "k", title: "difficulty k", axis: { tickMinStep: 1, format: "d" }, scale: { nice: false } };

/** Points by format and k of something that the cases have and not the subjects. */
function of_cases(climbs, tell, what) {
  const known = climbs.flatMap(({ format, rungs }) => rungs.map((rung) => ({ k: rung.k, format, value: number(tell(rung)) }))).filter(({ value }) => value != null);
  const first = new Map(known.reverse().map((each) => [`${each.format} ${each.k}`, each]));
  return [...first.values()].map((each) => ({ ...each, subject: `${what}, ${spaced(each.format)}`, told: magnitude(each.value) }));
}

/** A layer of grey lines of what the cases have, where there is any. */
function grey_lines(points, axis, strokeDash) {
  const values = points.map((point) => ({ ...point, y: axis.place(point.value) }));
  return values.length === 0 ? [] : [{
    data: { values },
    mark: { type: "line", color: faint(), strokeDash, strokeWidth: 2.5 },
    encoding: {
      x: { ...k_axis, type: "quantitative" }, y: axis.y, detail: { field: "format" },
      tooltip: [{ field: "subject", title: "cases" }, { field: "k", type: "quantitative" }, { field: "told", title: "value" }],
    },
  }];
}

const lines_of = (points) => unique(points.map(({ subject }) => subject));

function error_lines(here, climbs) {
  const [kind, which] = here.measure.value.split(" ");
  const words = ladder_measures[here.measure.value];
  const points = climbs.flatMap(({ subject, rungs }) => rungs.map((rung) => ({ subject, k: rung.k, value: number(rung[kind][which]) }))).filter(({ value }) => value != null);
  if (!points.length) return "No hit was at the right root here.";
  const forced = kind === "ulp" ? of_cases(climbs, ({ condition }) => condition.p50, "the case forces") : [];
  const axis = with_zero([...[...points, ...forced].map(({ value }) => value), ...(kind === "ulp" ? [] : [1])], words, "0");
  for (const point of points) Object.assign(point, { y: axis.place(point.value), told: magnitude(point.value) });
  const { layer: [band, ...lines] } = lines_by(points, here, k_axis, axis, ["k", words]);
  const beside = kind === "ulp"
    ? grey_lines(forced, axis, [6, 4])
    : [{ data: { values: [{ one: 1 }] }, mark: { type: "rule", color: faint(), strokeDash: [6, 4], strokeWidth: 2.5 }, encoding: { y: { field: "one", type: "quantitative" } } }];
  const all = [...points, ...forced];
  return { figures: () => lines_in_figures(all, lines_of(all), "k", ["k", words]), layer: [band, ...beside, ...lines] };
}

function wrong_lines(here, climbs) {
  const points = climbs.flatMap(({ subject, rungs }) => rungs.map(({ k, wrong, cases }) => ({ subject, k, value: (100 * wrong) / cases, told: `${grouped(wrong)} of ${grouped(cases)} (${percent(wrong, cases)} %)` })));
  if (!points.length) return "No subject is chosen.";
  const axis = with_zero(points.map(({ value }) => value), "wrong, per cent", "none");
  for (const point of points) point.y = axis.place(point.value);
  return lines_by(points, here, k_axis, axis, ["k", "wrong"]);
}

function margin_lines(climbs) {
  const half = of_cases(climbs, ({ margin }) => margin.p50, "half below"), tenth = of_cases(climbs, ({ margin }) => margin.p10, "a tenth below");
  const all = [...half, ...tenth];
  if (!all.some(({ value }) => positive(value))) return "No margin was measured here.";
  const axis = with_zero(all.map(({ value }) => value), "margin, u", "0");
  return {
    figures: () => lines_in_figures(all, lines_of(all), "k", ["k", "margin, u"]),
    layer: [axis.band, ...grey_lines(half, axis, [7, 3]), ...grey_lines(tenth, axis, [2, 3])],
  };
}

function climb_table(climbs, shape, with_promise) {
  const holds = ({ holds_to, most }) => (holds_to == null ? "nowhere" : holds_to >= most ? `all the way, k = ${most}` : `k = ${holds_to}`);
  const broken = ({ broken: at }) => at
    ? element("div", {}, `k = ${at.k}: ${at.limit} ${magnitude(at.seen)}, at most ${magnitude(at.most)}`, at.case ? copied("case", at.case) : null)
    : "–";
  const columns = [
    ["subject", ({ subject }) => subject],
    ...(with_promise ? [["held to", ({ held_to }) => held_to]] : []),
    ["holds up to", holds],
    ["slope, ulps", ({ slope }) => magnitude(slope.ulp), true],
    ["slope, own", ({ slope }) => magnitude(slope.own), true],
    ["slope of the condition", ({ slope }) => magnitude(slope.condition), true],
    ["first broken", broken],
  ];
  const furthest = ({ holds_to }) => holds_to ?? -Infinity;
  return table(`${shape}: who holds furthest comes first`, columns, [...climbs].sort((a, b) => furthest(b) - furthest(a) || 0));
}
