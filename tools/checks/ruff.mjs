// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Ruff, as the npm package has it: node ruff.mjs NODE_MODULES, with {options, write, files} as JSON on standard input.
// Prints what ruff says of the files, or with `write` formats them.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';

const require = createRequire(resolve(process.argv[2], 'package.json'));
const { PositionEncoding, Workspace } = require('@astral-sh/ruff-wasm-nodejs');
const { options, write, files } = JSON.parse(readFileSync(0, 'utf8'));
const ruff = new Workspace(options, PositionEncoding.Utf16);
for (const file of files) {
  const text = readFileSync(file, 'utf8');
  const formatted = ruff.format(text);
  if (formatted !== text) {
    if (write) writeFileSync(file, formatted);
    else console.log(`${file}: ruff writes this differently`);
  }
  for (const { code, message, start_location: at } of ruff.check(formatted)) {
    console.log(`${file}:${at.row}:${at.column}: ${message} [${code}]`);
  }
}
