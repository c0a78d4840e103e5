// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

// Pictures of whole programs, a vertex shader with a pixel shader.
namespace clipc::draw {

struct Pair {
  std::string vertex, fragment;  // GLSL
};

struct PairDifference {
  int pixels = 0;
  int drawn = 0;      // by the second program
  int colors = 0;     // that differ from each other in the second picture
  int different = 0;  // pixels whose colors are further apart than 1e-3 of their size
};

// Draws a mesh over the whole target with both programs, on the current context, and compares the
// pictures. Both get the same vertices by location, the same bytes in uniform blocks of one name,
// and the same texels in textures of one name. Throws DrawError where a program does not link or
// reads what it cannot be given: plain uniforms, attributes that are matrices.
PairDifference ComparePictures(const Pair& first, const Pair& second);

}  // namespace clipc::draw
