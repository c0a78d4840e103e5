// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "backend-spirv/module.h"
#include "backend-spirv/types.h"
#include "ir/program.h"

namespace clipc::spirv {

// A place in memory: a path from a variable.
struct Place {
  Ref base = 0;  // a pointer
  spv::StorageClass storage = spv::StorageClass::Function;
  std::vector<Ref> indices = {};
  ir::TypeId type = {};  // at the end of the path
  Layout layout = Layout::kValue;
  bool row_major = false;
  bool is_buffer = false;       // it is a ConstantBuffer<T>, or an array of them
  bool is_non_uniform = false;  // which buffer it is in differs between invocations
  // Layout::kRows: the byte in the buffer, without the rows and words that are added; and the bytes
  // from one component to the next, if they do not follow each other.
  std::uint32_t offset = 0, stride = 0;
  Ref row = 0, component = 0;
  // The components that a last swizzle of several takes from a vector; then `vector` is its type.
  std::array<std::uint8_t, 4> components{};
  std::uint8_t count = 0;
  ir::TypeId vector = {};
};

// The part of an element of a structured buffer that the steps of a store lead to.
struct StoredPart {
  Place place;  // the element, or the field or element in it; its type is without a row's step
  bool is_row = false;
  Ref first = 0;            // of components: the number of the first one; 0: all of it
  std::uint32_t known = 0;  // that number, where it is a literal
};

// The variable of a constant buffer.
struct DeclaredBlock {
  Ref variable = 0;
  std::vector<std::uint32_t> kept;  // the members, in the order of the block
  bool is_rows = false;             // the block is an array of rows instead
};

// The variable of an object, or of an array of them.
struct DeclaredObject {
  Ref variable = 0;
  Ref type = 0;  // of one object: of a buffer its block
  spv::StorageClass storage = spv::StorageClass::UniformConstant;
};

// What a module needs in which an index that is not uniform chooses an object of an array.
spv::Capability NonUniformOf(ir::ObjectKind object);

// Whether the input is an array of distances to planes, a variable like those that a shader
// declares.
bool IsArrayInput(ir::Builtin builtin);
// The factors in the array that the input or output is; 0 if it is not one.
std::uint32_t FactorCount(ir::Builtin builtin);

}  // namespace clipc::spirv
