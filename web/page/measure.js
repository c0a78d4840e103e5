// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The displacement of a cut in pixels, and how it flickers: distances that the GPU computed against the reference in double. The
// definitions are those of the study, study/edges.h and flicker.h.
import { Reference } from './reference.js';

export const FRAMES = 8;
export const PAN = 0.003; // radians a frame

const MOST_WHOLE = 0.01; // of the edges: with more, the 99th percentile is known as "or more" only

/** Whether the distances of both ends are on one side, so that all of the edge is kept or dropped. */
const isWhole = (a, b) => a >= 0 === b >= 0;

/** The share of an edge at which distances cut it; the end that is left over where they keep or drop all of it. */
function cutShare(a, b, isAKept) {
  if (!isWhole(a, b)) return a / (a - b);
  return a >= 0 === isAKept ? 1 : 0;
}

function pixelsBetween(p, q, width, height) {
  const x = (p[0] / p[3] - q[0] / q[3]) * 0.5 * width;
  const y = (p[1] / p[3] - q[1] / q[3]) * 0.5 * height;
  return Math.hypot(x, y);
}

function summary(pixels) {
  const sorted = pixels.filter((x) => !Number.isNaN(x)).sort((a, b) => a - b);
  if (!sorted.length) return null;
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))];
  return { count: sorted.length, median: at(0.5), p99: at(0.99), largest: sorted.at(-1) };
}

/**
 * Measures one result of the lowering `discard`, whose planes are those of the scene with the indices `cutting`.
 * `constantsOf(matrices)` fills its constants, `matricesAt(pan)` are the scene's.
 * @returns {{displacement, most, isLeast, flicker, cuts}} or null where nothing is cut, or the shader moves vertices by itself. `most`
 * is the displacement if every edge were kept or dropped as a whole, the most that a mesh shows; `isLeast` says that many are, so that
 * vertices farther from the cut may be on the wrong side too. `cuts` as Reference.seenCut() has them, for each plane
 */
export function measure(capture, mesh, cutting, matricesAt, constantsOf, { width, height }) {
  let edges = null;
  let cuts = null;
  let before = null;
  const displaced = [];
  const possible = [];
  const moved = [];
  let whole = 0;
  for (let frame = 0; frame < FRAMES; ++frame) {
    const matrices = matricesAt(frame * PAN);
    const reference = new Reference(mesh, matrices, cutting);
    const captured = capture.run(constantsOf(matrices));
    if (!edges) {
      if (captured.planes < cutting.length || !reference.holds(captured)) return null;
      edges = cutting.map((_, index) => reference.cutEdges(index));
      if (!edges.some((list) => list.length)) return null;
      cuts = edges.map((list) => reference.seenCut(list));
    }
    const now = edges.map((list, index) =>
      list.map(({ a, b }) => {
        const distance = (vertex) => captured.values[captured.stride * vertex + 4 + index];
        if (!before && isWhole(distance(a), distance(b))) ++whole;
        return cutShare(distance(a), distance(b), reference.distances[index][a] >= 0);
      }),
    );
    edges.forEach((list, index) =>
      list.forEach(({ a, b, share }, i) => {
        const seen = reference.at(a, b, now[index][i]);
        const pixelsTo = (place) => pixelsBetween(reference.at(a, b, place), seen, width, height);
        if (before) return moved.push(pixelsTo(before[index][i]));
        displaced.push(pixelsTo(share));
        const exact = reference.at(a, b, share);
        const pixelsToEnds = [0, 1].map((end) =>
          pixelsBetween(reference.at(a, b, end), exact, width, height),
        );
        possible.push(Math.max(...pixelsToEnds));
      }),
    );
    before = now;
  }
  const displacement = summary(displaced);
  if (!displacement) return null;
  return {
    displacement,
    most: summary(possible).p99,
    isLeast: whole > MOST_WHOLE * displaced.length,
    flicker: summary(moved),
    cuts,
  };
}
