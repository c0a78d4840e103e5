// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Matrices as Direct3D has them: 16 numbers in rows, points are rows, the translation is the last row.

export const multiply = (a, b) =>
  a.map((_, at) => {
    const [row, column] = [at - (at % 4), at % 4];
    return (
      a[row] * b[column] +
      a[row + 1] * b[4 + column] +
      a[row + 2] * b[8 + column] +
      a[row + 3] * b[12 + column]
    );
  });

/** A point times a matrix. */
export const transformed = (point, m) =>
  [0, 1, 2, 3].map((column) => point.reduce((sum, x, row) => sum + x * m[4 * row + column], 0));

export const transpose = (m) => m.map((_, at) => m[(at % 4) * 4 + (at >> 2)]);

export const translation = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const normalize = (a) => a.map((x) => x / Math.hypot(...a));

/** The view from `eye` to `target`, right-handed, y up. */
export function lookAt(eye, target) {
  const back = normalize(eye.map((x, i) => x - target[i]));
  const right = normalize(cross([0, 1, 0], back));
  const up = cross(back, right);
  const axes = [0, 1, 2].flatMap((i) => [right[i], up[i], back[i], 0]);
  return [...axes, -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
}

/** A perspective whose depth is 0 at `near` and 1 at `far`, or the other way round. */
export function perspective(fieldOfView, aspect, near, far, isReversed) {
  const y = 1 / Math.tan(fieldOfView / 2);
  const [a, b] = isReversed
    ? [near / (far - near), (near * far) / (far - near)]
    : [far / (near - far), (near * far) / (near - far)];
  return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, a, -1, 0, 0, b, 0];
}

/** The turn by `angle` about y. */
export function rotationY(angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1];
}

/** The product as an application makes it of floats: each operation is rounded. */
export const multiplyFloats = (a, b) =>
  a.map((_, at) => {
    const [row, column] = [at - (at % 4), at % 4];
    let sum = 0;
    for (let i = 0; i < 4; ++i)
      sum = Math.fround(sum + Math.fround(a[row + i] * b[4 * i + column]));
    return sum;
  });

/** The plane before `matrix`, given the plane after it. */
export const planeBefore = (matrix, plane) =>
  [0, 4, 8, 12].map((row) => plane.reduce((sum, x, i) => sum + matrix[row + i] * x, 0));

/** A plane of the world in the space of a view, which turns and moves only. */
export function planeInView(plane, view) {
  const normal = [0, 1, 2].map(
    (i) => plane[0] * view[i] + plane[1] * view[4 + i] + plane[2] * view[8 + i],
  );
  return [...normal, plane[3] - normal[0] * view[12] - normal[1] * view[13] - normal[2] * view[14]];
}
