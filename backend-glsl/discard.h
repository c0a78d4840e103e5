// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/glsl_info.h"
#include "backend-glsl/target.h"
#include "ir/program.h"

// The fragment shader's part of the lowering `discard`: it reads the distances that the vertex
// shader interpolates, and discards where one is below 0 or not a number, as Direct3D clips.
namespace clipc::glsl {

struct DiscardCode {
  std::string declarations;  // the inputs, and the function `function`
  std::string function;      // "clip_planes": the function that the fragment shader calls first
};

// Writes the code for a program after LowerClipPlanes with Lowering::kDiscard, which WriteGlsl
// wrote with `info`; returns empty code if the program has no clip planes. The function gets no
// name in `taken`.
DiscardCode WriteDiscard(const ir::Program& program, const Target& target, const GlslInfo& info,
                         const std::vector<std::string_view>& taken = {});

struct Insertion {
  std::string text = {};     // the whole fragment shader; empty when there is a problem
  std::string error = {};    // the reason why the code cannot be inserted, in words
  bool tests_early = false;  // it writes depth and stencil before it discards
};

// Puts the code into a GLSL fragment shader of the same version as the target's: the declarations
// after its directives, the call first in `main`. If the `main` of the text is inside of #if, an
// #error at the end says so where the preprocessor removes it. Nothing else of the text changes.
Insertion InsertDiscard(std::string_view fragment, const ir::Program& program, const Target& target,
                        const GlslInfo& info);

}  // namespace clipc::glsl
