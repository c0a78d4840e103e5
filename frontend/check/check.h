// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "frontend/check/check_options.h"
#include "frontend/parse/ast.h"
#include "ir/program.h"
#include "ir/run_passes.h"

namespace clipc {

// Resolves the names, types and overloads of everything that the entry point reaches. Returns the
// program that the shader means, in Form::kResolved. Every error about the shader is reported here,
// except errors of the syntax, which the parser reports. The program is meaningful only when
// `diagnostics` has no errors afterwards. Bodies of functions that the entry point does not reach
// are not looked at, so the same file may hold pixel shaders and other stages.
// `passes` sees the passes of resolve::Resolve, and may end them.
ir::Program Check(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics,
                  const ir::PassOptions& passes = {});

}  // namespace clipc
