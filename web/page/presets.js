// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Scenes that show what costs a cut its precision: each sets every control that matters.

const EASY = {
  near: '0.1',
  depth: 'standard',
  offset: '0',
  chain: 'steps',
  space: 'clip',
  lower: 'clip-distance',
  height: '0.1',
  tilt: '70',
  heading: '-170',
};

/** By the button's text: values by the controls' ids. */
export const PRESETS = {
  Near: EASY,
  'Far plane': { ...EASY, near: '0.00001' },
  'World far away': { ...EASY, offset: '100000', space: 'xyw1' },
  'Baked mesh': { ...EASY, offset: '100000', chain: 'baked', space: 'object' },
};

const PLACED = ['height', 'tilt', 'heading'];

/** The preset whose values the controls have, wherever the plane is; or undefined. */
export const presetOf = (values) =>
  Object.keys(PRESETS).find((name) =>
    Object.entries(PRESETS[name]).every(
      ([id, value]) => PLACED.includes(id) || values(id) === value,
    ),
  );
