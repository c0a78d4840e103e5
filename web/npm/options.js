// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The options of a call, and of the query of a bundler, as words for the compiler.

// The keys of CompileOptions.
// The stages between the first shader and the pixel shader, and the extension of their GLSL.
export const MIDDLE = [
  { stage: 'hull', extension: '.tesc' },
  { stage: 'domain', extension: '.tese' },
  { stage: 'geometry', extension: '.geom' },
];
const MIDDLE_KEYS = MIDDLE.map(({ stage }) => `${stage}Entry`);
const KEYS = [
  'path',
  'profile',
  'entry',
  'target',
  'lower',
  ...MIDDLE_KEYS,
  'pixelEntry',
  'pixelShader',
  'defines',
  'options',
  'readInclude',
];
const QUERY_KEYS = ['profile', 'entry', 'target', 'lower', ...MIDDLE_KEYS, 'pixelEntry', 'options'];
// What vite adds to the query of a module: its time and version, and how it is imported.
const OF_VITE = ['import', 't', 'v'];

/** The number of letters to insert, delete, replace or swap with their neighbour, without regard to case. */
function distance(from, to) {
  const [a, b] = [from.toLowerCase(), to.toLowerCase()];
  const rows = [Array.from({ length: b.length + 1 }, (_, k) => k)];
  for (let i = 1; i <= a.length; ++i) {
    rows[i] = [i];
    for (let k = 1; k <= b.length; ++k) {
      const replaced = rows[i - 1][k - 1] + (a[i - 1] !== b[k - 1]);
      rows[i][k] = Math.min(rows[i - 1][k] + 1, rows[i][k - 1] + 1, replaced);
      if (i > 1 && k > 1 && a[i - 1] === b[k - 2] && a[i - 2] === b[k - 1])
        rows[i][k] = Math.min(rows[i][k], rows[i - 2][k - 2] + 1);
    }
  }
  return rows[a.length][b.length];
}

/** A message about the first of `names` that is not one of `known`; empty if there is none. */
function mistakeIn(names, known, what) {
  const unknown = names.find((name) => !known.includes(name));
  if (unknown === undefined) return '';
  const limit = Math.max(1, Math.floor(unknown.length / 3));
  const near = known
    .map((name) => ({ name, edits: distance(unknown, name) }))
    .filter(({ edits }) => edits <= limit)
    .sort((one, other) => one.edits - other.edits);
  const advice = near.length ? `did you mean \`${near[0].name}\`?` : `it has ${known.join(', ')}`;
  return `clipc: error: unknown key \`${unknown}\` of ${what}; ${advice}\n`;
}

/**
 * @returns {{words: string[], isPair: boolean, mistake: string}} `mistake`: a message; empty if there is none. `isPair`:
 *   the pixel shader is an output too.
 */
export function wordsOf(options) {
  const words = [];
  if (options.profile) words.push('-T', options.profile);
  if (options.entry) words.push('-E', options.entry);
  if (options.target) words.push(`--target=${options.target}`);
  if (options.lower) words.push(`--lower=${options.lower}`);
  for (const { stage, extension } of MIDDLE) {
    const entry = options[`${stage}Entry`];
    if (entry) words.push(`--${stage}-entry=${entry}`, `--${stage}-output=${extension}`);
  }
  if (options.pixelShader) words.push(`--pixel-shader=${options.pixelShader}`);
  if (options.pixelEntry) words.push(`--pixel-entry=${options.pixelEntry}`);
  if (options.pixelShader || options.pixelEntry) words.push('--pixel-output=.frag');
  for (const [name, value] of Object.entries(options.defines ?? {})) {
    words.push('-D', value === true ? name : `${name}=${value}`);
  }
  words.push(...(options.options ?? []));
  return {
    words,
    isPair: words.some((word) => word.startsWith('--pixel-output')),
    mistake: mistakeIn(Object.keys(options), KEYS, 'the options'),
  };
}

/**
 * The options of `import './x.hlsl?target=webgl2&lower=discard'`, over those of the configuration.
 * @returns {{options: CompileOptions, mistake: string}}
 */
export function optionsOfQuery(query, configured) {
  const options = { profile: 'vs_5_0', target: 'webgl2', ...configured };
  const pairs = [...new URLSearchParams(query)].filter(([name]) => !OF_VITE.includes(name));
  for (const [name, value] of pairs) {
    if (name === 'options') options.options = value.split(/\s+/).filter(Boolean);
    else options[name] = value;
  }
  const names = pairs.map(([name]) => name);
  return { options, mistake: mistakeIn(names, QUERY_KEYS, `the query \`?${query}\``) };
}
