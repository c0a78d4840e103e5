// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Draws pairs by WebGL 2 in headless Chromium: of a vertex shader of clipc's and a pixel shader of other tools, and both of clipc's.
//   node pairs_test.mjs CLIPC CLIPC-DRAW CHROMIUM FOLDER       FOLDER: testdata/draw/pairs
// glslang and SPIRV-Cross translate both entry points of a shader to ES 3.00; clipc translates `vs` for the target webgl2 to fit
// the pixel shader, given as GLSL and as SPIR-V. Its image is that of the tools' own two halves, whose varyings SPIRV-Cross
// names by location; and the desktop's OpenGL ES draws the same. A swapped name and a swapped member give another image. So do both halves by
// clipc, that of examples/water too, but where a pixel reads its place: Direct3D counts rows from the top, the others leave that out.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { Page } from './browser.mjs';
import { onDesktop, scratchFolder } from './desktop.mjs';
import { differing } from './drawing.mjs';

// Rasterisers move vertices to places of their own, 1/16 or 1/256 of a pixel apart, and colors with them.
const SNAPPED = 0.03;
const AT_EDGES = 80; // pixels of 4096: a row of them, where the mesh ends

const [clipc, draw, chromium, folder] = process.argv.slice(2);
const here = fileURLToPath(new URL('.', import.meta.url));
const scratch = scratchFolder('pairs');
const page = await Page.open(chromium, here, { path: 'empty.html' });
await page.loaded();
await page.evaluate(
  `import('/draw_pair.mjs').then(({ drawPair }) => void (window.drawPair = drawPair))`,
);
if (
  !(await page.evaluate(
    `!!new OffscreenCanvas(1, 1).getContext('webgl2')?.getExtension('EXT_color_buffer_float')`,
  ))
) {
  console.log('this browser does not draw floats by WebGL 2');
  process.exit(77);
}

const run = (command, ...given) =>
  execFileSync(command, given, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** The shader's translations: both halves of the others, and the pixel shader to fit. */
function referencesOf(path, vertexEntry) {
  const spirv = {};
  for (const [entry, stage] of [
    [vertexEntry, 'vert'],
    ['ps', 'frag'],
  ]) {
    spirv[entry] = join(scratch, `${entry}.spv`);
    run('glslangValidator', '-D', '-V', '-S', stage, '-e', entry, path, '-o', spirv[entry]);
  }
  const cross = (entry, ...options) =>
    run('spirv-cross', spirv[entry], '--version', '300', '--es', ...options);
  const named = (way) =>
    Array.from({ length: 16 }, (_, i) => [
      '--rename-interface-variable',
      way,
      String(i),
      `varying_${i}`,
    ]).flat();
  const fragment = join(scratch, 'pixel.frag');
  writeFileSync(fragment, cross('ps'));
  return {
    fragment,
    spirv: spirv.ps,
    own: [cross(vertexEntry, ...named('out')), cross('ps', ...named('in'))],
  };
}

const drawn = (vertex, fragment) =>
  page.evaluate(`drawPair(${JSON.stringify(vertex)}, ${JSON.stringify(fragment)})`);

/** Two names that `pattern` finds with one type, of which one `isGood`; null where there are none. */
function alike(text, pattern, isGood) {
  const found = [...text.matchAll(pattern)];
  for (const [i, [, type, name]] of found.entries()) {
    const other = found
      .slice(i + 1)
      .find(
        ([, otherType, otherName]) => otherType === type && (isGood(name) || isGood(otherName)),
      );
    if (other) return [name, other[2]];
  }
  return null;
}

const exchanged = (text, [a, b]) =>
  text.replace(new RegExp(`\\b(${a}|${b})\\b`, 'g'), (name) => (name === a ? b : a));

/** The vertex shader with two outputs that have each other's name; null where no two are alike. */
function withSwappedNames(vertex) {
  const names = alike(vertex, /^(?:flat )?out (?:highp )?(\w+) (\w+);/gm, () => true);
  return names && exchanged(vertex, names);
}

/** The vertex shader with two members of a block in each other's place; null where no two are alike, or both unused. */
function withSwappedMembers(vertex) {
  const isUsed = (name) => new RegExp(`\\.${name}\\b`).test(vertex);
  const [blocks, rest] = [
    vertex.slice(0, vertex.indexOf('void main()')),
    vertex.slice(vertex.indexOf('void main()')),
  ];
  const names = alike(blocks, /^ {4}(vec\d|float) (\w+);/gm, isUsed);
  return names && exchanged(blocks, names) + rest;
}

/** The two shaders of a pair by clipc; null where the target or the browser cannot say them. */
function bothHalves(path) {
  const [vertex, fragment] = ['both.vert', 'both.frag'].map((file) => join(scratch, file));
  try {
    run(
      clipc,
      ...['-w', '-T', 'vs_5_0', '-E', 'vs', '--pixel-entry=ps', '--target=webgl2', path],
      ...['-o', vertex, `--pixel-output=${fragment}`],
    );
  } catch (error) {
    assert.match(error.stderr, /\[target-no-perspective\]/);
    return null;
  }
  const halves = [vertex, fragment].map((file) => readFileSync(file, 'utf8'));
  return /GL_ANGLE_clip_cull_distance/.test(halves[0]) ? null : halves;
}

let pairs = 0;
let both = 0;
const noticed = { name: 0, member: 0 };
for (const name of readdirSync(folder)
  .filter((file) => file.endsWith('.hlsl'))
  .sort()) {
  const path = join(folder, name);
  const text = readFileSync(path, 'utf8');
  const [line] = text.match(/^\/\/ RUN:.*/m);
  const halves = bothHalves(path);
  if (!halves) continue;
  const { fragment, spirv, own } = referencesOf(path, /--reference (\w+)/.exec(line)?.[1] ?? 'vs');
  const theirs = await drawn(...own);
  assert.equal(theirs.problem, undefined, `${name}, the others' halves`);
  const colors = new Set(
    Array.from({ length: 4096 }, (_, i) => theirs.colors.slice(4 * i, 4 * i + 4).join()),
  );
  assert.ok(colors.size > 64, `${name}: the image shows too little`);
  const ours = await drawn(...halves);
  assert.equal(ours.problem, undefined, `${name}, both halves\n${halves.join('\n')}`);
  if (!/gl_FragCoord/.test(halves[1])) {
    assert.equal(differing(ours.colors, theirs.colors), 0, `${name}: pixels of both halves`);
    both += 1;
  }
  if (/--targets/.test(line)) continue; // not every form of the pixel shader is for ES 3.00
  for (const pixelShader of [fragment, spirv]) {
    const vertex = run(
      clipc,
      '-w',
      '-T',
      'vs_5_0',
      '-E',
      'vs',
      '--target=webgl2',
      `--pixel-shader=${pixelShader}`,
      path,
      '-o',
      '-',
    );
    const pixels = readFileSync(fragment, 'utf8');
    const mine = await drawn(vertex, pixels);
    assert.equal(mine.problem, undefined, `${name}\n${vertex}`);
    assert.equal(
      differing(mine.colors, theirs.colors),
      0,
      `${name}: pixels that differ from the others' own halves`,
    );
    assert.ok(
      differing(mine.colors, onDesktop(draw, mine.draw, scratch), SNAPPED) < AT_EDGES,
      `${name}: pixels that differ from the desktop's`,
    );
    ++pairs;
    for (const [kind, spoil] of pixelShader === fragment
      ? [
          ['name', withSwappedNames],
          ['member', withSwappedMembers],
        ]
      : []) {
      const other = spoil(vertex);
      if (!other) continue;
      const spoiled = await drawn(other, pixels);
      assert.ok(
        spoiled.problem || differing(spoiled.colors, theirs.colors) > 0,
        `${name}: a swapped ${kind} changes nothing\n${other}`,
      );
      noticed[kind] += 1;
    }
  }
}
console.log(
  `${pairs} pairs and ${both} of clipc alone drawn by WebGL 2; ${noticed.name} with names and ${noticed.member} with members swapped are noticed`,
);
assert.ok(
  pairs >= 20 && both >= 19 && noticed.name >= 2 && noticed.member >= 1,
  'too few pairs to show anything',
);
await page.close();
