// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Fills a shader's constant buffers for the scene, by the names of their members, and each clip plane by clipc's table.
import { multiply, multiplyFloats, transpose } from './matrices.js';
import { buffersOf } from './program.js';

/** What a matrix of this name is, from the scene; null if the name says nothing. */
function matrixNamed(name, { world, view, projection, isFloat }) {
  const product = isFloat ? multiplyFloats : multiply;
  const word = name.toLowerCase().replace(/[^a-z]/g, '');
  const has = (...parts) => parts.some((part) => word.includes(part));
  if (has('wvp', 'worldviewproj', 'modelviewproj', 'mvp'))
    return product(product(world, view), projection);
  if (has('worldview', 'modelview')) return product(world, view);
  if (has('viewproj', 'vp', 'toclip')) return product(view, projection);
  if (has('proj')) return projection;
  if (has('view', 'camera')) return view;
  if (has('world', 'model', 'object', 'bone')) return world;
  return null;
}

const NUMBERS = {
  time: ({ seconds }) => [seconds],
  eye: ({ eye }) => eye,
  camera_position: ({ eye }) => eye,
  tint: () => [1, 1, 1, 1],
  color: () => [1, 1, 1, 1],
  ambient: () => [0.3, 0.3, 0.3, 1],
  diffuse: () => [0.7, 0.7, 0.7, 0],
  lightdirection: () => [0.4, -0.8, -0.45, 0],
  scale: () => [1, 1],
  bias: () => [0],
  split: () => [1, 2, 3, 4],
  direction: () => [0.6, 0.8],
  strength: () => [0.3],
  origin: () => [0, 0],
  cell: () => [1],
  texel: () => [0.01, 0.01],
  height_scale: () => [1],
  fade_radius: () => [4],
  low: () => [-0.8, -0.8, -0.8],
  high: () => [0.8, 0.8, 0.8],
  enabled: () => [1],
};

/** Whether a matrix lies in memory by its columns as rows: the packing, and the side on which the text multiplies it. */
function isTransposed(name, rowMajor, text) {
  const isFirst = new RegExp(`mul\\s*\\(\\s*(\\w+\\.)?${name}\\s*,`).test(text);
  return isFirst === rowMajor;
}

/** The members, and those of structs in their place. Each element of an array begins at a multiple of 16 bytes. */
const flat = (members, structs, base = 0) =>
  members.flatMap((member) => {
    const at = base + member.offset;
    const [, name, dimensions] = /^([^[]*)(.*)$/.exec(member.type);
    const fields = member.fields ?? structs.find((struct) => struct.name === name)?.fields;
    if (!fields) return [{ ...member, offset: at }];
    const count = [...dimensions.matchAll(/\d+/g)].reduce(
      (product, [number]) => product * Number(number),
      1,
    );
    const stride = Math.ceil(member.size / count / 16) * 16;
    return Array.from({ length: count }, (_, i) => flat(fields, structs, at + i * stride)).flat();
  });

/** Writes a member; returns false where its name or type says nothing. */
function fillMember({ name, type, offset, size, rowMajor = false }, view, text, scene) {
  const at = offset / 4;
  if (/^float[34]x[34](\[\d+\])?$/.test(type)) {
    const matrix = matrixNamed(name, scene);
    if (!matrix) return false;
    const elements = isTransposed(name, rowMajor, text) ? transpose(matrix) : matrix;
    const [, count = 1] = /\[(\d+)\]/.exec(type) ?? [];
    const one = count > 1 ? Math.ceil(size / count / 16) * 4 : size / 4;
    for (let i = 0; i < count; ++i) view.floats.set(elements.slice(0, one), at + i * one);
    return true;
  }
  const value = NUMBERS[name.toLowerCase()]?.(scene);
  if (!value || !/^(float[234]?|bool)$/.test(type)) return false;
  if (type === 'bool') view.words[at] = value[0];
  else view.floats.set(value.slice(0, Number(type[5] ?? 1)), at);
  return true;
}

/**
 * For each of the shader's planes the scene's plane that it is: planes of one constant are one. Null where a plane is composed of
 * several constants.
 */
export function planesOf(reflection) {
  const places = [];
  const planes = [];
  for (const { cbuffer, offset } of reflection.clipPlanes) {
    if (!cbuffer || offset === undefined) return null;
    const place = `${cbuffer}@${offset}`;
    if (!places.includes(place)) places.push(place);
    planes.push(places.indexOf(place));
  }
  return planes;
}

/**
 * The bytes of each of the reflection's constant buffers; `planeConstant(i)` is the constant of the scene's plane i.
 * @returns {{buffers: Map<string, ArrayBuffer>, unknown: string[]}} by the buffer's name; members that got zeros
 */
export function fillConstants(reflection, text, scene, planeConstant) {
  const buffers = new Map();
  const unknown = [];
  const holdsPlane = (buffer, { offset, size }) =>
    reflection.clipPlanes.some(
      (plane) => plane.cbuffer === buffer && plane.offset >= offset && plane.offset < offset + size,
    );
  const structs = [...reflection.structs, ...(reflection.pixelShader?.structs ?? [])];
  for (const { name: buffer, size, members } of buffersOf(reflection)) {
    const bytes = new ArrayBuffer(Math.ceil(size / 16) * 16);
    const view = { floats: new Float32Array(bytes), words: new Uint32Array(bytes) };
    buffers.set(buffer, bytes);
    for (const member of flat(members, structs)) {
      const isFilled = fillMember(member, view, text, scene);
      if (!isFilled && !holdsPlane(buffer, member)) unknown.push(member.name);
    }
  }
  const planes = planesOf(reflection) ?? [];
  reflection.clipPlanes.forEach(({ cbuffer, offset }, i) => {
    if (planes[i] !== undefined)
      new Float32Array(buffers.get(cbuffer)).set(planeConstant(planes[i]), offset / 4);
  });
  return { buffers, unknown };
}
