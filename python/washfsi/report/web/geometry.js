// SPDX-License-Identifier: BSD-3-Clause
// Surfaces and lines of three.js.

/**
 * Returns a surface or lines of three.js: attributes by name, each with how many numbers a vertex has, and the vertices
 * joined.
 */
function geometryOf(attributes, joined) {
  const geometry = new THREE.BufferGeometry();
  for (const [name, [numbers, width]] of Object.entries(attributes)) {
    geometry.setAttribute(
      name,
      numbers.isBufferAttribute ? numbers : new THREE.BufferAttribute(Float32Array.from(numbers), width),
    );
  }
  geometry.setIndex(joined.buffer ? new THREE.BufferAttribute(joined, 1) : joined);
  return geometry;
}

/** Returns numbers behind each other as points of three. */
function triplesOf(numbers) {
  return Array.from({ length: numbers.length / 3 }, (_, place) => [...numbers.subarray(3 * place, 3 * place + 3)]);
}
