// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/draw/inputs.h"
#include "tools/draw/opengl/program.h"
#include "tools/draw/pair.h"

namespace clipc::draw {

struct Pair {
  std::string vertex, fragment;  // GLSL
};

// The vertices of FullTarget() for a program: values by location.
Inputs MeshInputs(const GlProgram& program);

// Draws a mesh over the whole target with both programs, on the current context, and compares the
// images. Both get the same vertices by location, the same bytes in uniform blocks of one name,
// small integers where the first declares integers, and the same texels in textures of one name.
// Throws DrawError where a program does not link or
// reads what it cannot be given: plain uniforms, attributes that are matrices.
PairDifference CompareImages(const Pair& first, const Pair& second);

}  // namespace clipc::draw
