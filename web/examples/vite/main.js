// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
import { glsl, table } from './plane.hlsl';

const { constant } = table.planes[0];
document.body.append(
  `${glsl}\nThe plane is at byte ${constant.byte_offset} of ${constant.glsl_block}.`,
);
