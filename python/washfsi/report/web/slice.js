// SPDX-License-Identifier: BSD-3-Clause
// A slice of the flow, along any axis and anywhere; in the plane all of it.

const MOST = 255; // of a cell's number: the upper limit
const CUT = "if (diffuseColor.a < 0.5 * opacity) discard; diffuseColor.a = opacity;"; // where the distance is zero

/** Returns how the slice is shown: its opacity is the distance from the walls, at which it ends. */
function sliceMaterial(opacity) {
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, transparent: opacity < 1, opacity });
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace("#include <alphatest_fragment>", CUT);
  };
  return material;
}

const OPACITY = 0.88; // in space

/** The slice: a rectangle with a picture of its cells. */
class Slice {
  constructor(playback, arrays, scales) {
    this.flow = playback.flow;
    this.scales = scales;
    this.plane = playback.dim === 2;
    this.cells = [...this.flow.cells, 1].slice(0, 3);
    this.numbers = Object.fromEntries(this.flow.fields.map((field) => [field.name, arrays(field.values)]));
    this.field = this.flow.fields[0];
    this.distance = arrays(this.flow.distance);
    this.slice = new THREE.Mesh(new THREE.BufferGeometry(), sliceMaterial(this.plane ? 1 : OPACITY));
    this.solid = new THREE.Mesh(
      this.slice.geometry,
      new THREE.MeshBasicMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
    );
    this.solid.visible = this.plane;
    this.object = new THREE.Group().add(this.slice, this.solid);
    this.cut(2, 0.3);
  }

  /** Takes the slice across an axis at a share of the box. */
  cut(axis, share) {
    const layers = this.cells[axis];
    this.axis = axis;
    this.layer = this.plane ? 0 : Math.min(layers - 1, Math.floor(share * layers));
    this.sides = [0, 1, 2].filter((other) => other !== axis);
    const [wide, high] = this.sides.map((side) => this.cells[side]);
    this.slice.material.map?.dispose();
    this.picture = new Uint8Array(4 * wide * high);
    this.slice.material.map = new THREE.DataTexture(this.picture, wide, high, THREE.RGBAFormat);
    Object.assign(this.slice.material.map, { magFilter: THREE.LinearFilter, minFilter: THREE.LinearFilter });
    this.slice.material.needsUpdate = true;
    this.place();
  }

  /** Returns where the slice is along its axis [m]. */
  get position() {
    return this.plane ? 0 : this.flow.first[this.axis] + this.layer * this.flow.spacing[this.axis];
  }

  /** Returns the corners of the rectangle that a box, given by two corners, cuts out of the slice's plane. */
  corners(box) {
    const [one, other] = this.sides;
    return [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ].map(([u, v]) => {
      const point = [0, 0, 0];
      point[this.axis] = this.position;
      point[one] = box[u][one];
      point[other] = box[v][other];
      return point;
    });
  }

  /** Makes the rectangle. */
  place() {
    const { first, spacing } = this.flow;
    const lower = first.map((low, axis) => low - spacing[axis] / 2);
    const upper = lower.map((low, axis) => low + this.cells[axis] * spacing[axis]);
    const corners = this.corners([lower, upper]);
    this.slice.geometry.dispose();
    this.slice.geometry = this.solid.geometry = geometryOf(
      { position: [corners.flat(), 3], uv: [[0, 0, 1, 0, 1, 1, 0, 1], 2] },
      [0, 1, 2, 0, 2, 3],
    );
  }

  /** Shows the field of the frame that is nearest. */
  show(frame, share) {
    const kept = Math.min(this.flow.frames - 1, Math.round((frame + share) / this.flow.apart));
    const numbers = this.numbers[this.field.name];
    const [wide, high] = this.sides.map((side) => this.cells[side]);
    const strides = [1, this.cells[0], this.cells[0] * this.cells[1]];
    const start = kept * this.cells[0] * this.cells[1] * this.cells[2] + this.layer * strides[this.axis];
    for (let row = 0; row < high; row++) {
      for (let column = 0; column < wide; column++) {
        const cell = start + column * strides[this.sides[0]] + row * strides[this.sides[1]];
        const place = 4 * (row * wide + column);
        putColour(this.colours, numbers[cell] / MOST, this.picture, place, 255);
        this.picture[place + 3] = this.distance[cell];
      }
    }
    this.slice.material.map.needsUpdate = true;
  }

  get colours() {
    return this.scales[this.field.signed ? "signed" : "flow"];
  }

  recolour() {
    this.solid.material.color.set(styleValue("--solid"));
  }
}
