// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Constructors.
namespace clipc::glsl {

// Writes the constructor call of an ir::Construct of this type.
Binding WriteConstruct(Code& code, ir::TypeId type, std::span<const ir::ExprId> arguments);
// Writes an ir::MatrixTruncate to this type.
Binding WriteTruncated(Code& code, const ir::Type& type, ir::ExprId matrix);

}  // namespace clipc::glsl
