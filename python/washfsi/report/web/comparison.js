// SPDX-License-Identifier: BSD-3-Clause
// Several runs beside each other.

const POINTS = ["circle", "rect", "triangle", "rectRot", "cross"];

/** Draws the spreads of a chart's points. */
const spreadBars = {
  id: "spreadBars",
  afterDatasetsDraw(chart) {
    const { x, y } = chart.scales;
    const pen = chart.ctx;
    pen.save();
    for (const { data, borderColor } of chart.data.datasets) {
      pen.strokeStyle = borderColor;
      pen.lineWidth = 1.2;
      data.forEach((point) => drawSpread(pen, point, x, y));
    }
    pen.restore();
  },
};

function drawSpread(pen, point, x, y) {
  pen.beginPath();
  pen.moveTo(x.getPixelForValue(point.x - point.wide), y.getPixelForValue(point.y));
  pen.lineTo(x.getPixelForValue(point.x + point.wide), y.getPixelForValue(point.y));
  pen.moveTo(x.getPixelForValue(point.x), y.getPixelForValue(point.y - point.high));
  pen.lineTo(x.getPixelForValue(point.x), y.getPixelForValue(point.y + point.high));
  pen.stroke();
}

/** Returns the limits of an axis round values and their spreads. */
function limitsOf(points, value, spread) {
  const low = Math.min(...points.map((point) => point[value] - point[spread]));
  const high = Math.max(...points.map((point) => point[value] + point[spread]));
  const margin = 0.12 * (high - low || Math.abs(high) || 1);
  return { min: low - margin, max: high + margin };
}

/** Returns the points of a panel in the units of its axes. */
function tradeoffPoints(panel, designs) {
  const [across, up] = ["x", "y"].map((axis) =>
    prefixOf(Math.max(...panel.points.map((point) => Math.abs(point[axis].value))), panel.points[0][axis].unit),
  );
  const points = panel.points.map(({ name, x, y }) => ({
    name,
    number: designs.indexOf(name),
    x: x.value / across[0],
    y: y.value / up[0],
    wide: (x.std ?? 0) / across[0],
    high: (y.std ?? 0) / up[0],
  }));
  const titles = [
    [panel.x, "x", across],
    [panel.y, "y", up],
  ].map(([title, axis, [, prefix]]) => {
    const unit = unitText(panel.points[0][axis].unit, prefix);
    return `${title}${unit ? ` [${unit}]` : ""}`;
  });
  return { points, titles };
}

/** Draws a trade-off into a frame. */
function tradeoffChart(panel, designs, canvas) {
  const { points, titles } = tradeoffPoints(panel, designs);
  const options = chartOptions(
    axisOptions(titles[0], limitsOf(points, "x", "wide")),
    axisOptions(titles[1], limitsOf(points, "y", "high")),
    { interaction: { mode: "nearest", intersect: true } },
  );
  Object.assign(options.plugins.legend.labels, { usePointStyle: true, boxHeight: 7 });
  options.plugins.tooltip.callbacks = {
    label: ({ raw }) =>
      `${raw.name}: ${digitsOf(raw.x)} ± ${digitsOf(raw.wide, 2)}, ${digitsOf(raw.y)} ± ${digitsOf(raw.high, 2)}`,
    title: () => "",
  };
  const datasets = points.map((point) => ({
    label: point.name,
    colour: point.number,
    data: [point],
    pointRadius: 6,
    pointHoverRadius: 8,
    pointStyle: POINTS[Math.floor(point.number / 7) % POINTS.length],
    borderColor: seriesColour(point.number),
    backgroundColor: seriesColour(point.number),
  }));
  return new Chart(canvas, { type: "scatter", data: { datasets }, options, plugins: [spreadBars] });
}

/** Returns what the bars of the trade-offs are. */
function barsNote(comparison) {
  const seeds = Math.max(...comparison.tradeoffs.flatMap((panel) => panel.points.map((point) => point.x.seeds)));
  const first = comparison.first
    ? " Some runs have no cycle after the first: their figures are of start-up and decide nothing."
    : "";
  return (
    (seeds > 1
      ? `Bars: standard deviation over up to ${seeds} seeds.`
      : "Bars: standard deviation of a cycle, where there are cycles after the first.") + first
  );
}

/** Returns the row of a figure: each run's, and how far it is from the first run's where that is more than its spread. */
function comparisonRow(row) {
  const { value, std } = row.values[0] ?? {};
  const first = Math.abs(value) > (std ?? 0) ? value : NaN;
  return element(
    "tr",
    {},
    element("th", { scope: "row" }, row.label),
    row.values.map((figure, place) => {
      const cell = numberCell(figure?.value ?? null, row.unit, figure?.std);
      const change = place && figure && first ? (figure.value / first - 1) * 100 : NaN;
      if (Number.isFinite(change))
        cell.append(
          element("span", { class: "change" }, ` ${change < 0 ? "−" : "+"}${digitsOf(Math.abs(change), 2)} %`),
        );
      return cell;
    }),
  );
}

/** Returns the row of a figure on several grids, with its estimate. */
function gridRow({ label, unit, values, estimate, order, observed }) {
  const cell = numberCell(estimate.value, unit, estimate.std, { class: "number mean" });
  if (observed) cell.append(element("span", { class: "change" }, ` order ${digitsOf(order, 2)}`));
  return element(
    "tr",
    {},
    element("th", { scope: "row" }, label),
    values.map((figure) => numberCell(figure.value, unit, figure.std)),
    cell,
  );
}

/** Returns the table of a case on several grids. */
function gridTable({ designs, grids, rows }) {
  const heads = ["figure", ...grids.map((cells) => `${cells} cells`), "estimate"];
  return [
    element("h3", {}, `On finer grids: ${designs.join(", ")}`),
    element(
      "p",
      { class: "note" },
      "The estimate continues the two finest grids to cells of no width (Richardson), by first order unless three grids show " +
        "another. The number behind ± is the size of this continuation and the spread over seeds: an estimate, not a bound.",
    ),
    table(heads, ownedRows(rows, heads.length, gridRow)),
  ];
}

/** Returns the name of a curve among those of all panels. */
function curveTitle(panel, curve) {
  return [panel.title, curve.label].filter(Boolean).join(": ");
}

/** The comparison, with its charts. */
class Comparison {
  constructor(data, packs, chosen) {
    this.data = data;
    this.packs = packs;
    this.time = new TimeCharts(chosen);
    this.charts = [];
    this.overlay = element("div", {});
    this.element = this.build();
  }

  build() {
    const { comparison, runs } = this.data;
    const pictures = comparison.tradeoffs.map((panel) => this.tradeoff(panel));
    const heads = ["figure", ...runs.map((run) => run.name)];
    return section(
      "comparison",
      `${runs.length} runs beside each other`,
      pictures.length
        ? [
            element("h3", {}, "Washing action and what it costs"),
            element("p", { class: "note" }, barsNote(comparison)),
            element("div", { class: "charts" }, pictures),
          ]
        : null,
      comparison.verdicts.length
        ? [
            element("h3", {}, "What can be decided"),
            element(
              "ul",
              {},
              comparison.verdicts.map((text) => element("li", {}, text)),
            ),
          ]
        : null,
      comparison.grids.map(gridTable),
      element("h3", {}, "Over time"),
      this.chooser(),
      this.overlay,
      comparison.rows.length
        ? [
            element("h3", {}, "Figures of a cycle"),
            table(heads, ownedRows(comparison.rows, heads.length, comparisonRow)),
          ]
        : null,
      element("h3", {}, "How far to believe them"),
      table(
        ["run", "findings"],
        runs.map((run) =>
          element("tr", {}, element("th", { scope: "row" }, run.name), element("td", {}, trustMarks(run))),
        ),
      ),
    );
  }

  tradeoff(panel) {
    const canvas = element("canvas", { role: "img", "aria-label": `${panel.y} against ${panel.x}` });
    this.charts.push([panel, canvas]);
    return element(
      "figure",
      { class: "chart" },
      element("figcaption", {}, element("b", {}, panel.group)),
      element("div", { class: "plot" }, canvas),
    );
  }

  /** Returns the curves that all runs can be compared by, by title: [panel, label]. */
  comparable() {
    const found = new Map();
    for (const run of this.data.runs) {
      for (const panel of run.curves)
        for (const curve of panel.curves) found.set(curveTitle(panel, curve), panel);
    }
    return found;
  }

  chooser() {
    const titles = [...this.comparable().keys()];
    this.title = titles.filter((title) => title.startsWith("Power")).pop() ?? titles[0];
    const made = choice(
      "compared",
      "curve",
      titles.map((title) => [title, title]),
      (title) => {
        this.title = title;
        this.drawOverlay();
      },
    );
    made.querySelector("select").value = this.title;
    return element("p", {}, titles.length ? made : "There are no histories.");
  }

  /** Draws the curve that is chosen, of all runs. */
  drawOverlay() {
    this.time.destroy();
    const panel = this.comparable().get(this.title);
    if (!panel) return;
    const curves = this.data.runs.flatMap((run, place) =>
      run.curves.flatMap((other) =>
        other.curves
          .filter((curve) => curveTitle(other, curve) === this.title)
          .map((curve) => ({
            label: run.name,
            time: this.packs[place](curve.time),
            values: this.packs[place](curve.values),
          })),
      ),
    );
    this.overlay.replaceChildren(this.time.add({ title: this.title, note: panel.note, unit: panel.unit, curves }));
  }

  /** Draws, once it is in the page. */
  draw() {
    this.charts = this.charts.map(([panel, canvas]) => tradeoffChart(panel, this.data.comparison.designs, canvas));
    this.drawOverlay();
  }

  recolour() {
    this.charts.forEach(recolour);
    this.time.recolour();
  }
}
