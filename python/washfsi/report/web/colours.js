// SPDX-License-Identifier: BSD-3-Clause
// Scales of colour, told apart by all eyes: their lightness grows with the number.

const OUTWARD = [
  [1, 0],
  [0.62, 0],
  [0.7, 0.3],
  [0.45, 0],
]; // factor and share of white, for cloths beyond the seven colours

/** Writes the colour of a share from 0 to 1 into an array, as three numbers from 0 to `full`. */
function putColour(scale, share, target, place, full) {
  const colour = scale[Math.round(Math.min(1, Math.max(0, share)) * (scale.length - 1))];
  for (let part = 0; part < 3; part++) target[place + part] = (colour[part] * full) / 255;
}

/** Returns a scale as a gradient of the style sheet. */
function gradientOf(scale) {
  return `linear-gradient(90deg, ${scale.map((colour) => `rgb(${colour.join(",")})`).join(",")})`;
}

/** Returns the colour of a cloth by its number, as three numbers from 0 to 1. */
function clothColour(number) {
  const base = new THREE.Color(seriesColour(number));
  const [factor, white] = OUTWARD[Math.floor(number / 7) % OUTWARD.length];
  return base
    .multiplyScalar(factor)
    .lerp(new THREE.Color(1, 1, 1), white)
    .toArray();
}
