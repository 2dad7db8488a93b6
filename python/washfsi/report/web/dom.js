// SPDX-License-Identifier: BSD-3-Clause
// Making elements of the page. Texts go in as texts, never as HTML.

/** Returns a new element with attributes (class, data-..., on... functions) and children, elements or texts. */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return made;
}

/** Returns a section with a title, by which the contents list it. */
function section(id, title, ...children) {
  return element("section", { id, "aria-label": title }, element("h2", {}, title), ...children);
}

/** Returns a table in a frame that scrolls sideways when it is too wide, by the keyboard too. */
function table(heads, rows) {
  const head = element(
    "tr",
    {},
    heads.map((text) => element("th", { scope: "col" }, text)),
  );
  return element(
    "div",
    { class: "wide", tabindex: 0 },
    element("table", {}, element("thead", {}, head), element("tbody", {}, rows)),
  );
}

/** Returns a choice of [value, text] pairs. */
function choice(id, label, pairs, changed) {
  const options = pairs.map(([value, text]) => element("option", { value }, text));
  return element(
    "label",
    {},
    `${label} `,
    element("select", { id, onchange: (event) => changed(event.target.value) }, options),
  );
}

/** Returns a box to tick. */
function tick(id, label, checked, changed) {
  const box = element("input", { id, type: "checkbox", checked, onchange: (event) => changed(event.target.checked) });
  return element("label", {}, box, ` ${label}`);
}
