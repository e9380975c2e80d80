// Spheres by the textbook: rayaudit audit --program 'node mine.mjs' --shape sphere
import { readFileSync } from 'node:fs';

// A hex float as C writes it: 0x1.8p+1 is 3.
const number = (word) => {
  const [, sign, digits, more = '', power] = /^(-?)0x(\w)\.?(\w*?)p(.+)$/.exec(word) ?? [];
  if (!digits) return Number(word.replace('inf', 'Infinity'));
  return Number(`${sign}1`) * (Number(`0x${digits}${more}`) / 16 ** more.length) * 2 ** power;
};
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const firstHit = (centre, radius, origin, direction, tMin, tMax) => {
  const v = origin.map((o, i) => o - centre[i]);
  const a = dot(direction, direction), b = dot(v, direction), c = dot(v, v) - radius * radius;
  const root = Math.sqrt(b * b - a * c);  // NaN where they do not meet
  return [(-b - root) / a, (-b + root) / a].find((t) => tMin < t && t < tMax);
};

// sphere CX CY CZ R ray OX OY OZ DX DY DZ [range TMIN TMAX]
for (const line of readFileSync(0, 'utf8').trimEnd().split('\n')) {
  const [shape, ...words] = line.split(' ');
  if (shape !== 'sphere') throw Error('mine.mjs answers spheres only: --shape sphere');
  const x = words.filter((word) => word !== 'ray' && word !== 'range').map(number);
  const [tMin, tMax] = x.length > 10 ? x.slice(10) : [0, Infinity];
  const t = firstHit(x.slice(0, 3), x[3], x.slice(4, 7), x.slice(7, 10), tMin, tMax);
  console.log(line, t === undefined ? 'miss' : `hit ${t}`);
}
