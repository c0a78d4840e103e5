// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"
#include "frontend/rules/build_main.h"

namespace clipc::check {

EntrySignature SignatureOf(Context& context, FunctionInfoId entry);
void ReadInterpolation(ast::Qualifiers qualifiers, ir::Interpolation& interpolation, bool& centroid,
                       bool& sample);

}  // namespace clipc::check
