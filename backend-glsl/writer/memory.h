// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>

#include "backend-glsl/writer/context.h"

// Reads of values from constant buffers in rows of four words.
namespace clipc::glsl {

struct Memory {
  std::string array;      // "Light_rows"
  bool is_float = false;  // the words are floats; else uints
};
// The place of a value in a Memory.
struct Address {
  std::string dynamic;       // added to the constant part, in rows; may be empty
  std::uint32_t offset = 0;  // bytes
};

// The text of the value of this type at the address.
std::string Load(WriterContext& context, const Memory& memory, ir::TypeId type, bool row_major,
                 const Address& address);

// The place "2 * i" of element `index` of an array whose elements are `stride` units apart.
std::string Scaled(std::uint32_t stride, const std::string& index);

}  // namespace clipc::glsl
