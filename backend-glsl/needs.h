// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc::glsl {

// What a part of a shader needs of its target. CheckTarget reports what the target lacks; the
// writer names the extension through which the target has it.
struct Need {
  using Plain = diag::Kind<std::string_view>;
  using Named = diag::Kind<std::string_view, std::string_view>;

  Feature feature;
  // The error when the target lacks the feature: with the target's name, or with the name of the
  // variable, semantic or `what` and the target's.
  const Plain* plain = nullptr;
  const Named* named = nullptr;
  std::string_view what = {};
};

// Null when every target has it.
const Need* NeedOf(ir::Builtin builtin);
const Need* NeedOf(ir::ObjectKind kind);
const Need* NeedOf(ir::ObjectOp op);
const Need* NeedOf(ir::Scalar kind);

}  // namespace clipc::glsl
