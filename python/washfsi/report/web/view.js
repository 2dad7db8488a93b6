// SPDX-License-Identifier: BSD-3-Clause
// The window into space: camera, lights, and turning it with mouse or finger. It draws only when something has changed.

const DIRECTIONS = { "3d": [0.42, -1.05, 0.72], top: [0, -0.001, 1], front: [0, -1, 0.001], side: [1, 0, 0.001] };
const ANGLE = 30; // of the camera [degrees]

/** Returns what draws in space, null where nothing does. */
function drawerName() {
  const context = document.createElement("canvas").getContext("webgl");
  if (!context) return null;
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const name = context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return name;
}

/** A view of a box. `seen` returns the points that it has to show. */
class View {
  constructor(frame, lower, upper, seen) {
    this.frame = frame;
    this.seen = seen;
    const three = (corner) => new THREE.Vector3(...corner, ...(corner.length === 2 ? [0] : []));
    [this.lower, this.upper] = [three(lower), three(upper)];
    this.size = this.upper.distanceTo(this.lower);
    const soft = /SwiftShader|llvmpipe|software/i.test(drawerName()); // without a graphics processor
    this.renderer = new THREE.WebGLRenderer({ antialias: !soft });
    this.renderer.setPixelRatio(soft ? 1 : Math.min(window.devicePixelRatio, 2));
    frame.append(this.renderer.domElement);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(ANGLE);
    this.camera.up.set(0, 0, 1);
    this.light();
    this.outline();
    this.control();
    this.watcher = new ResizeObserver(() => this.resize());
    this.watcher.observe(frame);
  }

  /** Lights from all sides and from behind the reader's left shoulder. */
  light() {
    const lamp = new THREE.DirectionalLight(0xffffff, 0.55);
    lamp.position.set(-0.5, 0.7, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera, this.sky());
  }

  sky() {
    const sky = new THREE.HemisphereLight(0xffffff, 0xb0b0b0, 0.72);
    sky.position.set(0, 0, 1);
    return sky;
  }

  /** Draws the edges of the box. */
  outline() {
    const box = new THREE.Box3(this.lower, this.upper);
    this.box = new THREE.Box3Helper(box);
    this.scene.add(this.box);
  }

  /** Lets mouse and fingers turn and move. The wheel zooms once the view is clicked: the page scrolls past it. */
  control() {
    const canvas = this.renderer.domElement;
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.screenSpacePanning = true;
    this.controls.enableZoom = false;
    this.controls.enableKeys = false;
    this.controls.addEventListener("change", () => this.ask());
    canvas.addEventListener("pointerdown", () => {
      this.touched = this.controls.enableZoom = true;
    });
    this.frame.addEventListener("pointerleave", () => {
      this.controls.enableZoom = false;
    });
  }

  /** Looks from a direction, so that what has to be seen fills the picture. */
  look(name) {
    const ahead = new THREE.Vector3(...DIRECTIONS[name]).normalize().negate();
    const right = ahead.clone().cross(this.camera.up).normalize();
    const axes = [right, right.clone().cross(ahead), ahead];
    const slope = Math.tan(((ANGLE / 2) * Math.PI) / 180);
    const points = this.seen();
    const place = fittedPlace(
      points,
      axes.map((axis) => axis.toArray()),
      [slope * this.camera.aspect, slope],
    );
    this.from = name;
    this.camera.position.set(...place).applyMatrix4(new THREE.Matrix4().makeBasis(...axes));
    this.turnAbout(points, ahead);
    this.ask();
  }

  /** Makes the camera turn about a place straight ahead, as far away as the middle of some points. */
  turnAbout(points, ahead) {
    const box = new THREE.Box3().setFromPoints(points.map((point) => new THREE.Vector3(...point)));
    const distance = box.getCenter(new THREE.Vector3()).sub(this.camera.position).dot(ahead);
    [this.camera.near, this.camera.far] = [distance / 200, distance + 20 * this.size];
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(this.camera.position).addScaledVector(ahead, distance);
    this.controls.update();
  }

  /** Goes nearer or farther. */
  zoom(factor) {
    this.camera.position
      .sub(this.controls.target)
      .multiplyScalar(1 / factor)
      .add(this.controls.target);
    this.controls.update();
    this.ask();
  }

  resize() {
    const { clientWidth, clientHeight } = this.frame;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (!this.touched) this.look(this.from);
    this.ask();
  }

  /** Asks for a picture with the next one of the screen. */
  ask() {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = null;
      this.renderer.render(this.scene, this.camera);
    });
  }

  recolour() {
    this.scene.background = new THREE.Color(styleValue("--stage"));
    this.box.material.color.set(styleValue("--faint"));
    this.ask();
  }

  destroy() {
    cancelAnimationFrame(this.asked);
    this.watcher.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
