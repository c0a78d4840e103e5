// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Where planes cut a mesh, in double: what a shader's float arithmetic is held against.
import { multiply, planeBefore } from './matrices.js';
import { MOST_PLACES } from './runtime.js';

const LEAST_SINE = 0.05; // edges nearer to the plane's direction are left out, as in the study
const NEARER = 0.995; // lines are drawn so much nearer to the eye than the surface

/** The edges of a mesh's triangles, once each: two indices after the other. */
export function edgesOf(mesh) {
  if (mesh.edges) return mesh.edges;
  const count = mesh.positions.length / 3;
  const keys = new Set();
  for (let i = 0; i < mesh.indices.length; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [mesh.indices[i + k], mesh.indices[i + ((k + 1) % 3)]];
      keys.add(a < b ? a * count + b : b * count + a);
    }
  }
  mesh.edges = new Uint32Array(2 * keys.size);
  let at = 0;
  for (const key of keys) {
    mesh.edges[at++] = Math.floor(key / count);
    mesh.edges[at++] = key % count;
  }
  return mesh.edges;
}

/** The vertices of a mesh under the scene's matrices. */
export class Reference {
  /** `cutting`: the indices of the scene's planes that cut. */
  constructor(mesh, scene, cutting) {
    this.mesh = mesh;
    this.scene = scene;
    this.toClip = multiply(multiply(scene.world, scene.view), scene.projection);
    const { positions } = mesh;
    const vertices = positions.length / 3;
    this.clip = new Float64Array(4 * vertices);
    this.planes = cutting.map((index) => planeBefore(scene.world, scene.planes[index]));
    this.distances = this.planes.map(() => new Float64Array(vertices));
    const m = this.toClip;
    for (let i = 0; i < vertices; ++i) {
      const [x, y, z] = [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];
      for (let c = 0; c < 4; ++c)
        this.clip[4 * i + c] = x * m[c] + y * m[4 + c] + z * m[8 + c] + m[12 + c];
      this.planes.forEach(
        (plane, p) =>
          (this.distances[p][i] = x * plane[0] + y * plane[1] + z * plane[2] + plane[3]),
      );
    }
  }

  /** The point of the clip space at `share` of the way from vertex a to vertex b. */
  at(a, b, share) {
    return [0, 1, 2, 3].map(
      (c) => this.clip[4 * a + c] + share * (this.clip[4 * b + c] - this.clip[4 * a + c]),
    );
  }

  /** The edges that plane `index` cuts in the image, at an angle that can be measured: {a, b, share}. */
  cutEdges(index) {
    const edges = edgesOf(this.mesh);
    const { positions } = this.mesh;
    const d = this.distances[index];
    const slope = Math.hypot(...this.planes[index].slice(0, 3));
    const cut = [];
    for (let i = 0; i < edges.length; i += 2) {
      const [a, b] = [edges[i], edges[i + 1]];
      if (d[a] < 0 === d[b] < 0) continue;
      const length = Math.hypot(
        ...[0, 1, 2].map((c) => positions[3 * a + c] - positions[3 * b + c]),
      );
      if (Math.abs(d[a] - d[b]) < LEAST_SINE * slope * length) continue;
      const share = d[a] / (d[a] - d[b]);
      const [x, y, z, w] = this.at(a, b, share);
      if (w > 0 && Math.abs(x) <= w && Math.abs(y) <= w && z >= 0 && z <= w)
        cut.push({ a, b, share });
    }
    return cut;
  }

  /** Whether the shader takes the mesh where the scene has it. `captured`: Capture.run(). */
  holds({ values, stride }) {
    for (let i = 0; 4 * i < this.clip.length; i += 97) {
      const [x, y, , w] = this.clip.subarray(4 * i, 4 * i + 4);
      const [atX, atY, , atW] = values.subarray(stride * i, stride * i + 4);
      const off = Math.max(Math.abs(x - atX), Math.abs(y - atY), Math.abs(w - atW));
      if (!(off <= 0.1 * Math.max(Math.abs(x), Math.abs(y), Math.abs(w)))) return false;
    }
    return true;
  }

  /**
   * What of a cut the prediction takes: {places, edge}, with x, y and z of places in the mesh's own space, and the length of the
   * triangles' edges in half images. `cut`: cutEdges(); null where it is empty.
   */
  seenCut(cut) {
    if (!cut.length) return null;
    const { positions } = this.mesh;
    const count = Math.min(cut.length, MOST_PLACES);
    const places = Array.from(
      { length: count },
      (_, i) => cut[Math.floor((i * cut.length) / count)],
    ).flatMap(({ a, b, share }) =>
      [0, 1, 2].map(
        (c) => positions[3 * a + c] + share * (positions[3 * b + c] - positions[3 * a + c]),
      ),
    );
    const aspect = this.scene.projection[5] / this.scene.projection[0];
    const lengths = cut.flatMap(({ a, b }) => {
      const [[px, py, , pw], [qx, qy, , qw]] = [this.at(a, a, 0), this.at(b, b, 0)];
      return pw > 0 && qw > 0 ? [Math.hypot(aspect * (px / pw - qx / qw), py / pw - qy / qw)] : [];
    });
    return {
      places,
      edge: lengths.length ? lengths.reduce((sum, x) => sum + x, 0) / lengths.length : 1,
    };
  }

  /** The cut as lines over the surface: pairs of points of the clip space from -w to w. */
  lines() {
    const { indices } = this.mesh;
    const lines = [];
    const row = this.scene.projection.slice(12);
    const add = (a, b, d) => {
      const point = this.at(a, b, d[a] / (d[a] - d[b])).map(
        (x, c) => NEARER * x + (1 - NEARER) * row[c],
      );
      lines.push(point[0], point[1], 2 * point[2] - point[3], point[3]);
    };
    this.distances.forEach((d, index) => {
      for (let i = 0; i < indices.length; i += 3) {
        const corners = [indices[i], indices[i + 1], indices[i + 2]];
        const kept = corners.map((corner) => d[corner] >= 0);
        if (kept[0] === kept[1] && kept[1] === kept[2]) continue;
        if (
          this.distances.some(
            (other, at) => at !== index && corners.every((corner) => other[corner] < 0),
          )
        )
          continue;
        for (let k = 0; k < 3; ++k)
          if (kept[k] !== kept[(k + 1) % 3]) add(corners[k], corners[(k + 1) % 3], d);
      }
    });
    return new Float32Array(lines);
  }
}
