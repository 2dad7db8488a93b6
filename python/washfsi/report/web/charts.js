// SPDX-License-Identifier: BSD-3-Clause
// Plots over time, by Chart.js. All share one stretch of time, which dragging over any of them sets, and a line at the
// playback's time.

const DASHES = [[], [6, 3], [2, 2], [8, 3, 2, 3]];
const LEAST_DRAG = 6; // [px], else it is a click

/** Returns the colours of a chart by the theme. */
function chartColours() {
  return { text: styleValue("--text"), faint: styleValue("--line") };
}

/** Returns an axis of a chart. */
function axisOptions(title, limits = {}) {
  const { text, faint } = chartColours();
  return {
    type: "linear",
    title: { display: true, text: title, color: text },
    grid: { color: faint, borderColor: faint },
    ticks: { color: text, maxRotation: 0, autoSkipPadding: 16, includeBounds: false },
    ...limits,
  };
}

/** Returns what all charts have in common. */
function chartOptions(x, y, more = {}) {
  const { text } = chartColours();
  return {
    animation: false,
    responsive: true,
    maintainAspectRatio: false,
    parsing: false,
    normalized: true,
    scales: { x, y },
    interaction: { mode: "nearest", axis: "x", intersect: false },
    plugins: {
      legend: { labels: { color: text, boxWidth: 22, boxHeight: 1 } },
      tooltip: { callbacks: { title: timeTitle } },
      decimation: { enabled: true, algorithm: "min-max" },
    },
    ...more,
  };
}

function timeTitle(items) {
  return items.length ? `${items[0].parsed.x.toPrecision(4)} s` : "";
}

/** Returns the curves of a panel as datasets, divided by a factor. */
function datasetsOf(curves, factor) {
  return curves.map((curve, number) => ({
    label: curve.label,
    colour: number,
    pointRadius: 0,
    pointHitRadius: 4,
    borderWidth: 1.7,
    borderColor: seriesColour(number),
    backgroundColor: seriesColour(number),
    borderDash: DASHES[Math.floor(number / 7) % 4],
    data: Array.from(curve.values, (value, place) => ({ x: curve.time[place], y: value / factor })),
  }));
}

/** Returns the largest size of the numbers of some curves. */
function largest(curves) {
  return curves.reduce((high, { values }) => values.reduce((most, value) => Math.max(most, Math.abs(value)), high), 0);
}

/** Plots over time that share their stretch of time. */
class TimeCharts {
  constructor(chosen) {
    this.charts = [];
    this.chosen = chosen; // called with the time that is clicked
    this.time = null;
    this.window = null;
  }

  /** Makes the plot of a panel (title, note, unit, curves with label, time, values) and returns its element. */
  add(panel) {
    const canvas = element("canvas", { role: "img", "aria-label": panel.title });
    const line = element("div", { class: "cursor" });
    const frame = element("div", { class: "plot" }, canvas, line, element("div", { class: "selection" }));
    const [factor, prefix] = prefixOf(largest(panel.curves), panel.unit);
    const unit = unitText(panel.unit, prefix);
    const all = [
      Math.min(...panel.curves.map(({ time }) => time[0])),
      Math.max(...panel.curves.map(({ time }) => time[time.length - 1])),
    ];
    const options = chartOptions(
      axisOptions("time [s]", { min: all[0], max: all[1] }),
      axisOptions(unit ? `[${unit}]` : ""),
    );
    options.plugins.legend.display = panel.curves.some((curve) => curve.label);
    const chart = new Chart(canvas, { type: "line", data: { datasets: datasetsOf(panel.curves, factor) }, options });
    this.charts.push({ chart, line, all });
    this.listen(chart, canvas, frame);
    return element(
      "figure",
      { class: "chart" },
      element("figcaption", {}, element("b", {}, panel.title), ` ${panel.note ?? ""}`),
      frame,
    );
  }

  /** Follows the mouse on a plot: a click sets the time, a drag the stretch, a double click takes all again. */
  listen(chart, canvas, frame) {
    const shade = frame.querySelector(".selection");
    let from = null;
    let dragged = false; // the click that follows a drag is none
    const place = (event) => event.clientX - canvas.getBoundingClientRect().left;
    canvas.addEventListener("pointerdown", (event) => {
      dragged = false;
      if (event.pointerType !== "mouse") return;
      from = place(event);
      canvas.setPointerCapture(event.pointerId); // also beyond its edge
    });
    canvas.addEventListener("pointermove", (event) => {
      if (from !== null) shadeBetween(shade, from, place(event));
    });
    canvas.addEventListener("pointerup", (event) => {
      if (from !== null) dragged = this.release(chart, from, place(event));
      from = null;
      shadeBetween(shade, 0, 0);
    });
    canvas.addEventListener("click", (event) => {
      if (!dragged) this.chosen(chart.scales.x.getValueForPixel(place(event)));
    });
    canvas.addEventListener("dblclick", () => this.zoom(null));
  }

  /** Ends a drag; returns whether it was one. */
  release(chart, from, to) {
    if (Math.abs(to - from) < LEAST_DRAG) return false;
    this.zoom([Math.min(from, to), Math.max(from, to)].map((pixel) => chart.scales.x.getValueForPixel(pixel)));
    return true;
  }

  /** Shows a stretch of time in all plots; null shows all. */
  zoom(stretch) {
    this.window = stretch;
    for (const { chart, all } of this.charts) {
      [chart.options.scales.x.min, chart.options.scales.x.max] = stretch ?? all;
      chart.update("none");
    }
    this.showTime(this.time);
  }

  /** Puts the line to a time. */
  showTime(time) {
    this.time = time;
    for (const { chart, line } of this.charts) {
      const { left, right, top, bottom } = chart.chartArea ?? {};
      const pixel = time === null ? NaN : chart.scales.x.getPixelForValue(time);
      line.hidden = !(pixel >= left && pixel <= right);
      if (!line.hidden)
        Object.assign(line.style, {
          transform: `translateX(${pixel}px)`,
          top: `${top}px`,
          height: `${bottom - top}px`,
        });
    }
  }

  /** Takes the colours of the theme. */
  recolour() {
    this.charts.forEach(({ chart }) => recolour(chart));
  }

  destroy() {
    this.charts.forEach(({ chart }) => chart.destroy());
    this.charts = [];
  }
}

/** Shades what a drag has gone over. */
function shadeBetween(shade, from, to) {
  Object.assign(shade.style, { left: `${Math.min(from, to)}px`, width: `${Math.abs(to - from)}px` });
}

/** Gives a chart the colours of the theme. */
function recolour(chart) {
  const { text, faint } = chartColours();
  for (const axis of Object.values(chart.options.scales)) {
    axis.title.color = axis.ticks.color = text;
    axis.grid.color = axis.grid.borderColor = faint;
  }
  chart.options.plugins.legend.labels.color = text;
  for (const set of chart.data.datasets) {
    if (set.colour !== undefined) set.borderColor = set.backgroundColor = seriesColour(set.colour);
  }
  chart.update("none");
}

/** Returns the section with the plots of a run; null without any. */
function curvesSection(run, arrays, charts) {
  if (!run.curves.length) return null;
  const panels = run.curves.map((panel) =>
    charts.add({
      ...panel,
      curves: panel.curves.map((curve) => ({
        label: curve.label,
        time: arrays(curve.time),
        values: arrays(curve.values),
      })),
    }),
  );
  return section(
    "curves",
    "Over time",
    element(
      "p",
      { class: "note" },
      "Drag over a plot to see a stretch of time in all of them, double-click for all of it; a click takes the playback " +
        "there.",
    ),
    element("div", { class: "charts" }, panels),
  );
}
