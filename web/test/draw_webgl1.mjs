// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Runs in a page.
import { SIZE, forJson, link } from './drawing.mjs';

const floatsOf = (words) => new Float32Array(new Uint32Array(words).buffer);

function setAttributes(gl, program, attributes) {
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); ++i) {
    const { name, type } = gl.getActiveAttrib(program, i);
    const location = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, floatsOf(attributes[name]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(
      location,
      [gl.FLOAT, gl.FLOAT_VEC2, gl.FLOAT_VEC3, gl.FLOAT_VEC4].indexOf(type) + 1,
      gl.FLOAT,
      false,
      0,
      0,
    );
  }
}

const INTEGERS = [
  ['INT', 'INT_VEC2', 'INT_VEC3', 'INT_VEC4'],
  ['BOOL', 'BOOL_VEC2', 'BOOL_VEC3', 'BOOL_VEC4'],
];

/** Rows are arrays of vec4; what is not a float is a uniform of its own. */
function setUniforms(gl, program, uniforms) {
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
    const { name, type, size } = gl.getActiveUniform(program, i);
    const place = gl.getUniformLocation(program, name);
    const words = uniforms[name.replace('[0]', '')];
    if (!words) throw new Error(`no words for the uniform ${name}`);
    const width =
      1 + Math.max(...INTEGERS.map((shapes) => shapes.map((shape) => gl[shape]).indexOf(type)));
    if (type === gl.FLOAT_VEC4) gl.uniform4fv(place, floatsOf(words).subarray(0, 4 * size));
    else if (width) gl[`uniform${width}iv`](place, new Int32Array(words));
    else throw new Error(`the uniform ${name} is neither rows nor an integer`);
  }
}

/** Draws by WebGL 1 what `clipc-draw image` takes; integers among the attributes are floats. Returns {colors} or {problem}. */
export function drawWebgl1({ vertex, fragment, vertices, attributes, uniforms }) {
  const canvas = new OffscreenCanvas(SIZE, SIZE);
  const gl = canvas.getContext('webgl');
  try {
    if (!gl.getExtension('OES_texture_float') || !gl.getExtension('WEBGL_color_buffer_float'))
      throw new Error('no floats to draw to');
    const program = link(gl, vertex, fragment);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, SIZE, SIZE, 0, gl.RGBA, gl.FLOAT, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(
      gl.FRAMEBUFFER,
      gl.COLOR_ATTACHMENT0,
      gl.TEXTURE_2D,
      gl.getParameter(gl.TEXTURE_BINDING_2D),
      0,
    );
    gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT16, SIZE, SIZE);
    gl.framebufferRenderbuffer(
      gl.FRAMEBUFFER,
      gl.DEPTH_ATTACHMENT,
      gl.RENDERBUFFER,
      gl.getParameter(gl.RENDERBUFFER_BINDING),
    );
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.viewport(0, 0, SIZE, SIZE);
    gl.useProgram(program);
    setAttributes(gl, program, attributes);
    setUniforms(gl, program, uniforms);
    gl.drawArrays(gl.TRIANGLES, 0, vertices);
    const colors = new Float32Array(4 * SIZE * SIZE);
    gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.FLOAT, colors);
    const error = gl.getError();
    return error ? { problem: `WebGL has the error ${error}` } : { colors: forJson(colors) };
  } catch (error) {
    return { problem: error.message };
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}
