// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Constructors.
namespace clipc::glsl {

// A Construct of this type.
Text ConstructText(Code& code, ir::TypeId type, std::span<const ir::ExprId> arguments);
// A MatrixTruncate to this type.
Text TruncateText(Code& code, ir::TypeId type, ir::ExprId matrix);

}  // namespace clipc::glsl
