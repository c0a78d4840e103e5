// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The system that the module sees as a library: a clock, and no files. WASI preview 1.

const SUCCESS = 0;
const BAD_FILE = 8;
const NO_SUCH_FUNCTION = 52;

/**
 * The imports of `wasi_snapshot_preview1` for `module`. `memory()` gives its memory once it runs.
 * @param {WebAssembly.Module} module
 * @param {() => WebAssembly.Memory} memory
 */
export function emptySystem(module, memory) {
  const view = () => new DataView(memory().buffer);
  const functions = {
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    clock_time_get(_clock, _precision, to) {
      view().setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
      return SUCCESS;
    },
    clock_res_get(_clock, to) {
      view().setBigUint64(to, 1000n, true);
      return SUCCESS;
    },
    random_get(to, size) {
      crypto.getRandomValues(new Uint8Array(memory().buffer, to, size));
      return SUCCESS;
    },
    proc_exit(status) {
      throw new Error(`the module ended with status ${status}`);
    },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    if (from !== 'wasi_snapshot_preview1') continue;
    const missing = name.startsWith('fd_') ? BAD_FILE : NO_SUCH_FUNCTION;
    imports[name] = functions[name] ?? (() => missing);
  }
  return imports;
}
