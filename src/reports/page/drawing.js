// Two views of a case: ray, shape, crossings, and where the answer says they meet.

/** A C hex float, a decimal or inf. */
function read_number(word) {
  const hex = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)(?:p([+-]?\d+))?$/i.exec(word);
  if (!hex) return word.replace("inf", "Infinity") * 1;
  const [, sign, whole, fraction, exponent] = hex;
  const digits = [...whole + fraction].reduce((sum, digit) => sum * 16 + parseInt(digit, 16), 0);
  const scale = Number(exponent ?? 0) - 4 * fraction.length;
  const half = Math.trunc(scale / 2);  // 2^-1074 is below the range of 2^scale where digits are large
  return (sign === "-" ? -1 : 1) * digits * 2 ** half * 2 ** (scale - half);
}

const shape_parts = {
  sphere: ["centre", "radius"],
  disk: ["centre", "normal", "radius"],
  cylinder: ["base", "top", "radius"],
  cone: ["base", "apex", "radius"],
  capped_cylinder: ["base", "top", "radius"],
  capped_cone: ["base", "apex", "radius"],
};

/** The case and answer on a line, or null where it holds no shape that is known here. */
function read_case(line) {
  const words = line.split("#")[0].trim().split(/\s+/);
  const question = { shape: words.shift() };
  const take = (count) => words.splice(0, count).map(read_number);
  if (!(question.shape in shape_parts)) return null;
  for (const part of shape_parts[question.shape])
    question[part] = part === "radius" ? take(1)[0] : take(3);
  while (words.shift() !== "ray" && words.length > 0);  // before it, how far an open shape extends
  question.origin = take(3);
  question.direction = take(3);
  if (words[0] === "range") [, question.least, question.most] = words.splice(0, 3).map(read_number);
  const [answer, ...rest] = words;
  if (answer === "hit") question.answer = { t: read_number(rest[0]) };
  else if (answer === "at") question.answer = { point: rest.slice(0, 3).map(read_number) };
  return question;
}

const plus = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const times = (a, s) => a.map((x) => x * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** To length 1, also from lengths whose squares leave the range. */
function unit(a) {
  const most = Math.max(...a.map(Math.abs));
  if (!(most > 0 && most < Infinity)) return [0, 0, 0];
  const near = times(a, 1 / most);
  return times(near, 1 / Math.sqrt(dot(near, near)));
}
/** The part of a that is square to the unit vector d, to length 1; [0, 0, 0] where there is none. */
function square_to(d, a) {
  const u = unit(a);
  const rest = plus(u, d, -dot(u, d));
  return dot(rest, rest) > 1e-14 ? unit(rest) : [0, 0, 0];
}
const any_square_to = (d) => square_to(d, [0, 1, 2].map((i) => (Math.abs(d[i]) < 0.6 ? 1 : 0)));

/** The case in units of its shape and around its middle, and points of its outline. */
function scene(question) {
  const foot = question.centre ?? question.base;
  const tip = question.top ?? question.apex ?? foot;
  const axis = plus(tip, foot, -1);
  const extent = Math.max(question.radius, ...axis.map(Math.abs));
  const middle = plus(times(foot, 0.5), times(tip, 0.5));
  const local = (p) => times(plus(p, middle, -1), 1 / extent);
  const radius = question.radius / extent;
  const normal = unit(question.normal ?? axis);
  const e = any_square_to(normal), f = cross(normal, e);
  const ring = (centre) => range(0, 72).map((i) => {
    const angle = (i / 36) * Math.PI;
    return plus(plus(local(centre), e, radius * Math.cos(angle)), f, radius * Math.sin(angle));
  });
  const rings = question.shape === "sphere" ? [] : question.top ? [ring(foot), ring(tip)] : [ring(foot)];
  return {
    rings,
    hull: question.apex ? [...rings[0], local(tip)] : rings.flat(),
    radius,
    axis: question.normal ?? (question.shape === "sphere" ? plus(foot, question.origin, -1) : axis),
    origin: local(question.origin),
    direction: unit(question.direction),
    pace: Math.hypot(...times(question.direction, 1 / extent)),
    local,
  };
}

/** The convex hull of points in the plane (Andrew's monotone chain). */
function outline(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const chain = (list) => {
    const kept = [];
    for (const p of list) {
      while (kept.length > 1 && turn(kept.at(-2), kept.at(-1), p) <= 0) kept.pop();
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

const svg = (tag, attributes, ...children) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};

/** Where a line through o along d is within the square |x|, |y| <= half; null where nowhere. */
function clipped(o, d, half) {
  let from = -Infinity, to = Infinity;
  for (const i of [0, 1]) {
    if (Math.abs(d[i]) < 1e-12) {
      if (Math.abs(o[i]) > half) return null;
      continue;
    }
    const ends = [(-half - o[i]) / d[i], (half - o[i]) / d[i]].sort((a, b) => a - b);
    from = Math.max(from, ends[0]);
    to = Math.min(to, ends[1]);
  }
  return from < to ? [from, to] : null;
}

/** One view: across and up are unit vectors of the picture; marks are points with a class. */
function view(about, at, across, up, marks, half) {
  const flat = (p) => [dot(p, across), dot(p, up)];
  const size = 150, on_paper = ([x, y]) => [(x / half) * size, (-y / half) * size];
  const path = (points) => points.map((p) => on_paper(p).map((x) => x.toFixed(2)).join(",")).join(" ");
  const picture = svg("svg", { viewBox: `${-size - 6} ${-size - 6} ${2 * size + 12} ${2 * size + 12}`, role: "img", "aria-label": about, class: "view" });
  picture.append(svg("rect", { x: -size, y: -size, width: 2 * size, height: 2 * size, class: "frame" }));
  if (at.hull.length === 0) picture.append(svg("circle", { r: (at.radius / half) * size, class: "shape" }));
  else picture.append(svg("polygon", { points: path(outline(at.hull.map(flat))), class: "shape" }));
  for (const ring of at.rings) picture.append(svg("polyline", { points: path(ring.map(flat)), class: "rim" }));

  const origin = flat(at.origin), direction = flat(at.direction);
  const seen = Math.hypot(...direction) > 1e-9 ? clipped(origin, direction, half) : null;
  if (seen) {
    const point = (s) => on_paper(plus(origin, direction, s));
    const part = (from, to, kind) => {
      if (!(from < to)) return;
      const [a, b] = [point(from), point(to)];
      picture.append(svg("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: kind }));
    };
    part(seen[0], Math.min(seen[1], 0), "before");
    part(Math.max(seen[0], 0), seen[1], "ray");
    if (seen[1] > 0) {
      const tip = point(seen[1]), angle = (Math.atan2(-direction[1], direction[0]) * 180) / Math.PI;
      picture.append(svg("path", { d: "M-9,-4L0,0L-9,4Z", class: "tip", transform: `translate(${tip}) rotate(${angle})` }));
    }
  }
  for (const { point, kind, words } of marks) {
    const [x, y] = on_paper(flat(point));
    if (!(Math.abs(x) <= size && Math.abs(y) <= size)) continue;
    const form = {
      origin: "M-3,-3H3V3H-3Z",
      hit: "M-5,0A5,5 0 1 1 5,0A5,5 0 1 1 -5,0Z",
      touch: "M-5,0A5,5 0 1 1 5,0A5,5 0 1 1 -5,0Z",
      other: "M-4,-4L4,4M-4,4L4,-4",
      answer: "M0,-8L8,0L0,8L-8,0Z",
    }[kind];
    picture.append(svg("path", { d: form, class: `mark ${kind}`, transform: `translate(${x},${y})` }, svg("title", {}, words)));
  }
  return picture;
}

const mark_words = {
  proper: "the proper hit",
  tangent: "a touch (tangent)", rim: "a touch (rim)", apex: "a touch (apex)",
  start: "a touch (start of the range)", end: "a touch (end of the range)", within: "a stretch within the surface",
  later: "a later crossing", behind: "a root before the range", past: "a root after the range",
  clipped: "a root off the shape", mirrored: "a root on the other nappe",
};
const other_roots = ["later", "behind", "past", "clipped", "mirrored"];

/** What is to be marked along the ray. */
function marks_of(question, at, crossings) {
  const along = (t) => plus(at.origin, at.direction, t * at.pace);
  const marks = [{ point: at.origin, kind: "origin", words: "the origin of the ray" }];
  for (const [kind, ...ends] of crossings) {
    const looks = kind === "proper" ? "hit" : other_roots.includes(kind) ? "other" : "touch";
    for (const each of ends.map(number))
      if (Number.isFinite(each)) marks.push({ point: along(each), kind: looks, words: `${mark_words[kind] ?? kind}, t = ${each}` });
  }
  const answer = question.answer;
  if (answer?.point) marks.push({ point: at.local(answer.point), kind: "answer", words: "the answer's point" });
  else if (Number.isFinite(answer?.t)) marks.push({ point: along(answer.t), kind: "answer", words: `the answer, t = ${answer.t}` });
  return marks.filter(({ point }) => point.every(Number.isFinite));
}

/** Two views of a case line with its crossings [kind, t, where a stretch ends]; words where it cannot be drawn. */
function drawing(line, crossings) {
  const question = read_case(line);
  const at = question && scene(question);
  const is_plain = at && [...at.origin, ...at.direction, at.pace, at.radius, ...at.hull.flat()].every(Number.isFinite) && dot(at.direction, at.direction) > 0.5 && at.radius > 0;
  if (!is_plain) return element("p", { class: "nothing" }, "No drawing: the case is invalid, or no picture reaches so far.");

  let up = square_to(at.direction, at.axis);
  if (dot(up, up) < 0.5) up = any_square_to(at.direction);
  const sideways = cross(at.direction, up);
  const marks = marks_of(question, at, crossings);
  const reach = Math.max(at.radius, ...at.hull.map((p) => Math.max(...p.map(Math.abs))));
  const near = marks.map(({ point }) => Math.hypot(...point)).filter((far) => far < 4 * reach);
  const half = 1.15 * Math.max(reach, ...near);
  const away = Math.hypot(...at.origin);
  const seen = marks.filter(({ kind }) => kind !== "origin");
  return element(
    "div", { class: "drawing" },
    element("figure", {}, view("The case from the side", at, at.direction, up, marks, half),
      element("figcaption", {}, "from the side: the ray runs to the right")),
    element("figure", {}, view("The case as the ray sees it", at, sideways, up, marks, half),
      element("figcaption", {}, "as the ray sees it: all of the ray is one point")),
    element("p", { class: "about" },
      "Filled circle: the proper hit; open circle: a touch; cross: a root that is no hit; diamond: the answer; square: the origin. ",
      away > 4 * reach ? `The origin is ${magnitude(away / reach)} times the size of the shape away. ` : null,
      "What is nearer than a line is wide, only the figures tell."),
    element("ul", { class: "marks" }, seen.map(({ words }) => element("li", {}, words))));
}
