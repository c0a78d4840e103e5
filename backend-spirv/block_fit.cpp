// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/block_fit.h"

#include <algorithm>
#include <span>

#include "backend-spirv/types.h"
#include "ir/packing.h"

namespace clipc::spirv {

using namespace ir;

namespace {

// A member or a field at its place.
struct Placed {
  TypeId type;
  bool row_major;
  std::uint32_t offset;
};

class Fit {
 public:
  Fit(const TypeTable& types, bool is_relaxed) : types_(types), is_relaxed_(is_relaxed) {}

  // Whether the parts of a struct, in the order of their offsets, fit.
  bool Has(std::span<const Placed> parts) const {
    std::uint64_t end = 0;
    for (const Placed& part : parts) {
      if (part.offset < end || !Has(part)) return false;
      const TypeKind kind = types_[part.type].kind;
      end = std::uint64_t{part.offset} + PackedExtent(types_, part.type, part.row_major).size;
      const Type& type = types_[part.type];
      // Of matrices spirv-val sees that where the order is ColMajor alone.
      const bool is_matrix = type.IsNumeric() && ShapeOf(type).HasRows();
      if (kind == TypeKind::kArray || kind == TypeKind::kStruct || is_matrix)
        end = RoundUp(end, kRow);
    }
    return true;
  }

 private:
  bool Has(const Placed& part) const {
    const Type& type = types_[part.type];
    if (type.IsNumeric()) return HasNumber(type, part);
    if (part.offset % kRow != 0) return false;
    if (type.kind == TypeKind::kArray) return Has({type.element, part.row_major, 0});
    if (type.kind != TypeKind::kStruct) return false;
    std::vector<Placed> fields;
    std::uint32_t end = 0;
    for (const Field& field : types_[type.structure].fields) {
      fields.push_back({field.type, field.row_major, FieldPlace(types_, field, end)});
      end = fields.back().offset + PackedExtent(types_, field.type, field.row_major).size;
    }
    return !fields.empty() && std::ranges::is_sorted(fields, {}, &Placed::offset) && Has(fields);
  }

  bool HasNumber(const Type& type, const Placed& part) const {
    if (IsWide(type.scalar)) return false;
    const Shape shape = ShapeOf(type);
    const bool is_matrix = type.kind == TypeKind::kMatrix;
    const std::uint32_t registers = part.row_major ? type.rows : type.columns;
    if (shape.kind == Shape::kRows && !part.row_major) return false;
    if (shape.HasRows()) return part.offset % kRow == 0;
    if (is_matrix && registers > 1) return false;  // a component in each row
    const std::uint32_t size = shape.size == 3 ? 4 : shape.size;
    return part.offset % (is_relaxed_ ? 4 : 4 * size) == 0;
  }

  const TypeTable& types_;
  bool is_relaxed_;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> FittingMembers(const Program& program,
                                                         const Cbuffer& cbuffer,
                                                         const std::vector<bool>& is_read,
                                                         bool is_relaxed) {
  const Fit fit(program.types, is_relaxed);
  const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
  for (const bool only_read : {false, true}) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < cbuffer.members.size(); ++i) {
      if (!only_read || is_read[cbuffer.members[i].var.index]) kept.push_back(i);
    }
    std::ranges::stable_sort(kept, {}, [&](std::uint32_t i) { return cbuffer.members[i].offset; });
    std::vector<Placed> parts;
    for (const std::uint32_t i : kept) {
      const CbufferMember& member = cbuffer.members[i];
      const Var& var = program.vars[member.var];
      const TypeId type = is_constant_buffer ? program.types.Innermost(var.type) : var.type;
      parts.push_back({type, var.row_major, member.offset});
    }
    if (fit.Has(parts)) return kept;
  }
  return std::nullopt;
}

}  // namespace clipc::spirv
