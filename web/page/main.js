// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
import { adviceFor, short, shownOf } from './advice.js';
import { Chart } from './chart.js';
import { Compiles } from './compile.js';
import { planesOf } from './constants.js';
import { Editor } from './editor.js';
import { Files, MAIN } from './files.js';
import { readGltf } from './gltf.js';
import { Handle } from './handle.js';
import { Lens } from './lens.js';
import { readLink, writeLink } from './link.js';
import { baked, MESHES } from './mesh.js';
import { Images } from './images.js';
import { presetOf, PRESETS } from './presets.js';
import { loadRuntime, SPACES } from './runtime.js';
import { CHAINS, Scene } from './scene.js';
import { isStart, startOf } from './start.js';
import { steer } from './steer.js';
import { Tabs } from './tabs.js';

const TARGETS = [
  'webgl2',
  'webgl1',
  'essl100',
  'essl300',
  'essl310',
  'essl320',
  'glsl120',
  'glsl130',
  'glsl140',
  'glsl150',
  'glsl330',
  'glsl400',
  'glsl410',
  'glsl420',
  'glsl430',
  'glsl440',
  'glsl450',
  'glsl460',
  'vulkan',
  'hlsl',
];
const LOWERINGS = ['clip-distance', 'discard', 'near-plane', 'level9', 'none'];
const DRAGS = { camera: 'turns the camera', plane: 'moves the plane', turn: 'turns the plane' };
const SAVED = ['options', 'target', 'lower', 'space', 'near', 'depth', 'offset', 'chain', 'mesh'];
const START = 'A cut model';
const WAIT = 120; // milliseconds after the last key
const MOST_FILE = 64 << 20;

const shaders = import.meta.webpackContext('./gallery', { regExp: /\.(hlsl|fx)$/ });
const gallery = Object.fromEntries(shaders.keys().map((path) => [path.slice(2), shaders(path)]));

const { dataset } = document.documentElement;
const element = (id) => document.getElementById(id);
const count = (name) => (dataset[name] = String(Number(dataset[name] ?? 0) + 1));
const say = (text, isBad = false) => {
  element('status').textContent = text;
  element('status').classList.toggle('bad', isBad);
};
const fill = (id, values) => {
  const named = Array.isArray(values)
    ? values.map((value) => [value, value])
    : Object.entries(values);
  element(id).replaceChildren(...named.map(([value, text]) => new Option(text, value)));
};

const scene = new Scene();
const views = [
  {
    element: element('clipped'),
    caption: element('clipped-caption'),
    name: 'Clipped by clip distances',
  },
  {
    element: element('discarded'),
    caption: element('discarded-caption'),
    name: 'Clipped by discard',
  },
];
const lens = new Lens(element('lens'));
const images = new Images(scene, views, lens, showScene, showNumbers);
const handle = new Handle(
  scene,
  Object.fromEntries(['stage', 'overlay', 'move', 'turn'].map((id) => [id, element(id)])),
  () => images.redraw(),
);
const chart = new Chart(element('chart'), ({ space, lower }) => {
  setValues({ space, lower });
});
const tabs = new Tabs(element('tabs'), element('text'), () => tabs.needsSpirv && compileSoon());
const compiles = new Compiles((version) => (dataset.version = version));
const editor = new Editor(element('source'), MAIN, () => compileSoon());
const files = new Files(
  { list: element('files'), name: element('name'), remove: element('remove') },
  editor,
  () => compileSoon(),
);

// ---- what is shown

/** The controls follow the scene. */
function showScene() {
  for (const id of ['height', 'tilt', 'heading']) element(id).value = scene.plane[id];
  handle.show();
  const works = images.views.map(({ canvas }) => canvas.work);
  dataset.draws = String(works.reduce((sum, work) => sum + work.draws, 0));
  dataset.uploads = String(works.reduce((sum, work) => sum + work.uploads, 0));
}

/** The cut's displacement in each plane space: measured in that of the shader, predicted in the others. */
function pixelsOf({ space, predicted, found }) {
  const shown = Object.entries(predicted).map(([name, pixels]) => [name, shownOf(pixels, found)]);
  return { ...Object.fromEntries(shown), ...(found && { [space]: found.displacement.p99 }) };
}

let numbersShown = null;

/** The sentence under the image. */
function showAdvice() {
  const { text, fix } = adviceFor(numbersShown, {
    view: viewChosen(),
    lower: element('lower').value,
    chain: scene.chain,
  });
  const words = text.split(/(--[\w=-]+)/).map((part, at) => {
    if (at % 2 === 0) return part;
    const option = document.createElement('code');
    option.textContent = part;
    return option;
  });
  element('sentence').replaceChildren(...words);
  element('fix').hidden = !fix;
  element('fix').textContent = fix?.text ?? '';
  element('fix').onclick = () => setValues(fix.values);
}

function showNumbers(numbers) {
  numbersShown = numbers;
  showAdvice();
  const place = element('prediction');
  place.textContent = numbers ? sentences(numbers) : 'No plane that a constant moves.';
  const { displacement, flicker } = numbers?.found ?? {};
  Object.assign(place.dataset, {
    predicted: numbers?.predicted[numbers.space] ?? '',
    measured: displacement?.p99 ?? '',
    median: displacement?.median ?? '',
    flicker: flicker?.p99 ?? '',
  });
  element('chart-part').hidden = !numbers;
  if (numbers)
    chart.show(numbers.planes, pixelsOf(numbers), {
      space: element('space').value,
      lower: element('lower').value,
    });
  count('measured');
  dataset.shows = dataset.compiled ?? '0'; // the compile whose images were measured
}

function sentences({ space, predicted, found, problem, warning }) {
  const expected = Number.isFinite(predicted[space])
    ? `Predicted displacement of the cut, for this view and others near it: ${short(shownOf(predicted[space], found))} pixels` +
      `${found && predicted[space] > found.most ? ' or more' : ''}.`
    : 'No prediction.';
  // The runtime knows neither the mesh nor the view: its number is that of an object as large as the image is high.
  const advice = warning.split('; ').slice(1).join('; ');
  const measured = found
    ? `Measured: ${short(found.displacement.p99)} pixels${found.isLeast ? ' or more' : ''} ` +
      `(99 of 100 of ${found.displacement.count} edges; median ` +
      `${short(found.displacement.median)}, largest ${short(found.displacement.largest)}). ` +
      `Flicker while the camera pans: ${short(found.flicker.p99)} pixels a frame (median ${short(found.flicker.median)}).`
    : 'Nothing to measure: no edge in view is cut, or the shader moves the mesh by itself.';
  const whole = found?.isLeast
    ? 'An edge of the mesh that is kept or dropped as a whole counts with its length; vertices farther away may be wrong too. '
    : '';
  const said = advice && `The runtime's advice: ${advice}.`;
  return `Plane space ${space}. ${expected} ${measured} ${whole}${said}${problem}`.trim();
}

// ---- compiling

const viewChosen = () => document.querySelector('#view input:checked').value;

/** The shown result, both images', and SPIR-V where it is looked at. */
function requests() {
  const space = element('space').value;
  const lower = element('lower').value;
  const words = element('options').value.split(/\s+/).filter(Boolean);
  const [pixelEntry] = words.flatMap((word) => /^--pixel-entry=(.+)/.exec(word)?.[1] ?? []);
  const options = words.filter((word) => !word.startsWith('--pixel-entry='));
  if (space !== 'clip') options.push(`--plane-space=${space}`);
  const drawn = (how) => ({
    target: 'webgl2',
    lower: how,
    pixelEntry,
    options: [...options, '--depth-range=negative-one-to-one'],
  });
  const isLeft = ['near-plane', 'none'].includes(lower);
  const left = viewChosen() === 'others' ? 'none' : isLeft ? lower : 'clip-distance';
  images.views[0].name = {
    'near-plane': 'Clipped by the near plane',
    none: 'Without the plane',
    'clip-distance': 'Clipped by clip distances',
  }[left];
  return [
    { target: element('target').value, lower, options, pixelEntry },
    left === 'clip-distance' && !images.hasClipDistances ? null : drawn(left),
    drawn('discard'),
    tabs.needsSpirv
      ? { target: 'vulkan', lower: 'clip-distance', options: [...options, '-spirv'], pixelEntry }
      : null,
  ];
}

let timer = 0;
function compileSoon() {
  clearTimeout(timer);
  timer = setTimeout(compileNow, WAIT);
}

async function compileNow() {
  const source = editor.text;
  const answer = await compiles.compile(source, requests(), files.includes);
  count('compiled');
  if (answer.stopped) return say('The shader took too long; the compile was stopped.', true);
  if (answer.failed) return say(answer.failed, true);
  const [shown, left, right, spirv] = answer.results;
  files.mark(shown.diagnostics);
  if (shown.status === 'bad-request' || shown.status === 'no-memory') say(shown.messages, true);
  else
    say(
      shown.ok ? `Compiled in ${answer.milliseconds.toFixed(1)} ms` : 'The shader has errors',
      !shown.ok,
    );
  tabs.show({ shown, spirv });
  const problems = [left, right].map((result) =>
    result && !result.ok && shown.ok ? (result.diagnostics[0]?.message ?? result.messages) : '',
  );
  if (!left && !images.hasClipDistances)
    problems[0] = 'this browser has no WEBGL_clip_cull_distance';
  images.use([left, right], source, problems);
  showPlanes();
}

/** As many planes to choose from as the shader in the image has. */
function showPlanes() {
  const planes = new Set(images.result ? planesOf(images.result.reflection) : []).size || 1;
  if (element('plane').options.length !== planes)
    fill(
      'plane',
      Array.from({ length: planes }, (_, i) => String(i + 1)),
    );
  scene.chosen = Number(element('plane').value) - 1;
  images.redraw();
}

// ---- the controls

function bind(id, set) {
  element(id).addEventListener('input', () => {
    set(element(id).value);
    images.redraw();
  });
}

/** Gives controls other values, as a person does. */
function setValues(values) {
  for (const [id, value] of Object.entries(values)) {
    element(id).value = value;
    element(id).dispatchEvent(new Event('input'));
  }
}

/** The canvas that is looked at, and the presets whose values the controls have. */
function showView() {
  const isDiscard =
    viewChosen() === 'discard' || (viewChosen() === 'clipc' && !images.hasClipDistances);
  for (const [id, isHidden] of [
    ['clipped', isDiscard],
    ['discarded', !isDiscard],
  ]) {
    element(id).hidden = isHidden;
    element(`${id}-caption`).hidden = isHidden;
  }
  showAdvice();
  images.redraw();
}

function showPreset() {
  const name = presetOf((id) => element(id).value);
  for (const button of element('presets').children)
    button.setAttribute('aria-pressed', String(button.textContent === name));
}

function makePresets() {
  for (const [name, values] of Object.entries(PRESETS)) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = name;
    button.addEventListener('click', () => setValues(values));
    element('presets').append(button);
  }
  for (const id of Object.keys(PRESETS.Near)) element(id).addEventListener('input', showPreset);
  showPreset();
}

let meshChosen = null;

/** Draws `mesh` from now on, with its vertices where the matrix chain has them. */
function placeMesh(mesh = meshChosen) {
  meshChosen = mesh;
  images.mesh = baked(mesh, scene.baked);
}

/** The mesh that the control names; a file's stays. */
const meshNamed = () => MESHES[element('mesh').value]?.() ?? meshChosen;

function choose(name) {
  const text = gallery[name] ?? startOf(scene.chain);
  element('options').value = text.match(/^\/\/ clipc (.*)$/m)?.[1] ?? '-T vs_5_0';
  files.includes = {};
  editor.text = text;
}

async function loadFile(file) {
  if (!file) return;
  try {
    if (file.size > MOST_FILE) throw new Error('the file is larger than 64 MB');
    placeMesh(readGltf(await file.arrayBuffer()));
    if (![...element('mesh').options].some(({ value }) => value === 'file'))
      element('mesh').append(new Option('', 'file'));
    element('mesh').options[element('mesh').options.length - 1].text = file.name;
    element('mesh').value = 'file';
    say(`${file.name} is loaded`);
  } catch (error) {
    say(error.message, true);
  }
}

function bindScene() {
  for (const id of ['height', 'tilt', 'heading'])
    bind(id, (value) => (scene.plane[id] = Number(value)));
  bind('plane', (value) => (scene.chosen = Number(value) - 1));
  bind('near', (value) => (scene.near = Number(value)));
  bind('offset', (value) => {
    scene.offset = Number(value);
    if (scene.chain === 'baked') placeMesh();
  });
  bind('depth', (value) => (scene.isReversed = value === 'reversed'));
  bind('chain', (value) => {
    const wasBaked = scene.baked;
    scene.chain = value;
    if (scene.baked !== wasBaked) placeMesh();
    if (isStart(editor.text)) editor.text = startOf(value);
  });
  element('reference').addEventListener('input', () => {
    images.showsReference = element('reference').checked;
    images.redraw();
  });
  element('mesh').addEventListener('input', () => placeMesh(meshNamed()));
  element('file').addEventListener('change', () => loadFile(element('file').files[0]));
  placeMesh(meshNamed());
  element('shows-lens').addEventListener('input', () => {
    lens.isOn = element('shows-lens').checked;
    images.redraw();
  });
  element('view').addEventListener('input', () => {
    showView();
    compileNow();
  });
  for (const { element: image } of views) {
    image.addEventListener('pointermove', ({ offsetX, offsetY, buttons }) => {
      if (buttons) return;
      lens.place = [(2 * offsetX) / image.clientWidth - 1, 1 - (2 * offsetY) / image.clientHeight];
      images.redraw();
    });
    image.addEventListener('pointerleave', () => {
      lens.place = null;
      images.redraw();
    });
    steer(
      image,
      scene,
      () => element('drag').value,
      () => images.redraw(),
    );
  }
}

function start() {
  fill('gallery', [START, ...Object.keys(gallery)]);
  fill('target', TARGETS);
  fill('lower', LOWERINGS);
  fill('space', SPACES);
  fill('mesh', Object.keys(MESHES));
  fill('near', ['0.1', '0.01', '0.001', '0.0001', '0.00001']);
  fill('depth', ['standard', 'reversed']);
  fill('offset', ['0', '1000', '100000']);
  fill('chain', CHAINS);
  fill('drag', DRAGS);
  fill('plane', ['1']);
  for (const id of ['target', 'lower', 'space', 'options'])
    element(id).addEventListener('input', compileSoon);
  element('gallery').addEventListener('input', () => choose(element('gallery').value));
  makePresets();
  bindScene();
  showView();
  element('link').addEventListener('click', async () => {
    const state = Object.fromEntries(SAVED.map((id) => [id, element(id).value]));
    Object.assign(state, { view: viewChosen(), scene: scene.saved });
    location.hash = await writeLink({ ...state, text: editor.text, includes: files.includes });
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    say('The address of this page now carries the shader');
  });
  loadRuntime().then(
    (loaded) => {
      images.runtime = loaded;
      images.redraw();
    },
    (error) => say(String(error), true),
  );
  openLink();
}

async function openLink() {
  const state = await readLink(location.hash).catch(() => null);
  if (!state) return choose(element('gallery').value);
  for (const id of SAVED) {
    const { options } = element(id);
    const isKnown = options ? [...options].some(({ value }) => value === state[id]) : id in state;
    if (isKnown) element(id).value = state[id];
  }
  scene.restore(state.scene);
  [scene.near, scene.offset] = [Number(element('near').value), Number(element('offset').value)];
  [scene.chain, scene.isReversed] = [element('chain').value, element('depth').value === 'reversed'];
  for (const choice of document.querySelectorAll('#view input'))
    if (choice.value === state.view) choice.checked = true;
  placeMesh(meshNamed());
  showView();
  showPreset();
  files.includes = state.includes ?? {};
  editor.text = state.text;
}

start();
