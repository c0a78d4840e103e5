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
    bindTexture(this.gl, Boolean(this.result.pixel));
    this.#bindInputs(buffers);
    return this.#bindBlocks(constants) + this.#bindUniforms(constants);
  }

  #bindBlocks(constants) {
    const { gl } = this;
    let uploads = 0;
    buffersOf(this.result.reflection).forEach(({ name, glsl }, binding) => {
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
    for (const { name, members } of buffersOf(this.result.reflection)) {
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

/** The constant buffers of a vertex shader and of the pixel shader that was compiled with it, each once. */
export function buffersOf({ cbuffers, pixelShader }) {
  const own = (pixelShader?.cbuffers ?? []).filter(
    ({ glsl }) => glsl && !glsl.sharedWithVertexShader,
  );
  return [
    ...cbuffers,
    ...own.map((buffer) => ({ ...buffer, name: `${buffer.name} of the pixel shader` })),
  ];
}

const checkers = new WeakMap();

/** Every texture of a pair is a checker board; a vertex shader alone reads zeros. */
function bindTexture(gl, isPair) {
  gl.activeTexture(gl.TEXTURE0);
  if (!isPair) return gl.bindTexture(gl.TEXTURE_2D, null);
  if (checkers.has(gl)) return gl.bindTexture(gl.TEXTURE_2D, checkers.get(gl));
  const texture = gl.createTexture();
  checkers.set(gl, texture);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  const pixels = Array.from({ length: 64 }, (_, i) => ((i + (i >> 3)) % 2 ? 255 : 150)).flatMap(
    (x) => [x, x, x, 255],
  );
  gl.texImage2D(
    gl.TEXTURE_2D,
    0,
    gl.RGBA,
    8,
    8,
    0,
    gl.RGBA,
    gl.UNSIGNED_BYTE,
    new Uint8Array(pixels),
  );
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
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
