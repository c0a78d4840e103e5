// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Values out of arrays of words: constant buffers in rows, structured buffers in single words.
#include <algorithm>

#include "backend-glsl/writer.h"
#include "base/invariant.h"
#include "ir/packing.h"

namespace clipc::glsl {

using namespace ir;

namespace {

constexpr std::uint32_t kWord = 4;

std::uint32_t RoundUp(std::uint32_t value, std::uint32_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

std::string Sum(const std::string& dynamic, std::uint32_t constant) {
  if (dynamic.empty()) return std::to_string(constant);
  return constant == 0 ? dynamic : dynamic + " + " + std::to_string(constant);
}

Address Plus(Address address, std::uint32_t bytes) {
  address.offset += bytes;
  return address;
}

}  // namespace

std::uint32_t Writer::StrideOf(const Memory& memory, TypeId array, bool row_major) const {
  if (memory.is_rows) return ArrayStride(program_.types, array, row_major);
  return Structured(program_.types, program_.types[array].element).size;
}

// `count` words that lie side by side; in rows, within one row.
std::string Writer::Words(const Memory& memory, const Address& address, int count) {
  if (memory.is_rows) {
    std::string text = memory.array + "[" + Sum(address.dynamic, address.offset / kRow) + "]";
    if (count < 4)
      text += "." + std::string("xyzw").substr(address.offset % kRow / kWord,
                                               static_cast<std::size_t>(count));
    return text;
  }
  std::string text;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t word = address.offset / kWord + static_cast<std::uint32_t>(i);
    text += (i > 0 ? ", " : "") + memory.array + "[" + Sum(address.dynamic, word) + "]";
  }
  return count == 1 ? text : "uvec" + std::to_string(count) + "(" + text + ")";
}

std::string Writer::FromWords(const Memory& memory, Scalar kind, int components,
                              std::string words) {
  const std::string type = TypeName(ShapeOf(kind, 1, components));
  switch (BaseOf(kind)) {
    case Scalar::kFloat:
      if (memory.is_float) return words;
      Require(Feature::kBitCasts);
      return "uintBitsToFloat(" + words + ")";
    case Scalar::kUint: return words;
    case Scalar::kBool:
      if (components == 1) return words + " != 0u";
      return "notEqual(" + words + ", uvec" + std::to_string(components) + "(0u))";
    default: return type + "(" + words + ")";
  }
}

std::string Writer::LoadVector(const Memory& memory, Scalar kind, int components,
                               const Address& address) {
  const Scalar base = BaseOf(kind);
  if (ByteSize(kind) == kWord)
    return FromWords(memory, kind, components, Words(memory, address, components));
  const std::string pack = base == Scalar::kDouble  ? "packDouble2x32("
                           : base == Scalar::kInt64 ? "packInt2x32(ivec2("
                                                    : "packUint2x32(";
  std::string text;
  for (int i = 0; i < components; ++i) {
    text += (i > 0 ? ", " : "") + pack +
            Words(memory, Plus(address, static_cast<std::uint32_t>(i) * 8), 2);
    text += base == Scalar::kInt64 ? "))" : ")";
  }
  return components == 1 ? text : TypeName(ShapeOf(kind, 1, components)) + "(" + text + ")";
}

std::string Writer::LoadMatrix(const Memory& memory, const Type& type, bool row_major,
                               const Address& address) {
  const Shape shape = ShapeOf(type);
  const int registers = row_major ? type.rows : type.columns;
  const int length = row_major ? type.columns : type.rows;
  const std::uint32_t tight = static_cast<std::uint32_t>(length) * ByteSize(type.scalar);
  const std::uint32_t stride = memory.is_rows ? RoundUp(tight, kRow) : tight;
  if (!shape.HasRows() && registers == 1) return LoadVector(memory, type.scalar, length, address);

  const auto each = [&](int count, const auto& text) {
    std::string list;
    for (int i = 0; i < count; ++i)
      list += (i > 0 ? ", " : "") + text(static_cast<std::uint32_t>(i));
    return list;
  };
  const auto register_text = [&](std::uint32_t i) {
    return LoadVector(memory, type.scalar, length, Plus(address, i * stride));
  };
  if (!shape.HasRows() || row_major)
    return TypeName(shape) + "(" + each(registers, register_text) + ")";
  if (shape.kind == Shape::kMatrix) {
    return "transpose(" + TypeName(ShapeOf(type.scalar, type.columns, type.rows)) + "(" +
           each(registers, register_text) + "))";
  }
  const auto row = [&](std::uint32_t r) {
    return TypeName(shape.Row()) + "(" +
           each(type.columns,
                [&](std::uint32_t c) {
                  return LoadVector(memory, type.scalar, 1,
                                    Plus(address, c * stride + r * ByteSize(type.scalar)));
                }) +
           ")";
  };
  return TypeName(shape) + "(" + each(type.rows, row) + ")";
}

std::string Writer::LoadArray(const Memory& memory, TypeId id, bool row_major,
                              const Address& address) {
  const Type& type = program_.types[id];
  const std::uint32_t stride = StrideOf(memory, id, row_major);
  if (type.count < kLongArray) {
    std::string text = TypeName(id) + "(";
    for (std::uint32_t i = 0; i < type.count; ++i) {
      const std::string element = Load(memory, type.element, row_major, Plus(address, i * stride));
      text += (i > 0 ? ", " : "") + ElementText(type.element, {element});
    }
    return text + ")";
  }
  const std::uint32_t unit = memory.is_rows ? kRow : kWord;
  const std::string helper =
      Helper("load_" + memory.array,
             TypeName(id) + std::to_string(address.offset % unit) + (row_major ? "r" : "c"),
             [&](const std::string& function) {
               const std::string at = Fresh("at");
               const auto value = [&](const std::string& index) {
                 const Address element{at + " + " + std::to_string(stride / unit) + " * " + index,
                                       address.offset % unit};
                 return ElementText(type.element, {Load(memory, type.element, row_major, element)});
               };
               return TypeName(id) + " " + function + "(int " + at + ") {\n" +
                      FilledArray(id, value) + "}\n";
             });
  return helper + "(" + Sum(address.dynamic, address.offset / unit) + ")";
}

std::string Writer::Load(const Memory& memory, TypeId id, bool row_major, const Address& address) {
  const Type& type = program_.types[id];
  switch (type.kind) {
    case TypeKind::kScalar:
    case TypeKind::kVector: return LoadVector(memory, type.scalar, type.columns, address);
    case TypeKind::kMatrix: return LoadMatrix(memory, type, row_major, address);
    case TypeKind::kArray: return LoadArray(memory, id, row_major, address);
    case TypeKind::kStruct: break;
    default: CLIPC_CHECK(!"a type that a buffer can hold");
  }
  std::string text = TypeName(id) + "(";
  std::uint32_t end = 0;
  const Struct& structure = program_.types.StructOf(id);
  for (const Field& field : structure.fields) {
    std::uint32_t offset = 0;
    if (memory.is_rows) {
      offset = PackedOffset(program_.types, field.type, field.row_major, end);
      end = offset + PackedExtent(program_.types, field.type, field.row_major).size;
    } else {
      const StructuredExtent extent = Structured(program_.types, field.type);
      offset = RoundUp(end, extent.alignment);
      end = offset + extent.size;
    }
    if (&field != &structure.fields.front()) text += ", ";
    text += Load(memory, field.type, field.row_major, Plus(address, offset));
  }
  return text + (structure.fields.empty() ? "0.0)" : ")");
}

}  // namespace clipc::glsl
