// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Reads and writes of structured buffers.
namespace clipc::glsl {

Text StructuredLoad(Code& code, const ir::ObjectCall& node);
Text BufferStore(Code& code, const ir::ObjectCall& node);
// The element of a buffer, or a part of the element, that a store or an atomic operation changes.
std::string BufferWord(Code& code, const ir::ObjectCall& node);
// The number of elements of a buffer.
Text BufferSize(Code& code, ir::ExprId object);

}  // namespace clipc::glsl
