// SPDX-License-Identifier: BSD-3-Clause
// The paths of the cloths' centres in the plane of radius and height, over what the bodies sweep.

/** Returns what the bodies sweep as datasets: closed lines, filled. */
function sweptDatasets(tracks) {
  return tracks.swept.map((ring) => ({
    label: "",
    showLine: true,
    pointRadius: 0,
    borderWidth: 1,
    fill: "shape",
    borderColor: styleValue("--edge"),
    backgroundColor: styleValue("--solid"),
    data: [...ring, ring[0]].map(([x, y]) => ({ x, y })),
    swept: true,
  }));
}

/** Returns the tracks as datasets. */
function trackDatasets(tracks, arrays) {
  return tracks.tracks.map((track, number) => {
    const height = arrays(track.height);
    return {
      label: track.name,
      colour: number,
      showLine: true,
      pointRadius: 0,
      borderWidth: 1.2,
      borderColor: seriesColour(number),
      borderDash: DASHES[Math.floor(number / 7) % 4],
      data: Array.from(arrays(track.radius), (x, place) => ({ x, y: height[place] })),
    };
  });
}

/** Makes both axes of a chart of one scale, by the height of its frame. */
function equalScale(chart, frame, ratio) {
  const { width, height } = chart.chartArea;
  const missing = width * ratio - height;
  if (Math.abs(missing) > 2) frame.style.height = `${frame.clientHeight + missing}px`;
}

/** The chart of the tracks, with a dot on each at the playback's time. */
class TracksChart {
  constructor(run, arrays) {
    const tracks = run.tracks;
    this.times = arrays(tracks.time);
    this.paths = trackDatasets(tracks, arrays);
    this.dots = { label: "", pointRadius: 4, borderColor: styleValue("--text"), backgroundColor: [], data: [] };
    this.frame = element(
      "div",
      { class: "plot" },
      (this.canvas = element("canvas", { role: "img", "aria-label": "tracks of cloths" })),
    );
    this.tracks = tracks;
  }

  /** Draws, once the frame is in the page. */
  draw() {
    const { reach, lower, upper } = this.tracks;
    const options = chartOptions(
      axisOptions("radius [m]", { min: 0, max: reach }),
      axisOptions("height [m]", { min: lower, max: upper }),
      { parsing: {}, normalized: false, interaction: { mode: "nearest", intersect: true } },
    );
    options.plugins.legend.display = false;
    options.plugins.tooltip.callbacks = {
      label: (item) => item.dataset.label || `cloth ${item.dataIndex}`,
      title: () => "",
    };
    options.onResize = () => requestAnimationFrame(() => equalScale(this.chart, this.frame, (upper - lower) / reach));
    const datasets = [this.dots, ...this.paths, ...sweptDatasets(this.tracks)];
    this.chart = new Chart(this.canvas, { type: "scatter", data: { datasets }, options });
    equalScale(this.chart, this.frame, (upper - lower) / reach);
    this.showTime(this.times[0]);
  }

  /** Puts the dots to the row nearest to a time. */
  showTime(time) {
    const far = this.times.map((other) => Math.abs(other - time));
    const row = far.indexOf(Math.min(...far));
    if (row === this.row && this.chart) return;
    this.row = row;
    this.dots.data = this.paths.map((path) => path.data[row]);
    this.dots.backgroundColor = this.paths.map((path) => path.borderColor);
    this.chart?.update("none");
  }

  recolour() {
    const swept = this.chart.data.datasets.filter((set) => set.swept);
    swept.forEach((set) => {
      set.borderColor = styleValue("--edge");
      set.backgroundColor = styleValue("--solid");
    });
    recolour(this.chart);
  }
}

/** Returns the section of the tracks. */
function tracksSection(tracks) {
  return section(
    "tracks",
    "Tracks of the cloths",
    element(
      "p",
      {},
      "Centres of the cloths in the plane of the distance from the machine's axis and the height, and what the bodies " +
        "sweep when they turn (grey). " +
        "Dots are where the cloths are at the playback's time; point at a line for its cloth.",
    ),
    tracks.frame,
  );
}
