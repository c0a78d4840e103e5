// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Matrices as Direct3D has them: 16 numbers in rows, points are rows, the translation is the last row.

export const multiply = (a, b) =>
  a.map((_, at) => {
    const [row, column] = [at - (at % 4), at % 4];
    return a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column] + a[row + 3] * b[12 + column];
  });

export const transpose = (m) => m.map((_, at) => m[(at % 4) * 4 + (at >> 2)]);

export const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export const translation = (x, y, z) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
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
  const [a, b] = isReversed ? [near / (far - near), (near * far) / (far - near)] : [far / (near - far), (near * far) / (near - far)];
  return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, a, -1, 0, 0, b, 0];
}
