// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Plane constants by clipc's runtime, which is in the same module as the compiler: runtime/clipc_runtime.h.
import { Instance } from 'clipc/compiler.js';

export const SPACES = ['clip', 'xyw1', 'object'];
const KNOWN_IN_WORLD = 1;
const MOST_PIXELS = 0.5;

export async function loadRuntime() {
  const response = await fetch(new URL('clipc/clipc.wasm', import.meta.url));
  const module = await WebAssembly.compile(await response.arrayBuffer());
  const instance = new Instance(module, null, () => null);
  const { exports } = instance;
  exports._initialize();
  const plane = exports.clipc_module_allocate(16);
  const matrices = [0, 1, 2].map(() => exports.clipc_module_allocate(64));
  const draw = exports.clipc_module_allocate(20);
  const result = exports.clipc_module_allocate(232);
  const message = exports.clipc_module_allocate(200);
  const floats = (address, values) => new Float32Array(exports.memory.buffer, address, values.length).set(values);

  /** {constant, edgeError, warning} for a plane of the world, for a picture of `rows` rows; or {problem}. */
  return function planeConstant(space, worldPlane, { world, view, projection, steps = 1 }, rows) {
    floats(plane, worldPlane);
    [world, view, projection].forEach((matrix, i) => floats(matrices[i], matrix));
    new Uint32Array(exports.memory.buffer, draw, 5).set([...matrices, steps, 0]);
    const error = exports.clipc_plane_constant(SPACES.indexOf(space), plane, KNOWN_IN_WORLD, draw, rows, MOST_PIXELS, result, message);
    if (error) return { problem: instance.textAt(message), constant: [0, 0, 0, 1] };
    const view8 = new DataView(exports.memory.buffer, result);
    return {
      constant: [0, 4, 8, 12].map((at) => view8.getFloat32(at, true)),
      edgeError: view8.getFloat64(16, true),
      warning: view8.getUint32(24, true) ? instance.textAt(result + 28) : '',
    };
  };
}
