// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Compiles away from the page, which may end this worker at any time.
import { createCompiler } from 'clipc';

/** The page's first message is the module. */
let setModule;
const module = new Promise((resolve) => (setModule = resolve));
const ready = createCompiler(module).then((compiler) => {
  postMessage({ version: compiler.version });
  return compiler;
});

/** The compiler with glslang and with the listing of SPIR-V, which is loaded when a compile needs it. */
let whole;

/** Whether a compile has been timed: the first one starts the module, so it runs twice, and the second counts. */
let isStarted = false;

/** A result, with its SPIR-V as text where it has some. */
async function compile(light, text, options) {
  const result = light.compile(text, options);
  const isMissing = light.missedGlslang;
  if (!isMissing && !result.spirv.length) return result;
  const compiler = await (whole ??= createCompiler());
  const made = isMissing ? compiler.compile(text, options) : result;
  return made.spirv.length ? { ...made, text: compiler.disassemble(made.spirv) } : made;
}

addEventListener('message', async ({ data: { module, number, text, requests, includes } }) => {
  if (module) return setModule(module);
  const compiler = await ready;
  const readInclude = (path) => includes[path.replace(/^(\.\/)+/, '')];
  const compileAll = async () => {
    const results = [];
    for (const options of requests)
      results.push(options && (await compile(compiler, text, { ...options, readInclude })));
    return results;
  };
  if (!isStarted) await compileAll();
  isStarted = true;
  const began = performance.now();
  const results = await compileAll();
  postMessage({ number, results, milliseconds: performance.now() - began });
});
