// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
import { Canvas } from './canvas.js';
import { Compiles } from './compile.js';
import { fillConstants } from './constants.js';
import { Editor } from './editor.js';
import { readLink, writeLink } from './link.js';
import { MESHES } from './mesh.js';
import { loadRuntime, SPACES } from './runtime.js';
import { Scene, steer } from './scene.js';
import { START } from './start.js';

const TARGETS = ['webgl2', 'glsl450', 'glsl330', 'glsl120', 'essl300', 'essl320', 'vulkan'];
const LOWERINGS = ['clip-distance', 'discard', 'near-plane', 'level9', 'none'];
const TABS = ['GLSL', 'Messages', 'Clip table', 'Reflection', 'Discard'];
const WAIT = 120; // milliseconds after the last key

const files = import.meta.webpackContext('./gallery', { regExp: /\.(hlsl|fx)$/ });
const gallery = { 'A cut model': START };
for (const path of files.keys()) gallery[path.slice(2)] = files(path);

const element = (id) => document.getElementById(id);
const say = (text, isBad = false) => {
  element('status').textContent = text;
  element('status').classList.toggle('bad', isBad);
};
const fill = (id, values) => element(id).append(...values.map((value) => new Option(value)));

const scene = new Scene();
const views = [
  { canvas: new Canvas(element('clipped')), caption: element('clipped-caption'), lower: 'clip-distance' },
  { canvas: new Canvas(element('discarded')), caption: element('discarded-caption'), lower: 'discard' },
];
let planeConstant = null;
let shown = null;
let tab = TABS[0];

// ---- the outputs

function showText() {
  const text = {
    GLSL: () => shown.glsl,
    Messages: () => shown.messages,
    'Clip table': () => (shown.table ? JSON.stringify(shown.table, null, 2) : ''),
    Reflection: () => (shown.reflection ? JSON.stringify(shown.reflection, null, 2) : ''),
    Discard: () => shown.discard,
  }[tab];
  element('text').textContent = (shown && text()) || (shown ? 'Nothing.' : '');
}

function makeTabs() {
  const select = (name) => {
    tab = name;
    for (const button of element('tabs').children) {
      const isSelected = button.textContent === name;
      button.setAttribute('aria-selected', String(isSelected));
      button.tabIndex = isSelected ? 0 : -1;
    }
    showText();
  };
  for (const name of TABS) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = name;
    button.setAttribute('role', 'tab');
    button.setAttribute('aria-controls', 'text');
    button.addEventListener('click', () => select(name));
    element('tabs').append(button);
  }
  element('tabs').addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    const next = (TABS.indexOf(tab) + step + TABS.length) % TABS.length;
    select(TABS[next]);
    element('tabs').children[next].focus();
  });
  select(tab);
  return select;
}

// ---- the pictures

function draw() {
  if (!planeConstant) return;
  const lines = [];
  for (const { canvas, caption, lower, problem } of views) {
    const { element: picture, result } = canvas;
    const matrices = scene.matrices(picture.width / picture.height);
    let unknown = [];
    if (result) {
      const position = result.table?.position_space;
      const space = SPACES.includes(position) ? position : 'clip';
      const constant = planeConstant(space, scene.plane, matrices, picture.height);
      const filled = fillConstants(result.reflection, result.source, matrices, () => constant.constant);
      unknown = filled.unknown;
      canvas.draw(filled.buffers, scene.isReversed);
      if (lower === 'clip-distance') lines.push(constant.problem ?? predicted(space, constant));
    }
    const missing = lower === 'clip-distance' && canvas.gl && !canvas.clip ? ': this browser has no WEBGL_clip_cull_distance' : '';
    const zeros = unknown.length ? `; zeros for ${unknown.join(', ')}` : '';
    caption.textContent = (lower === 'discard' ? 'Discard' : 'Clip distances') + (problem ? `: ${problem}` : missing || zeros);
  }
  element('prediction').textContent = lines.join(' ');
}

const predicted = (space, { edgeError, warning }) =>
  `Plane space ${space}: ${edgeError ? `edges move by up to ${edgeError.toPrecision(2)} pixels (predicted)` : 'no prediction'}.` +
  (warning ? ` ${warning}` : '');

let isDrawing = false;
function redraw() {
  if (isDrawing) return;
  isDrawing = true;
  requestAnimationFrame(() => {
    isDrawing = false;
    element('height').value = scene.height;
    draw();
  });
}

// ---- compiling

function settings() {
  const space = element('space').value;
  const options = element('options').value.split(/\s+/).filter(Boolean);
  if (space !== 'clip') options.push(`--plane-space=${space}`);
  const drawn = (lower) => ({ target: 'webgl2', lower, options: [...options, '--depth-range=negative-one-to-one'] });
  const main = { target: element('target').value, lower: element('lower').value, options };
  return [main, ...views.map(({ canvas, lower }) => (lower === 'clip-distance' && !canvas.clip ? null : drawn(lower)))];
}

const compiles = new Compiles((version) => (document.documentElement.dataset.version = version));
const editor = new Editor(element('source'), () => compileSoon());

let timer = 0;
function compileSoon() {
  clearTimeout(timer);
  timer = setTimeout(compileNow, WAIT);
}

async function compileNow() {
  const source = editor.text;
  const answer = await compiles.compile(source, settings());
  document.documentElement.dataset.compiled = String(Number(document.documentElement.dataset.compiled ?? 0) + 1);
  if (answer.stopped) return say('The shader took too long; the compile was stopped.', true);
  if (answer.failed) return say(answer.failed, true);
  [shown] = answer.results;
  editor.show(shown.diagnostics);
  if (shown.status === 'bad-request' || shown.status === 'no-memory') say(shown.messages, true);
  else say(shown.ok ? `Compiled three ways in ${answer.milliseconds.toFixed(1)} ms` : 'The shader has errors', !shown.ok);
  showText();
  views.forEach((view, i) => {
    const result = answer.results[i + 1];
    view.problem = '';
    if (result?.ok) view.problem = view.canvas.use({ ...result, source });
    else if (result && shown.ok) view.problem = result.diagnostics[0]?.message ?? result.messages;
  });
  redraw();
}

// ---- the controls

function bind(id, set) {
  element(id).addEventListener('input', () => {
    set(element(id).value);
    redraw();
  });
}

function choose(name) {
  const text = gallery[name];
  element('options').value = text.match(/^\/\/ clipc (.*)$/m)?.[1] ?? '-T vs_5_0';
  editor.text = text;
}

function start() {
  fill('gallery', Object.keys(gallery));
  fill('target', TARGETS);
  fill('lower', LOWERINGS);
  fill('space', SPACES);
  fill('mesh', Object.keys(MESHES));
  fill('near', ['0.1', '0.01', '0.001', '0.0001']);
  fill('depth', ['standard', 'reversed']);
  fill('offset', ['0', '1000', '100000']);
  makeTabs();
  for (const id of ['target', 'lower', 'space', 'options']) element(id).addEventListener('input', compileSoon);
  element('gallery').addEventListener('input', () => choose(element('gallery').value));
  bind('height', (value) => (scene.height = Number(value)));
  bind('tilt', (value) => (scene.tilt = Number(value)));
  bind('heading', (value) => (scene.heading = Number(value)));
  bind('near', (value) => (scene.near = Number(value)));
  bind('offset', (value) => (scene.offset = Number(value)));
  bind('depth', (value) => (scene.isReversed = value === 'reversed'));
  const setMesh = (name) => views.forEach(({ canvas }) => (canvas.mesh = MESHES[name]()));
  bind('mesh', setMesh);
  setMesh('Knot');
  for (const { canvas } of views) steer(canvas.element, scene, redraw);
  element('link').addEventListener('click', async () => {
    const state = Object.fromEntries(['options', 'target', 'lower', 'space'].map((id) => [id, element(id).value]));
    location.hash = await writeLink({ ...state, text: editor.text });
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    say('The address of this page now carries the shader');
  });
  loadRuntime().then(
    (loaded) => {
      planeConstant = loaded;
      redraw();
    },
    (error) => say(String(error), true),
  );
  openLink();
}

async function openLink() {
  const state = await readLink(location.hash).catch(() => null);
  if (!state) return choose(element('gallery').value);
  for (const id of ['options', 'target', 'lower', 'space']) element(id).value = state[id] ?? element(id).value;
  editor.text = state.text;
}

start();
