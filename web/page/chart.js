// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Speed against accuracy for the scene in view: each way to clip is a point, and a button that chooses it. Both axes have names, and
// zones say what can be seen.
import speed from './tables/speed.csv';

/** The ways that the page can draw, by their names in the study's tables. */
export const WAYS = {
  object: { space: 'object', lower: 'clip-distance' },
  xyw1: { space: 'xyw1', lower: 'clip-distance' },
  clip: { space: 'clip', lower: 'clip-distance' },
  'near-plane': { space: 'object', lower: 'near-plane' },
  'discard-object': { space: 'object', lower: 'discard' },
  discard: { space: 'clip', lower: 'discard' },
};
const WORKLOAD = 'image';
const HEIGHT = 300; // pixels, as style.css has it
const LABEL = { height: 24, width: 130 };
const ROOM = { left: 84, bottom: 46, top: 8 }; // for the axes
const [LEAST_COST, MOST_COST] = [0.95, 1.4];
const [LEAST_PIXELS, MOST_PIXELS] = [1e-5, 1e4];

const rows = speed
  .trim()
  .split('\n')
  .slice(1)
  .map((line) => line.split(','))
  .map(([workload, way, planes, , , , ratio]) => ({
    workload,
    way,
    planes: Number(planes),
    ratio: Number(ratio),
  }));

/** A frame's time with so many planes, by the time without planes; null where the study has none. */
export function costOf(way, planes) {
  const measured = rows.filter(
    (row) => row.workload === WORKLOAD && row.way === way && row.planes >= planes,
  );
  return measured.length ? measured.reduce((a, b) => (a.planes < b.planes ? a : b)).ratio : null;
}

const TICKS = { costs: [1, 1.1, 1.2, 1.3, 1.4], pixels: [1e-4, 1e-2, 1, 100, 1e4] };
const VISIBLE = 0.5; // pixels
const INVISIBLE = 1 / 256;

const share = (x, least, most) => Math.min(1, Math.max(0, (x - least) / (most - least)));

/** Labels that would lie on one another move apart, and stay in the chart. */
function spread(places) {
  places.sort((a, b) => a.y - b.y);
  const isBeside = (a, b) => Math.abs(a.x - b.x) < LABEL.width;
  places.forEach((place, i) => {
    for (const above of places.slice(0, i))
      if (isBeside(above, place)) place.y = Math.max(place.y, above.y + LABEL.height);
  });
  const last = HEIGHT - ROOM.bottom - LABEL.height;
  for (let i = places.length - 1; i >= 0; --i) {
    places[i].y = Math.min(places[i].y, last);
    for (const below of places.slice(i + 1))
      if (isBeside(below, places[i])) places[i].y = Math.min(places[i].y, below.y - LABEL.height);
  }
}

export class Chart {
  #element;
  #points = new Map();
  #axes;
  #lines;

  /** `choose(way)` is called for a point that is pressed. */
  constructor(element, choose) {
    this.#element = element;
    this.#axes = document.createElement('div');
    this.#axes.className = 'axes';
    this.#axes.setAttribute('aria-hidden', 'true');
    element.append(this.#axes);
    for (const name of Object.keys(WAYS)) {
      const dot = document.createElement('span');
      dot.className = 'dot';
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name;
      button.addEventListener('click', () => choose(WAYS[name]));
      element.append(dot, button);
      this.#points.set(name, { dot, button });
    }
  }

  /** `pixels[space]`: the displacement in each plane space; `chosen`: {space, lower}. */
  show(planes, pixels, chosen) {
    const width = this.#element.clientWidth - ROOM.left;
    const across = (cost) => ROOM.left + share(cost, LEAST_COST, MOST_COST) * (width - LABEL.width);
    const down = (displaced) =>
      ROOM.top +
      (1 - share(Math.log(displaced), Math.log(LEAST_PIXELS), Math.log(MOST_PIXELS))) *
        (HEIGHT - ROOM.bottom - ROOM.top);
    this.#drawAxes(across, down);
    const places = [];
    for (const [name, { dot, button }] of this.#points) {
      const { space, lower } = WAYS[name];
      const [cost, displaced] = [costOf(name, planes), pixels[space]];
      const isShown = cost !== null && Number.isFinite(displaced);
      dot.hidden = button.hidden = !isShown;
      if (!isShown) continue;
      button.setAttribute('aria-pressed', String(chosen.space === space && chosen.lower === lower));
      button.setAttribute(
        'aria-label',
        `${name}: ${cost.toFixed(2)} times the time without planes, edges move by ${displaced.toPrecision(2)} pixels`,
      );
      const [x, y] = [across(cost), down(displaced)];
      dot.style.transform = `translate(${x - 5}px, ${y - 5}px)`;
      dot.classList.toggle('chosen', button.getAttribute('aria-pressed') === 'true');
      places.push({ button, displaced, x, y: y - LABEL.height / 2 });
    }
    spread(places);
    for (const { button, displaced, x, y } of places) {
      button.style.transform = `translate(${x + 22}px, ${y}px)`;
      const line = `M${x} ${down(displaced)}L${x + 20} ${y + LABEL.height / 2}h4`;
      this.#lines.insertAdjacentHTML('beforeend', `<path d="${line}" />`);
    }
  }

  #drawAxes(across, down) {
    const bottom = HEIGHT - ROOM.bottom;
    const part = (name, style, text = '') => {
      const made = document.createElement('span');
      made.className = name;
      made.textContent = text;
      Object.assign(made.style, style);
      return made;
    };
    const zone = (name, from, to, text) =>
      part(
        `zone ${name}`,
        { top: `${down(from)}px`, height: `${down(to) - down(from)}px`, left: `${ROOM.left}px` },
        text,
      );
    this.#lines = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    this.#axes.replaceChildren(
      this.#lines,
      zone('visible', MOST_PIXELS, VISIBLE, 'everybody sees it'),
      zone('invisible', INVISIBLE, LEAST_PIXELS, 'nobody sees it'),
      ...TICKS.pixels.map((pixels) =>
        part(
          'tick',
          { top: `${down(pixels)}px`, left: '0', width: `${ROOM.left - 6}px` },
          String(pixels),
        ),
      ),
      ...TICKS.costs.map((cost) =>
        part('tick under', { top: `${bottom + 4}px`, left: `${across(cost)}px` }, String(cost)),
      ),
      part(
        'title',
        { top: `${bottom + 24}px`, left: `${ROOM.left}px` },
        'time of a frame; without planes it is 1 →',
      ),
      part('title upwards', { top: `${bottom}px` }, 'the cut is off by, in pixels →'),
    );
  }
}
