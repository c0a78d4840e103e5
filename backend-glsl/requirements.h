// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc::glsl {

// The feature that a part of a shader needs of its target. CheckTarget reports a feature that the
// target lacks; the writer names the extension through which the target has it.
struct Requirement {
  using Plain = diag::Kind<std::string_view>;
  using Named = diag::Kind<std::string_view, std::string_view>;

  Feature feature;
  // The error if the target lacks the feature: `plain` takes the target's name; `named` takes
  // `what`, or if it is empty the name of the variable or semantic, and the target's name.
  const Plain* plain = nullptr;
  const Named* named = nullptr;
  std::string_view what = {};
};

// The name of the uniform with the height of the framebuffer, where a target counts the y of a
// pixel from the lower edge and Direct3D from the upper one.
inline constexpr std::string_view kFramebufferHeight = "framebuffer_height";

// Whether the shader reads the y of the input, a pixel's position, and the target needs that height
// for it.
bool NeedsFramebufferHeight(const ir::Program& program, const Target& target,
                            const ir::IoVar& input);

// Whether the call is a Gather with an offset that is not constant.
bool HasVaryingOffset(const ir::Program& program, const ir::ObjectCall& call);
// Whether GLSL has textureLod of the texture with a sampler that compares.
bool HasShadowLevels(ir::ObjectKind kind);
// Whether GLSL has a function for the operation on a texture of this kind in the stage, if it is
// one that compares.
bool HasComparison(ir::ObjectOp op, ir::ObjectKind kind, const StageInfo& stage);

// Returns the need of an input or output, an object, an operation or a type; null if every target
// has it.
const Requirement* RequirementOf(ir::Builtin builtin, const StageInfo& stage);
const Requirement* RequirementOf(ir::ObjectKind kind);
const Requirement* RequirementOf(ir::ObjectOp op);
const Requirement* RequirementOf(ir::Scalar kind);

}  // namespace clipc::glsl
