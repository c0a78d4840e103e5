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

/** A result, with its SPIR-V as text where it has some. */
function compile(compiler, text, options) {
  const result = compiler.compile(text, options);
  return result.spirv.length ? { ...result, text: compiler.disassemble(result.spirv) } : result;
}

addEventListener('message', async ({ data: { module, number, text, settings } }) => {
  if (module) return setModule(module);
  const compiler = await ready;
  const began = performance.now();
  const results = settings.map((options) => options && compile(compiler, text, options));
  postMessage({ number, results, milliseconds: performance.now() - began });
});
