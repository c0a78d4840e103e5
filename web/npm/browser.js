// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
import { Compiler } from './compiler.js';

export { Compiler };

async function fetchModule() {
  const response = await fetch(new URL('./clipc.wasm', import.meta.url));
  if (!response.ok) throw new Error(`clipc.wasm: ${response.status} ${response.statusText}`);
  // Not compileStreaming: some servers do not say that the file is WebAssembly.
  return WebAssembly.compile(await response.arrayBuffer());
}

let module;
export async function createCompiler(wasm) {
  return new Compiler(await (wasm ?? (module ??= fetchModule())));
}

let shared;
export async function compile(text, options) {
  shared ??= createCompiler();
  return (await shared).compile(text, options);
}
