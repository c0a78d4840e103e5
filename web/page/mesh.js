// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Meshes: {positions, normals, uvs, indices}, within about one unit of the origin, y up.

/** A surface over the unit square, `columns` by `rows` quads; `point(u, v)` gives [x, y, z]. */
function surface(columns, rows, point) {
  const positions = [];
  const normals = [];
  const uvs = [];
  const indices = [];
  const step = 1e-3;
  for (let row = 0; row <= rows; ++row) {
    for (let column = 0; column <= columns; ++column) {
      const [u, v] = [column / columns, row / rows];
      const here = point(u, v);
      const along = point(u + step, v).map((x, i) => x - point(u - step, v)[i]);
      const across = point(u, v + step).map((x, i) => x - point(u, v - step)[i]);
      const normal = [
        across[1] * along[2] - across[2] * along[1],
        across[2] * along[0] - across[0] * along[2],
        across[0] * along[1] - across[1] * along[0],
      ];
      const length = Math.hypot(...normal) || 1;
      positions.push(...here);
      normals.push(...normal.map((x) => x / length));
      uvs.push(u, v);
      if (column === columns || row === rows) continue;
      const first = row * (columns + 1) + column;
      const below = first + columns + 1;
      indices.push(first, first + 1, below, first + 1, below + 1, below);
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    indices: new Uint16Array(indices),
  };
}

const TURN = 2 * Math.PI;

const knot = (u) => {
  const angle = u * TURN;
  const radius = 0.62 + 0.24 * Math.cos(3 * angle);
  return [radius * Math.cos(2 * angle), 0.3 * Math.sin(3 * angle), radius * Math.sin(2 * angle)];
};

/** A tube along `knot`. */
function tube(u, v) {
  const here = knot(u);
  const ahead = knot(u + 1e-4).map((x, i) => x - here[i]);
  const side = [ahead[2], 0, -ahead[0]];
  const sideLength = Math.hypot(...side);
  const up = [-ahead[1] * ahead[0], ahead[0] * ahead[0] + ahead[2] * ahead[2], -ahead[1] * ahead[2]];
  const upLength = Math.hypot(...up);
  const [c, s] = [0.17 * Math.cos(-v * TURN), 0.17 * Math.sin(-v * TURN)];
  return here.map((x, i) => x + (c * side[i]) / sideLength + (s * up[i]) / upLength);
}

export const MESHES = {
  Knot: () => surface(240, 24, tube),
  Torus: () =>
    surface(96, 48, (u, v) => {
      const radius = 0.7 + 0.3 * Math.cos(v * TURN);
      return [radius * Math.cos(u * TURN), 0.3 * Math.sin(v * TURN), radius * Math.sin(u * TURN)];
    }),
  Sphere: () =>
    surface(64, 32, (u, v) => {
      const radius = Math.sin(v * Math.PI);
      return [radius * Math.cos(u * TURN), -Math.cos(v * Math.PI), radius * Math.sin(u * TURN)];
    }),
  Terrain: () =>
    surface(100, 100, (u, v) => {
      const [x, z] = [2.4 * (u - 0.5), 2.4 * (v - 0.5)];
      const y = 0.25 * Math.sin(4 * x) * Math.cos(3 * z) + 0.08 * Math.sin(11 * x + 2 * z) + 0.04 * Math.cos(17 * z - x);
      return [x, y, -z];
    }),
};
