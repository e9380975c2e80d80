// Charts by Vega-Lite, drawn when they come into sight, and the others when nothing else is to do.

const dark = matchMedia("(prefers-color-scheme: dark)");
const narrow = matchMedia("(max-width: 540px)");
const charts = new Map();
/** The views of the charts by id, for scripts: await rayaudit.draw(id), then view.toSVG(). */
window.rayaudit = { views: {}, draw };

// After Okabe and Ito, "Color Universal Design", 2008, without yellow, which fades on white; lighter
// on a dark page.
const hues_on_light = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f", "#8c510a", "#332288", "#000000"];
const hues_on_dark = ["#4aa8e8", "#ff8a4c", "#2fcf9f", "#e3a0c4", "#f0b840", "#a6dcfa", "#a8a8a8", "#c98a62", "#a79be0", "#ffffff"];
const hues = () => (dark.matches ? hues_on_dark : hues_on_light);
const dashes = { float: [1, 0], double: [7, 3], long_double: [2, 3], double_double: [8, 3, 2, 3], float128: [1, 5] };
const ink = () => (dark.matches ? "#e8e8e8" : "#1b1b1b");
const faint = () => (dark.matches ? "#8b8b8b" : "#767676");

function theme() {
  const line = dark.matches ? "#3a3a3a" : "#dddddd";
  const words = { labelColor: ink(), titleColor: ink(), labelFont: "system-ui, sans-serif", titleFont: "system-ui, sans-serif", labelFontSize: 12, titleFontSize: 12, titleFontWeight: 500 };
  return {
    background: "transparent",
    font: "system-ui, sans-serif",
    view: { stroke: line },
    axis: { ...words, gridColor: line, domainColor: faint(), tickColor: faint(), labelOverlap: true },
    legend: { ...words, orient: "bottom", symbolStrokeWidth: 2 },
    text: { color: ink(), font: "system-ui, sans-serif" },
  };
}

/**
 * A figure that draws what specify() tells: a specification without width and height, which may have
 * figures(), a table of the same; or words where there is nothing to draw. The caption is text, or a
 * function that gives it anew.
 */
function chart(id, caption, specify) {
  const place = element("div", { id, class: "chart" });
  const words = element("figcaption", {}), rows = element("div", {});
  const details = element("details", { class: "in-figures", hidden: true, ontoggle: () => tell_figures(drawn) }, element("summary", {}, "the same in figures"), rows);
  const drawn = { place, caption, words, details, rows, specify, stale: true, drawing: Promise.resolve(), embedded: null };
  charts.set(id, drawn);
  sight.observe(place);
  when_idle(() => draw(id));
  return element("figure", {}, words, place, details);
}

/** Fills in the figures of a chart where they are open. */
function tell_figures({ details, rows, figures }) {
  details.hidden = !figures;
  rows.replaceChildren(...(details.open && figures ? [figures()] : []));
}

/** What lines show: a row for each x, a column for each line. */
function lines_in_figures(points, names, field, [x_words, y_words]) {
  const told = new Map(points.map((point) => [`${point[field]} ${point.subject}`, point.told]));
  const columns = names.map((name) => [name, (x) => told.get(`${x} ${name}`) ?? "–", true]);
  return table(y_words, [[x_words, magnitude, true], ...columns], unique(points.map((point) => point[field])).sort((a, b) => a - b));
}

const when_idle = (act) =>
  window.requestIdleCallback ? requestIdleCallback(act, { timeout: 4000 }) : setTimeout(act, 300);
const sight = new IntersectionObserver((seen) => {
  for (const each of seen) if (each.isIntersecting) draw(each.target.id);
});

/** Draws a chart where it is stale; a promise of its view. */
function draw(id) {
  const drawn = charts.get(id);
  drawn.drawing = drawn.drawing.then(() => drawn.stale && drawn.place.isConnected && embed(id, drawn));
  return drawn.drawing.then(() => window.rayaudit.views[id]);
}

async function embed(id, drawn) {
  drawn.stale = false;
  const spec = drawn.specify();
  const { figures, ...chart } = typeof spec === "string" ? {} : spec;
  drawn.figures = figures;
  tell_figures(drawn);
  drawn.words.textContent = typeof drawn.caption === "function" ? drawn.caption() : drawn.caption;
  drawn.embedded?.finalize();
  delete window.rayaudit.views[id];
  if (typeof spec === "string") {
    drawn.place.replaceChildren(element("p", { class: "nothing" }, spec));
    drawn.embedded = null;
    return;
  }
  drawn.embedded = await vegaEmbed(
    drawn.place,
    { width: "container", height: narrow.matches ? 280 : 360, autosize: { type: "fit", contains: "padding" }, ...chart },
    {
      mode: "vega-lite",
      renderer: "svg",
      ast: true,
      actions: { export: true, source: false, editor: false, compiled: false },
      downloadFileName: id,
      config: theme(),
    });
  window.rayaudit.views[id] = drawn.embedded.view;
}

/** Draws charts anew: what they show has changed. */
function redraw(...ids) {
  for (const id of ids) {
    charts.get(id).stale = true;
    draw(id);
  }
}
for (const look of [dark, narrow]) look.addEventListener("change", () => redraw(...charts.keys()));

const power_label = "datum.value <= 0 ? '' : datum.value >= 1e4 || datum.value < 1e-3 ? replace(format(datum.value, '.0e'), '+', '') : format(datum.value, '~g')";

/** Whole powers of ten between two, at most so many; where there are few, 2 and 5 times them too. */
function ticks_between(least, most, count = 9) {
  const from = Math.floor(Math.log10(least) + 1e-9), to = Math.ceil(Math.log10(most) - 1e-9);
  const step = Math.max(1, Math.ceil((to - from) / count));
  const powers = range(0, Math.floor((to - from) / step)).map((i) => 10 ** (from + i * step));
  return to - from > 3 ? powers : powers.flatMap((power) => [power, 2 * power, 5 * power]);
}

/** An axis of logarithms over values. */
const log_axis = (values) => ({ values: ticks_between(Math.min(...values), Math.max(...values)), labelExpr: power_label });

/** Subjects as series: the hue is that of the routine on all of a page, the dashes those of the number. */
function series(names, subjects) {
  const routine = (name) => (name.includes("/") ? name.slice(0, name.lastIndexOf("/")) : name);
  const routines = unique(subjects.map(({ name }) => routine(name)));
  const formats = new Map(subjects.map(({ name, format }) => [name, format]));
  const columns = Math.max(1, Math.floor((document.documentElement.clientWidth - 60) / 190));
  const color = {
    field: "subject", type: "nominal", title: null, sort: null,
    scale: { domain: names, range: names.map((name) => hues()[routines.indexOf(routine(name)) % hues().length]) },
    legend: { columns: Math.min(columns, 4), labelLimit: 170, symbolType: "stroke" },
  };
  const strokeDash = {
    field: "subject", type: "nominal", sort: null,
    scale: { domain: names, range: names.map((name) => dashes[formats.get(name)] ?? [1, 0]) },
    legend: { columns: Math.min(columns, 4), labelLimit: 170 },
  };
  return { color, strokeDash };
}

/**
 * An axis of logarithms with a band for 0 below its least positive value, and one above for infinity
 * where there is any: the scale, a place for each value, and the layer of the bands.
 */
function with_zero(values, title, zero) {
  const shown = values.filter(positive);
  // What is beyond 1e290 and 1e-290 is placed there, so that the bands are numbers too.
  const power = (x, round) => Math.min(290, Math.max(-290, round(Math.log10(x))));
  const least = power(shown.length ? Math.min(...shown) : 1, (x) => Math.floor(x + 1e-9));
  const most = Math.max(least + 1, power(shown.length ? Math.max(...shown) : 1, (x) => Math.ceil(x - 1e-9)));
  const step = Math.min(12, Math.max(1, 0.08 * (most - least)));
  const floor = 10 ** (least - step), lowest = 10 ** least, highest = 10 ** most, ceiling = 10 ** (most + step), edge = 10 ** (0.35 * step);
  const has_infinite = values.includes(Infinity);
  const domain = [floor / edge, has_infinite ? ceiling * edge : highest * 10 ** (0.02 * (most - least))];
  const ticks = [floor, ...ticks_between(lowest, highest, 8), ...(has_infinite ? [ceiling] : [])];
  const bands = [floor, ...(has_infinite ? [ceiling] : [])].map((at) => ({ low: at / edge, high: at * edge }));
  const place = (value) => {
    if (positive(value)) return Math.min(highest, Math.max(lowest, value));
    return value === 0 ? floor : value === Infinity ? ceiling : null;
  };
  return {
    domain, place,
    y: {
      field: "y", type: "quantitative", title,
      scale: { type: "log", domain, nice: false },
      axis: { values: ticks, labelExpr: `datum.value <= ${floor * 1.001} ? '${zero}' : datum.value >= ${ceiling * 0.999} ? 'inf' : ${power_label}` },
    },
    band: {
      data: { values: bands },
      mark: { type: "rect", color: faint(), opacity: 0.15, tooltip: null },
      encoding: { y: { field: "low", type: "quantitative" }, y2: { field: "high" } },
    },
  };
}
