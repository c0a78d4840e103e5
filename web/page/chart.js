// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Speed against accuracy for the scene in view: each way to clip is a point, and a button that chooses it.
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
const SETTING = 'picture';
const HEIGHT = 240; // pixels, as style.css has it
const LABEL = { height: 26, width: 130 };
const [LEAST_COST, MOST_COST] = [0.95, 1.4];
const [LEAST_PIXELS, MOST_PIXELS] = [1e-5, 1e2];

const rows = speed
  .trim()
  .split('\n')
  .slice(1)
  .map((line) => line.split(','))
  .map(([setting, way, planes, , , , ratio]) => ({
    setting,
    way,
    planes: Number(planes),
    ratio: Number(ratio),
  }));

/** A frame's time with so many planes, by the time without planes; null where the study has none. */
export function costOf(way, planes) {
  const measured = rows.filter(
    (row) => row.setting === SETTING && row.way === way && row.planes >= planes,
  );
  return measured.length ? measured.reduce((a, b) => (a.planes < b.planes ? a : b)).ratio : null;
}

const share = (x, least, most) => Math.min(1, Math.max(0, (x - least) / (most - least)));

export class Chart {
  #element;
  #points = new Map();

  /** `choose(way)` is called for a point that is pressed. */
  constructor(element, choose) {
    this.#element = element;
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

  /** `pixels[space]`: the displacement to expect in each plane space; `chosen`: {space, lower}. */
  show(planes, pixels, chosen) {
    const width = this.#element.clientWidth;
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
      const x = share(cost, LEAST_COST, MOST_COST) * (width - LABEL.width);
      const y =
        (1 - share(Math.log(displaced), Math.log(LEAST_PIXELS), Math.log(MOST_PIXELS))) *
        (HEIGHT - LABEL.height);
      dot.style.transform = `translate(${x}px, ${y}px)`;
      places.push({ button, x, y });
    }
    // Labels that would lie on one another move up.
    places.sort((a, b) => b.y - a.y);
    places.forEach((place, i) => {
      for (const below of places.slice(0, i)) {
        const isBeside = Math.abs(below.x - place.x) < LABEL.width;
        if (isBeside) place.y = Math.min(place.y, below.y - LABEL.height);
      }
      place.button.style.transform = `translate(${place.x + 12}px, ${place.y}px)`;
    });
  }
}
