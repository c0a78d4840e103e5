// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Fills a shader's constant buffers for the scene, by the names of their members, and each clip plane by clipc's table.
import { multiply, transpose } from './matrices.js';

/** What a matrix of this name is, from the scene; null if the name says nothing. */
function matrixNamed(name, { world, view, projection }) {
  const word = name.toLowerCase().replace(/[^a-z]/g, '');
  const has = (...parts) => parts.some((part) => word.includes(part));
  if (has('wvp', 'worldviewproj', 'modelviewproj', 'mvp')) return multiply(multiply(world, view), projection);
  if (has('worldview', 'modelview')) return multiply(world, view);
  if (has('viewproj', 'vp', 'toclip')) return multiply(view, projection);
  if (has('proj')) return projection;
  if (has('view', 'camera')) return view;
  if (has('world', 'model', 'object')) return world;
  return null;
}

const FLOATS = {
  time: ({ seconds }) => [seconds],
  eye: ({ eye }) => eye,
  camera_position: ({ eye }) => eye,
  tint: () => [1, 1, 1, 1],
  color: () => [1, 1, 1, 1],
  cell: () => [0.1],
  height_scale: () => [1],
  fade_radius: () => [1],
  low: () => [-0.8, -0.8, -0.8],
  high: () => [0.8, 0.8, 0.8],
};

/**
 * The bytes of each of the reflection's constant buffers.
 * @returns {{buffers: Map<string, ArrayBuffer>, unknown: string[]}} by the buffer's name; members that got zeros
 */
export function fillConstants(reflection, text, scene, planeConstant) {
  const buffers = new Map();
  const unknown = [];
  for (const { name: buffer, size, members } of reflection.cbuffers) {
    const bytes = new ArrayBuffer(Math.ceil(size / 16) * 16);
    const floats = new Float32Array(bytes);
    buffers.set(buffer, bytes);
    for (const { name, type, offset } of members) {
      const at = offset / 4;
      const isPlane = reflection.clipPlanes.some((plane) => plane.cbuffer === buffer && plane.offset === offset);
      if (isPlane) continue;
      if (type === 'float4x4') {
        const matrix = matrixNamed(name, scene);
        if (!matrix) unknown.push(name);
        // Columns lie in memory one after the other, unless the vector is multiplied from the right.
        const isFirst = new RegExp(`mul\\s*\\(\\s*(\\w+\\.)?${name}\\s*,`).test(text);
        floats.set(matrix ? (isFirst ? matrix : transpose(matrix)) : new Float32Array(16), at);
      } else if (/^float[234]?$/.test(type)) {
        const width = Number(type[5] ?? 1);
        const value = FLOATS[name.toLowerCase()]?.(scene);
        if (value) floats.set(value.slice(0, width), at);
        else unknown.push(name);
      } else {
        unknown.push(name);
      }
    }
  }
  for (const { cbuffer, offset } of reflection.clipPlanes) {
    const bytes = cbuffer && buffers.get(cbuffer);
    if (bytes && offset !== undefined) new Float32Array(bytes).set(planeConstant(), offset / 4);
  }
  return { buffers, unknown };
}
