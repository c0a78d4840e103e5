// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/packing.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace clipc::ir {
namespace {

constexpr std::uint64_t kRow = 16;
// The largest size in bytes. Hostile array sizes stop there instead of wrapping round; no device
// takes a buffer that large.
constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max() & ~(kRow - 1);

std::uint32_t Clamped(std::uint64_t bytes) {
  return static_cast<std::uint32_t>(std::min(bytes, kLargest));
}

// The extent of a matrix of `registers` registers of `length` components: the columns of a
// column-major matrix, the rows of a row-major one.
Extent MatrixExtent(std::uint32_t scalar_size, std::uint32_t registers, std::uint32_t length) {
  const std::uint64_t stride = RoundUp(std::uint64_t{length} * scalar_size, kRow);
  const std::uint32_t size =
      static_cast<std::uint32_t>(stride * (registers - 1)) + length * scalar_size;
  return {size, registers > 1 ? static_cast<std::uint32_t>(kRow) : scalar_size};
}

std::uint32_t Place(Extent extent, std::uint32_t end) {
  std::uint64_t offset = RoundUp(end, extent.alignment);
  const bool straddles = offset / kRow != (offset + std::max(extent.size, 1u) - 1) / kRow;
  if (straddles) offset = RoundUp(offset, kRow);
  return Clamped(offset);
}

// The offset of `field`, or the size of the whole when `field` is past the last one.
std::uint32_t Walk(const TypeTable& types, const Struct& structure, std::size_t field) {
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < structure.fields.size(); ++i) {
    const Field& current = structure.fields[i];
    const Extent extent = PackedExtent(types, current.type, current.row_major);
    const std::uint32_t offset = current.offset.value_or(Place(extent, end));
    if (i == field) return offset;
    end = Clamped(std::uint64_t{offset} + extent.size);
  }
  return end;
}

Extent MemberExtent(const TypeTable& types, const Var& var, CbufferKind kind) {
  // ConstantBuffer<T> b[2][3] is six buffers of a T.
  const TypeId type = kind == CbufferKind::kConstantBuffer ? types.Innermost(var.type) : var.type;
  return PackedExtent(types, type, var.row_major);
}

struct Range {
  std::uint32_t begin, end;
};

// The first place from `end` on that touches no range.
std::uint32_t PlaceOutside(const std::vector<Range>& taken, Extent extent, std::uint32_t end) {
  std::uint32_t offset = Place(extent, end);
  for (std::size_t i = 0; i < taken.size();) {
    const bool overlaps =
        offset < taken[i].end && taken[i].begin < std::uint64_t{offset} + extent.size;
    if (!overlaps) {
      ++i;
      continue;
    }
    offset = Place(extent, taken[i].end);
    i = 0;
  }
  return offset;
}

}  // namespace

Extent PackedExtent(const TypeTable& types, TypeId id, bool row_major) {
  using enum TypeKind;
  const Type& type = types[id];
  const std::uint32_t scalar_size = ByteSize(type.scalar);
  switch (type.kind) {
    case kScalar: return {scalar_size, scalar_size};
    case kVector: return {scalar_size * type.columns, scalar_size};
    case kMatrix:
      return row_major ? MatrixExtent(scalar_size, type.rows, type.columns)
                       : MatrixExtent(scalar_size, type.columns, type.rows);
    case kArray: {
      if (type.count == 0) return {0, static_cast<std::uint32_t>(kRow)};
      const std::uint64_t size = PackedExtent(types, type.element, row_major).size;
      return {Clamped(RoundUp(size, kRow) * (type.count - 1) + size),
              static_cast<std::uint32_t>(kRow)};
    }
    case kStruct: return {types.StructOf(id).packed_size, static_cast<std::uint32_t>(kRow)};
    case kObject:
    case kError:
    case kVoid:
    case kString: return {0, 4};
  }
  return {};
}

std::uint32_t PackedOffset(const TypeTable& types, TypeId type, bool row_major, std::uint32_t end) {
  return Place(PackedExtent(types, type, row_major), end);
}

std::uint32_t FieldPlace(const TypeTable& types, const Field& field, std::uint32_t end) {
  return field.offset.value_or(PackedOffset(types, field.type, field.row_major, end));
}

std::uint32_t FieldOffset(const TypeTable& types, StructId structure, std::uint32_t field) {
  return Walk(types, types[structure], field);
}

StructId TypeTable::AddStruct(Struct structure) {
  const StructId id = structs_.Add(std::move(structure));
  Measure(id);
  return id;
}

void TypeTable::Measure(StructId structure) {
  Struct& measured = structs_[structure];
  measured.packed_size = Walk(*this, measured, measured.fields.size());
}

std::uint32_t ArrayStride(const TypeTable& types, TypeId array, bool row_major) {
  return Clamped(RoundUp(PackedExtent(types, types[array].element, row_major).size, kRow));
}

void LayOut(const TypeTable& types, const Arena<Var>& vars, Cbuffer& buffer, bool whole_registers) {
  std::uint32_t end = 0;
  std::vector<Range> taken;
  for (CbufferMember& member : buffer.members) {
    member.size = MemberExtent(types, vars[member.var], buffer.kind).size;
    if (!member.has_packoffset) continue;
    end = Clamped(RoundUp(std::uint64_t{member.offset} + member.size, whole_registers ? kRow : 1));
    taken.push_back({member.offset, end});
  }
  for (CbufferMember& member : buffer.members) {
    if (member.has_packoffset) continue;
    const Extent extent = MemberExtent(types, vars[member.var], buffer.kind);
    member.offset = PlaceOutside(taken, extent, end);
    end = Clamped(std::uint64_t{member.offset} + member.size);
  }
  std::uint64_t last = 0;
  for (const CbufferMember& member : buffer.members) {
    last = std::max(last, std::uint64_t{member.offset} + member.size);
  }
  buffer.size = Clamped(RoundUp(last, kRow));
}

}  // namespace clipc::ir
