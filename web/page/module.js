// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// clipc's module without glslang, compiled once for the page and its worker.
async function load() {
  const url = new URL('./light.wasm', import.meta.url);
  try {
    return await WebAssembly.compileStreaming(fetch(url));
  } catch (error) {
    if (!(error instanceof TypeError)) throw error; // a server that does not know the type of .wasm
    return WebAssembly.compile(await (await fetch(url)).arrayBuffer());
  }
}

export const module = load();
