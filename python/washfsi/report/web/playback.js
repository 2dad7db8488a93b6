// SPDX-License-Identifier: BSD-3-Clause
// The playback: the view with cloths, bodies and a slice of the flow, and what steers it.

const SPEEDS = [
  ["0.1", "a tenth"],
  ["0.25", "a quarter"],
  ["0.5", "half"],
  ["1", "real"],
  ["2", "double"],
];
const SLICES = [
  ["none", "none"],
  ["2", "across z"],
  ["1", "across y"],
  ["0", "across x"],
];
const VIEWS = [
  ["3d", "3D"],
  ["top", "from above"],
  ["front", "from the front"],
  ["side", "from the side"],
];

const START = 0.75; // share of the frames before the one where the playback stands at first

/** Returns a bar that tells the colours of a scale. */
function colourBar(title, unit, scale, low, high) {
  const [factor, prefix] = prefixOf(Math.max(Math.abs(low), Math.abs(high)), unit);
  const shown = unitText(unit, prefix);
  return element(
    "div",
    { class: "bar" },
    element("span", {}, `${title}${shown ? ` [${shown}]` : ""}`),
    element("div", { style: `background:${gradientOf(scale)}` }),
    element(
      "div",
      { class: "ends" },
      element("span", {}, digitsOf(low / factor, 3)),
      element("span", {}, `≥ ${digitsOf(high / factor, 3)}`),
    ),
  );
}

/** Plays a run. `told` is called with every time that is shown. */
class Playback {
  constructor(run, arrays, scales, told) {
    this.data = run.playback;
    this.told = told;
    this.times = this.data.times;
    this.time = this.times[Math.round(START * (this.times.length - 1))];
    this.speed = this.data.times.length > 1 ? 0.25 : 1;
    this.stage = element("div", { class: "stage" });
    this.view = new View(this.stage, this.data.lower, this.data.upper, () => this.seen());
    this.subject = arrays(this.data.scene.points);
    this.solids = this.data.solids.map((solid) => new Solid(solid, arrays));
    this.cloths = this.data.cloths ? new Cloths(this.data, arrays, scales.cloth) : null;
    this.slice = this.data.flow ? new Slice(this.data, arrays, scales) : null;
    this.parts = [...this.solids, this.cloths, this.slice].filter(Boolean);
    this.view.scene.add(...this.parts.map((part) => part.object));
    this.scales = scales;
    this.view.look(this.data.dim === 2 ? "top" : "3d");
    this.build();
  }

  /** Returns the points that the view has to show: those of the subject, and in open water a piece of the slice round it. */
  seen() {
    const points = triplesOf(this.subject);
    const { open, lower, upper } = this.data.scene;
    return open && this.slice.object.visible ? points.concat(this.slice.corners([lower, upper])) : points;
  }

  /** Makes what steers it. */
  build() {
    const last = this.times[this.times.length - 1];
    this.button = element(
      "button",
      { id: "play", type: "button", "aria-label": "play", onclick: () => this.toggle() },
      "▶",
    );
    this.slider = element("input", {
      id: "time",
      type: "range",
      min: this.times[0],
      max: last,
      step: "any",
      value: this.time,
      "aria-label": "time",
      oninput: (event) => this.go(Number(event.target.value)),
    });
    this.clock = element("output", { id: "clock", for: "time", "aria-live": "off" });
    this.bars = element("div", { class: "bars" });
    this.tip = element("output", { class: "tip" });
    this.stage.append(this.bars, this.clock, this.tip, this.zoomButtons());
    this.stage.addEventListener("click", (event) => this.point(event));
    this.element = element(
      "div",
      { class: "playback" },
      this.stage,
      element("div", { class: "transport" }, this.button, this.slider),
      element("div", { class: "settings" }, this.settings()),
    );
  }

  zoomButtons() {
    const button = (name, sign, factor) =>
      element(
        "button",
        { type: "button", title: name, "aria-label": name, onclick: () => this.view.zoom(factor) },
        sign,
      );
    return element("div", { class: "zoom" }, button("nearer", "+", 1.25), button("farther", "−", 0.8));
  }

  settings() {
    const speed = choice("speed", "speed", SPEEDS, (value) => {
      this.speed = Number(value);
    });
    speed.querySelector("select").value = String(this.speed);
    const view = choice("view", "view", VIEWS, (value) => this.view.look(value));
    view.querySelector("select").value = this.view.from;
    return [
      view,
      speed,
      this.clothSettings(),
      this.sliceSettings(),
      ...this.solids.map((solid) => tick(`show-${solid.name}`, solid.name, true, (on) => this.reveal(solid, on))),
    ];
  }

  /** Returns what steers the cloths' colours. */
  clothSettings() {
    if (!this.cloths) return null;
    const pairs = [...this.data.cloths.colours.map(({ name, title }) => [name, title]), ["number", "number"]];
    return [
      choice("colour", "cloths by", pairs, (value) => {
        this.cloths.by = value;
        this.refresh();
      }),
      tick("show-cloths", "cloths", true, (on) => this.reveal(this.cloths, on)),
    ];
  }

  /** Returns what steers the slice. */
  sliceSettings() {
    if (!this.slice) return null;
    const fields = choice(
      "field",
      "flow",
      this.data.flow.fields.map(({ name, title }) => [name, title]),
      (value) => {
        this.slice.field = this.data.flow.fields.find(({ name }) => name === value);
        this.refresh();
      },
    );
    if (this.data.dim === 2) return [fields, tick("show-flow", "flow", true, (on) => this.reveal(this.slice, on))];
    this.height = element("input", {
      id: "height",
      type: "range",
      min: 0,
      max: 1,
      step: "any",
      value: 0.3,
      "aria-label": "place of the slice",
      oninput: () => this.cut(),
    });
    const across = choice("slice", "slice", SLICES, (value) => {
      this.axis = value;
      this.cut();
    });
    this.axis = across.querySelector("select").value = "2";
    this.where = element("output", { class: "where" });
    return [across, element("label", {}, "at ", this.height, " ", this.where), fields];
  }

  /** Takes the slice where it is set. */
  cut() {
    this.slice.object.visible = this.axis !== "none";
    if (this.slice.object.visible) this.slice.cut(Number(this.axis), Number(this.height.value));
    this.refresh();
  }

  reveal(part, on) {
    part.object.visible = on;
    this.refresh();
  }

  /** Returns the frame before the time, and how far it is to the next. */
  moment() {
    const after = this.times.findIndex((time) => time > this.time);
    const frame = after < 0 ? this.times.length - 1 : Math.max(after - 1, 0);
    const length = (this.times[frame + 1] ?? Infinity) - this.times[frame];
    return [frame, Math.max(0, (this.time - this.times[frame]) / length)];
  }

  /** Shows a time. */
  go(time) {
    this.time = Math.min(Math.max(time, this.times[0]), this.times[this.times.length - 1]);
    this.slider.value = this.time;
    this.clock.textContent = `t = ${timeText(this.time, this.times[this.times.length - 1])}`;
    const moment = this.moment();
    this.parts.filter((part) => part.object.visible).forEach((part) => part.show(...moment));
    this.view.ask();
    this.told(this.time);
  }

  /** Shows the same time anew. */
  refresh() {
    if (this.where)
      this.where.textContent =
        this.axis === "none" ? "" : `${"xyz"[this.slice.axis]} = ${this.slice.position.toFixed(3)} m`;
    this.bars.replaceChildren(...this.colourBars());
    this.go(this.time);
  }

  /** Returns the bars of what is coloured by numbers. */
  colourBars() {
    const bars = [];
    const quantity = this.cloths?.object.visible && this.cloths.quantities[this.cloths.by];
    if (quantity) bars.push(colourBar(`cloth: ${quantity.title}`, quantity.unit, this.scales.cloth, 0, quantity.limit));
    const field = this.slice?.object.visible && this.slice.field;
    if (field) bars.push(colourBar(`flow: ${field.title}`, field.unit, this.slice.colours, field.low, field.high));
    return bars;
  }

  /** Starts or stops. */
  toggle() {
    this.playing = !this.playing;
    this.button.textContent = this.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", this.playing ? "pause" : "play");
    if (!this.playing) return;
    if (this.time >= this.times[this.times.length - 1]) this.time = this.times[0];
    let before = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      this.advance((now - before) / 1000);
      before = now;
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** Goes on by a time of the clock on the wall [s], and begins again behind the end. */
  advance(seconds) {
    const [first, last] = [this.times[0], this.times[this.times.length - 1]];
    const next = this.time + this.speed * seconds;
    this.go(next > last ? first : next);
  }

  /** Tells which cloth is pointed at, with the number that colours it there. */
  point(event) {
    if (!this.cloths?.object.visible || event.target !== this.view.renderer.domElement) return;
    const { left, top, width, height } = this.stage.getBoundingClientRect();
    const ray = new THREE.Raycaster();
    ray.setFromCamera(
      { x: (2 * (event.clientX - left)) / width - 1, y: 1 - (2 * (event.clientY - top)) / height },
      this.view.camera,
    );
    const [hit] = ray.intersectObject(this.cloths.shape.mesh);
    this.tip.textContent = hit ? this.tipText(this.data.dim === 3 ? hit.face.a : hit.face.a >> 1) : "";
  }

  tipText(marker) {
    const quantity = this.cloths.quantities[this.cloths.by];
    const value = quantity ? `: ${formatted(this.cloths.shown[marker], quantity.unit).join(" ")}` : "";
    return `cloth ${this.cloths.number[marker]}${value}`;
  }

  recolour() {
    this.parts.forEach((part) => part.recolour?.());
    this.view.recolour();
    this.refresh();
  }

  destroy() {
    this.playing = false;
    this.view.destroy();
  }
}

/** Returns the playback of a run, or a word where the browser cannot draw in space. */
function makePlayback(run, arrays, scales, told) {
  if (drawerName() !== null) return new Playback(run, arrays, scales, told);
  return {
    element: element("p", { class: "note" }, "The playback needs WebGL, which this browser does not give."),
    go() {},
    recolour() {},
    destroy() {},
  };
}

/** Returns the section of the playback. */
function playbackSection(run, playback) {
  const { every, times, flow } = run.playback;
  const apart = flow && flow.apart > 1 ? `, the flow in one of ${flow.apart}` : "";
  const coarse = flow && flow.coarser > 1 ? ` The flow is that of one cell of ${flow.coarser} along each axis.` : "";
  return section(
    "playback",
    "Playback",
    playback.element,
    element(
      "p",
      { class: "note" },
      (times.length > 1
        ? `${times.length} of ${every} frames${apart}; between them cloths and bodies are interpolated.`
        : "The start alone.") +
        `${coarse} ` +
        "Drag to turn, with the right button or two fingers to move; click for the wheel to zoom, on a cloth for its " +
        "number.",
    ),
  );
}
