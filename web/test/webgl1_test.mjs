// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// clipc's GLSL for the target webgl1, drawn by WebGL 1 in headless Chromium with the planes by discard: its image is that of the
// target glsl330 on the desktop's OpenGL, where the planes are clip distances. Both get the same vertices and constants.
//   node webgl1_test.mjs CLIPC CLIPC-DRAW CHROMIUM FOLDER...     FOLDERs of shaders; those that OpenGL ES 2 cannot say are left out
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { Page } from './browser.mjs';
import { onDesktop, scratchFolder } from './desktop.mjs';
import { SIZE, corners, differing, random } from './drawing.mjs';

// Rasterisers move vertices to places of their own, 1/16 or 1/256 of a pixel apart, and colors with them.
const SNAPPED = 0.03;
const AT_EDGES = 40; // pixels of 4096: some along the mesh's end and along the planes
const LEAST_COLORS = 64; // an image with fewer shows nothing
const ROUGH = ['exact.hlsl']; // NaNs and infinities, which interpolate as they like

const [clipc, draw, chromium, ...folders] = process.argv.slice(2);
const scratch = scratchFolder('webgl1');
const page = await Page.open(chromium, fileURLToPath(new URL('.', import.meta.url)), {
  path: 'empty.html',
});
await page.loaded();
await page.evaluate(
  `import('/draw_webgl1.mjs').then(({ drawWebgl1 }) => void (window.drawWebgl1 = drawWebgl1))`,
);
if (
  !(await page.evaluate(
    `!!new OffscreenCanvas(1, 1).getContext('webgl')?.getExtension('WEBGL_color_buffer_float')`,
  ))
) {
  console.log('this browser does not draw floats by WebGL 1');
  process.exit(77);
}

/** The texts of a shader for a target; null where clipc refuses it. */
function compiled(path, target, lower) {
  const [vertex, reflection, discard] = ['x.vert', 'x.json', 'x.discard.glsl'].map((name) =>
    join(scratch, name),
  );
  const options = (
    readFileSync(path, 'utf8').match(/^\/\/ clipc (.*)$/m)?.[1] ?? '-T vs_5_0'
  ).split(' ');
  const { status, stderr } = spawnSync(
    clipc,
    [
      '-w',
      ...options,
      `--target=${target}`,
      `--lower=${lower}`,
      '--depth-range=negative-one-to-one',
      path,
      '-o',
      vertex,
      `--reflect=${reflection}`,
    ],
    { encoding: 'utf8' },
  );
  if (status === 1) return null;
  assert.equal(status, 0, `${path}: ${stderr}`);
  const read = (file) => (existsSync(file) ? readFileSync(file, 'utf8') : '');
  return {
    vertex: read(vertex),
    discard: lower === 'discard' ? read(discard) : '',
    reflection: JSON.parse(read(reflection)),
  };
}

/** A fragment shader whose color depends on all of the shader's outputs but the planes' distances. */
function fragmentOf({ reflection, discard }, isOld) {
  const outputs = reflection.outputs.filter(
    ({ builtin, semantic }) => !builtin && semantic !== 'SV_ClipPlaneDistance',
  );
  const typeOf = ({ type }) => type.replace(/^float([234])$/, 'vec$1');
  const term = ({ name, type }, i) => {
    const weights = [0.7, 0.4, 0.25, 0.15].map((weight) => (weight / (1 + i)).toFixed(4));
    return type === 'float'
      ? `vec4(${weights.join(', ')}) * ${name}`
      : `${weights[i % 3]} * ${name}${{ 2: '.xyxy', 3: '.xyzx', 4: '' }[type[5]]}`;
  };
  const sum = ['vec4(gl_FragCoord.xy / 64.0, 0.0, 1.0)', ...outputs.map(term)].join(' + ');
  const [head, input] = isOld
    ? ['#version 100\nprecision highp float;\n', 'varying']
    : ['#version 330\nout vec4 color;\n', 'in'];
  return (
    `${head}${outputs.map((output) => `${input} ${typeOf(output)} ${output.name};\n`).join('')}${discard}` +
    `void main() {\n    ${discard ? 'clip_planes();' : ''}\n    ${isOld ? 'gl_FragColor' : 'color'} = ${sum};\n}\n`
  );
}

const wordsOf = (floats) => [...new Uint32Array(new Float32Array(floats).buffer)];

/** The numbers of each input: the first is the position, integers are small, weights add up to 1. */
function numbersOf({ inputs }) {
  return inputs
    .filter(({ builtin, used }) => used && !builtin)
    .map(({ name, semantic, type }, i) => {
      const next = random(`attribute ${i}`);
      const width = Number(/[234]$/.exec(type)?.[0] ?? 1);
      const isInteger = !type.startsWith('float');
      const number = (at) =>
        i === 0
          ? at
          : isInteger
            ? Math.floor(2 * next())
            : semantic === 'BLENDWEIGHT'
              ? 1 / width
              : next();
      const values = corners.flatMap(([x, y]) => [x, y, 0, 1].slice(0, width).map(number));
      return { name, isInteger, values };
    });
}

/** A member's fields, where it has them, in its place. */
const fieldsOf = (member) =>
  member.fields?.map((field) => ({ ...field, offset: member.offset + field.offset })) ?? [member];

/** Where the integers of a buffer's member are, in words. */
function integersOf({ type, offset }) {
  const [, width = 1, count = 1] = /^(?:int|uint|bool)([234])?(?:\[(\d+)\])?$/.exec(type) ?? [
    '',
    0,
    0,
  ];
  return Array.from(
    { length: width * count },
    (_, i) => offset / 4 + 4 * Math.floor(i / width) + (i % width),
  );
}

/** The words of each constant buffer: matrices are nearly the identity, planes cut the image, integers are 1. */
function buffersOf({ cbuffers, clipPlanes }) {
  return Object.fromEntries(
    cbuffers.map(({ name, size, members }) => {
      const next = random(name);
      const floats = new Float32Array(Math.ceil(size / 16) * 4).map(() => 0.05 * next());
      for (const { type, offset, size: bytes } of members.flatMap(fieldsOf)) {
        const [, rows, columns, count = 1] = /^float([34])x([34])(?:\[(\d+)\])?$/.exec(type) ?? [];
        for (let i = 0; rows && i < count; ++i) {
          for (let k = 0; k < Math.min(rows, columns); ++k)
            floats[offset / 4 + i * 4 * Math.ceil(bytes / count / 16) + 5 * k] += 1;
        }
      }
      clipPlanes.forEach(({ cbuffer, offset }, i) => {
        if (cbuffer === name && offset !== undefined)
          floats.set([Math.cos(2 * i + 0.5), Math.sin(2 * i + 0.5), 0.1, 0.4], offset / 4);
      });
      const words = wordsOf(floats);
      for (const at of members.flatMap(integersOf)) words[at] = 1;
      return [name, words];
    }),
  );
}

/** The draws of a shader by WebGL 1 and by OpenGL, as `clipc-draw image` takes them. */
function drawsOf(ours, theirs) {
  const [numbers, buffers] = [numbersOf(ours.reflection), buffersOf(ours.reflection)];
  const common = {
    width: SIZE,
    height: SIZE,
    clear: [0, 0, 0, 0],
    reversed: false,
    float: true,
    vertices: corners.length,
    indices: corners.map((_, i) => i),
  };
  const uniforms = {};
  for (const { name, glsl: rows, members } of ours.reflection.cbuffers) {
    if (rows?.rows) uniforms[rows.rows] = buffers[name];
    for (const member of members)
      if (member.uniform) uniforms[member.glsl] = integersOf(member).map((at) => buffers[name][at]);
  }
  const attributes = (hasIntegers) =>
    Object.fromEntries(
      numbers.map(({ name, isInteger, values }) => [
        name,
        hasIntegers && isInteger ? values : wordsOf(values),
      ]),
    );
  const blocks = Object.fromEntries(
    theirs.reflection.cbuffers
      .filter(({ glsl }) => glsl?.block)
      .map(({ name, glsl }) => [glsl.block, buffers[name]]),
  );
  return [
    {
      ...common,
      vertex: ours.vertex,
      fragment: fragmentOf(ours, true),
      clipDistances: 0,
      attributes: attributes(false),
      blocks: {},
      uniforms,
    },
    {
      ...common,
      vertex: theirs.vertex,
      fragment: fragmentOf(theirs, false),
      clipDistances: theirs.reflection.clipDistanceMask,
      attributes: attributes(true),
      blocks,
      uniforms: {},
    },
  ];
}

const drawn = (description) => page.evaluate(`drawWebgl1(${JSON.stringify(description)})`);
const count = { shaders: 0, cut: 0 };
for (const path of folders
  .flatMap((folder) =>
    readdirSync(folder, { recursive: folder === 'testdata/glsl' })
      .sort()
      .map((name) => join(folder, name)),
  )
  .filter((name) => /\.(hlsl|fx)$/.test(name))) {
  if (ROUGH.some((name) => path.endsWith(name))) continue;
  const ours = compiled(path, 'webgl1', 'discard');
  const theirs = ours && compiled(path, 'glsl330', 'clip-distance');
  if (!theirs || ours.reflection.resources.length) continue;
  const [mine, desktop] = drawsOf(ours, theirs);
  const { colors, problem } = await drawn(mine);
  if (/^no words for/.test(problem)) continue; // a struct of uniforms
  assert.equal(problem, undefined, `${path}\n${mine.vertex}\n${mine.fragment}`);
  const expected = onDesktop(draw, desktop, scratch);
  const different = differing(colors, expected, SNAPPED);
  const shown = new Set(
    Array.from({ length: SIZE * SIZE }, (_, i) => expected.slice(4 * i, 4 * i + 4).join()),
  ).size;
  const cut = ours.discard
    ? differing(
        (await drawn({ ...mine, fragment: mine.fragment.replace('clip_planes();', '') })).colors,
        colors,
      )
    : 0;
  console.log(`   ${path}: ${shown} colors, ${different} pixels differ, ${cut} are cut`);
  if (shown < LEAST_COLORS) continue;
  assert.ok(
    different < AT_EDGES,
    `${path}: ${different} pixels differ from the desktop's\n${mine.vertex}`,
  );
  count.shaders += 1;
  count.cut += cut > 10 * AT_EDGES;
}
console.log(
  `${count.shaders} shaders drawn by WebGL 1 as the desktop draws them, ${count.cut} of them cut by discard`,
);
assert.ok(count.shaders >= 30 && count.cut >= 15, 'too few shaders to show anything');

// Browsers enforce what GLSL ES 1.00, appendix A, says of indices.
const indices = fileURLToPath(
  new URL('../../testdata/glsl/pixel/loop_indices.hlsl', import.meta.url),
);
const { stdout: fragment } = spawnSync(clipc, ['-T', 'ps_5_0', '--target=webgl1', indices], {
  encoding: 'utf8',
});
const refused = await page.evaluate(`(() => {
  const gl = new OffscreenCanvas(1, 1).getContext('webgl');
  const shader = gl.createShader(gl.FRAGMENT_SHADER);
  gl.shaderSource(shader, ${JSON.stringify(fragment)});
  gl.compileShader(shader);
  return gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? '' : gl.getShaderInfoLog(shader);
})()`);
assert.equal(refused, '', fragment);
await page.close();
