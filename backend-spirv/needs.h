// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "legalize/needs.h"

namespace clipc::spirv {

// What SPIR-V needs of the legalising passes. `split` are the arrays whose elements have bindings
// of their own.
inline legalize::Needs NeedsOf(bool is_opengl, legalize::ArraySplit split) {
  return {
      .split_arrays = split,
      .flat_arrays = !is_opengl,  // VUID-StandaloneSpirv-UniformConstant-04655
      .simple_indices = is_opengl,
  };
}

}  // namespace clipc::spirv
