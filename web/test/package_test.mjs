// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Installs the package in an empty folder and uses it as a stranger does; and its bytes are those of the program.
//   node package_test.mjs PACKAGE.tgz CLIPC FOLDER...     FOLDERs of shaders to compare
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [archive, program, ...folders] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), 'clipc-package-'));
process.on('exit', () => rmSync(scratch, { recursive: true, force: true }));
writeFileSync(join(scratch, 'package.json'), '{"private": true, "type": "module"}');
execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', resolve(archive)], {
  cwd: scratch,
  stdio: ['ignore', 'pipe', 'inherit'],
});

const installed = pathToFileURL(join(scratch, 'node_modules/clipc/node.js'));
const { compile, createCompiler } = await import(installed);
const compiler = await createCompiler();

async function test(name, run) {
  await run();
  console.log(`ok ${name}`);
}

const SHADER = `#include "common.hlsli"
cbuffer C : register(b0) { float4x4 m; float4 plane; };
[clipplanes(plane)]
float4 main(float4 p : POSITION) : SV_Position { return mul(p * SCALE, m); }
`;
const readInclude = (path) => (path.endsWith('common.hlsli') ? '#define SCALE 2\n' : null);

writeFileSync(
  join(scratch, 'use.js'),
  `import { compile } from 'clipc';
const { glsl } = await compile('float4 main() : SV_Position { return 1; }', { profile: 'vs_5_0' });
process.stdout.write(glsl.split('\\n')[0]);`,
);
await test('an import by its name', () => {
  assert.equal(
    execFileSync('node', ['use.js'], { cwd: scratch, encoding: 'utf8' }),
    '#version 450',
  );
});

await test('every part of a result', () => {
  const options = {
    profile: 'vs_5_0',
    path: 'water.hlsl',
    readInclude,
    options: ['-spirv'],
    target: 'vulkan',
  };
  const result = compiler.compile(SHADER, options);
  assert.equal(result.status, 'compiled', result.messages);
  assert.match(result.glsl, /gl_ClipDistance\[0\] = dot/);
  assert.equal(result.spirv[0], 0x07230203);
  assert.equal(result.table.clipPlanes?.length ?? result.table.planes.length, 1);
  assert.equal(result.reflection.clipPlanes[0].offset, 64);
  assert.match(result.tableHeader, /clip_table/);
  assert.deepEqual(result.dependencies, ['common.hlsli']);
});

await test('both shaders of a program', () => {
  const text =
    'float4 vs(float2 uv : UV) : SV_Position { return uv.xyxy; } float4 ps() : SV_Target { return 1; }';
  const result = compiler.compile(text, { entry: 'vs', pixelEntry: 'ps', options: ['-spirv'] });
  assert.equal(result.status, 'compiled', result.messages);
  assert.match(result.pixel, /SV_Target0/);
  assert.equal(result.pixelSpirv[0], 0x07230203);
  const same = compiler.compile(text, {
    options: ['-E', 'vs', '--pixel-entry=ps', '--pixel-output=.frag', '-spirv'],
  });
  assert.equal(same.pixel, result.pixel);
  assert.equal(same.discard, '');
});

await test('every shader of a program', () => {
  const text =
    'struct V { float4 p : SV_Position; }; V vs(float2 uv : UV) { V v = {uv.xyxy}; return v; }' +
    '[maxvertexcount(1)] void gs(point V v[1], inout PointStream<V> s) { s.Append(v[0]); }' +
    'float4 ps() : SV_Target { return 1; }';
  const options = { entry: 'vs', geometryEntry: 'gs', pixelEntry: 'ps', options: ['-spirv'] };
  const { shaders, glsl, pixel, ...result } = compiler.compile(text, options);
  assert.equal(result.status, 'compiled', result.messages);
  assert.deepEqual(
    shaders.map(({ stage }) => stage),
    ['vertex', 'geometry', 'pixel'],
  );
  assert.equal(shaders[0].text, glsl);
  assert.match(shaders[1].text, /EmitVertex\(\)/);
  assert.equal(shaders[2].text, pixel);
  assert(shaders.every(({ spirv }) => spirv[0] === 0x07230203));
});

await test('HLSL with clip distances', () => {
  const result = compiler.compile(SHADER, { readInclude, target: 'hlsl' });
  assert.equal(result.status, 'compiled', result.messages);
  assert.match(result.hlsl, /#include "common.hlsli"[^]*SV_ClipDistance0/);
  assert.equal(result.glsl, '');
});

await test('an effect from memory', () => {
  const text = `#include "lights.fxh"
    float4 VS(float4 p : POSITION) : POSITION { return mul(p, World); }
    float4 PS() : COLOR { return 1; }
    technique Draw { pass P { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); } }`;
  const readInclude = (path) => (path === 'lights.fxh' ? 'float4x4 World;' : null);
  const options = ['--effect'];
  const result = compiler.compile(text, {
    path: 'water.fx',
    target: 'webgl2',
    options,
    readInclude,
  });
  assert.equal(result.status, 'compiled', result.messages);
  const [program] = result.effect.techniques[0].passes[0].programs;
  assert.match(program.glsl, /^#version 300 es/);
  assert.match(program.pixel, /^#version 300 es/);
  assert.deepEqual(
    program.code.map((shader) => shader.text),
    [program.glsl, program.pixel],
  );
  assert.equal(program.reflection.cbuffers[0].members[0].name, 'World');
  assert.equal(compiler.compile('float4 main() : SV_Position { return 1; }').effect, null);
});

await test('messages with their places', () => {
  const result = compiler.compile('float4 main() : SV_Position { return nothing; }', {
    profile: 'vs_5_0',
  });
  assert.equal(result.status, 'errors');
  assert.equal(result.glsl, '');
  assert.equal(result.diagnostics[0].severity, 'error');
  assert.equal(result.diagnostics[0].line, 1);
  assert.equal(result.diagnostics[0].column, 38);
  assert.match(result.messages, /shader\.hlsl:1:38: error/);
  assert.equal(compiler.compile('', { options: ['--no-such'] }).status, 'bad-request');
});

await test('what an include callback throws', () => {
  const readInclude = () => {
    throw new Error('mine');
  };
  assert.throws(() => compiler.compile(SHADER, { readInclude }), /mine/);
  assert.equal(compiler.compile('float4 main() : SV_Position { return 1; }').status, 'compiled');
});

await test('shader bombs end, and the compiler works afterwards', () => {
  const bombs = {
    conditions: '#if ' + '('.repeat(200000) + '\n#endif\n',
    calls: `float4 main() : SV_Position { return ${'sin('.repeat(20000)}1${')'.repeat(20000)}; }`,
    parentheses: `float4 main() : SV_Position { return ${'('.repeat(100000)}1${')'.repeat(100000)}; }`,
    sums: `float4 main() : SV_Position { return ${'1+'.repeat(50000)}1; }`,
    blocks: `float4 main() : SV_Position { ${'{'.repeat(100000)}${'}'.repeat(100000)} return 1; }`,
    includes: '#include "a.hlsli"\n',
    macros:
      '#define A0 1 1\n' +
      Array.from({ length: 40 }, (_, i) => `#define A${i + 1} A${i} A${i}\n`).join('') +
      'A40\n',
  };
  for (const [name, text] of Object.entries(bombs)) {
    const result = compiler.compile(text, { readInclude: () => text });
    assert.ok(name === 'sums' || !result.ok, name);
    assert.ok(result.ok || result.messages, name);
    assert.equal(
      compiler.compile('float4 main() : SV_Position { return 1; }').status,
      'compiled',
      name,
    );
    console.log(`   ${name}: ${result.status}: ${result.messages.split('\n')[0].slice(0, 100)}`);
  }
});

await test('memory ends at 1 GiB, with a message, and the compiler works afterwards', () => {
  const text = `float4 main() : SV_Position { return 1; }${' '.repeat(5e8)}`;
  const { status, messages } = compiler.compile(text);
  assert.equal(status, 'no-memory');
  assert.match(messages, /needs more stack or memory/);
  assert.equal(compiler.compile('float4 main() : SV_Position { return 1; }').status, 'compiled');
});

// ---- bundlers

const shader = join(scratch, 'water.hlsl');
writeFileSync(join(scratch, 'common.hlsli'), '#define SCALE 2\n');
writeFileSync(shader, SHADER);
const part = (name) => import(pathToFileURL(join(scratch, 'node_modules/clipc', name)));

await test('the plugin for Vite', async () => {
  const said = { files: [], errors: [] };
  const context = {
    addWatchFile: (file) => said.files.push(file),
    warn: (text) => said.errors.push(text),
    error: (error) => {
      throw error;
    },
  };
  const plugin = (await part('vite.js')).default({ profile: 'vs_5_0' });
  const { code } = await plugin.load.call(context, `${shader}?lower=discard`);
  assert.match(code, /export const discard = "[^"]*clip_planes/);
  assert.deepEqual(said, { files: [join(scratch, 'common.hlsli')], errors: [] });
  assert.equal(await plugin.load.call(context, join(scratch, 'use.js')), null);
  writeFileSync(
    join(scratch, 'wrong.hlsl'),
    'float4 main() : SV_Position {\n  return nothing;\n}\n',
  );
  await assert.rejects(
    plugin.load.call(context, join(scratch, 'wrong.hlsl')),
    ({ message, loc }) => /nothing/.test(message) && loc.line === 2 && loc.column === 9,
  );
});

await test('the loader for webpack', async () => {
  const { default: loader } = await part('webpack.js');
  const run = (text) =>
    new Promise((resolve) => {
      const files = [];
      const async = () => (error, code) => resolve({ error, code, files });
      loader.call(
        {
          async,
          resourcePath: shader,
          resourceQuery: '',
          getOptions: () => ({}),
          addDependency: (file) => files.push(file),
          emitWarning: () => {},
        },
        text,
      );
    });
  const { error, code, files } = await run(SHADER);
  assert.equal(error, null);
  assert.match(code, /export const glsl = "#version 300 es/);
  assert.deepEqual(files, [join(scratch, 'common.hlsli')]);
  assert.match(
    (await run('float4 main() : SV_Position { return nothing; }')).error.message,
    /nothing/,
  );
});

// ---- the same bytes

const run = (command, args) => {
  const { status, stdout, stderr } = spawnSync(command, args, {
    encoding: 'latin1',
    maxBuffer: 1 << 28,
  });
  return { status, stdout, stderr };
};

function shaders(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && /\.(hlsl|fx)$/.test(entry.name))
    .map((entry) => join(entry.path, entry.name))
    .sort();
}

const files = folders.flatMap(shaders);
const { messages: there } = compiler.compile('', { profile: 'vs_5_0', target: 'none such' });
const targets = [...there.slice(there.indexOf('there is')).matchAll(/`(\w+)`/g)].map(
  ([, name]) => name,
);
assert.ok(targets.length >= 19, there);
const lowerings = ['clip-distance', 'near-plane', 'none']; // for the others the program has files of its own, or asks for them
// Each shader as it comes, and for another target with another lowering, so that each of them has many shaders.
const comparisons = files.flatMap((file, i) => [
  { file },
  { file, target: targets[i % targets.length], lower: lowerings[i % lowerings.length] },
]);
let same = 0;
let milliseconds = 0;
for (const { file, target, lower } of comparisons) {
  const text = readFileSync(file);
  const began = performance.now();
  const result = compiler.compile(text, {
    path: file,
    profile: 'vs_5_0',
    target,
    lower,
    options: ['--diagnostics=text'],
    readInclude: (path) => {
      try {
        return readFileSync(path);
      } catch {
        return null;
      }
    },
  });
  milliseconds += performance.now() - began;
  const theirs = run(program, [
    file,
    '-T',
    'vs_5_0',
    ...(target ? [`--target=${target}`, `--lower=${lower}`] : []),
  ]);
  const ours = Buffer.from(result.messages).toString('latin1');
  const isSame =
    result.ok === (theirs.status === 0) &&
    ours === theirs.stderr &&
    (!result.ok || Buffer.from(result.glsl + result.hlsl).toString('latin1') === theirs.stdout);
  if (isSame) ++same;
  else
    console.log(
      `DIFFERS ${file}, ${target}, ${lower}: ${result.status}\n${ours.slice(0, 300)}\n--- the program: ${theirs.status}\n${theirs.stderr.slice(0, 300)}`,
    );
}
console.log(
  `${same} of ${comparisons.length} compiles of ${files.length} shaders have the program's bytes, ${(milliseconds / Math.max(comparisons.length, 1)).toFixed(2)} ms each`,
);
if (same !== comparisons.length) process.exitCode = 1;

const bin = join(scratch, 'node_modules/.bin/clipc');
for (const file of files.filter((_, i) => i % Math.ceil(files.length / 12) === 0)) {
  const reflected = [join(scratch, 'a.json'), join(scratch, 'b.json')];
  const [ours, theirs] = [bin, program].map((command, i) =>
    run(command, [file, '-T', 'vs_5_0', '--validate', `--reflect=${reflected[i]}`]),
  );
  assert.deepEqual(ours, theirs, file);
  if (ours.status === 0)
    assert.equal(readFileSync(reflected[0], 'utf8'), readFileSync(reflected[1], 'utf8'));
}
await test('the program of the package', () => {
  assert.deepEqual(run(bin, ['--help']), run(program, ['--help']));
  assert.deepEqual(run(bin, ['--no-such']), run(program, ['--no-such']));
  assert.match(run(bin, ['--version']).stdout, /^commit [0-9a-f]{12}, /m);
});
await compile('');
