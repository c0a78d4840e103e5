// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What Mesa draws of a draw that a page has described.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** A folder that is removed when the program ends. */
export function scratchFolder(name) {
  const folder = mkdtempSync(join(tmpdir(), `clipc-${name}-`));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** The colors that `clipc-draw image` gives, four floats for each pixel, the bottom row first. */
export function onDesktop(draw, description, scratch) {
  const [from, to] = [join(scratch, 'draw.json'), join(scratch, 'colors')];
  writeFileSync(from, JSON.stringify(description));
  execFileSync(draw, ['image', from, to], { stdio: ['ignore', 'inherit', 'inherit'] });
  const { buffer, byteOffset, byteLength } = readFileSync(to);
  return new Float32Array(buffer.slice(byteOffset, byteOffset + byteLength));
}
