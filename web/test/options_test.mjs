// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The options of the npm package and of its plugins, which need no module.
import assert from 'node:assert/strict';

import { Compiler } from '../npm/compiler.js';
import { optionsOfQuery, wordsOf } from '../npm/options.js';
import { compileModule } from '../npm/shader.js';

const known = wordsOf({
  path: 'a.hlsl',
  profile: 'vs_5_0',
  target: 'webgl2',
  defines: { A: true, B: 2 },
  options: ['-Zpr'],
  readInclude: () => null,
});
assert.deepEqual(known.words, [
  ...['-T', 'vs_5_0', '--target=webgl2', '-D', 'A', '-D', 'B=2', '-Zpr'],
]);
assert.equal(known.mistake, '');
assert.equal(known.isPair, false);

// A pair, by a key and by an option.
assert(wordsOf({ pixelEntry: 'ps' }).isPair);
assert(wordsOf({ options: ['--pixel-entry=ps', '--pixel-output=.frag'] }).isPair);
assert.deepEqual(wordsOf({ geometryEntry: 'gs', pixelEntry: 'ps' }).words, [
  '--geometry-entry=gs',
  '--geometry-output=.geom',
  '--pixel-entry=ps',
  '--pixel-output=.frag',
]);
const tessellated = wordsOf({ hullEntry: 'hs', domainEntry: 'ds' });
assert.equal(tessellated.mistake, '');
assert.deepEqual(tessellated.words, [
  '--hull-entry=hs',
  '--hull-output=.tesc',
  '--domain-entry=ds',
  '--domain-output=.tese',
]);
assert.equal(optionsOfQuery('hullEntry=hs&domainEntry=ds', {}).mistake, '');
assert(!wordsOf({ options: ['--pixel-shader=a.frag', '--lower=discard'] }).isPair);

// An unknown key, also of a call: no module is started for it.
const mistakes = [
  [{ profil: 'vs_4_0' }, /unknown key `profil` of the options; did you mean `profile`\?\n/],
  [{ pixelentry: 'ps' }, /unknown key `pixelentry` of the options; did you mean `pixelEntry`\?/],
  [{ taregt: 'webgl2' }, /did you mean `target`\?/],
  [{ bogus: 1 }, /unknown key `bogus` of the options; it has path, profile, .*, readInclude\n/],
];
for (const [options, message] of mistakes) {
  assert.match(wordsOf(options).mistake, message);
  const result = new Compiler(null).compile('', options);
  assert.equal(result.ok, false);
  assert.equal(result.status, 'bad-request');
  assert.match(result.messages, message);
}

// The query of a bundler: its own keys over those of the configuration, and what vite adds.
const { options, mistake } = optionsOfQuery('entry=vs&options=-Zpr%20-O0&t=17&v=1&import', {
  profile: 'vs_4_0',
});
assert.equal(mistake, '');
assert.deepEqual(options, {
  profile: 'vs_4_0',
  target: 'webgl2',
  entry: 'vs',
  options: ['-Zpr', '-O0'],
});
const query = /unknown key `entri` of the query `\?entri=x`; did you mean `entry`\?/;
assert.match(optionsOfQuery('entri=x', {}).mistake, query);
const { result, code } = await compileModule('x.hlsl', '', 'entri=x', {});
assert.match(result.messages, query);
assert.equal(result.ok, false);
assert.equal(code, '');
assert.match(optionsOfQuery('readInclude=x', {}).mistake, /unknown key `readInclude`/);
console.log('ok');
