// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "backend-spirv/module.h"
#include "ir/program.h"

namespace clipc::spirv {

inline constexpr std::uint32_t kRow = 16;  // bytes of a register of a constant buffer

// The form of a numeric type of HLSL in SPIR-V. float1 is a scalar, and a matrix of one row or one
// column a vector; other matrices of floats are matrices whose column i is HLSL's row i, and those
// of other kinds, which SPIR-V lacks, arrays of their rows.
struct Shape {
  enum Kind : std::uint8_t { kScalar, kVector, kMatrix, kRows };
  Kind kind = kScalar;
  ir::Scalar scalar = ir::Scalar::kFloat;  // one of BaseOf's
  std::uint32_t rows = 1;                  // kMatrix, kRows: HLSL's rows
  std::uint32_t size = 1;                  // the components of a vector or of a row

  bool IsScalar() const { return kind == kScalar; }
  bool IsVector() const { return kind == kVector; }
  bool HasRows() const { return kind == kMatrix || kind == kRows; }
  bool IsFloating() const { return scalar == ir::Scalar::kFloat || scalar == ir::Scalar::kDouble; }
  Shape Row() const { return {size == 1 ? kScalar : kVector, scalar, 1, size}; }
  Shape Component() const { return {kScalar, scalar, 1, 1}; }
  Shape With(ir::Scalar of) const;
  friend bool operator==(const Shape&, const Shape&) = default;
};
Shape ShapeOf(const ir::Type& type);
Shape ShapeOf(ir::Scalar scalar, std::uint32_t rows, std::uint32_t columns);

// A function of the set GLSL.std.450 that is HLSL's, for floats and for signed integers; 0 where
// there is none.
struct ExtendedFunction {
  std::uint32_t of_float = 0, of_int = 0;
};

// The operands of a function: the shape of the first, their values, and what the function gives.
struct Evaluated {
  Shape shape, result;
  Ref type = 0;  // of the result
  std::array<Ref, 4> values{};
  std::size_t count = 0;
};

// Where a value lies: at Direct3D's places in a constant buffer, or in an element of a structured
// buffer, where a bool is a uint; as SPIR-V pleases; or in rows of words (rows.cpp).
enum class Layout : std::uint8_t { kValue, kConstants, kElements, kRows };

// The types and constants of a module, by those of the program.
class Types {
 public:
  // `is_relaxed`: numbers of minimum precision may have 16 bits.
  Types(const ir::Program& program, Module& module, bool is_relaxed)
      : program_(program), module_(module), is_relaxed_(is_relaxed) {}

  bool IsRelaxed(ir::TypeId type) const {
    return is_relaxed_ && program_.types.HasMinPrecision(type);
  }

  // ---- types of values
  Ref Void() { return module_.Type(spv::Op::OpTypeVoid, {}); }
  Ref Of(ir::Scalar scalar);
  Ref Of(const Shape& shape);
  Ref Of(ir::TypeId type);
  Ref Vector(Ref component, std::uint32_t size);
  Ref Pointer(spv::StorageClass storage, Ref to);

  // ---- types in a buffer, with their places in memory; for Layout::kValue, those of values
  Ref InMemory(ir::TypeId type, bool row_major, Layout layout);
  // The block with those members of a buffer, by their numbers, or with the fields of a
  // ConstantBuffer<T>.
  Ref Block(const ir::Cbuffer& cbuffer, std::span<const std::uint32_t> kept, std::string_view name);
  // The block with the elements of a structured buffer, an array without a size. `is_storage`: it
  // is a Block, else a BufferBlock.
  Ref Elements(ir::TypeId element, bool row_major, std::string_view name, bool is_storage);
  // The array, or that without a size if `count` is 0; `stride` in bytes.
  Ref ArrayInMemory(Ref element, std::uint32_t count, std::uint32_t stride);
  // Whether the type has bools, arrays or structs in it, which are others in a buffer.
  bool DiffersInMemory(ir::TypeId type) const;
  // What holds a component, or a vector or row of them, in a buffer: uints in place of bools.
  static Shape InMemory(const Shape& shape) {
    return shape.scalar == ir::Scalar::kBool ? shape.With(ir::Scalar::kUint) : shape;
  }

  // ---- constants
  Ref Uint(std::uint32_t value);
  Ref Int(std::int32_t value);
  Ref Float(float value);
  Ref Bool(bool value);
  // A component as ir::Literal holds it.
  Ref Component(ir::Scalar scalar, std::uint64_t bits);
  // One number in all components.
  Ref Splat(const Shape& shape, std::uint64_t bits);
  Ref Zero(ir::TypeId type) { return module_.Constant(spv::Op::OpConstantNull, Of(type)); }
  // A value of its components, in the order of the type; takes them from the front of `bits`.
  Ref Value(ir::TypeId type, std::span<const std::uint64_t>& bits);
  // The bits of the number 1 in this kind.
  static std::uint64_t OneOf(ir::Scalar scalar);

 private:
  static constexpr std::size_t kScalars = static_cast<std::size_t>(ir::Scalar::kUint64) + 1;

  Ref Make(const Shape& shape);
  Ref StructInMemory(ir::StructId structure, Layout layout);
  Ref NewStructInMemory(ir::StructId structure, Layout layout);
  void DecorateMatrix(Ref structure, std::uint32_t member, ir::TypeId type, bool row_major,
                      Layout layout);
  Ref Composite(Ref type, std::span<const Ref> parts);

  const ir::Program& program_;
  Module& module_;
  const bool is_relaxed_;
  // The types of shapes: by scalar, rows, components of a row, and kind. 0: not made yet.
  std::array<std::array<std::array<std::array<Ref, 4>, 4>, 4>, kScalars> shapes_{};
  std::map<std::uint32_t, Ref> structs_;                                 // by StructId
  std::map<std::pair<std::uint32_t, Layout>, Ref> structs_in_memory_;    // the same
  std::map<std::tuple<Ref, std::uint32_t, std::uint32_t>, Ref> arrays_;  // with their strides
};

}  // namespace clipc::spirv
