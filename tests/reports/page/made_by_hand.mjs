// Small reports of costs and ladders, made by hand.

const environment = { compiler: "a compiler", flags: "-O2", processor: "a processor", processors: 2, contraction: false, flush_to_zero: false, rounding: "to nearest" };
const all = { schema: 1, tool: { name: "rayaudit", version: "1.2.3" }, seed: 1, environment };

const way = (subject, format, median, wrong, error, front) => ({
  subject, format, ns: [median * 0.95, median, median * 1.1], timed: 1024, cases: 4096, wrong,
  wrong_per_million: (wrong / 4096) * 1e6,
  per_million: { false_hit: (wrong / 4096) * 1e6, false_miss: 0, wrong_root: 0, wrong_t: 0, not_finite: 0 },
  wrong_margin: wrong ? 12.5 : null, max_ulp: error, max_forced: error, error, front,
});

const cell = (group, family) => ({
  shape: "sphere", family, group,
  ways: [way("textbook/float", "float", 6, 31, 3e4, true), way("textbook/double", "double", 8, 2, "inf", true),
    way("handout/float", "float", 9, 900, 1e7, false), way("certified/float", "float", 14, 0, 0.5, true),
    way("cgal/exact", "double", 20000, 0, 0.5, false), way("silent/float", "float", 7, 40, null, false)],
  steps: [{ from: "textbook/float", to: "certified/float", times: [2.1, 2.3, 2.6], text: "from textbook/float to certified/float: 2.3 times the time, wrong 7,568 to 0 per million" }],
});

export const cost_report = () => ({
  ...all, report: "cost", cases: 4096, rounds: 15, timed_cases: 1024, apart: 0.1, idle_ns: [1.5, 1.75, 2.25],
  absent: [{ subjects: "*/float128", why: "this compiler has no such number" }],
  cells: [cell("all", null), cell("easy", null), cell("hard", null), cell("family", "grazing")],
  prices: [{ shape: "sphere", subject: "certified/float", easy: [13, 14, 15], hard: [20, 22, 25], times: [1.4, 1.6, 1.8] }],
});

const rung = (k, slope) => {
  const error = 2 ** (slope * k);
  return {
    k, cases: 1024, wrong: k > 5 && slope > 0 ? k * k : 0,
    ulp: { p50: 0.3, p99: error / 2, max: k > 7 ? "inf" : error }, forced: { p50: 0.2, p99: 0.9, max: error / 2 ** (k / 2) },
    own: { p50: 0.1, p99: 0.8, max: 0.75 + k },
    condition: { p50: 2 ** (k / 2) }, margin: { p10: 2 ** (6 - k), p50: 2 ** (8 - k) },
  };
};

const climb = (subject, format, slope, holds_to) => ({
  subject, format, shape: "sphere", held_to: "max_forced 64", least: 1, most: 8, holds_to,
  broken: holds_to === 8 ? null : { k: 6, limit: "max_forced", seen: 123, most: 64, case: "sphere 0 0 0 1 ray 0 0.5 -3 0 0 2 hit 0x1.1p+0" },
  slope: { ulp: slope, own: slope - 0.5, condition: 0.5 },
  rungs: Array.from({ length: 8 }, (_, i) => rung(i + 1, slope)),
});

/** Says yes, but not where: of all its errors none is measured. */
const bare_climb = () => {
  const bare = climb("bare/float", "float", 0, 8);
  const none = { p50: null, p99: null, max: null };
  return { ...bare, slope: { ulp: null, own: null, condition: null }, rungs: bare.rungs.map((rung) => ({ ...rung, ulp: none, forced: none, own: none, condition: { p50: null } })) };
};

export const climb_report = () => ({
  ...all, report: "ladder", cases: 1024,
  family: { id: "grazing", about: "passes near its rim", difficulty: "radius off by 2^-k of it" },
  climbs: [bare_climb(), climb("textbook/float", "float", 2, 5), climb("handout/float", "float", 1, null), climb("certified/double", "double", 0, 8)],
});
