// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "ir/packing.h"
#include "ir/type.h"

// The layouts of memory that GLSL names, std140 and std430, where they agree with HLSL's in
// ir/packing.h. Source: section 7.6.2.2 of the OpenGL 4.6 specification.
namespace clipc::ir {

// The extent that std140 or std430 gives a type, in bytes.
struct StdExtent {
  std::uint32_t size = 0;  // with the padding after arrays, structs and matrices
  std::uint32_t alignment = 4;
  MatrixLayout matrices = MatrixLayout::kNone;
};
// Adds the layout of the matrices in a part to that of the whole; returns whether the two agree.
bool Agree(MatrixLayout& whole, MatrixLayout part);

// Returns std140's extent of `type`; std::nullopt if std140 puts some part of the type elsewhere
// than HLSL does in a cbuffer, or GLSL cannot say the order of its matrices or a struct without
// fields.
std::optional<StdExtent> Std140(const TypeTable& types, TypeId type, bool row_major);
// Returns std430's extent of `type` if it lays an array of them out as a StructuredBuffer<type>
// does; otherwise std::nullopt.
std::optional<StdExtent> Std430(const TypeTable& types, TypeId type, bool row_major);

// Whether an element of a StructuredBuffer is words in the order of its components, one each: it
// has no matrix and nothing of 64 bits.
bool IsOfWords(const TypeTable& types, TypeId type);

}  // namespace clipc::ir
