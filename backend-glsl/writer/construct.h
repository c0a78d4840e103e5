// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Constructors.
namespace clipc::glsl {

// The constructor call of an ir::Construct of this type.
Text ConstructText(Code& code, ir::TypeId type, std::span<const ir::ExprId> arguments);
// The text of an ir::MatrixTruncate to this type.
Text TruncateText(Code& code, ir::TypeId type, ir::ExprId matrix);

}  // namespace clipc::glsl
