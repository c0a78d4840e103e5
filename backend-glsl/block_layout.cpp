// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/block_layout.h"

#include <algorithm>
#include <span>

#include "ir/packing.h"
#include "ir/std_layout.h"

namespace clipc::glsl {

using namespace ir;

namespace {

constexpr std::uint32_t kPromised = 16384;  // bytes: GL_MAX_UNIFORM_BLOCK_SIZE is this at least

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

// Sets the explicit offset or the padding of a member of this alignment; `end` is that of the
// members before it.
void Place(BlockMember& member, std::uint32_t alignment, std::uint64_t end, bool explicit_offsets) {
  const bool is_moved = member.offset != RoundUp(end, alignment);
  member.explicit_offset = is_moved && explicit_offsets;
  member.padding =
      is_moved && !explicit_offsets ? static_cast<std::uint32_t>(member.offset - end) : 0;
}

// Returns whether the members, in order of offset, fit std140; sets their explicit offsets and
// paddings.
bool PlaceMembers(const TypeTable& types, std::span<BlockMember> members, std::uint32_t size,
                  bool explicit_offsets) {
  std::uint64_t end = 0;
  for (BlockMember& member : members) {
    const auto extent = Std140(types, member.type, member.row_major);
    if (!extent || member.offset % extent->alignment != 0 || member.offset < end) return false;
    Place(member, extent->alignment, end, explicit_offsets);
    member.matrices = extent->matrices;
    end = std::uint64_t{member.offset} + extent->size;
  }
  // A block larger than what Direct3D binds would read past the end of the host's buffer.
  return RoundUp(end, kRow) <= size;
}

// A division of a block, some of whose members do not fit std140, into parts. A member that is not
// read has no part where it does not fit, or where one that is read needs its room.
class Division {
 public:
  Division(const TypeTable& types, std::uint32_t size) : types_(types), size_(size) {}

  // Adds the next member in order of offset.
  void Add(const BlockMember& member, bool is_read) {
    const auto extent = Std140(types_, member.type, member.row_major);
    const bool fits = extent && member.offset % extent->alignment == 0 &&
                      RoundUp(std::uint64_t{member.offset} + extent->size, kRow) <= size_;
    if (!is_read) {
      if (fits && member.offset >= End()) AddWhole(member, *extent, false);
      return;
    }
    while (End() > member.offset && !parts_.back().is_read) parts_.pop_back();
    const bool is_free = member.offset >= End();
    const Type& type = types_[member.type];
    if (fits && is_free)
      AddWhole(member, *extent, true);
    else if (is_free && type.kind == TypeKind::kVector && ByteSize(type.scalar) == 4)
      AddByHand(member, PartForm::kWords, member.offset, member.offset + 4 * type.columns);
    else
      AddRows(member);
  }

  // Moves the parts to the layout. Returns false if there are none, which GLSL cannot declare.
  bool Finish(std::span<const BlockMember> members, const std::vector<bool>& is_read,
              bool explicit_offsets, BlockLayout& layout) {
    std::vector<BlockMember> placed;
    std::uint64_t end = 0;
    for (Part& part : parts_) {
      Place(part.member, part.alignment, end, explicit_offsets);
      placed.push_back(part.member);
      end = part.end;
    }
    std::size_t at = 0;
    for (const BlockMember& member : members) {
      if (!is_read[member.var.index]) continue;
      while (at + 1 < parts_.size() && parts_[at].end <= member.offset) ++at;
      if (at >= placed.size()) return false;
      BlockMember& part = placed[at];
      if (part.form == PartForm::kWhole && part.var == member.var) continue;
      layout.by_hand.push_back({member.var, member.offset, at});
      part.float_rows = part.float_rows && OnlyFloats(types_, member.type);
    }
    layout.members = std::move(placed);
    return true;
  }

 private:
  struct Part {
    BlockMember member;
    std::uint64_t end = 0;  // bytes
    std::uint32_t alignment = kRow;
    bool is_read = true;
  };

  std::uint64_t End() const { return parts_.empty() ? 0 : parts_.back().end; }

  void AddWhole(const BlockMember& member, const StdExtent& extent, bool is_read) {
    parts_.push_back(
        {member, std::uint64_t{member.offset} + extent.size, extent.alignment, is_read});
    parts_.back().member.matrices = extent.matrices;
  }

  void AddByHand(BlockMember member, PartForm form, std::uint64_t begin, std::uint64_t end) {
    member.form = form;
    member.offset = static_cast<std::uint32_t>(begin);
    member.rows = form == PartForm::kRows ? static_cast<std::uint32_t>((end - begin) / kRow) : 0;
    parts_.push_back({member, end, form == PartForm::kRows ? kRow : 4});
  }

  // Adds the rows in which the member lies, and which take up those parts that they touch.
  void AddRows(BlockMember member) {
    const std::uint32_t size = PackedExtent(types_, member.type, member.row_major).size;
    std::uint64_t begin = member.offset / kRow * kRow;
    std::uint64_t end = RoundUp(std::uint64_t{member.offset} + size, kRow);
    if (size == 0) return;
    for (; End() > begin; parts_.pop_back()) {
      const Part& part = parts_.back();
      if (!part.is_read) continue;
      begin = std::min<std::uint64_t>(begin, part.member.offset / kRow * kRow);
      end = std::max(end, RoundUp(part.end, kRow));
      member.var = part.member.var;
    }
    AddByHand(member, PartForm::kRows, begin, end);
  }

  const TypeTable& types_;
  std::uint64_t size_;       // of the buffer in bytes
  std::vector<Part> parts_;  // in order of offset, apart from each other
};

// Divides a block that does not fit std140. Returns false, and keeps the layout, for one that is
// declared by another stage or is a ConstantBuffer<T>, whose one member is read whole.
bool Divide(const Program& program, const Cbuffer& cbuffer, bool explicit_offsets,
            const std::vector<bool>& is_read, BlockLayout& layout) {
  if (cbuffer.declared || cbuffer.kind == CbufferKind::kConstantBuffer) return false;
  Division division(program.types, cbuffer.size);
  for (const BlockMember& member : layout.members) division.Add(member, is_read[member.var.index]);
  const std::vector<BlockMember> members = layout.members;
  return division.Finish(members, is_read, explicit_offsets, layout);
}

// Drops the members after the last one that is read from a block that is larger than OpenGL
// promises and would not be without them.
void EndEarly(const TypeTable& types, const std::vector<bool>& is_read, BlockLayout& layout) {
  auto& members = layout.members;
  const auto last = std::find_if(members.rbegin(), members.rend(), [&](const BlockMember& member) {
    return member.form != PartForm::kWhole || is_read[member.var.index];
  });
  if (last == members.rend()) return;
  const std::uint64_t size = last->form == PartForm::kRows
                                 ? std::uint64_t{last->rows} * kRow
                                 : PackedExtent(types, last->type, last->row_major).size;
  if (last->offset + size <= kPromised) members.erase(last.base(), members.end());
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
                        BlockStyle style, const std::vector<bool>& is_read) {
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

  const bool explicit_offsets = target.Has(Feature::kExplicitOffsets);
  if (!PlaceMembers(program.types, layout.members, cbuffer.size, explicit_offsets) &&
      !Divide(program, cbuffer, explicit_offsets, is_read, layout)) {
    if (!layout.float_rows && !target.Has(Feature::kBitCasts))
      return AsUniforms(program, cbuffer);  // the target reads no float from bits
    BlockLayout rows = AsRows(program, cbuffer);
    rows.float_rows = layout.float_rows;
    return rows;
  }
  const bool has_bits = std::ranges::any_of(layout.members, [](const BlockMember& member) {
    return member.form == PartForm::kRows && !member.float_rows;
  });
  if (has_bits && !target.Has(Feature::kBitCasts)) return AsUniforms(program, cbuffer);
  if (cbuffer.size > kPromised && !cbuffer.declared) EndEarly(program.types, is_read, layout);
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
