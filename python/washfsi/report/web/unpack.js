// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a run out of its compressed text.

const KINDS = { f4: Float32Array, u1: Uint8Array, u2: Uint16Array, u4: Uint32Array };

/** Returns the bytes of a text in base64. */
function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let place = 0; place < letters.length; place++) bytes[place] = letters.charCodeAt(place);
  return bytes;
}

/** Returns a function that gives the array at a place of a pack. */
async function unpacked(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  const buffer = await new Response(stream).arrayBuffer();
  return (place) => new KINDS[place.kind](buffer, place.start, place.count);
}

/** Returns the numbers that stand for what is packed between two limits. */
function unscaled(array, place) {
  const step = (place.high - place.low) / place.most;
  return Float32Array.from(array, (whole) => place.low + step * whole);
}
