// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Plane constants and predictions by clipc's runtime, which is in the same module as the compiler: runtime/clipc_runtime.h.
import { Instance } from 'clipc/compiler.js';

import { planeInView } from './matrices.js';
import { module } from './module.js';

export const SPACES = ['clip', 'xyw1', 'object'];
const KNOWN_IN_WORLD = 1;
const MOST_PIXELS = 0.5;
export const MOST_PLACES = 256; // of a cut, that clipc_cut_error counts
const ORDERS = [0, 0, 1, 3]; // clipc_matrix_order of so many matrices
const FLOAT_WORLD_VIEW = 4;
const KEEP_FAR = 1;
const REVERSED = 2;

export async function loadRuntime() {
  return new Runtime(new Instance(await module, null, () => null));
}

class Runtime {
  #instance;
  #at;

  constructor(instance) {
    this.#instance = instance;
    const { exports } = instance;
    exports._initialize();
    const place = (size) => exports.clipc_module_allocate(size);
    this.#at = {
      plane: place(16),
      matrices: [64, 64, 64].map(place),
      draw: place(16),
      result: place(232),
      message: place(200),
      places: place(24 * MOST_PLACES),
    };
  }

  #put(address, values) {
    new Float32Array(this.#instance.exports.memory.buffer, address, values.length).set(values);
  }

  /** Puts a clipc_draw_matrices. `steps`: the reflection's positionMatrices, of which two are world and view-projection. */
  #putDraw({ world, view, projection, isFloat }, steps) {
    const { matrices, draw } = this.#at;
    [world, view, projection].forEach((matrix, i) => this.#put(matrices[i], matrix));
    const order = isFloat && steps === 1 ? FLOAT_WORLD_VIEW : ORDERS[Math.min(steps, 3)];
    new Uint32Array(this.#instance.exports.memory.buffer, draw, 4).set([...matrices, order]);
  }

  /** {constant, warning} for a plane of the world; or {problem}. */
  constant(space, worldPlane, scene, steps, rows) {
    const { exports } = this.#instance;
    const { plane, draw, result, message } = this.#at;
    this.#put(plane, worldPlane);
    this.#putDraw(scene, steps);
    const error = exports.clipc_plane_constant(
      SPACES.indexOf(space),
      plane,
      KNOWN_IN_WORLD,
      draw,
      rows,
      MOST_PIXELS,
      result,
      message,
    );
    if (error) return { problem: this.#instance.textAt(message), constant: [0, 0, 0, 1] };
    const bytes = new DataView(exports.memory.buffer, result);
    return {
      constant: [0, 4, 8, 12].map((at) => bytes.getFloat32(at, true)),
      warning: bytes.getUint32(24, true) ? this.#instance.textAt(result + 28) : '',
    };
  }

  /** The same for the lowering `near-plane`, whose shader writes the constant's value as depth. */
  nearPlaneConstant(space, worldPlane, scene, steps, rows) {
    const { exports } = this.#instance;
    const { plane, matrices, result, message } = this.#at;
    const { constant, problem } = this.constant(space, worldPlane, scene, steps, rows);
    if (problem) return { constant, problem };
    this.#put(plane, planeInView(worldPlane, scene.view));
    this.#put(matrices[2], scene.projection);
    const error = exports.clipc_shear_near_plane(
      plane,
      matrices[2],
      scene.isReversed ? REVERSED : 0,
      KEEP_FAR,
      result,
      message,
    );
    if (error) return { constant, problem: this.#instance.textAt(message) };
    const scale = new DataView(exports.memory.buffer, result).getFloat64(64, true);
    return {
      constant: constant.map((x) => x * scale),
      problem: scene.isReversed ? 'this shader writes standard depth' : '',
    };
  }

  /**
   * The 99th percentile of the displacement in pixels that is predicted; NaN if nothing is. `cut`: Reference.seenCut(), or null for an
   * object around its own origin.
   */
  edgeError(space, worldPlane, scene, steps, cut, rows) {
    const { exports } = this.#instance;
    const { plane, matrices, draw, places } = this.#at;
    this.#putDraw(scene, steps);
    this.#put(plane, cut ? worldPlane : planeInView(worldPlane, scene.view));
    if (cut) new Float64Array(exports.memory.buffer, places, cut.places.length).set(cut.places);
    const pixels = cut
      ? exports.clipc_cut_error(
          SPACES.indexOf(space),
          plane,
          KNOWN_IN_WORLD,
          draw,
          places,
          cut.places.length / 3,
          cut.edge,
          rows,
        )
      : exports.clipc_edge_error(SPACES.indexOf(space), plane, matrices[2], rows);
    return pixels >= 0 ? pixels : NaN;
  }
}
