// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Meshes: {positions, normals, uvs, indices}, within about one unit of the origin, y up.
import { cross } from './matrices.js';

/** `mesh` with its vertices moved by `offset` along x, as floats. */
export const baked = (mesh, offset) =>
  offset
    ? {
        ...mesh,
        edges: mesh.edges,
        positions: mesh.positions.map((x, i) => (i % 3 ? x : x + offset)),
      }
    : mesh;

/** Surfaces over the unit square, each [columns, rows, point]: so many quads, and `point(u, v)` gives [x, y, z]. */
function surfaces(...parts) {
  const positions = [];
  const normals = [];
  const uvs = [];
  const indices = [];
  const step = 1e-3;
  for (const [columns, rows, point] of parts) {
    const base = positions.length / 3;
    for (let row = 0; row <= rows; ++row) {
      for (let column = 0; column <= columns; ++column) {
        const [u, v] = [column / columns, row / rows];
        const along = point(u + step, v).map((x, i) => x - point(u - step, v)[i]);
        const across = point(u, v + step).map((x, i) => x - point(u, v - step)[i]);
        const normal = [
          across[1] * along[2] - across[2] * along[1],
          across[2] * along[0] - across[0] * along[2],
          across[0] * along[1] - across[1] * along[0],
        ];
        const length = Math.hypot(...normal) || 1;
        positions.push(...point(u, v));
        normals.push(...normal.map((x) => x / length));
        uvs.push(u, v);
        if (column === columns || row === rows) continue;
        const first = base + row * (columns + 1) + column;
        const below = first + columns + 1;
        indices.push(first, first + 1, below, first + 1, below + 1, below);
      }
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    indices: new Uint32Array(indices),
  };
}

const TURN = 2 * Math.PI;

const knot = (u) => {
  const angle = u * TURN;
  const radius = 0.62 + 0.24 * Math.cos(3 * angle);
  return [radius * Math.cos(2 * angle), 0.3 * Math.sin(3 * angle), radius * Math.sin(2 * angle)];
};

/** A tube along the curve `center`, which nowhere goes along `axis`. */
const tube = (center, radius, axis) => (u, v) => {
  const here = center(u);
  const ahead = center(u + 1e-4).map((x, i) => x - here[i]);
  const side = cross(axis, ahead);
  const up = cross(ahead, side);
  const c = (radius(u) * Math.cos(-v * TURN)) / Math.hypot(...side);
  const s = (radius(u) * Math.sin(-v * TURN)) / Math.hypot(...up);
  return here.map((x, i) => x + c * side[i] + s * up[i]);
};

/** A teapot as tools/harness/mesh.cpp has it, smaller: body, knob, spout and handle. */
function teapot() {
  const turned = (radius, height) => (u, v) => {
    const angle = Math.PI * (0.0005 + 0.999 * v);
    const turn = -u * TURN;
    return [radius(angle) * Math.cos(turn), height(angle), radius(angle) * Math.sin(turn)];
  };
  const spout = (u) => [0.85 + 0.75 * u, -0.25 + 0.75 * u * u, 0];
  const handle = (u) => [
    -0.78 + 0.67 * Math.cos(Math.PI * (0.5 + u)),
    0.05 + 0.42 * Math.sin(Math.PI * (0.5 + u)),
    0,
  ];
  const small = (point) => (u, v) => point(u, v).map((x) => 0.75 * x);
  return surfaces(
    [
      96,
      48,
      small(
        turned(
          (a) => Math.sin(a) * (1 - 0.15 * Math.cos(a)),
          (a) => -0.75 * Math.cos(a),
        ),
      ),
    ],
    [
      32,
      16,
      small(
        turned(
          (a) => 0.13 * Math.sin(a),
          (a) => 0.87 - 0.13 * Math.cos(a),
        ),
      ),
    ],
    [32, 24, small(tube(spout, (u) => 0.24 - 0.14 * u, [0, 0, 1]))],
    [48, 24, small(tube(handle, () => 0.09, [0, 0, 1]))],
  );
}

export const MESHES = {
  Teapot: teapot,
  Knot: () => surfaces([240, 24, tube(knot, () => 0.17, [0, 1, 0])]),
  Torus: () =>
    surfaces([
      96,
      48,
      (u, v) => {
        const radius = 0.7 + 0.3 * Math.cos(v * TURN);
        return [radius * Math.cos(u * TURN), 0.3 * Math.sin(v * TURN), radius * Math.sin(u * TURN)];
      },
    ]),
  Sphere: () =>
    surfaces([
      64,
      32,
      (u, v) => {
        const radius = Math.sin(v * Math.PI);
        return [radius * Math.cos(u * TURN), -Math.cos(v * Math.PI), radius * Math.sin(u * TURN)];
      },
    ]),
  Terrain: () =>
    surfaces([
      100,
      100,
      (u, v) => {
        const [x, z] = [2.4 * (u - 0.5), 2.4 * (v - 0.5)];
        const y =
          0.25 * Math.sin(4 * x) * Math.cos(3 * z) +
          0.08 * Math.sin(11 * x + 2 * z) +
          0.04 * Math.cos(17 * z - x);
        return [x, y, -z];
      },
    ]),
};
