// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Compiles away from the page, which may end this worker at any time.
import { createCompiler } from 'clipc';

const ready = createCompiler().then((compiler) => {
  postMessage({ version: compiler.version });
  return compiler;
});

addEventListener('message', async ({ data: { number, text, settings } }) => {
  const compiler = await ready;
  const began = performance.now();
  const results = settings.map((options) => (options ? compiler.compile(text, options) : null));
  postMessage({ number, results, milliseconds: performance.now() - began });
});
