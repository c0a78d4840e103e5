// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A shader as a module of JavaScript, for webpack.js and vite.js.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

import { createCompiler } from './node.js';

let compiler;

/** The options of `import './x.hlsl?target=webgl2&lower=discard'`, over those of the configuration. */
function optionsOf(query, configured) {
  const options = { profile: 'vs_5_0', target: 'webgl2', ...configured };
  for (const [name, value] of new URLSearchParams(query)) {
    if (['profile', 'entry', 'target', 'lower', 'pixelEntry'].includes(name)) options[name] = value;
    else if (name === 'options') options.options = value.split(/\s+/).filter(Boolean);
  }
  return options;
}

/** @returns {{result: CompileResult, files: string[], code: string}} `files`: the includes */
export async function compileModule(path, text, query, configured) {
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
  const result = (await compiler).compile(text, {
    ...optionsOf(query, configured),
    path,
    readInclude,
  });
  const exported = ['glsl', 'pixel', 'hlsl', 'discard', 'table', 'reflection'];
  const code = exported
    .map((name) => `export const ${name} = ${JSON.stringify(result[name])};\n`)
    .join('');
  return { result, files, code: `${code}export default glsl || hlsl;\n` };
}
