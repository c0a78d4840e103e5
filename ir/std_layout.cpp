// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/std_layout.h"

#include <algorithm>

namespace clipc::ir {
namespace {

constexpr std::uint32_t kVec4 = 16;  // bytes of a register of a cbuffer, and of std140's vec4
// The limit on sizes in bytes: no device takes a larger buffer, and sums of such sizes stay far
// from wrapping round.
constexpr std::uint64_t kLargestBuffer = 1u << 30;

StdExtent VectorExtent(std::uint32_t scalar_size, std::uint32_t components) {
  return {scalar_size * components, scalar_size * (components == 3 ? 4 : components)};
}

// A comparison of std140 or std430 (section 7.6.2.2) with HLSL's layout.
class Comparer {
 public:
  // `tight`: std430 against a StructuredBuffer; else std140 against a cbuffer.
  Comparer(const TypeTable& types, bool tight)
      : types_(types), row_(tight ? 1 : kVec4), tight_(tight) {}

  std::optional<StdExtent> Extent(TypeId id, bool row_major) const {
    const Type& type = types_[id];
    switch (type.kind) {
      case TypeKind::kScalar:
      case TypeKind::kVector: return VectorExtent(ByteSize(type.scalar), type.columns);
      case TypeKind::kMatrix: return Matrix(type, row_major);
      case TypeKind::kArray: return Array(id, row_major);
      case TypeKind::kStruct: return Struct(types_.StructOf(id));
      default: return std::nullopt;
    }
  }

 private:
  std::optional<StdExtent> Matrix(const Type& type, bool row_major) const {
    const std::uint32_t scalar_size = ByteSize(type.scalar);
    const bool has_rows = type.rows > 1 && type.columns > 1;
    const std::uint32_t registers = row_major ? type.rows : type.columns;
    const std::uint32_t length = row_major ? type.columns : type.rows;
    if (!has_rows) {
      // The matrix is a vector in GLSL; in memory it has one component a row if it lies across its
      // only direction.
      if (registers > 1 && !tight_) return std::nullopt;
      return VectorExtent(scalar_size, type.Components());
    }
    // GLSL has matrices of floats only; others are arrays of their rows.
    if (!IsFloat(type.scalar) && !row_major) return std::nullopt;
    const StdExtent vector = VectorExtent(scalar_size, length);
    const auto alignment = std::max(vector.alignment, row_);
    const auto stride = static_cast<std::uint32_t>(RoundUp(vector.size, alignment));
    if (stride != RoundUp(std::uint64_t{scalar_size} * length, row_)) return std::nullopt;
    const MatrixLayout layout = row_major ? MatrixLayout::kColumnMajor : MatrixLayout::kRowMajor;
    return StdExtent{stride * registers, alignment,
                     IsFloat(type.scalar) ? layout : MatrixLayout::kNone};
  }

  std::optional<StdExtent> Array(TypeId id, bool row_major) const {
    const auto element = Extent(types_[id].element, row_major);
    if (!element) return std::nullopt;
    const auto alignment = std::max(element->alignment, row_);
    const std::uint64_t stride = RoundUp(element->size, alignment);
    const std::uint64_t size = stride * types_[id].count;
    if (size > kLargestBuffer || stride != HlslStride(id, row_major)) return std::nullopt;
    return StdExtent{static_cast<std::uint32_t>(size), alignment, element->matrices};
  }

  std::optional<StdExtent> Struct(const ir::Struct& structure) const {
    if (structure.fields.empty())
      return std::nullopt;  // takes no room in HLSL, and cannot be declared in GLSL
    StdExtent whole{0, row_, MatrixLayout::kNone};
    std::uint32_t hlsl_end = 0;
    std::uint64_t end = 0;
    for (const Field& field : structure.fields) {
      const auto extent = Extent(field.type, field.row_major);
      if (!extent || !Agree(whole.matrices, extent->matrices)) return std::nullopt;
      const std::uint32_t hlsl_offset = HlslOffset(field, hlsl_end);
      if (RoundUp(end, extent->alignment) != hlsl_offset) return std::nullopt;
      end = std::uint64_t{hlsl_offset} + extent->size;
      if (end > kLargestBuffer) return std::nullopt;
      hlsl_end = hlsl_offset + HlslSize(field.type, field.row_major);
      whole.alignment = std::max(whole.alignment, extent->alignment);
    }
    whole.size = static_cast<std::uint32_t>(RoundUp(end, whole.alignment));
    return whole;
  }

  std::uint32_t HlslStride(TypeId array, bool row_major) const {
    if (!tight_) return ArrayStride(types_, array, row_major);
    return Structured(types_, types_[array].element).size;
  }
  std::uint32_t HlslOffset(const Field& field, std::uint32_t end) const {
    if (!tight_) return FieldPlace(types_, field, end);
    return static_cast<std::uint32_t>(RoundUp(end, Structured(types_, field.type).alignment));
  }
  std::uint32_t HlslSize(TypeId type, bool row_major) const {
    return tight_ ? Structured(types_, type).size : PackedExtent(types_, type, row_major).size;
  }

  const TypeTable& types_;
  std::uint32_t row_;
  bool tight_;
};

}  // namespace

bool Agree(MatrixLayout& whole, MatrixLayout part) {
  if (part == MatrixLayout::kNone) return true;
  if (whole == MatrixLayout::kNone) whole = part;
  return whole == part;
}

std::optional<StdExtent> Std140(const TypeTable& types, TypeId type, bool row_major) {
  return Comparer(types, false).Extent(type, row_major);
}

std::optional<StdExtent> Std430(const TypeTable& types, TypeId type, bool row_major) {
  const auto extent = Comparer(types, true).Extent(type, row_major);
  if (!extent || RoundUp(extent->size, extent->alignment) != Structured(types, type).size)
    return std::nullopt;
  return extent;
}

bool IsOfWords(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  if (type.kind == TypeKind::kArray) return IsOfWords(types, type.element);
  if (type.kind == TypeKind::kStruct) {
    return std::ranges::all_of(types.StructOf(id).fields,
                               [&](const Field& field) { return IsOfWords(types, field.type); });
  }
  return type.IsScalarOrVector() && ByteSize(type.scalar) == 4;
}

}  // namespace clipc::ir
