// SPDX-License-Identifier: BSD-3-Clause
// Where a camera has to stand for its picture to be just filled.

const MARGIN = 0.05; // share of the picture that is free at each side

/** Returns the product of two vectors. */
function dot(one, other) {
  return one.reduce((sum, part, axis) => sum + part * other[axis], 0);
}

/**
 * Returns where a camera stands nearest to some points and still sees them all, as [right, up, ahead] along its axes, which
 * are given as vectors. `slopes` are the tangents of half the angles that it sees, to the right and up.
 *
 * From x, z it sees a point p if |p_x - x| <= s (p_z - z), which are two limits:
 *   x - s z >= a = max(p_x - s p_z)   and   -x - s z >= b = max(-p_x - s p_z).
 * Both are met with equality by x = (a - b)/2 and z = -(a + b)/(2 s), and by the same x farther back. The same holds for y; the
 * camera stands where the farther back of the two needs it.
 */
function fittedPlace(points, axes, slopes) {
  const ahead = points.map((point) => dot(point, axes[2]));
  const [across, up] = slopes.map((slope, axis) => {
    const free = (1 - 2 * MARGIN) * slope;
    const aside = points.map((point) => dot(point, axes[axis]));
    const a = Math.max(...aside.map((side, place) => side - free * ahead[place]));
    const b = Math.max(...aside.map((side, place) => -side - free * ahead[place]));
    return { middle: (a - b) / 2, depth: -(a + b) / (2 * free) };
  });
  return [across.middle, up.middle, Math.min(across.depth, up.depth)];
}
