// What a page is made of: elements, choices, tables, lines to copy.

/** Makes an element. Whatever is no node among its children becomes text, never markup. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value != null) made.setAttribute(name, value);
  }
  made.append(...children.flat().filter((child) => child != null));
  return made;
}

const section = (title, about, ...children) =>
  element("section", {}, element("h2", {}, title), element("p", { class: "about" }, about), ...children);

/** A value that several controls show, and others watch. */
function choice(value) {
  const watchers = [];
  return {
    get value() {
      return value;
    },
    set(next) {
      if (next === value) return;
      value = next;
      for (const watcher of watchers) watcher(value);
    },
    watch(watcher) {
      watchers.push(watcher);
    },
  };
}

/** The shape to begin with: the one that everybody knows, where it is there. */
function first_shape(shapes) {
  return shapes.includes("sphere") ? "sphere" : shapes[0];
}

/** A labelled select; options are [value, words], or a function that gives them anew. */
function select(label, chosen, options) {
  const control = element("select", { onchange: () => chosen.set(control.value) });
  const fill = () => {
    const now = typeof options === "function" ? options() : options;
    control.replaceChildren(...now.map(([value, words]) => element("option", { value }, words)));
    control.value = chosen.value;
  };
  fill();
  chosen.watch(() => (control.value = chosen.value));
  return Object.assign(element("label", { class: "choice" }, label, " ", control), { fill });
}

/** Boxes to tick, one a name; chosen holds the list of those that are. */
function boxes(label, chosen, names) {
  const ticks = names.map((name) => {
    const box = element("input", {
      type: "checkbox",
      onchange: () => chosen.set(names.filter((_, i) => ticks[i].box.checked)),
    });
    box.checked = chosen.value.includes(name);
    return { box, line: element("label", { class: "tick" }, box, " ", name) };
  });
  chosen.watch((now) => ticks.forEach(({ box }, i) => (box.checked = now.includes(names[i]))));
  return element(
    "details", { class: "ticks" },
    element("summary", {}, label),
    element("div", { class: "ticks-list" }, ticks.map(({ line }) => line)));
}

const controls = (...all) => element("div", { class: "controls" }, all);

/** Wide things scroll in a box of their own, which the keyboard reaches. */
const scrolling = (label, ...children) =>
  element("div", { class: "scrolling", tabindex: "0", role: "region", "aria-label": label }, children);

/** A table; columns are [words, row → content, is it a number?]. */
function table(caption, columns, rows) {
  const cell = (tag, numeric, ...content) =>
    element(tag, { class: numeric ? "figure" : null, scope: tag === "th" ? "col" : null }, ...content);
  return scrolling(
    caption,
    element(
      "table", {},
      element("caption", {}, caption),
      element("thead", {}, element("tr", {}, columns.map(([words, , numeric]) => cell("th", numeric, words)))),
      element("tbody", {}, rows.map((row) =>
        element("tr", {}, columns.map(([, tell, numeric]) => cell("td", numeric, tell(row))))))));
}

/** A line of text to take along. */
function copied(words, text) {
  const button = element("button", { type: "button", class: "copy", "aria-label": `Copy ${words}` }, "copy");
  const code = element("code", {}, text);
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "copied";
    } catch {
      getSelection().selectAllChildren(code);
      button.textContent = "selected";
    }
    setTimeout(() => (button.textContent = "copy"), 1500);
  });
  return element("div", { class: "copied" }, element("span", { class: "copied-words" }, words), code, button);
}

/** What ran, where: pairs of words and content in lines. */
const facts = (pairs) =>
  element("dl", { class: "facts" }, pairs.filter(([, told]) => told != null).map(([words, told]) =>
    element("div", {}, element("dt", {}, words), element("dd", {}, told))));

/** The heading of every page. */
function heading(report, about, pairs) {
  const at = report.environment;
  return element(
    "header", {},
    element("h1", {}, `rayaudit ${report.report}`),
    element("p", { class: "about" }, about),
    facts([
      ...pairs,
      ["seed", String(report.seed)],
      ["program", `${report.tool.name} ${report.tool.version}`],
      ["compiler", `${at.compiler}, ${at.flags}`],
      ["processor", `${at.processor}, ${at.processors} at once`],
      ["arithmetic", `rounding ${at.rounding}, ${at.contraction ? "with" : "no"} contraction, ` +
        `${at.flush_to_zero ? "subnormals flushed" : "subnormals kept"}`],
    ]));
}
