// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/type.h"

#include "base/invariant.h"

namespace clipc::ir {
namespace {

std::uint64_t Key(const Type& type) {
  // The key has 4 bits of kind, 28 of element, structure or object, 32 of count: enough for the ids
  // of any real program.
  constexpr std::uint32_t kNoElement = (1u << 28) - 1;
  const std::uint32_t inner = type.kind == TypeKind::kStruct ? type.structure.index
                              : type.element                 ? type.element.index
                                                             : kNoElement;
  CLIPC_CHECK(inner <= kNoElement);
  const std::uint32_t count =
      type.kind == TypeKind::kObject ? static_cast<std::uint32_t>(type.object) : type.count;
  return std::uint64_t{static_cast<std::uint8_t>(type.kind)} << 60 | std::uint64_t{inner} << 32 |
         count;
}

}  // namespace

const char* NameOf(Scalar kind) {
  static constexpr const char* kNames[] = {
#define SCALAR(Enumerator, Spelling) Spelling,
#include "base/builtin_types.def"
  };
  return kNames[static_cast<std::size_t>(kind)];
}

constexpr std::array<Type, TypeTable::kCommonCount> TypeTable::MakeCommon() {
  using enum TypeKind;
  std::array<Type, kCommonCount> types{};
  types[1].kind = kVoid;
  types[2].kind = kString;
  std::size_t next = kFirstNumeric;
  for (std::uint32_t scalar = 0; scalar < kScalarKinds; ++scalar) {
    const Scalar kind = static_cast<Scalar>(scalar);
    types[next++] = {.kind = kScalar, .scalar = kind};
    for (std::uint8_t columns = 1; columns <= 4; ++columns) {
      types[next++] = {.kind = kVector, .scalar = kind, .columns = columns};
    }
    for (std::uint8_t rows = 1; rows <= 4; ++rows) {
      for (std::uint8_t columns = 1; columns <= 4; ++columns) {
        types[next++] = {.kind = kMatrix, .scalar = kind, .rows = rows, .columns = columns};
      }
    }
  }
  return types;
}
constexpr std::array<Type, TypeTable::kCommonCount> TypeTable::kCommon = MakeCommon();

// The position of a numeric type in kCommon.
std::uint32_t TypeTable::NumericIndex(const Type& type) {
  std::uint32_t shape = 0;
  if (type.kind == TypeKind::kVector) shape = type.columns;
  if (type.kind == TypeKind::kMatrix) shape = 5 + (type.rows - 1) * 4 + (type.columns - 1);
  return kFirstNumeric + static_cast<std::uint32_t>(type.scalar) * kShapes + shape;
}

TypeId TypeTable::WithKind(TypeId id, ObjectKind kind) {
  const Type type = (*this)[id];
  return type.kind == TypeKind::kArray ? Array(WithKind(type.element, kind), type.count)
                                       : Object(kind);
}

TypeId TypeTable::WithScalar(TypeId type, Scalar kind) {
  Type copy = (*this)[type];
  if (!copy.IsNumeric() || copy.scalar == kind) return type;
  copy.scalar = kind;
  return Intern(copy);
}

TypeId TypeTable::Intern(const Type& type) {
  if (type.IsNumeric()) {
    CLIPC_CHECK(type.rows >= 1 && type.rows <= 4 && type.columns >= 1 && type.columns <= 4);
    return TypeId{NumericIndex(type)};
  }
  auto [entry, is_new] = by_key_.try_emplace(Key(type), TypeId{});
  if (is_new) entry->second = TypeId{kCommonCount + types_.Add(type).index};
  return entry->second;
}

std::uint32_t TypeTable::PartCount(TypeId id) const {
  const Type& type = (*this)[id];
  switch (type.kind) {
    case TypeKind::kMatrix: return type.rows;
    case TypeKind::kArray: return type.count;
    case TypeKind::kStruct: return static_cast<std::uint32_t>(StructOf(id).fields.size());
    default: return 0;
  }
}

TypeId TypeTable::PartType(TypeId id, std::uint32_t part) {
  const Type type = (*this)[id];
  if (type.kind == TypeKind::kMatrix) return Vector(type.scalar, type.columns);
  return type.kind == TypeKind::kStruct ? StructOf(id).fields[part].type : type.element;
}

std::string TypeTable::Name(TypeId id) const {
  using enum TypeKind;
  if (!id) return "<none>";
  const Type* type = &(*this)[Innermost(id)];
  const auto digit = [](auto count) { return static_cast<char>('0' + count); };
  std::string name;
  switch (type->kind) {
    case kError: name = "<error>"; break;
    case kVoid: name = "void"; break;
    case kString: name = "string"; break;
    case kScalar: name = NameOf(type->scalar); break;
    case kVector:
      name = NameOf(type->scalar);
      name += digit(type->columns);
      break;
    case kMatrix:
      name = NameOf(type->scalar);
      name += {digit(type->rows), 'x', digit(type->columns)};
      break;
    case kStruct:
      name = structs_[type->structure].name;
      if (name.empty()) name = "<unnamed struct>";
      break;
    case kObject:
      name = InfoOf(type->object).name;
      if (type->element) (name += '<').append(Name(type->element)) += '>';
      break;
    case kArray: break;
  }
  for (type = &(*this)[id]; type->kind == kArray; type = &(*this)[type->element])
    name += type->count == 0 ? "[]" : "[" + std::to_string(type->count) + "]";
  return name;
}

std::vector<Scalar> KindsOf(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  std::vector<Scalar> kinds(type.Components(), type.scalar);
  if (type.kind == TypeKind::kObject) kinds.push_back(Scalar::kUint);
  if (type.kind == TypeKind::kArray) {
    const std::vector<Scalar> element = KindsOf(types, type.element);
    for (std::uint32_t i = 0; i < type.count; ++i)
      kinds.insert(kinds.end(), element.begin(), element.end());
  }
  if (type.kind == TypeKind::kStruct) {
    for (const Field& field : types[type.structure].fields) {
      const std::vector<Scalar> part = KindsOf(types, field.type);
      kinds.insert(kinds.end(), part.begin(), part.end());
    }
  }
  return kinds;
}

}  // namespace clipc::ir
