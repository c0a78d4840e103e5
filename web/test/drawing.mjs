// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The mesh and the numbers of test draws, in pages and in node.
export const SIZE = 64; // pixels, of both sides of the image
const CELLS = 4;

/** The corners of triangles that cover the image: [x, y]. */
export const corners = [];
for (let row = 0; row < CELLS; ++row) {
  for (let column = 0; column < CELLS; ++column) {
    for (const [x, y] of [
      [0, 0],
      [1, 0],
      [0, 1],
      [0, 1],
      [1, 0],
      [1, 1],
    ])
      corners.push([(2 * (column + x)) / CELLS - 1, (2 * (row + y)) / CELLS - 1]);
  }
}

/** Random numbers from 0 to 1, the same for equal texts. */
export function random(text) {
  let state = 2166136261;
  for (const letter of text) state = Math.imul(state ^ letter.codePointAt(0), 16777619);
  return () => {
    state = (Math.imul(state ^ (state >>> 15), 0x2c1b3c6d) + 0x9e3779b9) | 0;
    const mixed = Math.imul(state ^ (state >>> 12), 0x297a2d39);
    return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 32;
  };
}

/** A linked program; throws what is wrong with the texts. */
export function link(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
      throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program));
  return program;
}

/** Floats as JSON can say them: it has no NaN. */
export const forJson = (floats) => Array.from(floats, (x) => (Number.isFinite(x) ? x : String(x)));

/** Pixels whose colors are further apart than `share` of their size. */
export function differing(a, b, share = 1e-3) {
  const isNear = (x, y) =>
    x === y ||
    String(x) === String(y) ||
    Math.abs(x - y) <= share * Math.max(1, Math.abs(x), Math.abs(y));
  let count = 0;
  for (let i = 0; i < a.length; i += 4)
    count += [0, 1, 2, 3].some((part) => !isNear(a[i + part], b[i + part]));
  return count;
}
