// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
import { readFile } from 'node:fs/promises';

import { Compiler } from './compiler.js';

export { Compiler };

let module;
const load = () =>
  (module ??= readFile(new URL('./clipc.wasm', import.meta.url)).then((bytes) =>
    WebAssembly.compile(bytes),
  ));

export async function createCompiler(wasm) {
  return new Compiler(await (wasm ?? load()));
}

let shared;
export async function compile(text, options) {
  shared ??= createCompiler();
  return (await shared).compile(text, options);
}
