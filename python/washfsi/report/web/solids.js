// SPDX-License-Identifier: BSD-3-Clause
// The bodies of the playback: surfaces that move as rigid bodies.

const MOTION = 12; // numbers of a frame: rotation by rows, displacement

/** Returns turn and place of a body in each frame. */
function posesOf(motion) {
  const poses = [];
  for (let start = 0; start < motion.length; start += MOTION) {
    const [a, b, c, d, e, f, g, h, i, x, y, z] = motion.subarray(start, start + MOTION);
    const turn = new THREE.Quaternion().setFromRotationMatrix(
      new THREE.Matrix4().set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1),
    );
    poses.push({ turn, place: new THREE.Vector3(x, y, z) });
  }
  return poses;
}

/** Returns how a body is shown: one round the water by its far side alone, which can be seen through. */
function solidMaterial(solid) {
  if (solid.corners === 2) return new THREE.LineBasicMaterial();
  const through = solid.surrounds
    ? { transparent: true, opacity: 0.28, depthWrite: false, side: THREE.FrontSide }
    : { side: THREE.DoubleSide };
  return new THREE.MeshPhongMaterial({ shininess: 12, ...through });
}

/** A body. */
class Solid {
  constructor(solid, arrays) {
    const geometry = geometryOf({ position: [arrays(solid.vertices), 3] }, arrays(solid.facets));
    if (solid.corners === 3) geometry.computeVertexNormals();
    this.name = solid.name;
    this.poses = posesOf(arrays(solid.motion));
    this.object = new (solid.corners === 2 ? THREE.LineSegments : THREE.Mesh)(geometry, solidMaterial(solid));
    this.object.renderOrder = solid.surrounds ? -1 : 0;
    this.recolour();
  }

  /** Moves it to between two frames. */
  show(frame, share) {
    const [now, next] = [this.poses[frame], this.poses[Math.min(frame + 1, this.poses.length - 1)]];
    THREE.Quaternion.slerp(now.turn, next.turn, this.object.quaternion, share);
    this.object.position.lerpVectors(now.place, next.place, share);
  }

  recolour() {
    this.object.material.color.set(styleValue(this.object.isLineSegments ? "--edge" : "--solid"));
  }
}
