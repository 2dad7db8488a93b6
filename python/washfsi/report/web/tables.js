// SPDX-License-Identifier: BSD-3-Clause
// Figures as cards and tables, and how far to believe them.

const START_UP = "The first cycle is start-up: the cloth is thrown from where it was laid.";
const VERDICTS = { ok: ["✓", "ok"], warn: ["!", "warning"], fail: ["✗", "failed"] };

/** Returns the card of a headline. */
function card(headline) {
  const [number, unit] = formatted(headline.value, headline.unit, headline.std);
  return element(
    "div",
    { class: "card" },
    element("h3", {}, headline.title),
    element("p", { class: "owner" }, headline.owner),
    element(
      "p",
      { class: "figure", "data-figure": headline.name, "data-value": headline.value },
      number,
      element("span", { class: "unit" }, unit ? ` ${unit}` : ""),
    ),
    element("p", { class: "note" }, headline.note),
  );
}

/** Returns all findings of a run. */
function findingsOf(run) {
  return [...(run.trust.start ?? []), ...(run.trust.end ?? [])];
}

/** Returns how many findings are of each verdict, as marks that lead to them. */
function trustMarks(run) {
  const findings = findingsOf(run);
  const marks = Object.entries(VERDICTS).map(([verdict, [sign, name]]) => {
    const count = findings.filter((finding) => finding.verdict === verdict).length;
    return count
      ? element(
          "a",
          { class: `mark ${verdict}`, href: "#trust" },
          `${sign} ${count} ${name}${verdict === "warn" && count > 1 ? "s" : ""}`,
        )
      : null;
  });
  return element("p", { class: "marks" }, findings.length ? marks : "No findings: there is no summary.");
}

/** Returns the first section: state of the run, findings, headlines. */
function overviewSection(run) {
  const cards = run.headlines.map(card);
  const none = element("p", { class: "note" }, "No complete cycle of agitation, so no figures per cycle.");
  return section(
    "overview",
    run.name,
    element("p", { class: `status ${run.status}` }, `case ${run.case}, ${run.status}`),
    trustMarks(run),
    cards.length ? element("div", { class: "cards" }, cards) : none,
  );
}

/** Returns one row of the cycles' table. */
function cycleRow(figure) {
  return element(
    "tr",
    { "data-figure": figure.name },
    element("th", { scope: "row" }, figure.label),
    numberCell(figure.mean, figure.unit, figure.std, { class: "number mean" }),
    figure.values.map((value) => numberCell(value, figure.unit)),
  );
}

/** Returns rows under the names of their owners, machine, bodies and groups. */
function ownedRows(figures, columns, rowOf) {
  let owner = null;
  return figures.flatMap((figure) => {
    const head =
      figure.owner === owner
        ? []
        : [element("tr", { class: "owner" }, element("th", { colspan: columns, scope: "rowgroup" }, figure.owner))];
    owner = figure.owner;
    return [...head, rowOf(figure)];
  });
}

/** Returns what the means are of. */
function cyclesNote(cycles) {
  if (cycles.figures.some((figure) => figure.mean !== null)) {
    return `Mean of a cycle from the second on ± standard deviation of a cycle. ${START_UP}`;
  }
  return `There is no mean. ${START_UP} A longer -time_end has one.`;
}

/** Returns the section on the cycles; null without any. */
function cyclesSection(run) {
  const cycles = run.cycles;
  if (!cycles) return null;
  const heads = [
    "figure",
    "mean ± spread",
    ...cycles.numbers.map((number, place) => `cycle ${number}${cycles.start_up[place] ? ", start-up" : ""}`),
  ];
  return section(
    "cycles",
    "Figures per cycle",
    element("p", {}, cyclesNote(cycles)),
    table(heads, ownedRows(cycles.figures, heads.length, cycleRow)),
  );
}

/** Returns the section with the figures of the whole run; null without any. */
function figuresSection(run) {
  if (!run.figures.length) return null;
  const rows = ownedRows(run.figures, 2, (figure) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, figure.label),
      numberCell(figure.value, figure.unit, figure.std, { "data-path": JSON.stringify(figure.path) }),
    ),
  );
  return section(
    "figures",
    "The whole run",
    element(
      "p",
      {},
      "Of the cloths: the mean over the markers of each one's average in time ± standard deviation over the " +
        "markers. " +
        "Of the bodies: load of water and cloth on them in the last step.",
    ),
    table(["figure", "value"], rows),
  );
}

/** Returns the line of a finding. */
function findingLine(finding) {
  const [sign, name] = VERDICTS[finding.verdict];
  const limit = finding.limit === undefined || finding.verdict === "ok" ? "" : ` (limit ${digitsOf(finding.limit)})`;
  return element(
    "li",
    { class: finding.verdict },
    element("span", { class: `sign ${finding.verdict}`, title: name, role: "img", "aria-label": name }, sign),
    element(
      "div",
      {},
      element("b", {}, finding.name),
      ` ${finding.found}${limit}`,
      finding.advice ? element("p", { class: "note" }, finding.advice) : null,
    ),
  );
}

/** Returns the section on how far to believe the run; null without findings. */
function trustSection(run) {
  const parts = [
    ["Before the run", run.trust.start],
    ["After the run", run.trust.end],
  ].filter(([, found]) => found?.length);
  if (!parts.length) return null;
  return section(
    "trust",
    "How far to believe it",
    element(
      "p",
      {},
      "The limits are experience, not theorems: what is ok can still be wrong, so refine the grid and repeat with other " +
        "seeds.",
    ),
    element(
      "div",
      { class: "trust" },
      parts.map(([title, found]) =>
        element("div", {}, element("h3", {}, title), element("ul", { class: "findings" }, found.map(findingLine))),
      ),
    ),
  );
}
