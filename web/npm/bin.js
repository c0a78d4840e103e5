#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The program clipc: the same module, with this system's files.
import { readFileSync } from 'node:fs';

import { Instance, listOf } from './compiler.js';

// node says that its WASI is an experiment; clipc's messages are all that is to be printed.
const { emitWarning } = process;
process.emitWarning = (warning, ...rest) => {
  if (!String(warning).startsWith('WASI')) emitWarning(warning, ...rest);
};
const { WASI } = await import('node:wasi');

const wasi = new WASI({ version: 'preview1', env: process.env, preopens: { '/': '/' } });
const module = new WebAssembly.Module(readFileSync(new URL('./clipc.wasm', import.meta.url)));
const instance = new Instance(module, wasi.getImportObject().wasi_snapshot_preview1, () => null);
wasi.initialize(instance.instance);
try {
  const strings = listOf([process.cwd(), ...process.argv.slice(2)]);
  process.exitCode = instance.exports.clipc_module_run(instance.copy(strings), strings.length);
} catch (error) {
  if (!(error instanceof RangeError || error instanceof WebAssembly.RuntimeError)) throw error;
  console.error('clipc: error: the shader needs more stack or memory than WebAssembly gives');
  process.exitCode = 1;
}
