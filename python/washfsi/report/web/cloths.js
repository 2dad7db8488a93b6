// SPDX-License-Identifier: BSD-3-Clause
// The cloths of the playback: lattices of markers in space, in the plane strips along their lines.

const STRIP = 0.0035; // half width of a strip, over the diagonal of what the view is about

/** Returns the triangles of quadrilaterals. */
function trianglesOf(quads) {
  const triangles = [];
  for (let start = 0; start < quads.length; start += 4) {
    const [a, b, c, d] = quads.subarray(start, start + 4);
    triangles.push(a, b, c, a, c, d);
  }
  return triangles;
}

/** Returns the edges of quadrilaterals, each once. */
function edgesOf(quads) {
  const edges = new Map();
  for (let start = 0; start < quads.length; start += 4) {
    for (let side = 0; side < 4; side++) {
      const ends = [quads[start + side], quads[start + ((side + 1) % 4)]].sort((one, other) => one - other);
      edges.set(ends.join(), ends);
    }
  }
  return [...edges.values()].flat();
}

/** Returns the lines of the plane as lists of markers, out of lists behind their lengths. */
function linesOf(packed) {
  const lines = [];
  for (let start = 0; start < packed.length; start += packed[start] + 1)
    lines.push(packed.subarray(start + 1, start + 1 + packed[start]));
  return lines;
}

/** Cloths as a surface of their quadrilaterals. Vertices are the markers. */
class Sheets {
  constructor(quads, markers) {
    this.positions = new THREE.BufferAttribute(new Float32Array(3 * markers), 3);
    this.colours = new THREE.BufferAttribute(new Float32Array(3 * markers), 3);
    this.geometry = geometryOf({ position: [this.positions], color: [this.colours] }, trianglesOf(quads));
    const grid = geometryOf({ position: [this.positions] }, edgesOf(quads));
    this.lines = new THREE.LineSegments(grid, new THREE.LineBasicMaterial({ transparent: true, opacity: 0.45 }));
    const material = new THREE.MeshLambertMaterial({
      vertexColors: THREE.VertexColors,
      side: THREE.DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = this.lines.frustumCulled = false;
    this.object = new THREE.Group().add(this.mesh, this.lines);
  }

  /** Takes places and colours of the markers, three numbers each. */
  put(places, colours) {
    this.positions.array.set(places);
    this.colours.array.set(colours);
    this.positions.needsUpdate = this.colours.needsUpdate = true;
    this.geometry.computeVertexNormals();
  }
}

/** Strips along lines in the plane, of a half width, at a height: two vertices for each marker. */
class Strip {
  constructor(lines, markers, width, height, material) {
    this.chains = lines;
    [this.width, this.height] = [width, height];
    this.positions = new THREE.BufferAttribute(new Float32Array(6 * markers), 3);
    this.colours = new THREE.BufferAttribute(new Float32Array(6 * markers), 3);
    const triangles = lines.flatMap((line) =>
      [...line].slice(1).flatMap((marker, place) => {
        const [a, b] = [2 * line[place], 2 * marker];
        return [a, a + 1, b, a + 1, b + 1, b];
      }),
    );
    this.geometry = geometryOf({ position: [this.positions], color: [this.colours] }, triangles);
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Takes places and colours of the markers, three numbers each. */
  put(places, colours) {
    for (const line of this.chains) line.forEach((marker, place) => this.widen(line, place, marker, places));
    for (let vertex = 0; vertex < this.positions.count; vertex++) {
      for (let part = 0; part < 3; part++) this.colours.array[3 * vertex + part] = colours[3 * (vertex >> 1) + part];
    }
    this.positions.needsUpdate = this.colours.needsUpdate = true;
  }

  /** Puts the two vertices of a marker to both sides of its line. */
  widen(line, place, marker, places) {
    const [before, after] = [line[Math.max(place - 1, 0)], line[Math.min(place + 1, line.length - 1)]];
    const [x, y] = [0, 1].map((axis) => places[3 * after + axis] - places[3 * before + axis]);
    const factor = this.width / (Math.hypot(x, y) || 1);
    for (const side of [0, 1]) {
      const sign = factor * (1 - 2 * side);
      this.positions.array.set(
        [places[3 * marker] - sign * y, places[3 * marker + 1] + sign * x, this.height],
        6 * marker + 3 * side,
      );
    }
  }
}

/** Cloths in the plane as coloured strips with dark rims, in front of the flow. */
class Strips {
  constructor(lines, markers, width) {
    const side = THREE.DoubleSide;
    const coloured = new THREE.MeshBasicMaterial({ vertexColors: THREE.VertexColors, side });
    this.rims = new Strip(lines, markers, 1.9 * width, width, new THREE.MeshBasicMaterial({ side }));
    this.strip = new Strip(lines, markers, width, 2 * width, coloured);
    [this.lines, this.mesh] = [this.rims.mesh, this.strip.mesh];
    this.object = new THREE.Group().add(this.lines, this.mesh);
  }

  put(places, colours) {
    this.rims.put(places, colours);
    this.strip.put(places, colours);
  }
}

/** The cloths: their places and colours between frames. */
class Cloths {
  constructor(playback, arrays, scale) {
    const cloths = playback.cloths;
    this.markers = cloths.markers;
    this.frames = unscaled(arrays(cloths.positions), cloths.positions);
    this.number = arrays(cloths.cloth);
    this.scale = scale;
    this.quantities = Object.fromEntries(
      cloths.colours.map((colour) => [
        colour.name,
        { ...colour, numbers: unscaled(arrays(colour.values), colour.values) },
      ]),
    );
    this.places = new Float32Array(3 * this.markers);
    this.colours = new Float32Array(3 * this.markers);
    const lines = arrays(cloths.lines);
    const { lower, upper } = playback.scene;
    const size = Math.hypot(...upper.map((high, axis) => high - lower[axis]));
    this.shape =
      playback.dim === 3 ? new Sheets(lines, this.markers) : new Strips(linesOf(lines), this.markers, STRIP * size);
    this.object = this.shape.object;
    this.by = cloths.colours.length ? cloths.colours[0].name : "number";
  }

  /** Puts numbers between two frames into an array. */
  between(numbers, width, frame, share, target) {
    const now = frame * width;
    const next = Math.min(now + width, numbers.length - width);
    for (let place = 0; place < width; place++)
      target[place] = (1 - share) * numbers[now + place] + share * numbers[next + place];
    return target;
  }

  /** Returns the values of the quantity by which they are coloured; null by number. */
  values(frame, share) {
    const quantity = this.quantities[this.by];
    return quantity ? this.between(quantity.numbers, this.markers, frame, share, new Float32Array(this.markers)) : null;
  }

  /** Shows them between two frames. */
  show(frame, share) {
    this.between(this.frames, 3 * this.markers, frame, share, this.places);
    this.shown = this.values(frame, share);
    for (let marker = 0; marker < this.markers; marker++) this.colour(marker);
    this.shape.put(this.places, this.colours);
  }

  colour(marker) {
    if (this.shown)
      putColour(this.scale, this.shown[marker] / this.quantities[this.by].limit, this.colours, 3 * marker, 1);
    else this.colours.set(this.palette[this.number[marker]], 3 * marker);
  }

  recolour() {
    const count = this.number.reduce((most, number) => Math.max(most, number), 0) + 1;
    this.palette = Array.from({ length: count }, (_, number) => clothColour(number));
    this.shape.lines?.material.color.set(styleValue("--edge"));
  }
}
