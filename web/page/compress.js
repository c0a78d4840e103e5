// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Writes FILE.br beside each file of a folder, for servers that send files as they were compressed before.
//   node compress.js FOLDER
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';

const [folder] = process.argv.slice(2);
const names = readdirSync(folder, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile() && !entry.name.endsWith('.png'))
  .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)));
for (const name of names.filter((file) => file.endsWith('.br'))) rmSync(join(folder, name));
for (const name of names.filter((file) => !file.endsWith('.br'))) {
  const path = join(folder, name);
  const params = {
    [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
    [constants.BROTLI_PARAM_LGWIN]: constants.BROTLI_MAX_WINDOW_BITS,
  };
  writeFileSync(`${path}.br`, brotliCompressSync(readFileSync(path), { params }));
}
