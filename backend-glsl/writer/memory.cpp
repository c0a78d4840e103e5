// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/memory.h"

#include <fmt/format.h>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/types.h"
#include "base/invariant.h"
#include "ir/packing.h"

namespace clipc::glsl {

using namespace ir;

namespace {

constexpr std::uint32_t kWord = 4;

std::string Sum(const std::string& dynamic, std::uint32_t constant) {
  if (dynamic.empty()) return std::to_string(constant);
  return constant == 0 ? dynamic : Concat(dynamic, " + ", std::to_string(constant));
}

// A reader of values from one array of words.
class Loader {
 public:
  Loader(WriterContext& context, const Memory& memory) : context_(context), memory_(memory) {}

  std::string Load(TypeId id, bool row_major, const Address& address) {
    const Type& type = context_[id];
    switch (type.kind) {
      case TypeKind::kScalar:
      case TypeKind::kVector: return Vector(type.scalar, type.columns, address);
      case TypeKind::kMatrix: return Matrix(type, row_major, address);
      case TypeKind::kArray: return Array(id, row_major, address);
      case TypeKind::kStruct: return Structure(id, address);
      default: CLIPC_CHECK(!"a type that a buffer can hold");
    }
    return "";
  }

 private:
  static Address Plus(Address address, std::uint64_t bytes) {
    address.offset += static_cast<std::uint32_t>(bytes);
    return address;
  }

  // `count` words that lie side by side within one row.
  std::string Words(const Address& address, std::uint32_t count) {
    const std::uint32_t word = address.offset / kWord;
    const std::string row = Sum(address.dynamic, word / 4);
    const std::string_view components = std::string_view("xyzw").substr(word % 4, count);
    return Concat(memory_.array, "[", row, "]", count < 4 ? "." : "", count < 4 ? components : "");
  }

  std::string FromWords(Scalar kind, std::uint32_t components, const std::string& words) {
    switch (BaseOf(kind)) {
      case Scalar::kFloat:
        if (memory_.is_float) return words;
        context_.Require(Feature::kBitCasts);
        return Called("uintBitsToFloat", {words}).text;
      case Scalar::kUint: return words;
      case Scalar::kBool:
        if (components == 1) return words + " != 0u";
        return fmt::format("notEqual({}, uvec{}(0u))", words, components);
      default: return Of(kind, components, words);
    }
  }

  std::string Of(Scalar kind, std::uint32_t components, const std::string& list) {
    return Called(TypeName(context_, ShapeOf(kind, 1, static_cast<int>(components))), {list}).text;
  }

  std::string Vector(Scalar kind, std::uint32_t components, const Address& address) {
    const std::uint32_t size = ByteSize(kind);
    if (size == kWord) return FromWords(kind, components, Words(address, components));
    const std::string list = ListOf(components, [&](std::uint32_t i) {
      const std::string words = Words(Plus(address, std::uint64_t{i} * size), 2);
      switch (BaseOf(kind)) {
        case Scalar::kDouble: return fmt::format("packDouble2x32({})", words);
        case Scalar::kInt64: return fmt::format("packInt2x32(ivec2({}))", words);
        default: return fmt::format("packUint2x32({})", words);
      }
    });
    return components == 1 ? list : Of(kind, components, list);
  }

  std::string Matrix(const Type& type, bool row_major, const Address& address) {
    const Shape shape = ShapeOf(type, context_.needs);
    const std::uint32_t registers = row_major ? type.rows : type.columns;
    const std::uint32_t length = row_major ? type.columns : type.rows;
    const std::uint32_t component = ByteSize(type.scalar);
    const std::uint32_t tight = length * component;
    const std::uint64_t stride = RoundUp(tight, kRow);
    if (!shape.HasRows() && registers == 1) return Vector(type.scalar, length, address);

    const auto all = [&] {
      return ListOf(registers, [&](std::uint32_t i) {
        return Vector(type.scalar, length, Plus(address, i * stride));
      });
    };
    const std::string name = TypeName(context_, shape);
    if (!shape.HasRows() || row_major) return Called(name, {all()}).text;
    if (shape.kind == Shape::kMatrix && context_.Has(Feature::kFullMatrices)) {
      const Shape turned = ShapeOf(type.scalar, type.columns, type.rows);
      return fmt::format("transpose({}({}))", TypeName(context_, turned), all());
    }
    const auto row = [&](std::uint32_t r) {
      return Of(type.scalar, type.columns, ListOf(registers, [&](std::uint32_t c) {
                  return Vector(type.scalar, 1,
                                Plus(address, c * stride + std::uint64_t{r} * component));
                }));
    };
    return Called(name, {ListOf(std::uint32_t{type.rows}, row)}).text;
  }

  std::string Array(TypeId id, bool row_major, const Address& address) {
    const Type& type = context_[id];
    const std::string name = TypeName(context_, id);
    const std::uint32_t stride = ArrayStride(context_.types, id, row_major);
    const auto element = [&](const Address& place) {
      return ElementText(context_, type.element, {Load(type.element, row_major, place)});
    };
    if (type.count < kLongArray) {
      const auto at = [&](std::uint32_t i) {
        return element(Plus(address, std::uint64_t{i} * stride));
      };
      return Called(name, {ListOf(type.count, at)}).text;
    }
    const std::uint32_t rest = address.offset % kRow;
    const std::string helper =
        Helper(context_, "load_" + memory_.array,
               Concat(name, std::to_string(rest), row_major ? "r" : "c"),
               [&](const std::string& function) {
                 const std::string at = Fresh(context_, "at");
                 const auto value = [&](const std::string& index) {
                   return element({fmt::format("{} + {} * {}", at, stride / kRow, index), rest});
                 };
                 return fmt::format("{} {}(int {}) {{\n{}}}\n", name, function, at,
                                    FilledArray(context_, id, value));
               });
    return Called(helper, {Sum(address.dynamic, address.offset / kRow)}).text;
  }

  std::string Structure(TypeId id, const Address& address) {
    const std::string name = TypeName(context_, id);
    const TypeTable& types = context_.types;
    const auto& fields = types.StructOf(id).fields;
    std::uint32_t end = 0;
    const std::string list = ListOf(fields, [&](const Field& field) {
      const std::uint32_t offset = FieldPlace(types, field, end);
      end = offset + PackedExtent(types, field.type, field.row_major).size;
      return Load(field.type, field.row_major, Plus(address, offset));
    });
    return Called(name, {fields.empty() ? "0.0" : list}).text;
  }

  WriterContext& context_;
  const Memory& memory_;
};

}  // namespace

std::string Load(WriterContext& context, const Memory& memory, TypeId type, bool row_major,
                 const Address& address) {
  return Loader(context, memory).Load(type, row_major, address);
}

std::string Scaled(std::uint32_t stride, const std::string& index) {
  return stride == 1 ? index : Concat(std::to_string(stride), " * ", index);
}

}  // namespace clipc::glsl
