// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// One sentence about the cut in view: how far it is off, and what to do about it.
import { SPACES } from './runtime.js';

const FINE = 0.05; // pixels that nobody sees
const HELPS = 4; // what is advised is at least so many times more accurate

export const short = (pixels) => (pixels === 0 ? '0' : Number(pixels.toPrecision(2)).toString());
const off = (pixels) =>
  pixels < 0.001
    ? 'less than 0.001 pixels'
    : `${short(pixels)} ${short(pixels) === '1' ? 'pixel' : 'pixels'}`;
const about = (pixels) => `${pixels < 0.001 ? '' : 'about '}${off(pixels)}`;

/** What a mesh shows of a displacement, with `found` of measure(): an edge is kept or dropped as a whole at most. */
export const shownOf = (pixels, found) => (found ? Math.min(pixels, found.most) : pixels);

/** {text, fix}: `fix` is {text, values}, values by the controls' ids, or null. `numbers`: what Images measured. */
export function adviceFor(numbers, { view, lower, chain }) {
  const isDropped = view === 'others' || lower === 'none';
  if (isDropped)
    return {
      text: 'Other compilers drop the clip plane with exit code 0: nothing is cut.',
      fix: null,
    };
  if (!numbers) return { text: 'This shader has no plane that a constant moves.', fix: null };
  const { space, predicted, found } = numbers;
  const pixels = found ? found.displacement.p99 : predicted[space];
  if (!Number.isFinite(pixels))
    return { text: 'No edge in view is cut. Drag the round handle to move the plane.', fix: null };
  const text = `The cut is off by ${found ? off(pixels) : about(pixels)}${found?.isLeast ? ' or more' : ''}`;
  if (pixels < FINE) return { text: `${text}: nobody sees that.`, fix: null };
  const best = SPACES.reduce((a, b) => (predicted[b] < predicted[a] ? b : a));
  if (predicted[best] * HELPS < Math.min(pixels, predicted[space]))
    return {
      text: `${text}. With --plane-space=${best} it is off by ${about(predicted[best])}.`,
      fix: { text: `Use ${best}`, values: { space: best } },
    };
  if (chain === 'baked')
    return {
      text: `${text}. Give the mesh its own origin, and a world matrix.`,
      fix: { text: 'Do so', values: { chain: 'one' } },
    };
  return {
    text: `${text}. Multiply world, view and projection to one matrix in double.`,
    fix: chain === 'one' ? null : { text: 'Do so', values: { chain: 'one' } },
  };
}
