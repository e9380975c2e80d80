// How the page spells figures: short, and never a 0 or a 100 % that is none.

const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ",");

/** "inf" where JSON has no infinity. */
const number = (x) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : x);

/** To three digits: 0.5, 117, 3.2e7; a dash where there is none. */
function magnitude(given) {
  const x = number(given);
  if (x == null || Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return x < 0 ? "-inf" : "inf";
  if (x === 0 || (Math.abs(x) >= 1e-3 && Math.abs(x) < 999.5)) return String(Number(x.toPrecision(3)));
  return x.toExponential(1).replace("e+", "e").replace(".0e", "e");
}

/** A share in per cent, without its sign. */
function percent(part, whole) {
  if (part === 0) return "0";
  if (part === whole) return "100";
  const share = (100 * part) / whole;
  if (share >= 99.95) return ">99.9";
  if (share < 0.01) return "<0.01";
  return share < 9.995 ? share.toFixed(2) : share.toFixed(1);
}

const spaced = (name) => name.replaceAll("_", " ");

const range = (least, most) => Array.from({ length: most - least + 1 }, (_, i) => least + i);
const unique = (list) => [...new Set(list)];

/** Is it a number that an axis of logarithms can show? */
const positive = (x) => typeof x === "number" && Number.isFinite(x) && x > 0;

const superscript = (n) => [...String(n)].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻").join("");
