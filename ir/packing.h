// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ir/program.h"

// HLSL's rules for constant buffers: rows (registers) of 16 bytes; a scalar or vector does not
// straddle a row; arrays, structs and matrices of more than one register start a row; an array
// element, a struct and a matrix's row or column take whole rows except the last one, so a scalar
// may follow inside the last row of an array, a matrix or a struct. A matrix of one register
// (column-major Nx1, row-major 1xN) is placed like the vector it is. 64-bit components are aligned
// to 8 bytes; a register of three or four of them takes two rows. bool takes 4 bytes. Source:
// "Packing rules for constant variables" (Direct3D 11 documentation), and where that is silent or
// loose, the HLSL language specification, "Constant Buffer Layout": what follows a struct may use
// the rest of its last row. The older page's sentence that a struct's size is a multiple of 16
// holds of array strides only; fxc's and DXC's listings agree. A size past 2^32 - 16 is 2^32 - 16.
namespace clipc::ir {

// The order of a matrix in memory, in GLSL's words. HLSL's rows are GLSL's columns, so HLSL's
// row_major is column_major here.
enum class MatrixLayout : std::uint8_t { kNone, kRowMajor, kColumnMajor };

constexpr std::uint64_t RoundUp(std::uint64_t value, std::uint64_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

struct Extent {
  std::uint32_t size = 0;       // bytes, without padding after the last component
  std::uint32_t alignment = 4;  // 16: must start a row; 4 or 8: may share one
};
// The extent of a value of `type` whose matrices lie as `row_major` says.
Extent PackedExtent(const TypeTable& types, TypeId type, bool row_major);
// The byte offset of the next member, which has the type `type`, when the members before it end at
// `end`.
std::uint32_t PackedOffset(const TypeTable& types, TypeId type, bool row_major, std::uint32_t end);
// The byte offset of a field when the fields before it end at `end`: its [[vk::offset]] if it has
// one, else its PackedOffset.
std::uint32_t FieldPlace(const TypeTable& types, const Field& field, std::uint32_t end);
// The number of bytes from the start of the struct to a field.
std::uint32_t FieldOffset(const TypeTable& types, StructId structure, std::uint32_t field);
// The number of bytes from one array element to the next: the element's size rounded up to a row.
std::uint32_t ArrayStride(const TypeTable& types, TypeId array, bool row_major);
// The bytes of a value in a buffer, without padding after the last component. Its components are in
// the order of the type, as Literal holds them.
std::vector<std::uint8_t> Packed(const TypeTable& types, TypeId type, bool row_major,
                                 std::span<const std::uint64_t> components);
// HLSL's layout of the elements of a StructuredBuffer: scalars at multiples of their own size,
// nothing else.
struct StructuredExtent {
  std::uint32_t size = 0;
  std::uint32_t alignment = 4;
};
StructuredExtent Structured(const TypeTable& types, TypeId type);
// Gives every member without has_packoffset its offset, every member its size, and the buffer its
// size (of one buffer, for an array of ConstantBuffers). Where only some members have a place of
// their own (register(c#) in $Globals; a cbuffer may not mix), the others follow the last of those
// in order of declaration, as fxc lays them out (DirectXShaderCompiler issue 1900), and step over
// every place that is taken. With `whole_registers` a taken place goes on to the end of its last
// register: in Direct3D 9 a register belongs to one variable.
void LayOut(const TypeTable& types, const Arena<Var>& vars, Cbuffer& buffer,
            bool whole_registers = false);

}  // namespace clipc::ir
