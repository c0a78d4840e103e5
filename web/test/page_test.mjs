// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Uses the page as a person does, in headless Chromium.
//   node page_test.mjs FOLDER CHROMIUM PACKAGE AXE.js     PACKAGE: the npm package's folder; AXE.js: axe-core, which looks for what a
//                                                         screen reader or a keyboard cannot use
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

import { Page } from './browser.mjs';

const [folder, chromium, packed, axe] = process.argv.slice(2);
const page = await Page.open(chromium, folder);
const test = page.test.bind(page);
const set = page.set.bind(page);

const compiles = () => page.evaluate('Number(document.documentElement.dataset.compiled ?? 0)');

/** Does something that makes the page compile, and waits until it has. */
async function compiled(action) {
  const before = await compiles();
  await action();
  await page.until(`Number(document.documentElement.dataset.compiled ?? 0) > ${before}`);
}

async function type(text, options = '-T vs_5_0') {
  await page.evaluate(`document.getElementById('options').value = '${options}'`);
  await page.evaluate(
    `document.querySelector('.cm-content').focus(); document.execCommand('selectAll')`,
  );
  await compiled(() => page.send('Input.insertText', { text }));
}

/** The pixels of both images after a draw: how many differ from the background, and from each other, of how many. */
const pixels = () =>
  page.evaluate(`new Promise((resolve) => {
    document.getElementById('near').dispatchEvent(new Event('input'));
    requestAnimationFrame(() => {
      const [a, b] = ['clipped', 'discarded'].map((id) => {
        const from = document.getElementById(id);
        const copy = new OffscreenCanvas(from.width, from.height).getContext('2d');
        copy.drawImage(from, 0, 0);
        return copy.getImageData(0, 0, from.width, from.height).data;
      });
      const far = (x, y, i) => Math.abs(x[i] - y[i]) + Math.abs(x[i + 1] - y[i + 1]) + Math.abs(x[i + 2] - y[i + 2]) > 24;
      let [drawn, drawnBeside, different, hash] = [0, 0, 0, 0];
      for (let i = 0; i < a.length; i += 4) {
        const isDrawn = (x) => Math.abs(x[i] - 32) + Math.abs(x[i + 1] - 36) + Math.abs(x[i + 2] - 42) > 12;
        drawn += isDrawn(a);
        drawnBeside += isDrawn(b);
        different += far(a, b, i);
        hash = (Math.imul(hash, 31) + a[i]) | 0;
      }
      resolve({ all: a.length / 4, drawn, drawnBeside, different, hash });
    });
  })`);

await test('the page is ready with a shader that compiles', async () => {
  await page.loaded();
  await page.until(
    'document.documentElement.dataset.compiled && !document.getElementById("status").classList.contains("bad")',
  );
  await page.until(
    'document.getElementById("prediction").textContent.includes("Plane space clip")',
  );
  await page.until('Number(document.documentElement.dataset.measured) > 0');
  assert.match(
    await page.evaluate('document.getElementById("text").textContent'),
    /^#version 300 es\n#extension GL_ANGLE_clip_cull_distance/,
  );
});

const hasPlanes = await page.evaluate(
  '!!document.createElement("canvas").getContext("webgl2")?.getExtension("WEBGL_clip_cull_distance")',
);
let first;
await test(`both images show one cut${hasPlanes ? '' : ' (discard only: no WEBGL_clip_cull_distance)'}`, async () => {
  await set('height', '0');
  first = await pixels();
  assert.ok(first.drawnBeside > first.all / 50, JSON.stringify(first));
  if (hasPlanes) {
    assert.ok(first.drawn > first.all / 50, JSON.stringify(first));
    // Edges of clipped triangles are smoothed, those of discard are not.
    assert.ok(first.different < first.all / 100, JSON.stringify(first));
  }
});

await test('a plane that moves cuts more', async () => {
  await set('height', '-0.6');
  const less = await pixels();
  assert.ok(less.drawnBeside < first.drawnBeside * 0.8, JSON.stringify([first, less]));
  await set('height', '0');
});

await test('plane spaces draw the same cut', async () => {
  for (const space of ['xyw1', 'object', 'clip']) {
    await compiled(() => set('space', space));
    await page.until(
      'document.documentElement.dataset.shows === document.documentElement.dataset.compiled',
    );
    const now = await pixels();
    assert.ok(
      Math.abs(now.drawnBeside - first.drawnBeside) < first.all / 500,
      `${space}: ${JSON.stringify([first, now])}`,
    );
    assert.match(
      await page.evaluate('document.getElementById("prediction").textContent'),
      new RegExp(`Plane space ${space}`),
    );
  }
});

await test('other compilers draw what the plane should cut away', async () => {
  const view = (name) =>
    compiled(() => page.evaluate(`document.querySelector('#view [value=${name}]').click()`));
  await view('others');
  const whole = await pixels();
  assert.match(
    await page.evaluate('document.getElementById("sentence").textContent'),
    /drop the clip plane/,
  );
  assert.ok(whole.drawn > 1.2 * whole.drawnBeside, JSON.stringify(whole));
  await view('clipc');
  if (hasPlanes) assert.ok((await pixels()).drawn < whole.drawn / 1.2);
});

await test('a preset sets every control, and its advice helps', async () => {
  const press = (id, text) =>
    page.evaluate(
      `[...document.querySelectorAll('#${id}')].find((button) => button.textContent === '${text}').click()`,
    );
  const advised = (words) =>
    page.until(
      `document.documentElement.dataset.shows === document.documentElement.dataset.compiled && ${words}.test(document.getElementById('sentence').textContent)`,
    );
  /** What is predicted and measured of one cut is of one size, in every preset. */
  const agree = async () => {
    const told = await page.evaluate('document.getElementById("prediction").textContent');
    const [predicted, measured] = [
      /Predicted .*?: ([\d.e-]+) pixels/,
      /Measured: ([\d.e-]+) pixels/,
    ].map((pattern) => Number(pattern.exec(told)?.[1]));
    assert.ok(predicted < 10 * measured && measured < 3 * predicted, told);
    assert.doesNotMatch(told, /displaces the cut/, 'a third number');
  };
  await compiled(() => press('presets button', 'Far plane'));
  await advised('/off by [\\d.]+ pixels or more. With --plane-space=/');
  await agree();
  assert.equal(await page.evaluate('document.getElementById("near").value'), '0.00001');
  await compiled(() => page.evaluate('document.getElementById("fix").click()'));
  await advised('/nobody sees/');
  await compiled(() => press('presets button', 'World far away'));
  await advised('/--plane-space=object/');
  await agree();
  await compiled(() => page.evaluate('document.getElementById("fix").click()'));
  await advised('/nobody sees/');
  await compiled(() => press('presets button', 'Baked mesh'));
  await advised('/its own origin/');
  await agree();
  await compiled(() => page.evaluate('document.getElementById("fix").click()'));
  await advised('/nobody sees/');
  await compiled(() => press('presets button', 'Near'));
  await advised('/nobody sees/');
  await agree();
  assert.equal(
    await page.evaluate('document.querySelector("#presets [aria-pressed=true]").textContent'),
    'Near',
  );
});

await test('the handles follow the plane, and move it by the keyboard', async () => {
  const place = () =>
    page.evaluate(
      `(({ style, ariaValueNow }) => ({ top: style.top, now: ariaValueNow }))(document.getElementById('move'))`,
    );
  await set('height', '0');
  await pixels();
  const before = await place();
  await page.evaluate('document.getElementById("move").focus()');
  for (const type of ['keyDown', 'keyUp'])
    await page.send('Input.dispatchKeyEvent', { type, key: 'ArrowUp', code: 'ArrowUp' });
  await pixels();
  const after = await place();
  assert.equal(Number(after.now), 0.05);
  assert.notEqual(after.top, before.top);
  assert.equal(await page.evaluate('document.getElementById("height").value'), '0.05');
  const { x, y } = await page.evaluate(
    `(({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 }))(document.getElementById('move').getBoundingClientRect())`,
  );
  for (const [type, right] of [
    ['mousePressed', 0],
    ['mouseMoved', 10],
    ['mouseMoved', 20],
    ['mouseMoved', 30],
    ['mouseMoved', 40],
    ['mouseReleased', 40],
  ]) {
    await page.send('Input.dispatchMouseEvent', {
      type,
      x: x + right,
      y,
      button: 'left',
      buttons: 1,
      clickCount: 1,
    });
    await pixels();
  }
  const dragged = await page.evaluate(
    `(({ x, width }) => x + width / 2)(document.getElementById('move').getBoundingClientRect())`,
  );
  assert.ok(Math.abs(dragged - x - 40) < 12, `${dragged - x} pixels of 40`); // it stays under the pointer
  await set('height', '0');
});

await test('the lens shows the cut enlarged', async () => {
  await pixels();
  const colors = await page.evaluate(`(() => {
    const lens = document.getElementById('lens');
    const { data } = lens.getContext('2d').getImageData(0, 0, lens.width, lens.height);
    return lens.hidden ? 0 : new Set(new Uint32Array(data.buffer)).size;
  })()`);
  assert.ok(colors > 3, `${colors} colours`);
});

await test('the pixel shader of the text draws', async () => {
  const shader = (color) => `cbuffer C { float4x4 world, view_projection; float4 plane; };
struct V { float4 p : SV_Position; float3 n : NORMAL; };
[clipplanes(plane)] V main(float4 p : POSITION, float3 n : NORMAL) { V v = { mul(mul(p, world), view_projection), n }; return v; }
float4 ps(V v) : SV_Target { return float4(${color}, 1) + 0.1 * v.n.xyzz; }`;
  await type(shader('1, 0, 0'), '-T vs_5_0 --pixel-entry=ps');
  const red = await pixels();
  await type(shader('0, 1, 0'), '-T vs_5_0 --pixel-entry=ps');
  const green = await pixels();
  assert.ok(red.drawnBeside > red.all / 50, JSON.stringify(red));
  assert.ok(Math.abs(red.drawnBeside - green.drawnBeside) < red.all / 500);
  assert.notEqual(red.hash, green.hash);
  await compiled(() => set('gallery', 'sky.hlsl'));
  await compiled(() => set('gallery', 'A cut model'));
});

await test('a wrong shader shows its message and keeps the last image', async () => {
  const before = await pixels();
  await type('float4 main() : SV_Position { return nothing; }');
  await page.until('document.querySelector(".cm-lintRange-error")?.textContent === "nothing"');
  assert.match(await page.evaluate('document.getElementById("status").textContent'), /errors/);
  // The message is where the GLSL was, and the line has a mark.
  assert.match(
    await page.evaluate('document.getElementById("text").textContent'),
    /shader.hlsl:1:38: error: `nothing` is not declared/,
  );
  await page.until('document.querySelectorAll(".cm-lint-marker-error").length === 1');
  assert.deepEqual(await pixels(), before);
});

await test('an include is a tab of its own', async () => {
  const press = (text) =>
    page.evaluate(
      `[...document.querySelectorAll('#files button')].find((button) => button.textContent.startsWith('${text}')).click()`,
    );
  await type(
    '#include "lib/color.hlsli"\nfloat4 main(float4 p : POSITION) : SV_Position { return p * Scale(); }',
  );
  await compiled(() => press('Add an include'));
  await compiled(() =>
    page.evaluate(`(({ name }) => {
      name.value = 'lib/color.hlsli';
      name.dispatchEvent(new Event('change'));
    })({ name: document.getElementById('name') })`),
  );
  await type('float Scale() { return hundred; }');
  await page.until('document.querySelector(".cm-lintRange-error")?.textContent === "hundred"');
  await page.until(
    'document.querySelector("#files [aria-pressed=true]").textContent === "lib/color.hlsli (1)"',
  );
  await type('float Scale() { return 100; }');
  await page.until('/100\\.0/.test(document.getElementById("text").textContent)');
  await press('shader.hlsl');
  assert.match(
    await page.evaluate('document.querySelector(".cm-content").textContent'),
    /#include/,
  );
  assert.ok(await page.evaluate('document.getElementById("remove").hidden'));
  await press('lib/color.hlsli');
  await compiled(() => page.evaluate('document.getElementById("remove").click()'));
  assert.match(
    await page.evaluate('document.getElementById("text").textContent'),
    /cannot open file|cannot find include file/,
  );
});

await test('a shader bomb ends in a message', async () => {
  await type(`#if ${'('.repeat(20000)}\n#endif\n`);
  assert.match(
    await page.evaluate('document.getElementById("status").textContent'),
    /errors|took too long/,
  );
});

await test('every shader of the gallery', async () => {
  for (const name of await page.evaluate(
    '[...document.getElementById("gallery").options].map((option) => option.value)',
  )) {
    await compiled(() => set('gallery', name));
    await pixels();
    const text = await page.evaluate('document.getElementById("text").textContent');
    const caption = await page.evaluate('document.getElementById("discarded-caption").textContent');
    console.log(`   ${name}: ${text.split('\n')[0]}; ${caption}`);
  }
  await compiled(() => set('gallery', 'A cut model'));
});

await test('every target and lowering can be chosen, and says its GLSL or why not', async () => {
  const { compile } = await import(pathToFileURL(resolve(packed, 'node.js')));
  for (const id of ['target', 'lower']) {
    const { messages } = await compile('', { profile: 'vs_5_0', [id]: 'none such' });
    const all = [...messages.slice(messages.indexOf('there is')).matchAll(/`([\w-]+)`/g)].map(
      ([, name]) => name,
    );
    const offered = await page.evaluate(
      `[...document.getElementById('${id}').options].map((option) => option.value)`,
    );
    assert.ok(all.length >= 5, messages);
    assert.deepEqual(offered.sort(), all.sort());
    const first = await page.evaluate(`document.getElementById('${id}').value`);
    for (const name of all) {
      await compiled(() => set(id, name));
      const status = await page.evaluate('document.getElementById("status").textContent');
      const text = await page.evaluate('document.getElementById("text").textContent');
      assert.ok(
        /^Compiled/.test(status)
          ? (name === 'hlsl' ? /SV_ClipDistance|clipplanes/ : /^#version \d/).test(text)
          : /errors/.test(status) && /error: /.test(text),
        `${name}: ${status}: ${text}`,
      );
    }
    await compiled(() => set(id, first));
  }
});

await test('each tab shows its text', async () => {
  const shows = async (name, matches) => {
    await page.evaluate(
      `[...document.querySelectorAll('[role=tab]')].find((tab) => tab.textContent === '${name}').click()`,
    );
    await page.until(`${matches}.test(document.getElementById('text').textContent)`);
    assert.equal(
      await page.evaluate(`document.querySelector('[aria-selected=true]').textContent`),
      name,
    );
    return page.evaluate('document.getElementById("text").textContent');
  };
  await compiled(() => set('lower', 'discard'));
  assert.match(await shows('Pixel shader', /discard/), /SV_Target/);
  await compiled(() => set('lower', 'clip-distance'));
  const table = JSON.parse(await shows('Clip table', /^\{/));
  const reflection = JSON.parse(await shows('Reflection', /"inputs"/));
  assert.deepEqual([table.lowering, table.planes.length], ['clip-distance', 1]);
  assert.equal(reflection.clipPlanes.length, 1);
  assert.ok(page.served.has('light.wasm') && !page.served.has('clipc.wasm'));
  assert.match(await shows('SPIR-V', /Capability ClipDistance/), /EntryPoint Vertex/);
  assert.ok(page.served.has('clipc.wasm')); // it has glslang
  await shows('Messages', /^Nothing|warning|note/);
  await page.evaluate(`document.querySelector('[aria-selected=true]').focus()`);
  for (const type of ['keyDown', 'keyUp'])
    await page.send('Input.dispatchKeyEvent', { type, key: 'ArrowLeft', code: 'ArrowLeft' });
  await page.until('/^#version/.test(document.getElementById("text").textContent)');
});

await test('a matrix in a struct of a constant buffer is filled', async () => {
  const shader = (
    member,
    name,
  ) => `struct Camera { float4 spare; float4x4 viewProjection; };\ncbuffer Frame { ${member}; float4 plane; };
[clipplanes(plane)] float4 main(float4 position : POSITION) : SV_Position { return mul(position, ${name}); }`;
  await type(shader('float4 spare; float4x4 viewProjection', 'viewProjection'));
  const plain = await pixels();
  assert.ok(plain.drawnBeside > plain.all / 50, JSON.stringify(plain));
  await type(shader('Camera cameras[2]', 'cameras[1].viewProjection'));
  assert.deepEqual(await pixels(), plain);
  await compiled(() => set('gallery', 'A cut model'));
});

await test('a link carries the shader', async () => {
  await set('near', '0.01');
  await type('float4 main() : SV_Position { return 7; }');
  await page.evaluate('document.getElementById("link").click()');
  await page.until('location.hash.length > 10');
  await page.send('Page.reload');
  await page.until('document.querySelector(".cm-content")?.textContent.includes("return 7")');
  assert.equal(await page.evaluate('document.getElementById("near").value'), '0.01');
});

await test('it fits a phone', async () => {
  await page.send('Emulation.setDeviceMetricsOverride', {
    width: 390,
    height: 800,
    deviceScaleFactor: 2,
    mobile: true,
  });
  assert.ok((await page.evaluate('document.documentElement.scrollWidth')) <= 390);
});

for (const scheme of ['light', 'dark']) {
  await test(`axe-core finds nothing, ${scheme}`, async () => {
    await page.send('Emulation.setEmulatedMedia', {
      features: [{ name: 'prefers-color-scheme', value: scheme }],
    });
    await page.evaluate(readFileSync(axe, 'utf8') + '; 0');
    const { violations } = await page.evaluate('axe.run()');
    for (const { id, help, nodes } of violations)
      console.log(`   ${id}: ${help}: ${nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`);
    assert.deepEqual(
      violations.map(({ id }) => id),
      [],
    );
  });
}

await test('the documents have no broken link, and axe-core finds nothing', async () => {
  const links = () =>
    page.evaluate(
      `[...document.querySelectorAll('a[href], img')].map((link) => link.href || link.src)`,
    );
  const seen = new Map();
  const texts = new Map();
  const waiting = [await page.evaluate('document.querySelector("header a").href')];
  while (waiting.length) {
    const address = waiting.pop();
    if (seen.has(address)) continue;
    seen.set(address, true);
    await page.send('Page.navigate', { url: address });
    await page.until(`location.href === '${address}' && document.readyState === 'complete'`);
    texts.set(address, await page.evaluate('document.documentElement.outerHTML'));
    if (/\/docs\/(index|language|effects)/.test(address)) {
      await page.evaluate(readFileSync(axe, 'utf8') + '; 0');
      const { violations } = await page.evaluate('axe.run()');
      assert.deepEqual(
        violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`),
        [],
        address,
      );
    }
    for (const link of await links()) {
      const [file, anchor] = link.split('#');
      if (!file.includes('/docs/')) continue;
      if (file.endsWith('.html') && !seen.has(file)) waiting.push(file);
      if (!file.endsWith('.html'))
        assert.ok(statSync(join(folder, new URL(file).pathname)).size > 0, link);
      if (anchor) seen.set(link, true);
    }
  }
  for (const link of seen.keys()) {
    const [file, anchor] = link.split('#');
    assert.ok(!anchor || texts.get(file).includes(`id="${anchor}"`), link);
  }
  assert.ok(texts.size > 30, `${texts.size} documents`);
});

await test('the download is under 2 MB', async () => {
  const isFirst = (name) => !name.endsWith('.br') && name !== 'clipc.wasm' && name !== 'docs'; // loaded when they are needed
  const names = readdirSync(folder).filter(isFirst);
  const sizes = names.map((name) => statSync(join(folder, `${name}.br`)).size);
  const size = sizes.reduce((sum, x) => sum + x, 0);
  console.log(`   ${(size / 1e6).toFixed(2)} MB by brotli`);
  assert.ok(size < 2e6);
});

await page.close();
