// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A WebGL 2 canvas that draws a mesh with the GLSL of one of clipc's results, and lines over it.
import { Program, uploadMesh } from './program.js';

const COLORS = /COLOR|TINT/;

/** The pixel shader of `result`, or one for its outputs, which shades by the slope of the depth where there are no normals. */
export function fragmentShader(result) {
  if (result.pixel) return result.pixel;
  const outputs = result.reflection.outputs.filter((output) => !output.builtin);
  const find = (test, types) =>
    outputs.find(({ semantic, type }) => test.test(semantic) && types.includes(type));
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

const LINES = {
  glsl: '#version 300 es\nin vec4 position;\nvoid main() { gl_Position = position; }\n',
  fragment:
    '#version 300 es\nout lowp vec4 color;\nvoid main() { color = vec4(1.0, 1.0, 1.0, 1.0); }\n',
};

export class Canvas {
  #program = null;
  #lines = null;
  #mesh = null;
  /** What the draws since the last reset cost. */
  work = { draws: 0, uploads: 0 };

  constructor(element, options = {}) {
    this.element = element;
    this.gl = element.getContext('webgl2', { antialias: true, ...options });
    this.clip = this.gl?.getExtension('WEBGL_clip_cull_distance') ?? null;
    element.addEventListener('webglcontextlost', (event) => event.preventDefault());
    element.addEventListener('webglcontextrestored', () => {
      const { result } = this;
      this.clip = this.gl.getExtension('WEBGL_clip_cull_distance');
      this.#lines = null;
      this.#program = null;
      this.mesh = this.#mesh.source;
      if (result) this.use(result);
    });
  }

  set mesh(source) {
    const { gl } = this;
    if (!gl) return;
    if (this.#mesh) Object.values(this.#mesh.buffers).forEach((made) => gl.deleteBuffer(made));
    this.#mesh = { buffers: uploadMesh(gl, source), source };
  }
  get mesh() {
    return this.#mesh?.source;
  }

  /** Draws with `result` from now on. Returns what is wrong; the last program stays then. */
  use(result) {
    if (!this.gl) return 'this browser has no WebGL 2';
    try {
      const program = new Program(this.gl, result, fragmentShader(result));
      this.#program?.delete();
      this.#program = program;
      return '';
    } catch (error) {
      return error.message;
    }
  }

  get result() {
    return this.#program?.result ?? null;
  }

  /**
   * `constants`: fillConstants(). One draw of the mesh, and one of `lines`, pairs of points of the clip space from -w to w.
   * `viewport`: another one than the whole image.
   */
  draw(constants, isReversed, lines = null, viewport = null) {
    const { gl, element } = this;
    if (!gl || !this.#program || gl.isContextLost()) return;
    gl.viewport(...(viewport ?? [0, 0, element.width, element.height]));
    gl.clearColor(0.125, 0.14, 0.165, 1);
    gl.clearDepth(isReversed ? 0 : 1);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(isReversed ? gl.GEQUAL : gl.LEQUAL);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const uploads = this.#program.bind(constants, this.#mesh.buffers);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#mesh.buffers.indices);
    const { clipDistanceMask = 0 } = this.result.reflection;
    const planes = this.clip ? Math.log2(clipDistanceMask + 1) : 0;
    for (let i = 0; i < planes; ++i) gl.enable(this.clip.CLIP_DISTANCE0_WEBGL + i);
    gl.drawElements(gl.TRIANGLES, this.#mesh.source.indices.length, gl.UNSIGNED_INT, 0);
    for (let i = 0; i < planes; ++i) gl.disable(this.clip.CLIP_DISTANCE0_WEBGL + i);
    this.work.draws += 1;
    this.work.uploads += uploads;
    if (lines?.length) this.#drawLines(lines);
  }

  #drawLines(lines) {
    const { gl } = this;
    if (!this.#lines) {
      const nothing = { cbuffers: [], inputs: [] };
      const program = new Program(gl, { glsl: LINES.glsl, reflection: nothing }, LINES.fragment);
      this.#lines = { program, buffer: gl.createBuffer() };
    }
    const { program, buffer } = this.#lines;
    program.bind(null, {});
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, lines, gl.STREAM_DRAW);
    const location = gl.getAttribLocation(program.program, 'position');
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, 4, gl.FLOAT, false, 0, 0);
    gl.drawArrays(gl.LINES, 0, lines.length / 4);
    this.work.draws += 1;
    this.work.uploads += 1;
  }
}
