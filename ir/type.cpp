// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/type.h"

#include "base/invariant.h"

namespace clipc::ir {
namespace {

std::uint64_t Key(const Type& type) {
  // 4 bits of kind, 28 of element, structure or object, 32 of count: enough for the ids of any real
  // program.
  constexpr std::uint32_t no_element = (1u << 28) - 1;
  const std::uint32_t inner = type.kind == TypeKind::kStruct ? type.structure.index
                              : type.element                 ? type.element.index
                                                             : no_element;
  CLIPC_CHECK(inner <= no_element);
  const std::uint32_t count =
      type.kind == TypeKind::kObject ? static_cast<std::uint32_t>(type.object) : type.count;
  return std::uint64_t{static_cast<std::uint8_t>(type.kind)} << 60 | std::uint64_t{inner} << 32 |
         count;
}

const char* ObjectName(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kTexture1D: return "Texture1D";
    case ObjectKind::kTexture1DArray: return "Texture1DArray";
    case ObjectKind::kTexture2D: return "Texture2D";
    case ObjectKind::kTexture2DArray: return "Texture2DArray";
    case ObjectKind::kTexture2DMS: return "Texture2DMS";
    case ObjectKind::kTexture2DMSArray: return "Texture2DMSArray";
    case ObjectKind::kTexture3D: return "Texture3D";
    case ObjectKind::kTextureCube: return "TextureCube";
    case ObjectKind::kTextureCubeArray: return "TextureCubeArray";
    case ObjectKind::kSampler: return "SamplerState";
    case ObjectKind::kSamplerComparison: return "SamplerComparisonState";
    case ObjectKind::kSampler1D: return "sampler1D";
    case ObjectKind::kSampler2D: return "sampler2D";
    case ObjectKind::kSampler3D: return "sampler3D";
    case ObjectKind::kSamplerCube: return "samplerCUBE";
    case ObjectKind::kBuffer: return "Buffer";
    case ObjectKind::kStructuredBuffer: return "StructuredBuffer";
    case ObjectKind::kByteAddressBuffer: return "ByteAddressBuffer";
    case ObjectKind::kRWBuffer: return "RWBuffer";
    case ObjectKind::kRWStructuredBuffer: return "RWStructuredBuffer";
    case ObjectKind::kRWByteAddressBuffer: return "RWByteAddressBuffer";
    case ObjectKind::kRWTexture1D: return "RWTexture1D";
    case ObjectKind::kRWTexture1DArray: return "RWTexture1DArray";
    case ObjectKind::kRWTexture2D: return "RWTexture2D";
    case ObjectKind::kRWTexture2DArray: return "RWTexture2DArray";
    case ObjectKind::kRWTexture3D: return "RWTexture3D";
    case ObjectKind::kOther: return "object";
  }
  return "object";
}

}  // namespace

bool IsWritable(ObjectKind kind) {
  return kind >= ObjectKind::kRWBuffer && kind <= ObjectKind::kRWTexture3D;
}
bool IsStructured(ObjectKind kind) {
  return kind == ObjectKind::kStructuredBuffer || kind == ObjectKind::kRWStructuredBuffer;
}
bool IsByteAddress(ObjectKind kind) {
  return kind == ObjectKind::kByteAddressBuffer || kind == ObjectKind::kRWByteAddressBuffer;
}
bool IsStorageBuffer(ObjectKind kind) { return IsStructured(kind) || IsByteAddress(kind); }
bool IsImage(ObjectKind kind) { return IsWritable(kind) && !IsStorageBuffer(kind); }

const char* NameOf(Scalar kind) {
  switch (kind) {
    case Scalar::kBool: return "bool";
    case Scalar::kInt: return "int";
    case Scalar::kUint: return "uint";
    case Scalar::kHalf: return "half";
    case Scalar::kFloat: return "float";
    case Scalar::kDouble: return "double";
    case Scalar::kMin10Float: return "min10float";
    case Scalar::kMin16Float: return "min16float";
    case Scalar::kMin12Int: return "min12int";
    case Scalar::kMin16Int: return "min16int";
    case Scalar::kMin16Uint: return "min16uint";
    case Scalar::kInt64: return "int64_t";
    case Scalar::kUint64: return "uint64_t";
  }
  return "?";
}

constexpr std::array<Type, TypeTable::kCommonCount> TypeTable::MakeCommon() {
  std::array<Type, kCommonCount> types{};
  types[1].kind = TypeKind::kVoid;
  types[2].kind = TypeKind::kString;
  std::size_t next = kFirstNumeric;
  for (std::uint32_t scalar = 0; scalar < kScalarKinds; ++scalar) {
    const Scalar kind = static_cast<Scalar>(scalar);
    types[next++] = {.kind = TypeKind::kScalar, .scalar = kind};
    for (std::uint8_t columns = 1; columns <= 4; ++columns) {
      types[next++] = {.kind = TypeKind::kVector, .scalar = kind, .columns = columns};
    }
    for (std::uint8_t rows = 1; rows <= 4; ++rows) {
      for (std::uint8_t columns = 1; columns <= 4; ++columns) {
        types[next++] = {
            .kind = TypeKind::kMatrix, .scalar = kind, .rows = rows, .columns = columns};
      }
    }
  }
  return types;
}
constexpr std::array<Type, TypeTable::kCommonCount> TypeTable::kCommon = MakeCommon();

// In the order of MakeCommon.
std::uint32_t TypeTable::NumericIndex(const Type& type) {
  std::uint32_t shape = 0;
  if (type.kind == TypeKind::kVector) shape = type.columns;
  if (type.kind == TypeKind::kMatrix) shape = 5 + (type.rows - 1) * 4 + (type.columns - 1);
  return kFirstNumeric + static_cast<std::uint32_t>(type.scalar) * kShapes + shape;
}

TypeId TypeTable::WithScalar(TypeId type, Scalar kind) {
  Type copy = (*this)[type];
  if (!copy.IsNumeric()) return type;
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

std::string TypeTable::Name(TypeId id) const {
  if (!id) return "<none>";
  std::string dimensions;
  const Type* type = &(*this)[id];
  for (; type->kind == TypeKind::kArray; type = &(*this)[type->element]) {
    dimensions += type->count == 0 ? "[]" : "[" + std::to_string(type->count) + "]";
  }
  std::string name;
  switch (type->kind) {
    case TypeKind::kError: name = "<error>"; break;
    case TypeKind::kVoid: name = "void"; break;
    case TypeKind::kString: name = "string"; break;
    case TypeKind::kScalar: name = NameOf(type->scalar); break;
    case TypeKind::kVector: name = NameOf(type->scalar) + std::to_string(type->columns); break;
    case TypeKind::kMatrix:
      name =
          NameOf(type->scalar) + std::to_string(type->rows) + "x" + std::to_string(type->columns);
      break;
    case TypeKind::kStruct:
      name = structs_[type->structure].name;
      if (name.empty()) name = "<unnamed struct>";
      break;
    case TypeKind::kObject:
      name = ObjectName(type->object);
      if (type->element) name += "<" + Name(type->element) + ">";
      break;
    case TypeKind::kArray: break;
  }
  return name + dimensions;
}

}  // namespace clipc::ir
