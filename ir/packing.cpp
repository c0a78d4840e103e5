// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/packing.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace clipc::ir {
namespace {

constexpr std::uint64_t kRow = 16;
// The largest size in bytes. Hostile array sizes stop there instead of wrapping round; no device
// takes a buffer that large.
constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max() & ~(kRow - 1);

// The largest size of an element of a StructuredBuffer, so that sums of such sizes stay far from
// wrapping round.
constexpr std::uint64_t kLargestElement = 1u << 30;

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

struct Packer {
  const TypeTable& types;
  std::span<const std::uint64_t> components;  // that are not packed yet
  std::vector<std::uint8_t> bytes;

  void Pack(TypeId id, bool row_major, std::uint64_t offset) {
    const Type& type = types[id];
    if (type.kind == TypeKind::kArray) {
      const std::uint64_t stride = ArrayStride(types, id, row_major);
      for (std::uint32_t i = 0; i < type.count && !components.empty(); ++i)
        Pack(type.element, row_major, offset + i * stride);
    } else if (type.kind == TypeKind::kStruct) {
      const auto& fields = types[type.structure].fields;
      for (std::uint32_t i = 0; i < fields.size(); ++i) {
        Pack(fields[i].type, fields[i].row_major, offset + FieldOffset(types, type.structure, i));
      }
    } else if (type.IsNumeric()) {
      PackRows(type, row_major, offset);
    }
  }

  // Packs a scalar, a vector or a matrix.
  void PackRows(const Type& type, bool row_major, std::uint64_t offset) {
    const std::uint64_t size = ByteSize(type.scalar);
    const bool is_matrix = type.kind == TypeKind::kMatrix;
    const std::uint64_t stride = RoundUp((row_major ? type.columns : type.rows) * size, kRow);
    for (std::uint32_t i = 0; i < type.Components() && !components.empty(); ++i) {
      const std::uint64_t row = i / type.columns, column = i % type.columns;
      const std::uint64_t place = !is_matrix  ? i * size
                                  : row_major ? row * stride + column * size
                                              : column * stride + row * size;
      for (std::uint64_t byte = 0; byte < size && offset + place + byte < bytes.size(); ++byte)
        bytes[offset + place + byte] = static_cast<std::uint8_t>(components.front() >> (8 * byte));
      components = components.subspan(1);
    }
  }
};

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

StructuredExtent Structured(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  const std::uint32_t scalar = ByteSize(type.scalar);
  switch (type.kind) {
    case TypeKind::kArray: {
      const StructuredExtent element = Structured(types, type.element);
      const std::uint64_t size = std::uint64_t{element.size} * type.count;
      return {static_cast<std::uint32_t>(std::min(size, kLargestElement)), element.alignment};
    }
    case TypeKind::kStruct: {
      StructuredExtent whole;
      for (const Field& field : types.StructOf(id).fields) {
        const StructuredExtent extent = Structured(types, field.type);
        const std::uint64_t end = RoundUp(whole.size, extent.alignment) + extent.size;
        whole.size = static_cast<std::uint32_t>(std::min(end, kLargestElement));
        whole.alignment = std::max(whole.alignment, extent.alignment);
      }
      whole.size = static_cast<std::uint32_t>(RoundUp(whole.size, whole.alignment));
      return whole;
    }
    default: return {scalar * type.Components(), scalar};
  }
}

std::vector<std::uint8_t> Packed(const TypeTable& types, TypeId type, bool row_major,
                                 std::span<const std::uint64_t> components) {
  Packer packer{types, components,
                std::vector<std::uint8_t>(PackedExtent(types, type, row_major).size)};
  packer.Pack(type, row_major, 0);
  return std::move(packer.bytes);
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
