// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the page shows of a cut: its displacement, measured and predicted, against the study's tables; flicker; planes, matrix
// chains, meshes and the chart.
//   node cut_test.mjs FOLDER CHROMIUM TABLES       TABLES: study/tables
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { Page } from './browser.mjs';

const ROWS = 360; // of the page's images; the study's have 1080
const STUDY_ROWS = 1080;

const [folder, chromium, tables] = process.argv.slice(2);
const page = await Page.open(chromium, folder);
const test = page.test.bind(page);
const set = page.set.bind(page);
const value = (id) => page.evaluate(`document.getElementById('${id}').value`);
const frame = () =>
  page.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
const text = (id) => page.evaluate(`document.getElementById('${id}').textContent`);

/** Waits until `isMeasured`. Returns what the page then tells of its cut, in pixels. */
async function told(isMeasured) {
  await page.until(isMeasured);
  const texts = await page.evaluate('({ ...document.getElementById("prediction").dataset })');
  return Object.fromEntries(
    Object.entries(texts).map(([name, digits]) => [name, digits === '' ? null : Number(digits)]),
  );
}
/** Does something that changes the scene. */
async function measured(action) {
  await page.evaluate('document.documentElement.dataset.measured = 0');
  await action();
  return told('Number(document.documentElement.dataset.measured) > 0');
}
/** Does something that makes the page compile. */
async function compiledAndMeasured(action) {
  const before = await page.evaluate('Number(document.documentElement.dataset.compiled)');
  await action();
  return told(`Number(document.documentElement.dataset.shows) > ${before}`);
}

await page.loaded('Number(document.documentElement.dataset.shows) > 0');

/** The column p99_px of the study's table directions.csv, by distance of eye and plane in near distances. */
function studied(method) {
  const rows = readFileSync(join(tables, 'directions.csv'), 'utf8')
    .trim()
    .split('\n')
    .slice(1)
    .map((line) => line.split(','));
  return rows
    .filter((row) => row[0] === 'standard' && row[2] === method)
    .map(([, ratio, , , , p99]) => ({ ratio: Number(ratio), p99: Number(p99) }));
}

/** The distance of the eye from the plane that goes through the mesh's middle, in near distances. */
function ratioOf(tilt, heading, near) {
  const [yaw, pitch, t, h] = [35, 22, tilt, heading].map((degrees) => (degrees * Math.PI) / 180);
  const eye = [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
  const normal = [Math.sin(t) * Math.cos(h), -Math.cos(t), Math.sin(t) * Math.sin(h)];
  return (2.4 * Math.abs(eye.reduce((sum, x, i) => sum + x * normal[i], 0))) / near;
}

const PLANES = [
  [20, 30],
  [70, -60],
  [100, 10],
  [140, 100],
  [60, 170],
  [90, 45],
];

await test("the displacement of `clip` is the study's", async () => {
  const [least] = studied('clip').filter(({ ratio }) => ratio >= 400);
  await set('near', '0.001');
  await set('height', '0');
  const shares = [];
  for (const [tilt, heading] of PLANES) {
    await set('tilt', String(tilt));
    const { measured: pixels, predicted } = await measured(() => set('heading', String(heading)));
    const expected =
      (least.p99 / least.ratio) * ratioOf(tilt, heading, 0.001) * (ROWS / STUDY_ROWS);
    console.log(
      `   tilt ${tilt}, heading ${heading}: ${pixels.toPrecision(2)} measured, ${predicted.toPrecision(2)} predicted, ${expected.toPrecision(2)} by the study's table`,
    );
    assert.ok(
      pixels / predicted > 0.1 && pixels / predicted < 3,
      `${pixels / predicted} of what is predicted`,
    );
    shares.push(pixels / expected);
  }
  const middle = shares.sort((a, b) => a - b)[PLANES.length / 2];
  assert.ok(middle > 0.2 && middle < 3, `${middle} times the study's`);
});

await test('`xyw1` and `object` cut where they should, and `object` does not flicker', async () => {
  const clip = await measured(() => set('heading', '30'));
  for (const space of ['xyw1', 'object']) {
    const now = await compiledAndMeasured(() => set('space', space));
    assert.ok(now.measured < clip.measured / 10, JSON.stringify({ clip, [space]: now }));
    assert.ok(now.measured < 3 * now.predicted, JSON.stringify(now));
    if (space === 'object') assert.ok(now.flicker < 1e-6, JSON.stringify(now));
    else assert.ok(clip.flicker > 10 * now.flicker, JSON.stringify({ clip, now }));
  }
});

await test('reversed depth helps `clip`', async () => {
  const standard = await compiledAndMeasured(() => set('space', 'clip'));
  const reversed = await measured(() => set('depth', 'reversed'));
  assert.ok(reversed.measured < standard.measured / 10, JSON.stringify({ standard, reversed }));
  await set('depth', 'standard');
});

await test("matrix chains far from the world's origin", async () => {
  await set('near', '0.1');
  await compiledAndMeasured(() => set('space', 'xyw1'));
  const far = {};
  far.steps = await measured(() => set('offset', '100000'));
  for (const chain of ['one', 'float', 'relative'])
    far[chain] = await compiledAndMeasured(() => set('chain', chain));
  console.log(
    `   ${Object.entries(far)
      .map(
        ([chain, at]) =>
          `${chain}: ${at.measured?.toPrecision(2)}, ${at.predicted.toPrecision(2)} predicted`,
      )
      .join('; ')}`,
  );
  assert.ok(far.steps.predicted > 1 && far.float.predicted > 1, JSON.stringify(far));
  for (const chain of ['one', 'relative'])
    assert.ok(far[chain].measured < 0.01 && far[chain].predicted < 0.01, chain);
  await set('offset', '0');
  await compiledAndMeasured(() => set('chain', 'steps'));
  await compiledAndMeasured(() => set('space', 'clip'));
});

const TWO = `cbuffer C { float4x4 world, view_projection; float4 planes[2]; };
[clipplanes(planes[0], planes[1])]
float4 main(float4 p : POSITION) : SV_Position { return mul(mul(p, world), view_projection); }`;

/** How many pixels of the right image are drawn. */
const drawn = () =>
  page.evaluate(`new Promise((resolve) => {
    document.getElementById('near').dispatchEvent(new Event('input'));
    requestAnimationFrame(() => {
      const from = document.getElementById('discarded');
      const copy = new OffscreenCanvas(from.width, from.height).getContext('2d');
      copy.drawImage(from, 0, 0);
      const { data } = copy.getImageData(0, 0, from.width, from.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) count += Math.abs(data[i] - 32) + Math.abs(data[i + 1] - 36) + Math.abs(data[i + 2] - 42) > 12;
      resolve(count);
    });
  })`);

await test('each plane has its own constant', async () => {
  await page.evaluate(`document.getElementById('options').value = '-T vs_5_0'`);
  await compiledAndMeasured(async () => {
    await page.evaluate(
      `document.querySelector('.cm-content').focus(); document.execCommand('selectAll')`,
    );
    await page.send('Input.insertText', { text: TWO });
  });
  assert.equal(await page.evaluate('document.getElementById("plane").options.length'), 2);
  const before = await drawn();
  await set('plane', '2');
  await frame();
  assert.notEqual(await value('height'), '0');
  const first = await measured(() => set('height', '-0.5'));
  const half = await drawn();
  assert.ok(half < 0.8 * before, `${before}, then ${half} pixels`);
  await set('plane', '1');
  await frame();
  assert.equal(await value('height'), '0');
  assert.ok(first.measured !== null);
});

await test('a drag turns the camera, moves or turns the plane', async () => {
  const drag = async (modifiers) => {
    const { x, y } = await page.evaluate(
      `(({ x, y }) => ({ x, y }))(document.getElementById('clipped').getBoundingClientRect())`,
    );
    const mouse = (type, dx, dy) =>
      page.send('Input.dispatchMouseEvent', {
        type,
        x: x + 100 + dx,
        y: y + 100 + dy,
        button: 'left',
        buttons: 1,
        clickCount: 1,
        modifiers,
      });
    await page.evaluate(`document.getElementById('clipped').scrollIntoView(); 0`);
    await mouse('mousePressed', 0, 0);
    await mouse('mouseMoved', 10, 30);
    await mouse('mouseReleased', 10, 30);
    await frame();
    return Promise.all(['height', 'tilt', 'heading'].map(value));
  };
  await page.evaluate(`document.getElementById('clipped').scrollIntoView(); 0`);
  const start = await Promise.all(['height', 'tilt', 'heading'].map(value));
  assert.deepEqual(await drag(0), start);
  const moved = await drag(8); // Shift
  assert.notEqual(moved[0], start[0]);
  assert.deepEqual(moved.slice(1), start.slice(1));
  const turned = await drag(1); // Alt
  assert.equal(turned[0], moved[0]);
  assert.notEqual(turned[1], moved[1]);
  assert.notEqual(turned[2], moved[2]);
});

await test('a point of the chart chooses its way, by the keyboard', async () => {
  await compiledAndMeasured(() => set('gallery', 'A cut model'));
  await page.evaluate(
    `[...document.querySelectorAll('#chart button')].find((button) => button.textContent === 'xyw1').focus()`,
  );
  await compiledAndMeasured(async () => {
    for (const type of ['keyDown', 'keyUp'])
      await page.send('Input.dispatchKeyEvent', {
        type,
        key: 'Enter',
        code: 'Enter',
        text: type === 'keyDown' ? '\r' : '',
      });
  });
  assert.equal(await value('space'), 'xyw1');
  assert.equal(
    await page.evaluate(`document.querySelector('#chart [aria-pressed=true]').textContent`),
    'xyw1',
  );
  const costs = readFileSync(join(tables, 'speed.csv'), 'utf8')
    .trim()
    .split('\n')
    .map((line) => line.split(','));
  const cost = Number(
    costs.find(
      ([workload, way, planes]) => workload === 'image' && way === 'object' && planes === '1',
    )[costs[0].indexOf('paired_ratio')],
  );
  assert.match(
    await page.evaluate(`document.querySelector('#chart button').getAttribute('aria-label')`),
    new RegExp(
      `^object: ${cost.toFixed(2)} times the time without planes, edges move by [\\d.e-]+ pixels`,
    ),
  );
  await compiledAndMeasured(() =>
    page.evaluate(
      `[...document.querySelectorAll('#chart button')].find((button) => button.textContent === 'near-plane').click()`,
    ),
  );
  assert.equal(await value('lower'), 'near-plane');
  assert.match(await text('clipped-caption'), /^Clipped by the near plane/);
  await compiledAndMeasured(() => set('lower', 'clip-distance'));
});

/** A tetrahedron as .glb. */
function tetrahedron() {
  const positions = new Float32Array([0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9]);
  const indices = new Uint16Array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
  const binary = Buffer.concat([positions, indices].map(({ buffer }) => Buffer.from(buffer)));
  const accessor = (bufferView, componentType, type, count) => ({
    bufferView,
    componentType,
    type,
    count,
  });
  const json = JSON.stringify({
    asset: { version: '2.0' },
    buffers: [{ byteLength: binary.length }],
    bufferViews: [
      { buffer: 0, byteLength: 48 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
    accessors: [accessor(0, 5126, 'VEC3', 4), accessor(1, 5123, 'SCALAR', 12)],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
  });
  const chunk = (kind, bytes) =>
    Buffer.concat([Buffer.from(new Uint32Array([bytes.length, kind]).buffer), bytes]);
  const chunks = [
    chunk(0x4e4f534a, Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4))),
    chunk(0x004e4942, binary),
  ];
  const size = 12 + chunks.reduce((sum, { length }) => sum + length, 0);
  return Buffer.concat([Buffer.from(new Uint32Array([0x46546c67, 2, size]).buffer), ...chunks]);
}

await test('a glTF file is drawn, and a damaged one ends in a message', async () => {
  const scratch = mkdtempSync(join(tmpdir(), 'clipc-gltf-'));
  const load = async (name, bytes) => {
    writeFileSync(join(scratch, name), bytes);
    const { root } = await page.send('DOM.getDocument');
    const { nodeId } = await page.send('DOM.querySelector', {
      nodeId: root.nodeId,
      selector: '#file',
    });
    await page.send('DOM.setFileInputFiles', { nodeId, files: [join(scratch, name)] });
    await page.until(`/glTF|loaded/.test(document.getElementById('status').textContent)`);
    const status = await text('status');
    await page.evaluate(`document.getElementById('status').textContent = ''`);
    return status;
  };
  for (const [id, at] of [
    ['height', '0.3'],
    ['tilt', '20'],
    ['heading', '30'],
  ])
    await set(id, at);
  const whole = tetrahedron();
  const numbers = await measured(() => load('whole.glb', whole));
  assert.equal(await value('mesh'), 'file');
  assert.ok((await drawn()) > 1000);
  assert.ok(numbers.measured !== null);
  const before = await drawn();
  for (const [name, bytes] of [
    ['short.glb', whole.subarray(0, whole.length - 8)],
    ['text.gltf', '{"meshes": 1}'],
    ['away.gltf', '{"buffers": [{"uri": "a.bin"}]}'],
  ]) {
    assert.match(await load(name, bytes), /^the glTF file /, name);
  }
  assert.equal(await drawn(), before);
  rmSync(scratch, { recursive: true });
});

await test('SPIR-V as text', async () => {
  await page.evaluate(
    `[...document.querySelectorAll('[role=tab]')].find((tab) => tab.textContent === 'SPIR-V').click()`,
  );
  await page.until(`document.getElementById('text').textContent.includes('BuiltIn ClipDistance')`);
  assert.match(await text('text'), /EntryPoint Vertex/);
});

// Two images and the lens, each with its lines.
await test('a frame has a bounded number of draws and uploads', async () => {
  for (const shader of await page.evaluate(
    '[...document.getElementById("gallery").options].map((option) => option.value)',
  )) {
    await compiledAndMeasured(() => set('gallery', shader));
    const { draws, uploads } = await page.evaluate('({ ...document.documentElement.dataset })');
    assert.ok(
      Number(draws) <= 6 && Number(uploads) <= 24,
      `${shader}: ${draws} draws, ${uploads} uploads`,
    );
  }
});

await page.close();
