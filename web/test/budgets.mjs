// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Prints what the page costs beside what it may cost; the exit status is 1 where something costs more. Times are of the
// processor, not of the clock. The size of the download is a test, page_test.mjs.
//   node budgets.mjs FOLDER PACKAGE CHROMIUM GALLERY       PACKAGE: the npm package's folder; GALLERY: a folder of shaders
import { readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

import { Page } from './browser.mjs';

const READY_SECONDS = 2;
const LOAD_MILLISECONDS = 100; // of the module, in node; V8 compiles it in threads of its own, which count
const FIRST_MILLISECONDS = 200; // the first shader, while V8 compiles the functions that it needs
const COMPILE_MILLISECONDS = 16;
const ROUNDS = 40;

const [folder, packed, chromium, gallery] = process.argv.slice(2);
let isOver = false;

function row(name, cost, budget, unit) {
  isOver ||= cost > budget;
  console.log(
    `${name.padEnd(44)} ${cost.toFixed(2).padStart(6)} of ${budget} ${unit}${cost > budget ? ', too much' : ''}`,
  );
}

const page = await Page.open(chromium, folder);
await page.loaded(
  'document.documentElement.dataset.compiled && document.documentElement.dataset.draws',
);
row('page ready', await page.processorTime(), READY_SECONDS, 's');
await page.close();

/** Does something, prints the processor's time for it and returns what it gives. */
async function timed(name, budget, run) {
  const before = process.cpuUsage();
  const result = await run();
  const { user, system } = process.cpuUsage(before);
  row(name, (user + system) / 1000, budget, 'ms');
  return result;
}

// What the page's worker does after a key: the text's result, and those of both images.
const { createCompiler } = await import(pathToFileURL(resolve(packed, 'node.js')));
const compiler = await timed('module loaded in node', LOAD_MILLISECONDS, () => createCompiler());
await timed('first shader in node', FIRST_MILLISECONDS, () =>
  compiler.compile(readFileSync(join(gallery, 'water_reflection.hlsl'), 'utf8'), {
    profile: 'vs_5_0',
  }),
);
for (const name of readdirSync(gallery).filter((file) => /\.(hlsl|fx)$/.test(file))) {
  const text = readFileSync(join(gallery, name), 'utf8');
  const options = text.match(/^\/\/ clipc (.*)$/m)[1].split(' ');
  const drawn = [...options, '--depth-range=negative-one-to-one'];
  const requests = [
    { lower: 'clip-distance', options },
    { lower: 'clip-distance', options: drawn },
    { lower: 'discard', options: drawn },
  ];
  const run = () =>
    requests.forEach((given) => compiler.compile(text, { target: 'webgl2', ...given }));
  for (let i = 0; i < ROUNDS; ++i) run();
  const before = process.cpuUsage();
  for (let i = 0; i < ROUNDS; ++i) run();
  const { user, system } = process.cpuUsage(before);
  row(`compiled three ways: ${name}`, (user + system) / 1e3 / ROUNDS, COMPILE_MILLISECONDS, 'ms');
}
process.exitCode = isOver ? 1 : 0;
