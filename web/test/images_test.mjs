// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The page's images against the desktop's: each shader of the gallery, by each way to clip, drawn by WebGL 2 in headless Chromium
// and by Mesa's OpenGL ES with the same texts, vertices and constants.
//   node images_test.mjs FOLDER CHROMIUM CLIPC-DRAW
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { Page } from './browser.mjs';
import { onDesktop, scratchFolder } from './desktop.mjs';

const NEAR = 3; // of 255, for each channel
const LAYERED = ['terrain.hlsl']; // it flattens the mesh, and colors of one depth are any of its layers'
const MOST_DIFFERENT = 1 / 400; // of the pixels that are drawn: edges that fall to either side of a pixel's middle

const [folder, chromium, draw] = process.argv.slice(2);
const scratch = scratchFolder('images');
const script = readFileSync(fileURLToPath(new URL('record.js', import.meta.url)), 'utf8');
const page = await Page.open(chromium, folder, { script });
const set = page.set.bind(page);
await page.loaded('Number(document.documentElement.dataset.shows) > 0');

/** Does something after which the page compiles, and waits until that is drawn and measured: then nothing more is drawn. */
async function compiled(action) {
  const before = await page.evaluate('Number(document.documentElement.dataset.compiled)');
  await action();
  await page.until(`Number(document.documentElement.dataset.shows) > ${before}`);
}

/** The last draw of a canvas, and its pixels, the bottom row first. */
const drawnBy = (id) =>
  page.evaluate(`(() => {
    const gl = document.getElementById('${id}').getContext('webgl2');
    const pixels = new Uint8Array(4 * gl.canvas.width * gl.canvas.height);
    gl.readPixels(0, 0, gl.canvas.width, gl.canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return { draw: window.draws['${id}']?.(), pixels: Array.from(pixels) };
  })()`);

function expectedOf(description) {
  // Browsers have one of the two extensions, and OpenGL ES the other.
  const vertex = description.vertex.replace(
    'GL_ANGLE_clip_cull_distance',
    'GL_EXT_clip_cull_distance',
  );
  return onDesktop(draw, { ...description, vertex }, scratch).map((x) => Math.round(255 * x));
}

await page.evaluate(`document.getElementById('reference').click()`);
await set('mesh', 'Sphere');
await set('height', '0.3');
let compared = 0;
let cut = 0;
const wrong = [];
for (const shader of await page.evaluate(
  '[...document.getElementById("gallery").options].map((option) => option.value)',
)) {
  await compiled(() => set('gallery', shader));
  for (const [lower, id] of [
    ['discard', 'discarded'],
    ['clip-distance', 'clipped'],
    ['near-plane', 'clipped'],
    ['none', 'clipped'],
  ]) {
    await compiled(() => set('lower', lower));
    const caption = await page.evaluate(`document.getElementById('${id}-caption').textContent`);
    if (await page.evaluate('document.getElementById("status").classList.contains("bad")'))
      continue; // not to be had in WebGL 2
    const { draw: description, pixels } = await drawnBy(id);
    const expected = expectedOf(description);
    const background = [32, 36, 42];
    const isFar = (a, b) => [0, 1, 2].some((part) => Math.abs(a[part] - b[part]) > NEAR);
    let [drawn, different] = [0, 0];
    for (let i = 0; i < pixels.length; i += 4) {
      const [ours, theirs] = [pixels.slice(i, i + 3), expected.slice(i, i + 3)];
      drawn += isFar(theirs, background);
      different += LAYERED.includes(shader)
        ? isFar(ours, background) !== isFar(theirs, background)
        : isFar(ours, theirs);
    }
    console.log(`   ${shader}, ${lower}: ${drawn} pixels drawn, ${different} differ; ${caption}`);
    if (!drawn || different > drawn * MOST_DIFFERENT)
      wrong.push(`${shader}, ${lower}: ${different} of ${drawn} pixels`);
    ++compared;
    cut += description.clipDistances > 0 && drawn > 0;
  }
}
await page.close();
assert.deepEqual(page.errors, []);
assert.deepEqual(wrong, []);
console.log(`${compared} images are the desktop's, ${cut} of them with clip distances`);
assert.ok(compared >= 20 && cut >= 4, 'too few images to show anything');
