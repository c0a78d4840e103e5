// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What a shader of the lowering `discard` computes for each vertex on this machine's GPU: its position and its clip distances.
import { Program, uploadMesh } from './program.js';

const FRAGMENT = '#version 300 es\nout lowp vec4 color;\nvoid main() { color = vec4(0.0); }\n';
const COMPONENTS = { FLOAT: 1, FLOAT_VEC2: 2, FLOAT_VEC3: 3, FLOAT_VEC4: 4 };

export class Capture {
  #program = null;
  #mesh = null;
  #planes = 0;
  #output = null;

  constructor(gl) {
    this.gl = gl;
  }

  set mesh(source) {
    const { gl } = this;
    if (this.#mesh) Object.values(this.#mesh.buffers).forEach((made) => gl.deleteBuffer(made));
    this.#mesh = { buffers: uploadMesh(gl, source), count: source.positions.length / 3 };
  }

  get result() {
    return this.#program?.result ?? null;
  }

  /** Whether `result` has clip distances to capture. */
  use(result) {
    const { gl } = this;
    const names = result.reflection.outputs
      .filter(({ semantic }) => semantic === 'SV_ClipPlaneDistance')
      .map(({ name }) => name);
    if (!names.length) return false;
    this.#program?.delete();
    this.#program = null;
    try {
      this.#program = new Program(gl, result, FRAGMENT, ['gl_Position', ...names]);
    } catch {
      return false;
    }
    this.#planes = 0;
    for (let i = 1; i <= names.length; ++i) {
      const { type, size } = gl.getTransformFeedbackVarying(this.#program.program, i);
      const shape = Object.keys(COMPONENTS).find((name) => gl[name] === type);
      this.#planes += COMPONENTS[shape] * size;
    }
    return true;
  }

  /** For each vertex four numbers of its clip space from -w to w, and a distance for each plane. */
  run(constants) {
    const { gl } = this;
    const stride = 4 + this.#planes;
    const { count, buffers } = this.#mesh;
    this.#program.bind(constants, buffers);
    this.#output ??= gl.createBuffer();
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, this.#output);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 4 * stride * count, gl.STREAM_READ);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, this.#output);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, count);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    const values = new Float32Array(stride * count);
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, this.#output);
    gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, values);
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
    return { values, stride, planes: this.#planes };
  }
}
