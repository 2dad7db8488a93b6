// SPDX-License-Identifier: BSD-3-Clause
// What was simulated: in words, as a drawing, and every option.

/** Returns the drawings of the start, which Python has made of lines alone. */
function drawingElements(drawings) {
  return drawings.map(({ title, svg }) => {
    const figure = element("figure", { class: "drawing" });
    figure.innerHTML = svg;
    figure.append(element("figcaption", {}, title));
    return figure;
  });
}

/** Returns the section on what was simulated. */
function storySection(run) {
  const words = run.words.flatMap(({ about, text }) => [element("dt", {}, about), element("dd", {}, text)]);
  return section(
    "story",
    "What was simulated",
    element(
      "div",
      { class: "story" },
      element("dl", {}, words),
      element("div", { class: "drawings" }, drawingElements(run.drawings)),
    ),
    element(
      "p",
      { class: "legend" },
      key("solid", "bodies"),
      run.groups.length ? key("cloth", "cloths") : null,
      key("water", "liquid"),
      run.drawings.length > 1 ? " at the start; a drum is cut in the middle." : " at the start.",
    ),
  );
}

/** Returns an entry of a legend. */
function key(kind, text) {
  return element("span", { class: "key" }, element("i", { class: kind }), text);
}

/** Returns the section with every option of the run. */
function optionsSection(run) {
  const rows = Object.entries(run.options).map(([name, value]) =>
    element(
      "tr",
      {},
      element("td", {}, element("code", {}, `-${name}`)),
      element("td", {}, element("code", {}, value)),
    ),
  );
  return section(
    "options",
    "Every option",
    element(
      "details",
      {},
      element("summary", {}, `${rows.length} options, as resolved.opts has them`),
      table(["option", "value"], rows),
    ),
  );
}
