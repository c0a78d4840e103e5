// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Runs in a page.
import { SIZE, corners, forJson, link, random } from './drawing.mjs';

/** Location 0 is the position; the others are random, small where they are integers. */
function attributesOf(gl, program) {
  const attributes = {};
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); ++i) {
    const { name, type } = gl.getActiveAttrib(program, i);
    const location = gl.getAttribLocation(program, name);
    if (location < 0) continue; // gl_VertexID
    const floats = [gl.FLOAT, gl.FLOAT_VEC2, gl.FLOAT_VEC3, gl.FLOAT_VEC4].indexOf(type) + 1;
    const ints = [gl.INT, gl.INT_VEC2, gl.INT_VEC3, gl.INT_VEC4].indexOf(type) + 1;
    const uints =
      [gl.UNSIGNED_INT, gl.UNSIGNED_INT_VEC2, gl.UNSIGNED_INT_VEC3, gl.UNSIGNED_INT_VEC4].indexOf(
        type,
      ) + 1;
    const width = floats || ints || uints;
    const next = random(`attribute ${location}`);
    const values = corners.flatMap(([x, y]) =>
      [x, y, 0, 1]
        .slice(0, width)
        .map((at) => (location === 0 ? at : floats ? next() : Math.floor(4 * next()))),
    );
    const words = new Uint32Array(
      floats ? new Float32Array(values).buffer : new Uint32Array(values).buffer,
    );
    attributes[name] = [...words];
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, words, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(location);
    if (floats) gl.vertexAttribPointer(location, width, gl.FLOAT, false, 0, 0);
    else gl.vertexAttribIPointer(location, width, ints ? gl.INT : gl.UNSIGNED_INT, 0, 0);
  }
  return attributes;
}

/** Each begins with nearly the identity, so that the mesh stays in view where that is a matrix. */
function blocksOf(gl, program) {
  const blocks = {};
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORM_BLOCKS); ++i) {
    const name = gl.getActiveUniformBlockName(program, i);
    const next = random(name);
    const size = gl.getActiveUniformBlockParameter(program, i, gl.UNIFORM_BLOCK_DATA_SIZE);
    const floats = Float32Array.from(
      { length: size / 4 },
      (_, at) => (at < 16 && at % 5 === 0 ? 1 : 0) + 0.05 + 0.2 * next(),
    );
    blocks[name] = [...new Uint32Array(floats.buffer)];
    gl.uniformBlockBinding(program, i, i);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, i, gl.createBuffer());
    gl.bufferData(gl.UNIFORM_BUFFER, floats, gl.STATIC_DRAW);
  }
  return blocks;
}

/**
 * Draws a mesh over the whole image by WebGL 2. The same vertices go to equal locations, the same numbers to uniform blocks of equal
 * names. Returns {colors} and the draw as `clipc-draw image` takes it, or {problem}.
 */
export function drawPair(vertex, fragment) {
  const canvas = new OffscreenCanvas(SIZE, SIZE);
  const gl = canvas.getContext('webgl2');
  try {
    if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('no EXT_color_buffer_float');
    const program = link(gl, vertex, fragment);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32F, SIZE, SIZE);
    gl.framebufferRenderbuffer(
      gl.FRAMEBUFFER,
      gl.COLOR_ATTACHMENT0,
      gl.RENDERBUFFER,
      gl.getParameter(gl.RENDERBUFFER_BINDING),
    );
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.viewport(0, 0, SIZE, SIZE);
    gl.useProgram(program);
    const [attributes, blocks] = [attributesOf(gl, program), blocksOf(gl, program)];
    gl.drawArrays(gl.TRIANGLES, 0, corners.length);
    const colors = new Float32Array(4 * SIZE * SIZE);
    gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.FLOAT, colors);
    const error = gl.getError();
    if (error) throw new Error(`WebGL has the error ${error}`);
    const draw = {
      vertex,
      fragment,
      width: SIZE,
      height: SIZE,
      clear: [0, 0, 0, 0],
      reversed: false,
      clipDistances: 0,
      float: true,
      vertices: corners.length,
      indices: corners.map((_, i) => i),
      attributes,
      blocks,
      uniforms: {},
    };
    return { colors: forJson(colors), draw };
  } catch (error) {
    return { problem: error.message };
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}
