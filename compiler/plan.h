// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/write.h"
#include "base/diagnostics.h"
#include "compiler/check_lowering.h"
#include "compiler/request.h"
#include "frontend/check/check.h"
#include "frontend/lex/source.h"

namespace clipc {

// What one compile does: the request with its names resolved and its defaults settled.
struct Plan {
  SourceInput input;
  CheckOptions check;
  LoweringRequest lowering;
  glsl::WriteOptions write;           // without comments
  bool keeps_matrices_whole = false;  // link/whole.h
};

// Makes the plan. Reports names that nothing has, and parts of the request that do not go together
// whatever the shader is; after errors, only `input` is meaningful.
Plan Resolve(const CompileRequest& request, Diagnostics& diagnostics);
// The same for the pixel shader of a pair, whose request PixelRequest made.
Plan ResolvePixelHalf(const CompileRequest& request, Diagnostics& diagnostics);

}  // namespace clipc
