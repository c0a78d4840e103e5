// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The two images of the scene, and what is predicted and measured of their cut.
import { Canvas } from './canvas.js';
import { Capture } from './capture.js';
import { fillConstants, planesOf } from './constants.js';
import { measure } from './measure.js';
import { Reference } from './reference.js';
import { SPACES } from './runtime.js';

const WAIT = 250; // milliseconds after the last draw

const spaceOf = (result) =>
  SPACES.includes(result.table?.position_space) ? result.table.position_space : 'clip';
const stepsOf = (result) => result.reflection.positionMatrices || 1;

export class Images {
  runtime = null;
  showsReference = true;
  #capture;
  #captured = null;
  #isDrawing = false;
  #timer = 0;

  /** `views`: [{element, caption, name}], by clip distances and by discard. `drawn()` and `measured(numbers)` are called after. */
  constructor(scene, views, lens, drawn, measured) {
    this.scene = scene;
    this.lens = lens;
    this.views = views.map((view) => ({ ...view, canvas: new Canvas(view.element), problem: '' }));
    this.drawn = drawn;
    this.measured = measured;
    const { gl } = this.views[1].canvas;
    this.#capture = gl && new Capture(gl);
  }

  get hasClipDistances() {
    return this.views[0].canvas.clip !== null;
  }

  /** The result that the left image shows. */
  get result() {
    return this.views[0].canvas.result ?? this.views[1].canvas.result;
  }

  set mesh(mesh) {
    this.views.forEach(({ canvas }) => (canvas.mesh = mesh));
    if (this.#capture) this.#capture.mesh = mesh;
    this.redraw();
  }

  /** Draws `results` from now on; null leaves an image as it is. `source` is their text, `problems` what it says in their place. */
  use(results, source, problems) {
    this.views.forEach((view, i) => {
      const result = results[i];
      view.problem = problems[i];
      if (result?.ok) view.problem = view.canvas.use({ ...result, source });
    });
    const [, discard] = results;
    if (discard?.ok && !this.views[1].problem)
      this.#captured = this.#capture?.use({ ...discard, source }) ? this.#capture.result : null;
    this.redraw();
  }

  redraw() {
    clearTimeout(this.#timer);
    if (!this.runtime || this.#isDrawing) return;
    this.#isDrawing = true;
    requestAnimationFrame(() => {
      this.#isDrawing = false;
      this.views.forEach((view) => {
        view.canvas.work = { draws: 0, uploads: 0 };
        this.#draw(view);
      });
      this.drawn();
      this.#timer = setTimeout(() => this.#measure(), WAIT);
    });
  }

  #fill(result, matrices, rows) {
    const problems = [];
    const constantOf = (plane) => {
      const isNear = result.table?.lowering === 'near-plane';
      const name = isNear ? 'nearPlaneConstant' : 'constant';
      const { constant, problem } = this.runtime[name](
        spaceOf(result),
        matrices.planes[plane],
        matrices,
        stepsOf(result),
        rows,
      );
      if (problem) problems.push(problem);
      return constant;
    };
    return { ...fillConstants(result.reflection, result.source, matrices, constantOf), problems };
  }

  /** Where the planes should cut; null where nobody looks at that. */
  #linesOf(result, mesh, matrices) {
    const planes = this.showsReference || this.lens.isOn ? planesOf(result.reflection) : null;
    return planes?.length ? new Reference(mesh, matrices, planes).lines() : null;
  }

  #draw({ canvas, caption, name, problem }) {
    const { element, result, mesh } = canvas;
    let said = problem;
    if (result) {
      const matrices = this.scene.matrices(element.width / element.height);
      const { buffers, unknown, problems } = this.#fill(result, matrices, element.height);
      const lines = this.#linesOf(result, mesh, matrices);
      const drawn = this.showsReference ? lines : null;
      const draw = (viewport) => canvas.draw(buffers, matrices.isReversed, drawn, viewport);
      if (!element.hidden) this.seen = this.lens.show(element, lines, draw);
      draw(null);
      said ||= problems[0] ?? (unknown.length ? `zeros for ${unknown.join(', ')}` : '');
    }
    caption.textContent = said ? `${name}: ${said}` : name;
  }

  /** The displacement that is predicted for each plane space, the largest of the planes that `cuts` are of. */
  #predict(result, planes, cuts) {
    const { width, height } = this.views[0].element;
    const matrices = this.scene.matrices(width / height);
    const ofPlane = (space, i) =>
      this.runtime.edgeError(
        space,
        matrices.planes[planes[i]],
        matrices,
        stepsOf(result),
        cuts?.[i] ?? null,
        height,
      );
    const seen = planes.flatMap((_, i) => (cuts && !cuts[i] ? [] : [i]));
    return Object.fromEntries(
      SPACES.map((space) => [space, Math.max(...seen.map((i) => ofPlane(space, i)))]),
    );
  }

  #measure() {
    const { result } = this;
    const planes = result && planesOf(result.reflection);
    if (!planes?.length) return this.measured(null);
    const { width, height } = this.views[1].element;
    const captured = this.#captured;
    const found =
      captured &&
      measure(
        this.#capture,
        this.views[1].canvas.mesh,
        planes,
        (pan) => this.scene.matrices(width / height, pan),
        (matrices) => this.#fill(captured, matrices, height).buffers,
        { width, height },
      );
    const predicted = this.#predict(result, planes, found?.cuts);
    const matrices = this.scene.matrices(width / height);
    const first = this.runtime.constant(
      spaceOf(result),
      matrices.planes[planes[0]],
      matrices,
      stepsOf(result),
      height,
    );
    this.measured({
      space: spaceOf(result),
      planes: planes.length,
      predicted,
      found,
      problem: first.problem ?? '',
      warning: first.warning ?? '',
    });
  }
}
