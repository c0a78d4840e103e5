// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// clipc's SPIR-V through naga, the compiler of wgpu: it validates, and gives WGSL that has the clip distances.
//   node naga_test.mjs CLIPC NAGA_FOLDER FOLDER...     NAGA_FOLDER: the installed package naga-wasm; FOLDERs of shaders
// A shader that naga 30 refuses stands below, with the words that naga says; OTHERWISE has the options with which it takes one. A
// shader that it takes must not stand there.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const REFUSED = {
  'cull_and_clip.hlsl': /CullDistance/,
  'cutaway.hlsl': /CullDistance/,
  'distances_without_gaps.hlsl': /CullDistance/,
  'control_flow.hlsl': /fall-through/,
  'skinning.hlsl': /Function .* is invalid/,
  'images.hlsl': /ImageBuffer/, // RWBuffer, which WGSL lacks
  'static_reads.hlsl': /SampledBuffer/, // Buffer, likewise
  'matrices.hlsl': /UnsupportedMatrixStride/, // of two components in each register of 16 bytes
  'packing.hlsl': /not a multiple of the required alignment/, // from Vulkan 1.1 on, vectors lie at any component of a row
  'packing_rules.hlsl': /not a multiple of the required alignment/,
  'matrix.hlsl': /cannot be used for user-defined entry point inputs or outputs/,
};
const OTHERWISE = {
  'packing.hlsl': ['-fspv-target-env=vulkan1.0'],
  'packing_rules.hlsl': ['-fspv-target-env=vulkan1.0'],
  'matrix.hlsl': ['--names=hlslcc'], // vectors between the stages, where WGSL has no matrices
};

const [program, folder, ...folders] = process.argv.slice(2);
const naga = await import(pathToFileURL(resolve(folder, 'dist/node.js')));
const scratch = mkdtempSync(join(tmpdir(), 'clipc-naga-'));
process.on('exit', () => rmSync(scratch, { recursive: true, force: true }));

function translate(spirv) {
  try {
    const module = naga.parseSpirv(spirv);
    return { wgsl: naga.writeWgsl(module, naga.validate(module)) };
  } catch (error) {
    return { problem: error.formatted ?? error.message ?? String(error) };
  }
}

let taken = 0;
let clipped = 0;

/** Translates a shader. `expected`: what naga says of it. */
function take(path, options, expected) {
  const output = join(scratch, 'x.spv');
  const compiled = spawnSync(program, [...options, '-spirv', path, '-o', output], {
    encoding: 'utf8',
  });
  if (compiled.status !== 0) return assert.equal(compiled.status, 1, `${path}: ${compiled.stderr}`); // of another profile or entry point
  const { wgsl, problem } = translate(readFileSync(output));
  if (expected) return assert.match(problem ?? 'taken', expected, path);
  assert.equal(problem, undefined, path);
  taken += 1;
  const glsl = spawnSync(program, [...options, '--target=vulkan', path, '-o', '-'], {
    encoding: 'utf8',
  }).stdout;
  const clips = /gl_ClipDistance\[/.test(glsl);
  assert.equal(/@builtin\(clip_distances\)/.test(wgsl), clips, `${path}: clip distances`);
  clipped += clips;
}

for (const shaders of folders) {
  for (const name of readdirSync(shaders).filter((file) => file.endsWith('.hlsl'))) {
    const path = join(shaders, name);
    const entry = /^\w+ vs\(/m.test(readFileSync(path, 'utf8')) ? 'vs' : 'main';
    const options = [
      '-w',
      '-T',
      'vs_5_0',
      '-E',
      entry,
      '--base-vertex=zero',
      '--base-instance=zero',
    ];
    take(path, options, REFUSED[name]);
    if (OTHERWISE[name]) take(path, [...options, ...OTHERWISE[name]]);
  }
}
console.log(`naga ${naga.nagaVersion}: ${taken} shaders, ${clipped} of them with clip distances`);
assert.ok(taken >= 40 && clipped >= 8, 'too few shaders to show anything');
