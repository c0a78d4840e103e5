// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A WebGL 2 canvas that draws a mesh with the GLSL of one of clipc's results.

const COLORS = /COLOR|TINT/;

/** A fragment shader for the outputs of `result`; it shades by the slope of the depth where there are no normals. */
function fragmentShader(result) {
  const outputs = result.reflection.outputs.filter((output) => !output.builtin);
  const find = (test, types) => outputs.find(({ semantic, type }) => test.test(semantic) && types.includes(type));
  const normal = find(/^NORMAL$/, ['float3', 'float4']);
  const color = find(COLORS, ['float3', 'float4']);
  const input = (output) => `in highp vec${output.type[5]} ${output.name};\n`;
  const discard = result.discard.replace(/^#version.*\n/m, '');
  return `#version 300 es
precision highp float;
${discard}${normal ? input(normal) : ''}${color ? input(color) : ''}out vec4 out_color;

void main() {
    ${discard ? 'clip_planes();' : ''}
    vec3 normal = ${normal ? `normalize(${normal.name}.xyz)` : 'normalize(vec3(-400.0 * vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)), 1.0))'};
    float light = 0.35 + 0.65 * abs(dot(normal, normalize(vec3(0.4, 0.8, 0.45))));
    vec3 surface = gl_FrontFacing ? vec3(0.95, 0.62, 0.25) : vec3(0.35, 0.55, 0.8);
    out_color = vec4(${color ? `surface * ${color.name}.xyz` : 'surface'} * light, 1.0);
}
`;
}

const ARRAYS = { POSITION: 'positions', NORMAL: 'normals', TEXCOORD: 'uvs' };

export class Canvas {
  #program = null;
  #result = null;
  #mesh = null;

  constructor(element) {
    this.element = element;
    this.gl = element.getContext('webgl2', { antialias: true });
    this.clip = this.gl?.getExtension('WEBGL_clip_cull_distance') ?? null;
    element.addEventListener('webglcontextlost', (event) => event.preventDefault());
    element.addEventListener('webglcontextrestored', () => {
      this.clip = this.gl.getExtension('WEBGL_clip_cull_distance');
      this.mesh = this.#mesh.source;
      this.use(this.#result);
    });
  }

  set mesh(source) {
    const { gl } = this;
    if (!gl) return;
    const buffer = (target, data) => {
      const made = gl.createBuffer();
      gl.bindBuffer(target, made);
      gl.bufferData(target, data, gl.STATIC_DRAW);
      return made;
    };
    if (this.#mesh) Object.values(this.#mesh.buffers).forEach((made) => gl.deleteBuffer(made));
    const buffers = {};
    for (const name of ['positions', 'normals', 'uvs']) buffers[name] = buffer(gl.ARRAY_BUFFER, source[name]);
    buffers.indices = buffer(gl.ELEMENT_ARRAY_BUFFER, source.indices);
    this.#mesh = { buffers, source };
  }

  /** Draws with `result` from now on. Returns what is wrong; the last program stays then. */
  use(result) {
    const { gl } = this;
    if (!gl) return 'this browser has no WebGL 2';
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, result.glsl], [gl.FRAGMENT_SHADER, fragmentShader(result)]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return gl.getShaderInfoLog(shader);
      gl.deleteShader(shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return gl.getProgramInfoLog(program);
    gl.deleteProgram(this.#program);
    this.#program = program;
    this.#result = result;
    return '';
  }

  get result() {
    return this.#result;
  }

  /** `buffers`: fillConstants(). One draw, and an upload for each constant buffer. */
  draw(buffers, isReversed) {
    const { gl, element } = this;
    if (!gl || !this.#program || gl.isContextLost()) return;
    gl.viewport(0, 0, element.width, element.height);
    gl.clearColor(0.125, 0.14, 0.165, 1);
    gl.clearDepth(isReversed ? 0 : 1);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(isReversed ? gl.GEQUAL : gl.LEQUAL);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(this.#program);
    this.#bindBuffers(buffers);
    this.#bindInputs();
    const planes = this.clip ? Math.log2((this.#result.reflection.clipDistanceMask ?? 0) + 1) : 0;
    for (let i = 0; i < planes; ++i) gl.enable(this.clip.CLIP_DISTANCE0_WEBGL + i);
    gl.drawElements(gl.TRIANGLES, this.#mesh.source.indices.length, gl.UNSIGNED_SHORT, 0);
    for (let i = 0; i < planes; ++i) gl.disable(this.clip.CLIP_DISTANCE0_WEBGL + i);
  }

  #bindBuffers(buffers) {
    const { gl } = this;
    this.uniforms ??= [];
    this.#result.reflection.cbuffers.forEach(({ name, glsl }, binding) => {
      const bytes = buffers.get(name);
      const block = gl.getUniformBlockIndex(this.#program, glsl.block ?? '');
      if (block === gl.INVALID_INDEX) return;
      this.uniforms[binding] ??= gl.createBuffer();
      gl.uniformBlockBinding(this.#program, block, binding);
      gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, this.uniforms[binding]);
      gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
    });
    for (const { name, members } of this.#result.reflection.cbuffers) {
      for (const { type, offset, glsl } of members) {
        const place = glsl && gl.getUniformLocation(this.#program, glsl);
        if (place === null || place === undefined || place === '') continue;
        const floats = new Float32Array(buffers.get(name));
        if (type === 'float4x4') gl.uniformMatrix4fv(place, true, floats.subarray(offset / 4, offset / 4 + 16));
        else if (/^float[234]?$/.test(type)) {
          const width = Number(type[5] ?? 1);
          gl[`uniform${width}fv`](place, floats.subarray(offset / 4, offset / 4 + width));
        }
      }
    }
  }

  #bindInputs() {
    const { gl } = this;
    const { buffers } = this.#mesh;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.indices);
    for (const { semantic, index, name, builtin } of this.#result.reflection.inputs) {
      const location = builtin ? -1 : gl.getAttribLocation(this.#program, name);
      if (location < 0) continue;
      const array = index === 0 && ARRAYS[semantic];
      if (array) {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffers[array]);
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, array === 'uvs' ? 2 : 3, gl.FLOAT, false, 0, 0);
      } else {
        gl.disableVertexAttribArray(location);
        gl.vertexAttrib4f(location, 1, 1, 1, 1);
      }
    }
  }
}
