// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/block_layout.h"

#include <algorithm>
#include <span>

#include "backend-glsl/shape.h"
#include "ir/packing.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The limit on sizes in bytes: no device takes a larger buffer, and sums of such sizes stay far
// from wrapping round.
constexpr std::uint64_t kLargest = 1u << 30;

Std140Extent VectorExtent(std::uint32_t scalar_size, std::uint32_t components) {
  return {scalar_size * components, scalar_size * (components == 3 ? 4 : components)};
}

// Adds the layout of the matrices in a part to that of the whole; returns whether the two agree.
bool Agree(MatrixLayout& whole, MatrixLayout part) {
  if (part == MatrixLayout::kNone) return true;
  if (whole == MatrixLayout::kNone) whole = part;
  return whole == part;
}

// A comparison of std140 or std430 (section 7.6.2.2) with HLSL's layout.
class Comparer {
 public:
  // `tight`: std430 against a StructuredBuffer; else std140 against a cbuffer.
  Comparer(const TypeTable& types, bool tight)
      : types_(types), row_(tight ? 1 : kRow), tight_(tight) {}

  std::optional<Std140Extent> Extent(TypeId id, bool row_major) const {
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
  std::optional<Std140Extent> Matrix(const Type& type, bool row_major) const {
    const std::uint32_t scalar_size = ByteSize(type.scalar);
    const Shape shape = ShapeOf(type.scalar, type.rows, type.columns);
    const std::uint32_t registers = row_major ? type.rows : type.columns;
    const std::uint32_t length = row_major ? type.columns : type.rows;
    if (!shape.HasRows()) {
      // The matrix is a vector in GLSL; in memory it has one component a row if it lies across its
      // only direction.
      if (registers > 1 && !tight_) return std::nullopt;
      return VectorExtent(scalar_size, shape.size);
    }
    if (shape.kind == Shape::kRows && !row_major) return std::nullopt;
    const Std140Extent vector = VectorExtent(scalar_size, length);
    const auto alignment = std::max(vector.alignment, row_);
    const auto stride = static_cast<std::uint32_t>(RoundUp(vector.size, alignment));
    if (stride != RoundUp(std::uint64_t{scalar_size} * length, row_)) return std::nullopt;
    const MatrixLayout layout = row_major ? MatrixLayout::kColumnMajor : MatrixLayout::kRowMajor;
    return Std140Extent{stride * registers, alignment,
                        shape.kind == Shape::kMatrix ? layout : MatrixLayout::kNone};
  }

  std::optional<Std140Extent> Array(TypeId id, bool row_major) const {
    const auto element = Extent(types_[id].element, row_major);
    if (!element) return std::nullopt;
    const auto alignment = std::max(element->alignment, row_);
    const std::uint64_t stride = RoundUp(element->size, alignment);
    const std::uint64_t size = stride * types_[id].count;
    if (size > kLargest || stride != HlslStride(id, row_major)) return std::nullopt;
    return Std140Extent{static_cast<std::uint32_t>(size), alignment, element->matrices};
  }

  std::optional<Std140Extent> Struct(const ir::Struct& structure) const {
    if (structure.fields.empty())
      return std::nullopt;  // takes no room in HLSL, and cannot be declared in GLSL
    Std140Extent whole{0, row_, MatrixLayout::kNone};
    std::uint32_t hlsl_end = 0;
    std::uint64_t end = 0;
    for (const Field& field : structure.fields) {
      const auto extent = Extent(field.type, field.row_major);
      if (!extent || !Agree(whole.matrices, extent->matrices)) return std::nullopt;
      const std::uint32_t hlsl_offset = HlslOffset(field, hlsl_end);
      if (RoundUp(end, extent->alignment) != hlsl_offset) return std::nullopt;
      end = std::uint64_t{hlsl_offset} + extent->size;
      if (end > kLargest) return std::nullopt;
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

// The members of the cbuffer or, with `fields_as_members`, the fields of T.
std::vector<BlockMember> MembersOf(const Program& program, const Cbuffer& cbuffer,
                                   bool fields_as_members) {
  std::vector<BlockMember> members;
  members.reserve(cbuffer.members.size());
  if (!fields_as_members) {
    for (const CbufferMember& member : cbuffer.members) {
      const Var& var = program.vars[member.var];
      members.push_back({.var = member.var,
                         .type = var.type,
                         .row_major = var.row_major,
                         .offset = member.offset});
    }
    return members;
  }
  const VarId var = cbuffer.members.front().var;
  const TypeId type = program.types.Innermost(program.vars[var].type);
  std::uint32_t end = 0;
  const auto& fields = program.types.StructOf(type).fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::uint32_t offset = FieldPlace(program.types, fields[i], end);
    end = offset + PackedExtent(program.types, fields[i].type, fields[i].row_major).size;
    members.push_back({.var = var,
                       .field = static_cast<int>(i),
                       .type = fields[i].type,
                       .row_major = fields[i].row_major,
                       .offset = offset});
  }
  return members;
}

// Returns whether the members, in order of offset, fit std140; sets their explicit offsets and
// paddings.
bool PlaceMembers(const TypeTable& types, std::span<BlockMember> members, std::uint32_t size,
                  bool explicit_offsets) {
  std::uint64_t end = 0;
  for (BlockMember& member : members) {
    const auto extent = Std140(types, member.type, member.row_major);
    if (!extent || member.offset % extent->alignment != 0 || member.offset < end) return false;
    const std::uint64_t natural = RoundUp(end, extent->alignment);
    member.explicit_offset = member.offset != natural && explicit_offsets;
    member.padding = member.offset != natural && !explicit_offsets
                         ? static_cast<std::uint32_t>(member.offset - end)
                         : 0;
    member.matrices = extent->matrices;
    end = std::uint64_t{member.offset} + extent->size;
  }
  // A block larger than what Direct3D binds would read past the end of the host's buffer.
  return RoundUp(end, kRow) <= size;
}

// The style of a buffer; a buffer that another stage declares has the style that it has there.
BlockStyle StyleOf(const Cbuffer& cbuffer, BlockStyle style) {
  if (!cbuffer.declared) return style;
  if (cbuffer.declared->is_loose) return BlockStyle::kFlat;
  return cbuffer.declared->has_instance ? BlockStyle::kNamed : BlockStyle::kPlain;
}

BlockLayout AsRows(const Program& program, const Cbuffer& cbuffer) {
  BlockLayout layout;
  layout.form = BlockForm::kRows;
  layout.members = MembersOf(program, cbuffer, false);
  return layout;
}

BlockLayout AsUniforms(const Program& program, const Cbuffer& cbuffer) {
  BlockLayout layout;
  layout.form = BlockForm::kUniforms;
  layout.members = MembersOf(program, cbuffer, false);
  return layout;
}

}  // namespace

std::optional<Std140Extent> Std140(const TypeTable& types, TypeId type, bool row_major) {
  return Comparer(types, false).Extent(type, row_major);
}

std::optional<Std140Extent> Std430(const TypeTable& types, TypeId type, bool row_major) {
  const auto extent = Comparer(types, true).Extent(type, row_major);
  if (!extent || RoundUp(extent->size, extent->alignment) != Structured(types, type).size)
    return std::nullopt;
  return extent;
}

StructuredExtent Structured(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  const std::uint32_t scalar = ByteSize(type.scalar);
  switch (type.kind) {
    case TypeKind::kArray: {
      const StructuredExtent element = Structured(types, type.element);
      const std::uint64_t size = std::uint64_t{element.size} * type.count;
      return {static_cast<std::uint32_t>(std::min(size, kLargest)), element.alignment};
    }
    case TypeKind::kStruct: {
      StructuredExtent whole;
      for (const Field& field : types.StructOf(id).fields) {
        const StructuredExtent extent = Structured(types, field.type);
        const std::uint64_t end = RoundUp(whole.size, extent.alignment) + extent.size;
        whole.size = static_cast<std::uint32_t>(std::min(end, kLargest));
        whole.alignment = std::max(whole.alignment, extent.alignment);
      }
      whole.size = static_cast<std::uint32_t>(RoundUp(whole.size, whole.alignment));
      return whole;
    }
    default: return {scalar * type.Components(), scalar};
  }
}

bool OnlyFloats(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  switch (type.kind) {
    case TypeKind::kArray: return OnlyFloats(types, type.element);
    case TypeKind::kStruct:
      return std::ranges::all_of(types.StructOf(id).fields,
                                 [&](const Field& field) { return OnlyFloats(types, field.type); });
    default: return type.IsNumeric() && BaseOf(type.scalar) == Scalar::kFloat;
  }
}

BlockLayout LayOutBlock(const Program& program, const Cbuffer& cbuffer, const Target& target,
                        BlockStyle style) {
  style = StyleOf(cbuffer, style);
  const bool is_flat = style == BlockStyle::kFlat;
  if (is_flat || !target.Has(Feature::kUniformBlocks)) {
    // Where the host cannot have matrices transposed, it gives the bytes of the buffer as they are.
    const bool as_rows = !is_flat && !target.Has(Feature::kUniformTransposes) && cbuffer.count == 1;
    return as_rows ? AsRows(program, cbuffer) : AsUniforms(program, cbuffer);
  }
  BlockLayout layout;
  const bool is_plain = style == BlockStyle::kPlain;
  const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
  layout.fields_as_members = is_constant_buffer && target.Has(Feature::kBlockInstances);
  layout.members = MembersOf(program, cbuffer, layout.fields_as_members);
  if (!std::ranges::is_sorted(layout.members, {}, &BlockMember::offset))
    std::ranges::stable_sort(layout.members, {}, &BlockMember::offset);
  layout.float_rows = std::ranges::all_of(layout.members, [&](const BlockMember& member) {
    return OnlyFloats(program.types, member.type);
  });

  if (!PlaceMembers(program.types, layout.members, cbuffer.size,
                    target.Has(Feature::kExplicitOffsets))) {
    if (!layout.float_rows && !target.Has(Feature::kBitCasts))
      return AsUniforms(program, cbuffer);  // the target reads no float from bits
    BlockLayout rows = AsRows(program, cbuffer);
    rows.float_rows = layout.float_rows;
    return rows;
  }
  layout.has_instance = target.Has(Feature::kBlockInstances) && (is_constant_buffer || !is_plain);
  layout.has_uints = layout.has_instance && !is_plain && !layout.fields_as_members;
  MatrixLayout whole = MatrixLayout::kNone;
  const bool is_whole = cbuffer.declared ? cbuffer.declared->rows_on_block : is_plain;
  const bool agree =
      is_whole && std::ranges::all_of(layout.members, [&](const BlockMember& member) {
        return Agree(whole, member.matrices);
      });
  if (agree) layout.matrices = whole;
  return layout;
}

}  // namespace clipc::glsl
