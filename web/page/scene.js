// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The scene: a camera that turns about the mesh, and a plane.
import { lookAt, perspective, translation } from './matrices.js';

const RADIANS = Math.PI / 180;
const FIELD_OF_VIEW = 40 * RADIANS;
const FAR = 100;

export class Scene {
  yaw = 35;
  pitch = 22;
  distance = 3.4;
  height = 0;
  tilt = 20;
  heading = 30;
  near = 0.1;
  offset = 0;
  isReversed = false;

  /** The plane in the world: it keeps the points with Ax + By + Cz + D >= 0. */
  get plane() {
    const [tilt, heading] = [this.tilt * RADIANS, this.heading * RADIANS];
    const normal = [Math.sin(tilt) * Math.cos(heading), -Math.cos(tilt), Math.sin(tilt) * Math.sin(heading)];
    const through = [this.offset, this.height, 0];
    return [...normal, -normal.reduce((sum, x, i) => sum + x * through[i], 0)];
  }

  matrices(aspect) {
    const [yaw, pitch] = [this.yaw * RADIANS, this.pitch * RADIANS];
    const target = [this.offset, 0, 0];
    const eye = [
      this.offset + this.distance * Math.cos(pitch) * Math.sin(yaw),
      this.distance * Math.sin(pitch),
      this.distance * Math.cos(pitch) * Math.cos(yaw),
    ];
    return {
      world: translation(this.offset, 0, 0),
      view: lookAt(eye, target),
      projection: perspective(FIELD_OF_VIEW, aspect, this.near, FAR, this.isReversed),
      eye,
      seconds: 0,
    };
  }

  turn(right, up) {
    this.yaw -= right;
    this.pitch = Math.min(85, Math.max(-85, this.pitch + up));
  }
}

/** Drags, the wheel and the arrow keys on a canvas change the scene; `moved` is called after each change. */
export function steer(canvas, scene, moved) {
  let last = null;
  canvas.addEventListener('pointerdown', (event) => {
    last = event;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!last || !event.buttons) return;
    const [right, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
    last = event;
    if (event.shiftKey) scene.height = Math.min(1.2, Math.max(-1.2, scene.height - down / 150));
    else scene.turn(right / 2, down / 2);
    moved();
  });
  canvas.addEventListener('pointerup', () => (last = null));
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      scene.distance = Math.min(20, Math.max(1.5, scene.distance * Math.exp(event.deltaY / 1000)));
      moved();
    },
    { passive: false },
  );
  const keys = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
  canvas.addEventListener('keydown', (event) => {
    const step = keys[event.key];
    if (!step) return;
    event.preventDefault();
    if (event.shiftKey) scene.height = Math.min(1.2, Math.max(-1.2, scene.height + step[1] / 100));
    else scene.turn(step[0], step[1]);
    moved();
  });
}
