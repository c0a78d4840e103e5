// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>

#include "backend-glsl/style.h"
#include "base/span.h"

namespace clipc::glsl {

struct WriteOptions {
  // The shader is for program pipelines of separate stages (glUseProgramStages): gl_PerVertex is
  // redeclared, as section 7.1.1 asks.
  bool separable = false;
  // The application promises draws without a base vertex (first vertex) or a base instance, so that
  // SV_VertexID and SV_InstanceID need no draw parameters.
  bool base_vertex_is_zero = false, base_instance_is_zero = false;
  bool invariant = false;  // gl_Position is invariant: passes that compute it alike agree on depth
  // Values of half and of the types of minimum precision may have 16 bits; else they have 32.
  bool relaxed_precision = false;
  BlockStyle blocks = BlockStyle::kNamed;
  NameStyle names = {};
};

// Returns the comment to write before a statement with this span, unless the last comment is the
// same; empty: no comment. Without the function there are no comments.
using CommentOf = std::function<std::string(Span)>;

}  // namespace clipc::glsl
