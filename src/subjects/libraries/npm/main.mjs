// Answers cases with libraries from npm, for npm.cpp: node main.mjs, with questions on standard input
// and answers on file 3. What a library prints goes where standard output and error go.
//
// First told: the length of a text, and the text, in JSON: { subjects: [{ name, format, shapes,
// convention, about }], absent: [why a library's subjects are not among them, ...] }. From then on
// little-endian doubles: place of the subject, place of the shape, number of cases, and 16 for each
// case; in answer 4 for each: its form, and t or the point.
import { readFileSync, readSync, writeSync } from 'node:fs'
import libraries from './libraries.mjs'

const here = new URL('.', import.meta.url)
const answers_to = 3
const numbers_a_case = 16, numbers_an_answer = 4
const shapes = ['disk', 'sphere', 'cylinder', 'cone', 'capped_cylinder', 'capped_cone']
const form = { miss: 0, hit: 1, at: 2, yes: 3, none: -1 }

const json = (path) => JSON.parse(readFileSync(new URL(path, here), 'utf8'))

/** The versions of the packages that the adapters were written for. */
const written_for = () => {
  const { dependencies, optionalDependencies } = json('package.json')
  return { ...dependencies, ...optionalDependencies }
}

const version_of = (name) => {
  try {
    return json(`node_modules/${name}/package.json`).version
  } catch {
    throw new Error(`${name} is not among the packages`)
  }
}

/** What is told of a library's subjects, before any of it is loaded. */
async function told(library, versions) {
  const { subjects, load } = await import(new URL(`${library}.mjs`, here))
  return subjects.map(({ asks, package: name, ...subject }) => {
    const version = version_of(name)
    const other = version === versions[name] ? '' : ` (the adapter was written for ${versions[name]})`
    return { ...subject, load, about: `${name} ${version}${other}, ${asks}` }
  })
}

async function all_subjects() {
  const versions = written_for()
  const subjects = [], absent = []
  for (const library of libraries)
    try {
      subjects.push(...(await told(library, versions)))
    } catch (why) {
      absent.push(`npm.${library}: ${why.message}`)
    }
  return { subjects, absent }
}

/** All of the buffer, or false where whoever asks has gone. */
function receive(buffer) {
  for (let got = 0; got < buffer.length; ) {
    const more = readSync(0, buffer, got, buffer.length - got)
    if (more === 0) return false
    got += more
  }
  return true
}

function send(buffer) {
  for (let sent = 0; sent < buffer.length; ) sent += writeSync(answers_to, buffer, sent)
}

function doubles(count) {
  const bytes = Buffer.alloc(8 * count)
  return { bytes, at: (place) => bytes.readDoubleLE(8 * place) }
}

/** A case as modules take it: the ray, and the shape as rayaudit/case.h has it. */
function question(at, first, shape) {
  const vector = (place) => ({ x: at(first + place), y: at(first + place + 1), z: at(first + place + 2) })
  const ray = { origin: vector(0), direction: vector(3), t_min: at(first + 6), t_max: at(first + 7) }
  const of = [
    () => ({ centre: vector(8), normal: vector(11), radius: at(first + 14) }),
    () => ({ centre: vector(8), radius: at(first + 11) }),
    () => ({ base: vector(8), top: vector(11), radius: at(first + 14) }),
    () => ({ base: vector(8), apex: vector(11), radius: at(first + 14) }),
  ]
  return [ray, of[shape < of.length ? shape : shape - 2]()]
}

/** What a module says of a case: a t, a point, yes or no, or nothing for a miss. */
function numbers_of(answer) {
  if (answer === null || answer === undefined || answer === false) return [form.miss, 0, 0, 0]
  if (answer === true) return [form.yes, 0, 0, 0]
  if (typeof answer === 'number') return [form.hit, answer, 0, 0]
  const { x, y, z } = answer
  const is_point = [x, y, z].every((each) => typeof each === 'number')
  return is_point ? [form.at, x, y, z] : [form.none, 0, 0, 0]
}

function answers(answer, shape, cases, count) {
  const said = Buffer.alloc(8 * numbers_an_answer * count)
  for (let i = 0; i < count; ++i)
    numbers_of(answer(...question(cases.at, numbers_a_case * i, shape))).forEach((number, place) =>
      said.writeDoubleLE(number, 8 * (numbers_an_answer * i + place)),
    )
  return said
}

async function answer_all(subjects) {
  const head = doubles(3)
  while (receive(head.bytes)) {
    const subject = subjects[head.at(0)], shape = head.at(1), count = head.at(2)
    const cases = doubles(numbers_a_case * count)
    if (!receive(cases.bytes)) return
    try {
      subject.loaded ??= await subject.load(subject)
      send(answers(subject.loaded[shapes[shape]], shape, cases, count))
    } catch (why) {
      writeSync(2, `${subject.name}: ${why?.stack ?? why}\n`)
      process.exit(1)
    }
  }
}

const { subjects, absent } = await all_subjects()
const text = Buffer.from(JSON.stringify({ subjects, absent }))
const length = Buffer.alloc(8)
length.writeDoubleLE(text.length)
send(length)
send(text)
await answer_all(subjects)
process.exit(0)
