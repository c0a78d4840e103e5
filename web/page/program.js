// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A linked program of one of clipc's results, which knows its constants and inputs by the reflection.

const ARRAYS = { POSITION: 'positions', ROOT: 'positions', NORMAL: 'normals', TEXCOORD: 'uvs' };
const DEFAULTS = {
  BLENDWEIGHT: () => [1, 0, 0, 0],
  INSTANCE: (index) => [0, 1, 2, 3].map((part) => Number(part === index)), // a row of the identity
};

export class Program {
  #uniforms = [];

  /** Throws what is wrong with the texts. `captured`: the outputs for transform feedback. */
  constructor(gl, result, fragment, captured = []) {
    this.gl = gl;
    this.program = gl.createProgram();
    for (const [type, text] of [
      [gl.VERTEX_SHADER, result.glsl],
      [gl.FRAGMENT_SHADER, fragment],
    ]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(gl.getShaderInfoLog(shader));
      gl.deleteShader(shader);
    }
    if (captured.length)
      gl.transformFeedbackVaryings(this.program, captured, gl.INTERLEAVED_ATTRIBS);
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS))
      throw new Error(gl.getProgramInfoLog(this.program));
    this.result = result;
  }

  delete() {
    this.gl.deleteProgram(this.program);
    this.#uniforms.forEach((buffer) => this.gl.deleteBuffer(buffer));
  }

  /** Makes the program current. Returns the number of uploads: one for each constant buffer, or for each uniform without one. */
  bind(constants, buffers) {
    this.gl.useProgram(this.program);
    this.#bindInputs(buffers);
    return this.#bindBlocks(constants) + this.#bindUniforms(constants);
  }

  #bindBlocks(constants) {
    const { gl } = this;
    let uploads = 0;
    this.result.reflection.cbuffers.forEach(({ name, glsl }, binding) => {
      const block = gl.getUniformBlockIndex(this.program, glsl?.block ?? '');
      if (block === gl.INVALID_INDEX) return;
      this.#uniforms[binding] ??= gl.createBuffer();
      gl.uniformBlockBinding(this.program, block, binding);
      gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, this.#uniforms[binding]);
      gl.bufferData(gl.UNIFORM_BUFFER, constants.get(name), gl.DYNAMIC_DRAW);
      ++uploads;
    });
    return uploads;
  }

  #bindUniforms(constants) {
    const { gl } = this;
    let uploads = 0;
    for (const { name, members } of this.result.reflection.cbuffers) {
      const floats = new Float32Array(constants.get(name));
      for (const { type, offset, glsl } of members) {
        const place = glsl ? gl.getUniformLocation(this.program, glsl) : null;
        const [, width, count] = /^float([234]?)(?:\[(\d+)\])?$/.exec(type) ?? [];
        if (place === null || (width === undefined && type !== 'float4x4')) continue;
        const at = offset / 4;
        if (type === 'float4x4') gl.uniformMatrix4fv(place, true, floats.subarray(at, at + 16));
        else if (count === undefined || width === '4')
          gl[`uniform${width || 1}fv`](
            place,
            floats.subarray(at, at + Number(width || 1) * Number(count ?? 1)),
          );
        else continue;
        ++uploads;
      }
    }
    return uploads;
  }

  #bindInputs(buffers) {
    const { gl } = this;
    for (let i = 0; i < gl.getParameter(gl.MAX_VERTEX_ATTRIBS); ++i) gl.disableVertexAttribArray(i);
    for (const { semantic, index, name, type, builtin } of this.result.reflection.inputs) {
      const location = builtin ? -1 : gl.getAttribLocation(this.program, name);
      if (location < 0) continue;
      const array = index === 0 && ARRAYS[semantic];
      if (type.startsWith('uint')) gl.vertexAttribI4ui(location, 0, 0, 0, 0);
      else if (type.startsWith('int')) gl.vertexAttribI4i(location, 0, 0, 0, 0);
      else if (array) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[array]);
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, array === 'uvs' ? 2 : 3, gl.FLOAT, false, 0, 0);
      } else {
        gl.vertexAttrib4f(location, ...(DEFAULTS[semantic]?.(index) ?? [1, 1, 1, 1]));
      }
    }
  }
}

/** The mesh's arrays as buffers. */
export function uploadMesh(gl, mesh) {
  const buffers = {};
  for (const name of ['positions', 'normals', 'uvs', 'indices']) {
    const target = name === 'indices' ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
    buffers[name] = gl.createBuffer();
    gl.bindBuffer(target, buffers[name]);
    gl.bufferData(target, mesh[name], gl.STATIC_DRAW);
  }
  return buffers;
}
