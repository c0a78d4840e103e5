// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/compile.h"
#include "frontend/lex/source.h"
#include "ir/program.h"

namespace clipc {

// Reads the request's pixel shader and links the vertex shader `program` with it (link/match.h).
// `input` is the vertex shader's: a pixel shader in HLSL has the same include folders and macros.
// Appends the files that were read to `dependencies`. Requires Form::kTyped; after errors the
// program is as it was.
void LinkPixelShader(const CompileRequest& request, SourceInput input, ir::Program& program,
                     std::vector<std::string>& dependencies, Diagnostics& diagnostics);

}  // namespace clipc
