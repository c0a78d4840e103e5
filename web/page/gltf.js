// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Reads the triangles of a glTF file, binary (.glb) or with its bytes in the text, as one mesh about the origin. Nodes, materials
// and animations are left out; buffers in other files are an error.
const MAGIC = 0x46546c67; // "glTF"
const JSON_CHUNK = 0x4e4f534a;
const TRIANGLES = 4;
const MOST_VERTICES = 1 << 20;
const ARRAYS = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
};
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

const fail = (text) => {
  throw new Error(text);
};

function chunksOf(bytes) {
  const view = new DataView(bytes);
  if (bytes.byteLength < 20 || view.getUint32(0, true) !== MAGIC)
    return { json: new TextDecoder().decode(bytes), binary: null };
  const chunks = { json: '', binary: null };
  for (let at = 12; at + 8 <= bytes.byteLength;) {
    const [length, kind] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    if (at + 8 + length > bytes.byteLength) fail('is cut short');
    const chunk = bytes.slice(at + 8, at + 8 + length);
    if (kind === JSON_CHUNK) chunks.json = new TextDecoder().decode(chunk);
    else chunks.binary ??= chunk;
    at += 8 + length;
  }
  return chunks;
}

function bufferOf({ uri }, binary) {
  if (uri === undefined) return binary ?? fail('has no bytes');
  const [, base64] =
    /^data:[^,]*;base64,(.*)$/s.exec(uri) ??
    fail(`has bytes in another file, \`${uri.slice(0, 40)}\``);
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;
}

/** The numbers of accessor `index`, `width` for each element. */
function read(gltf, buffers, index, width) {
  const accessor = gltf.accessors?.[index] ?? fail(`has no accessor ${index}`);
  const Type = ARRAYS[accessor.componentType];
  if (!Type || WIDTHS[accessor.type] !== width || accessor.sparse)
    fail(`has an accessor that this page does not read: ${index}`);
  const view =
    gltf.bufferViews?.[accessor.bufferView] ?? fail(`has no bytes for accessor ${index}`);
  const bytes = new DataView(buffers[view.buffer] ?? fail('has too few buffers'));
  const size = Type.BYTES_PER_ELEMENT;
  const stride = view.byteStride ?? size * width;
  const first = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const { count } = accessor;
  if (!(count > 0 && count <= 3 * MOST_VERTICES)) fail('has no vertices, or more than a million');
  if (first + stride * (count - 1) + size * width > bytes.byteLength) fail('is cut short');
  const get = `get${Type.name.replace('Array', '')}`;
  const most =
    accessor.normalized && Type !== Float32Array
      ? 2 ** (8 * size - (Type.name[0] === 'I' ? 1 : 0)) - 1
      : 1;
  return Float64Array.from({ length: count * width }, (_, i) => {
    const at = first + stride * Math.floor(i / width) + size * (i % width);
    return bytes[get](at, true) / most;
  });
}

/** For each vertex the sum of its triangles' normals. */
function slopes(positions, indices) {
  const normals = new Float64Array(positions.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * indices[i + k]);
    const [u, v] = [b, c].map((corner) =>
      [0, 1, 2].map((axis) => positions[corner + axis] - positions[a + axis]),
    );
    const normal = [
      u[1] * v[2] - u[2] * v[1],
      u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0],
    ];
    for (const corner of [a, b, c]) normal.forEach((x, axis) => (normals[corner + axis] += x));
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let axis = 0; axis < 3; ++axis) normals[i + axis] /= length;
  }
  return normals;
}

/** Moves and scales positions into a sphere of radius 1.2 about the origin. */
function fit(positions) {
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  const scale = 2.4 / Math.hypot(...high.map((x, i) => x - low[i]));
  if (!Number.isFinite(scale)) fail('has positions that are no numbers, or all in one place');
  return Float32Array.from(positions, (x, i) => (x - (low[i % 3] + high[i % 3]) / 2) * scale);
}

/** The mesh in the `bytes` of a file. Throws an Error that says what is wrong. */
export function readGltf(bytes) {
  try {
    return meshOf(chunksOf(bytes));
  } catch (error) {
    // A value that is not a list, an object or a number where one has to be.
    return error instanceof TypeError ||
      error instanceof RangeError ||
      error instanceof DOMException
      ? fail('the glTF file is damaged')
      : fail(`the glTF file ${error.message}`);
  }
}

function meshOf({ json, binary }) {
  let gltf;
  try {
    gltf = JSON.parse(json);
  } catch {
    fail('is neither .glb nor JSON');
  }
  const buffers = (gltf.buffers ?? []).map((buffer) => bufferOf(buffer, binary));
  const [positions, normals, uvs, indices] = [[], [], [], []];
  for (const { mode = TRIANGLES, attributes = {}, indices: accessor } of (
    gltf.meshes ?? []
  ).flatMap((mesh) => mesh.primitives ?? [])) {
    if (mode !== TRIANGLES || attributes.POSITION === undefined) continue;
    const first = positions.length / 3;
    const points = read(gltf, buffers, attributes.POSITION, 3);
    const count = points.length / 3;
    if (first + count > MOST_VERTICES) fail('has more than a million vertices');
    const corners =
      accessor === undefined
        ? points.map((_, i) => i).subarray(0, count)
        : read(gltf, buffers, accessor, 1);
    if (corners.length % 3 || corners.some((corner) => !(corner < count)))
      fail('has triangles of vertices that are not there');
    const given = attributes.NORMAL !== undefined && read(gltf, buffers, attributes.NORMAL, 3);
    const places =
      attributes.TEXCOORD_0 !== undefined && read(gltf, buffers, attributes.TEXCOORD_0, 2);
    for (const x of points) positions.push(x);
    for (const x of given?.length === points.length ? given : slopes(points, corners))
      normals.push(x);
    for (let i = 0; i < 2 * count; ++i) uvs.push(places ? (places[i] ?? 0) : 0);
    for (const corner of corners) indices.push(first + corner);
  }
  if (!indices.length) fail('has no triangles');
  return {
    positions: fit(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    indices: new Uint32Array(indices),
  };
}
