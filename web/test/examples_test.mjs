// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The examples for Vite and webpack as a developer uses them: the dev server runs, a browser shows the page, the shader is edited,
// and the browser shows clipc's message, or the new shader.
//   node examples_test.mjs CHROMIUM FOLDER...     FOLDERs of installed examples
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createServer } from 'node:net';
import { cpSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';

import { Page } from './browser.mjs';
import { scratchFolder } from './desktop.mjs';

/** Where each dev server shows an error, as an expression. */
const OVERLAYS = {
  vite: `document.querySelector('vite-error-overlay')?.shadowRoot?.textContent`,
  webpack: `document.querySelector('#webpack-dev-server-client-overlay')?.contentDocument?.body?.textContent`,
};
const COMMANDS = {
  vite: ['vite', '--host', '127.0.0.1', '--strictPort', '--port'],
  webpack: ['webpack', 'serve', '--host', '127.0.0.1', '--port'],
};

const [chromium, ...folders] = process.argv.slice(2);

/** A port that was free a moment ago. */
const freePort = () =>
  new Promise((done) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });

/** Starts the dev server of a folder, and waits until it answers. */
async function started(kind, folder) {
  const address = `http://127.0.0.1:${await freePort()}/`;
  const [tool, ...given] = COMMANDS[kind];
  const server = spawn(join(folder, 'node_modules/.bin', tool), [...given, new URL(address).port], {
    cwd: folder,
    stdio: ['ignore', 'inherit', 'inherit'],
  });
  process.on('exit', () => server.kill());
  for (
    const end = Date.now() + 60000;
    Date.now() < end;
    await new Promise((done) => setTimeout(done, 100))
  ) {
    if (
      await fetch(address).then(
        ({ ok }) => ok,
        () => false,
      )
    )
      return { server, address };
  }
  throw new Error(`${kind}'s dev server does not answer`);
}

for (const installed of folders) {
  const kind = basename(installed);
  const folder = scratchFolder(kind);
  cpSync(installed, folder, {
    recursive: true,
    filter: (path) => basename(path) !== 'node_modules',
  });
  symlinkSync(resolve(installed, 'node_modules'), join(folder, 'node_modules'));
  const { server, address } = await started(kind, folder);
  const page = await Page.open(chromium, address);
  const shader = join(folder, 'plane.hlsl');
  const text = readFileSync(shader, 'utf8');
  await page.loaded(`document.body?.textContent.includes('gl_ClipDistance[0] = dot')`);
  assert.match(
    await page.evaluate('document.body.textContent'),
    /The plane is at byte 64 of Draw\./,
  );

  writeFileSync(shader, text.replace('to_clip);', 'to_klip);'));
  await page.until(
    `/\`to_klip\` is not declared; did you mean \`to_clip\`\\?/.test(${OVERLAYS[kind]})`,
  );
  assert.match(await page.evaluate(OVERLAYS[kind]), /plane\.hlsl:9:35: error/);

  writeFileSync(shader, text.replace('position, 1)', 'position, 2)'));
  await page.until(`document.body?.textContent.includes('vec4(in_POSITION0, 2.0)')`);
  console.log(
    `ok ${kind}: the page has the shader, the message of a wrong one, and the changed one`,
  );
  await page.close();
  server.kill();
}
process.exit(0); // webpack's dev server leaves connections
