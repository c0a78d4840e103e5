// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The plane over the image: its outline, a handle that moves it and one that turns it.
import { cross, transformed } from './matrices.js';

const SIZE = 1.05; // of the outline, from its middle to its sides
const ARROW = 0.55;
const STEP = 0.01;
const KEYS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };
const LEAST_PIXELS = 25; // of a unit along the normal, as the image shows it

export class Handle {
  /** `elements`: {stage, overlay, move, turn}. `moved()` is called after each change of the scene. */
  constructor(scene, elements, moved) {
    this.scene = scene;
    Object.assign(this, elements);
    this.#steer(this.move, (right, down) => scene.movePlane(this.#along(right, down)), moved);
    this.#steer(this.turn, (right, down) => scene.turnPlane(right / 2, down / 2), moved);
    this.#keys(this.move, (step) => scene.movePlane(0.05 * step), moved);
    this.#keys(
      this.turn,
      (step, isSideways) => scene.turnPlane(isSideways ? 5 * step : 0, isSideways ? 0 : 5 * step),
      moved,
    );
  }

  /** How far a drag of the image's pixels moves the plane against its normal. */
  #along(right, down) {
    const [x, y] = this.normalInView;
    const length = Math.max(Math.hypot(x, y), LEAST_PIXELS);
    return -(right * x + down * y) / (length * length);
  }

  #steer(element, change, moved) {
    let last = null;
    element.addEventListener('pointerdown', (event) => {
      last = event;
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener('pointermove', (event) => {
      if (!last || !event.buttons) return;
      const scale = this.overlay.viewBox.baseVal.width / this.stage.clientWidth;
      change((event.clientX - last.clientX) * scale, (event.clientY - last.clientY) * scale);
      last = event;
      moved();
    });
    element.addEventListener('pointerup', () => (last = null));
  }

  #keys(element, change, moved) {
    element.addEventListener('keydown', (event) => {
      const step = KEYS[event.key];
      if (!step) return;
      event.preventDefault();
      change(step, event.key === 'ArrowLeft' || event.key === 'ArrowRight');
      moved();
    });
  }

  /** Follows the scene. */
  show() {
    const { width, height } = this.overlay.viewBox.baseVal;
    const { view, projection, planes } = this.scene.matrices(width / height);
    const [a, b, c, d] = planes[this.scene.chosen];
    const normal = [a, b, c];
    const origin = this.scene.middle;
    const distance = normal.reduce((sum, x, i) => sum + x * origin[i], d);
    const middle = origin.map((x, i) => x - distance * normal[i]);
    const side = unit(cross(normal, Math.abs(b) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
    const up = cross(normal, side);
    const at = (s, u, n) => {
      const point = middle.map((x, i) => x + s * side[i] + u * up[i] + n * normal[i]);
      const [x, y, , w] = transformed(transformed([...point, 1], view), projection);
      return [(x / w / 2 + 0.5) * width, (0.5 - y / w / 2) * height];
    };
    const corners = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([s, u]) => at(SIZE * s, SIZE * u, 0));
    const [foot, tip] = [at(0, 0, 0), at(0, 0, ARROW)];
    const ahead = at(0, 0, STEP);
    this.normalInView = [0, 1].map((i) => (ahead[i] - foot[i]) / STEP);
    this.overlay.innerHTML =
      `<polygon points="${corners.map((point) => point.map((x) => x.toFixed(1))).join(' ')}" />` +
      `<line x1="${foot[0]}" y1="${foot[1]}" x2="${tip[0]}" y2="${tip[1]}" />`;
    this.#place(this.move, foot, this.scene.plane.height, -1.2, 1.2);
    this.#place(this.turn, tip, Math.round(this.scene.plane.tilt), -180, 180);
  }

  #place(element, [x, y], value, least, most) {
    const { width, height } = this.overlay.viewBox.baseVal;
    const inside = (at, size) => Math.min(size - 10, Math.max(10, at));
    element.style.left = `${(100 * inside(x, width)) / width}%`;
    element.style.top = `${(100 * inside(y, height)) / height}%`;
    element.setAttribute('aria-valuemin', String(least));
    element.setAttribute('aria-valuemax', String(most));
    element.setAttribute('aria-valuenow', String(Number(value.toFixed(2))));
  }
}

function unit(vector) {
  const length = Math.hypot(...vector);
  return vector.map((x) => x / length);
}
