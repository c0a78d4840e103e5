// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/code.h"

// Reads and writes of structured and of byte address buffers.
namespace clipc::glsl {

Text StructuredLoad(Code& code, const ir::ObjectCall& node);
Text ByteLoad(Code& code, ir::TypeId type, const ir::ObjectCall& node);
Text BufferStore(Code& code, const ir::ObjectCall& node);
// The element of a buffer, a part of the element, or the word at an address, that a store or an
// atomic operation changes.
std::string BufferWord(Code& code, const ir::ObjectCall& node);
// The number of elements of a buffer, or of bytes of a byte address buffer.
Text BufferSize(Code& code, ir::ExprId object);

}  // namespace clipc::glsl
