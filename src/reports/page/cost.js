// The page of what accuracy costs: the front of time and accuracy, the price of each step on it.

const cost_measures = {
  wrong: "wrong answers per million",
  error: "worst error of its own, in units of float",
};

function cost_page(report, show) {
  const shapes = unique(report.cells.map(({ shape }) => shape));
  const here = { report, shape: choice(first_shape(shapes)), cases: choice(null), measure: choice("wrong") };
  const names = () => unique(report.cells.filter(({ shape }) => shape === here.shape.value).map(cell_name));
  here.cases.set(names()[0]);
  const cases = select("Cases", here.cases, () => names().map((name) => [name, name]));
  const below = element("div", {});
  const update = () => {
    if (!names().includes(here.cases.value)) here.cases.set(names()[0]);
    cases.fill();
    below.replaceChildren(...below_front(report, chosen_cell(here)));
    redraw("front");
  };
  const front = section(
    "Accuracy against time",
    "Further down is more accurate, further left is faster.",
    controls(select("Shape", here.shape, shapes.map((name) => [name, name])), cases,
      select("Height", here.measure, Object.entries(cost_measures))),
    chart("front", () => front_caption(here), () => front_chart(here)),
    below);
  show(
    heading(report, "What it takes in time to be right: every way to answer, measured on the same cases, on this machine, in one run.", [
      ["command", report.command ? element("code", {}, report.command) : null],
      ["cases", `${grouped(report.cases)} judged, ${grouped(report.timed_cases)} timed, fewer of dear ways, in ${report.rounds} rounds`],
      ["nanoseconds", `up to ${magnitude(report.idle_ns[2])} ns of each are spent on reading a case and writing an answer`],
    ]),
    front, price_section(report, shapes), absent_section(report));
  for (const chosen of [here.shape, here.cases, here.measure]) chosen.watch(update);
  update();
}

const cell_name = ({ group, family }) =>
  group === "family" ? family : { all: "all families", easy: "easy cases", hard: "hard cases" }[group];

const chosen_cell = ({ report, shape, cases }) =>
  report.cells.find((cell) => cell.shape === shape.value && cell_name(cell) === cases.value);

const spread = ([low, median, high]) => `${magnitude(median)} (${magnitude(low)} to ${magnitude(high)})`;
const counted = (x) => (x >= 100 ? grouped(Math.round(x)) : magnitude(x));
const value_of = (way, measure) => number(measure === "wrong" ? way.wrong_per_million : way.error);

/** The ways on the front of a cell, the fastest first. */
const front_of = ({ ways }) => ways.filter(({ front }) => front).sort((a, b) => a.ns[1] - b.ns[1]).map(({ subject }) => subject);

function front_caption(here) {
  const unmeasured = chosen_cell(here).ways.filter((way) => value_of(way, here.measure.value) == null).length;
  return "One point a way to answer; the bar is the spread of its time. " +
    `Coloured and ${narrow.matches ? "numbered, as in the table below" : "named"}: the front, by wrong answers first and then by error. ` +
    "Grey: a way that is no less accurate is clearly faster, or their times or their accuracies cannot be told apart." +
    (unmeasured ? ` Left out, for no error of their own was measured: ${unmeasured}.` : "");
}

function front_chart(here) {
  const measure = here.measure.value, cell = chosen_cell(here);
  const ways = cell.ways.filter((way) => value_of(way, measure) != null);
  if (!ways.length) return "Nothing was measured here.";
  const most = Math.max(...ways.map(({ cases }) => cases));
  const axis = with_zero(ways.map((way) => value_of(way, measure)), cost_measures[measure], measure === "wrong" ? `0 of ${grouped(most)}` : "0");
  const along = front_of(cell);
  const points = ways.map((way) => ({
    subject: way.subject, format: spaced(way.format), number: along.indexOf(way.subject) + 1,
    low: way.ns[0], x: way.ns[1], high: way.ns[2], y: axis.place(value_of(way, measure)),
    time: spread(way.ns), wrong: `${grouped(way.wrong)} of ${grouped(way.cases)}`, error: magnitude(way.error),
  })).sort((a, b) => a.number - b.number);
  const ends = points.flatMap(({ low, high }) => [low, high]);
  const domain = [Math.min(...ends) / 1.2, Math.max(...ends) * 1.2];
  const x = { field: "x", type: "quantitative", title: "nanoseconds a case, median", scale: { type: "log", nice: false, domain }, axis: log_axis(domain) };
  const y = axis.y;
  const tooltip = [["subject"], ["format"], ["time", "ns (spread)"], ["wrong"], ["error", cost_measures.error]]
    .map(([field, title = field]) => ({ field, title }));
  const front = points.filter(({ number }) => number), others = points.filter(({ number }) => !number);
  const hue = hues()[1];
  const labels = spaced_labels(front.map((point) => ({ ...point, words: narrow.matches ? String(point.number) : point.subject })), domain, axis.domain);
  const layer = (values, mark, encoding) => (values.length ? [{ data: { values }, mark, encoding }] : []);
  const written = (align) => layer(labels.filter((label) => label.align === align),
    { type: "text", align, fontSize: 12, fontWeight: 600, color: ink() }, { x, y, text: { field: "words" } });
  return {
    layer: [
      axis.band,
      ...layer(points, { type: "rule", strokeWidth: 1.5, opacity: 0.6, color: faint() }, { x: { ...x, field: "low" }, x2: { field: "high" }, y }),
      ...layer(others, { type: "point", filled: true, size: 45, color: faint(), opacity: 0.7 }, { x, y, tooltip }),
      // By error alone the front need not fall.
      ...(measure === "wrong" ? layer(front, { type: "line", interpolate: "step-after", strokeWidth: 2, color: hue }, { x, y }) : []),
      ...layer(front, { type: "point", filled: true, size: 90, color: hue, opacity: 1 }, { x, y, tooltip }),
      ...written("left"), ...written("right"),
    ],
  };
}

/** Places for the words of points, near them, within the chart and beside those that are there already. */
function spaced_labels(points, x_domain, y_domain) {
  const wide = Math.max(200, document.getElementById("front").clientWidth - 110), high = narrow.matches ? 200 : 280, letter = 7, line = 15;
  const across = (x) => (wide * Math.log(x / x_domain[0])) / Math.log(x_domain[1] / x_domain[0]);
  const up = (y) => (high * Math.log(y / y_domain[0])) / Math.log(y_domain[1] / y_domain[0]);
  const value = ([least, most], share) => least * (most / least) ** share;
  const taken = [];
  return points.map(({ words, x, y }) => {
    const length = words.length * letter;
    const align = across(x) + length < wide ? "left" : "right";
    const at = align === "left" ? across(x) : Math.max(length, across(x));
    const from = align === "left" ? at : at - length;
    const is_free = (height) => height < high && height > 0 &&
      taken.every((box) => Math.abs(box.height - height) >= line || box.to < from || from + length < box.from);
    const heights = range(0, 12).flatMap((i) => [up(y) + 13 + i * 4, up(y) - 13 - i * 4]);
    const height = heights.find(is_free) ?? heights[0];
    taken.push({ height, from, to: from + length });
    return { words, align, x: value(x_domain, at / wide), y: value(y_domain, height / high) };
  });
}

/** What stands below the front of a cell: its steps in sentences, and all of its ways. */
function below_front(report, cell) {
  const fastest = Math.min(...cell.ways.map(({ ns }) => ns[1]));
  const kinds = unique(cell.ways.flatMap(({ per_million }) => Object.keys(per_million ?? {})));
  const along = front_of(cell);
  const columns = [
    ["way", ({ subject, front }) => (front ? element("strong", {}, subject) : subject)],
    ["front", ({ subject, front }) => (front ? String(along.indexOf(subject) + 1) : ""), true],
    ["ns a case (spread)", ({ ns }) => spread(ns), true],
    ["times the fastest", ({ ns }) => magnitude(ns[1] / fastest), true],
    ["wrong", ({ wrong, cases }) => `${grouped(wrong)} of ${grouped(cases)}`, true],
    ["per million", (way) => counted(way.wrong_per_million), true],
    ...kinds.map((kind) => [spaced(kind), (way) => counted(way.per_million?.[kind] ?? 0), true]),
    ["wrong up to, u", (way) => magnitude(way.wrong_margin), true],
    ["ulps, most", (way) => magnitude(way.max_ulp), true],
    ["forced, most", (way) => magnitude(way.max_forced), true],
    ["own, in units of float, most", (way) => magnitude(way.error), true],
  ];
  const steps = (cell.steps ?? []).map(({ text }) => element("li", {}, text));
  const ways = [...cell.ways].sort((a, b) => a.ns[1] - b.ns[1]);
  return [
    element("h3", {}, "What the next step of accuracy costs"),
    steps.length ? element("ol", { class: "steps" }, steps) : element("p", {}, "There is no step: one way alone is on the front, or spreads overlap."),
    element("h3", {}, "All ways"),
    table(`${cell.shape}, ${cell_name(cell)}: the fastest first; figures by kind are wrong answers per million`, columns, ways),
  ];
}

function price_section(report, shapes) {
  const prices = report.prices ?? [];
  if (!prices.length) return null;
  const columns = [
    ["way", ({ subject }) => subject],
    ["easy, ns", ({ easy }) => spread(easy), true],
    ["hard, ns", ({ hard }) => spread(hard), true],
    ["hard / easy", ({ times }) => spread(times), true],
  ];
  return section(
    "What hard cases cost",
    "The same way on easy and on hard cases: 1 is a price that does not depend on the case. Medians, with their spread.",
    shapes.map((shape) => {
      const rows = prices.filter((price) => price.shape === shape).sort((a, b) => b.times[1] - a.times[1]);
      return element("details", { open: shape === first_shape(shapes) }, element("summary", {}, shape), table(`${shape}: the most dependent first`, columns, rows));
    }));
}

const absent_section = ({ absent }) => absent?.length
  ? section("Not measured", "Ways that this build or this machine does not have, or that could not be measured here, and why.", element("ul", {}, absent.map(({ subjects, why }) => element("li", {}, `${subjects}: ${why}`))))
  : null;
