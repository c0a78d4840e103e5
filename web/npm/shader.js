// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A shader as a module of JavaScript, for webpack.js and vite.js.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

import { nothing } from './compiler.js';
import { createCompiler } from './node.js';
import { MIDDLE, optionsOfQuery } from './options.js';

let compiler;

/** @returns {{result: CompileResult, files: string[], code: string}} `files`: the includes */
export async function compileModule(path, text, query, configured) {
  const { options, mistake } = optionsOfQuery(query, configured);
  if (mistake) return { result: nothing('bad-request', mistake), files: [], code: '' };
  compiler ??= createCompiler();
  const files = [];
  const readInclude = (name) => {
    try {
      const include = readFileSync(name);
      files.push(resolve(name));
      return include;
    } catch {
      return null;
    }
  };
  const result = (await compiler).compile(text, { ...options, path, readInclude });
  const between = MIDDLE.map(({ stage }) => {
    const shader = result.shaders.find((each) => each.stage === stage);
    return `export const ${stage} = ${JSON.stringify(shader?.text ?? '')};\n`;
  });
  const exported = ['glsl', 'pixel', 'hlsl', 'discard', 'table', 'reflection'];
  const code = exported
    .map((name) => `export const ${name} = ${JSON.stringify(result[name])};\n`)
    .join('');
  return { result, files, code: `${code}${between.join('')}export default glsl || hlsl;\n` };
}
