// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The scene: a camera that turns about the mesh, and planes. All that a shader and the reference get of it are floats, so that
// no way to clip pays for their rounding.
import { lookAt, multiply, perspective, rotationY, translation } from './matrices.js';

const RADIANS = Math.PI / 180;
const FIELD_OF_VIEW = 60 * RADIANS; // the study's
const FAR = 100;
export const MOST_PLANES = 8;

/** How a vertex gets from the mesh to the image, and what the page says of it. */
export const CHAINS = {
  steps: 'two matrices',
  one: 'one matrix',
  float: 'one matrix, in float',
  relative: 'camera-relative',
  baked: 'baked vertices',
};

const clamp = (x, low, high) => Math.min(high, Math.max(low, x));
const floats = (values) => values.map(Math.fround);

export class Scene {
  yaw = 35;
  pitch = 22;
  distance = 2.4;
  near = 0.1;
  offset = 0;
  isReversed = false;
  chain = 'steps';
  /** The plane that the controls move. */
  chosen = 0;
  /** The first plane cuts through the mesh; the others take little off its sides. */
  planes = Array.from({ length: MOST_PLANES }, (_, i) =>
    i ? { height: 0.75, tilt: 90, heading: 72 * i } : { height: 0.1, tilt: 70, heading: -170 },
  );

  /** Where the mesh's vertices are in its own space. */
  get baked() {
    return this.chain === 'baked' ? this.offset : 0;
  }

  get plane() {
    return this.planes[this.chosen];
  }

  /** Plane `index` of the world: it keeps the points with Ax + By + Cz + D >= 0. */
  #plane(index, origin) {
    const { height, tilt, heading } = this.planes[index];
    const [t, h] = [tilt * RADIANS, heading * RADIANS];
    const normal = floats([Math.sin(t) * Math.cos(h), -Math.cos(t), Math.sin(t) * Math.sin(h)]);
    return [
      ...normal,
      Math.fround(height - normal[0] * origin[0] - normal[1] * origin[1] - normal[2] * origin[2]),
    ];
  }

  /** What a draw needs; the camera has turned by `pan` radians where it stands. */
  matrices(aspect, pan = 0) {
    const [yaw, pitch] = [this.yaw * RADIANS, this.pitch * RADIANS];
    const center = this.chain === 'relative' ? -this.distance : 0;
    const [x, y, z] = [
      Math.cos(pitch) * Math.sin(yaw),
      Math.sin(pitch),
      Math.cos(pitch) * Math.cos(yaw),
    ];
    // The mesh's place: the world begins at the camera where it is relative to it.
    const mesh =
      this.chain === 'relative' ? [x * center, y * center, z * center] : [this.offset, 0, 0];
    const eye = mesh.map((at, i) => at + this.distance * [x, y, z][i]);
    this.middle = mesh;
    const view = multiply(lookAt(eye, mesh), rotationY(pan));
    return {
      world: floats(this.baked ? translation(0, 0, 0) : translation(...mesh)),
      view: floats(view),
      projection: floats(perspective(FIELD_OF_VIEW, aspect, this.near, FAR, this.isReversed)),
      planes: this.planes.map((_, i) => this.#plane(i, floats(mesh))),
      eye,
      seconds: 0,
      isFloat: this.chain === 'float',
      isReversed: this.isReversed,
    };
  }

  /** What a link keeps of it. */
  get saved() {
    const { yaw, pitch, distance, planes } = this;
    return { yaw, pitch, distance, planes };
  }

  /** Takes over the numbers of what `saved` gave; a link may hold anything. */
  restore(saved) {
    const copy = (to, from, names) => {
      for (const name of names) if (Number.isFinite(from?.[name])) to[name] = from[name];
    };
    copy(this, saved, ['yaw', 'pitch', 'distance']);
    this.planes.forEach((plane, i) => copy(plane, saved?.planes?.[i], Object.keys(plane)));
    this.turnCamera(0, 0);
    this.approach(1);
  }

  turnCamera(right, up) {
    this.yaw -= right;
    this.pitch = clamp(this.pitch + up, -85, 85);
  }

  movePlane(up) {
    this.plane.height = clamp(this.plane.height + up, -1.2, 1.2);
  }

  turnPlane(right, up) {
    this.plane.heading = ((((this.plane.heading + right + 180) % 360) + 360) % 360) - 180;
    this.plane.tilt = clamp(this.plane.tilt + up, -180, 180);
  }

  approach(factor) {
    this.distance = clamp(this.distance * factor, 1.2, 20);
  }
}
