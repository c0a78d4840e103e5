// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A round canvas that shows a place of another one enlarged. It is drawn anew for that, so that lines stay thin.
export const ZOOM = 12;

export class Lens {
  /** Where it looks: [x, y] from -1 to 1, or null for the place of the cut that is nearest to the eye. */
  place = null;
  isOn = true;
  #context;

  constructor(element) {
    this.element = element;
    this.#context = element.getContext('2d');
  }

  /** Draws what `draw(viewport)` draws into `canvas`, enlarged. `lines`: those of the cut. */
  show(canvas, lines, draw) {
    const at = this.place ?? nearest(lines);
    this.element.hidden = !this.isOn || !at;
    if (this.element.hidden) return null;
    const { width, height } = canvas;
    const begin = (middle, size) => size / 2 - (middle * 0.5 + 0.5) * size * ZOOM;
    draw([begin(at[0], width), begin(at[1], height), width * ZOOM, height * ZOOM]);
    const size = this.element.width;
    const corner = [(width - size) / 2, (height - size) / 2];
    this.#context.drawImage(canvas, ...corner, size, size, 0, 0, size, size);
    return at;
  }
}

/** The point of `lines`, pairs of points of the clip space, that has the least depth in view; null if there is none. */
function nearest(lines) {
  let best = null;
  let least = Infinity;
  for (let i = 0; i < (lines?.length ?? 0); i += 4) {
    const [x, y, , w] = lines.subarray(i, i + 4);
    if (!(w > 0) || w >= least || Math.abs(x) > 0.8 * w || Math.abs(y) > 0.8 * w) continue;
    least = w;
    best = [x / w, y / w];
  }
  return best;
}
