// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/layout.h"

#include <algorithm>

namespace clipc::random {
namespace {

constexpr int kRow = 16;

int UpToRow(int bytes) { return (bytes + kRow - 1) / kRow * kRow; }

// Registers that a matrix takes, and components of each.
struct Registers {
  int count, components;
};
Registers RegistersOf(Shape shape, bool row_major) {
  return row_major ? Registers{shape.rows, shape.columns} : Registers{shape.columns, shape.rows};
}

int PlaceAfter(const Extent& extent, int end) {
  const bool straddles = end % kRow + extent.size > kRow;
  return extent.starts_row || straddles ? UpToRow(end) : end;
}

bool IsRowMajor(const Field& field) { return field.major == "row_major "; }

// Calls visit(field, offset) for each field.
template <typename Visit>
int WalkFields(const Structs& structs, const Struct& structure, Visit&& visit) {
  int end = 0;
  for (const Field& field : structure.fields) {
    const Extent extent = ExtentOf(structs, field.type, IsRowMajor(field));
    const int at = PlaceAfter(extent, end);
    visit(field, at);
    end = at + extent.size;
  }
  return end;
}

void Append(const Structs& structs, const Type& type, bool row_major, int offset,
            std::vector<std::uint32_t>& bytes) {
  if (type.IsArray()) {
    const int stride = UpToRow(ExtentOf(structs, type.Element(), row_major).size);
    for (int i = 0; i < type.sizes[0]; ++i)
      Append(structs, type.Element(), row_major, offset + i * stride, bytes);
  } else if (type.IsStruct()) {
    WalkFields(structs, structs[type.structure], [&](const Field& field, int at) {
      Append(structs, field.type, IsRowMajor(field), offset + at, bytes);
    });
  } else {
    for (int row = 0; row < std::max(type.shape.rows, 1); ++row) {
      for (int column = 0; column < type.shape.columns; ++column) {
        const bool by_row = row_major || !type.shape.IsMatrix();
        bytes.push_back(static_cast<std::uint32_t>(
            offset + (by_row ? kRow * row + 4 * column : kRow * column + 4 * row)));
      }
    }
  }
}

}  // namespace

const Structs& WithMajors(Structs& structs, bool row_major) {
  for (Struct& structure : structs) {
    for (Field& field : structure.fields) {
      if (field.major.empty()) field.major = row_major ? "row_major " : "column_major ";
    }
  }
  return structs;
}

Extent ExtentOf(const Structs& structs, const Type& type, bool row_major) {
  if (type.IsArray()) {
    const int element = ExtentOf(structs, type.Element(), row_major).size;
    return {(type.sizes[0] - 1) * UpToRow(element) + element, true};
  }
  if (type.IsStruct())
    return {WalkFields(structs, structs[type.structure], [](const Field&, int) {}), true};
  if (!type.shape.IsMatrix()) return {4 * type.shape.columns, false};
  const Registers registers = RegistersOf(type.shape, row_major);
  return {kRow * (registers.count - 1) + 4 * registers.components, registers.count > 1};
}

std::vector<std::vector<std::uint32_t>> OffsetsOf(const Structs& structs,
                                                  const ConstantBuffer& buffer) {
  std::vector<std::vector<std::uint32_t>> all;
  int end = 0;
  for (const Member& member : buffer.members) {
    const Extent extent = ExtentOf(structs, member.type, member.row_major);
    const int at = member.packoffset >= 0 ? member.packoffset : PlaceAfter(extent, end);
    Append(structs, member.type, member.row_major, at, all.emplace_back());
    end = at + extent.size;
  }
  return all;
}

}  // namespace clipc::random
