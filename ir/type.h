// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/arena.h"
#include "base/id.h"
#include "base/kept_blocks.h"
#include "base/span.h"
#include "ir/object.h"

namespace clipc::ir {

// The kinds of a component. They differ for overload ranking and messages; the shader computes with
// BaseOf(kind) only: half and the minimum-precision types are computed at 32 bits, as Direct3D
// allows.
enum class Scalar : std::uint8_t {
#define SCALAR(Enumerator, Spelling) k##Enumerator,
#include "base/builtin_types.def"
};
// The kind that a value of `kind` has at run time: kBool, kInt, kUint, kFloat, kDouble, kInt64 or
// kUint64.
constexpr Scalar BaseOf(Scalar kind) {
  using enum Scalar;
  switch (kind) {
    case kHalf:
    case kMin10Float:
    case kMin16Float: return kFloat;
    case kMin12Int:
    case kMin16Int: return kInt;
    case kMin16Uint: return kUint;
    default: return kind;
  }
}
// Whether the kind needs no more than 16 bits: half, and those of minimum precision.
constexpr bool IsMinPrecision(Scalar kind) { return BaseOf(kind) != kind; }
// Whether the kind is half, float, double or min*float.
constexpr bool IsFloat(Scalar kind) {
  return BaseOf(kind) == Scalar::kFloat || BaseOf(kind) == Scalar::kDouble;
}
// Whether the kind is a signed or unsigned integer, not bool.
constexpr bool IsInteger(Scalar kind) { return !IsFloat(kind) && kind != Scalar::kBool; }
constexpr bool IsUnsigned(Scalar kind) {
  return BaseOf(kind) == Scalar::kUint || BaseOf(kind) == Scalar::kUint64;
}
// Whether a component of the kind has 64 bits rather than 32.
constexpr bool IsWide(Scalar kind) {
  return kind == Scalar::kDouble || kind == Scalar::kInt64 || kind == Scalar::kUint64;
}
// The bytes of a component in a buffer.
constexpr std::uint32_t ByteSize(Scalar kind) { return IsWide(kind) ? 8 : 4; }
const char* NameOf(Scalar kind);  // HLSL's spelling

enum class TypeKind : std::uint8_t {
  kError,
  kVoid,
  kScalar,
  kVector,
  kMatrix,
  kArray,
  kStruct,
  kObject,
  kString
};

struct Struct;
struct Type;
using StructId = Id<Struct>;
using TypeId = Id<Type>;

// Types are interned: equal types have equal ids.
struct Type {
  TypeKind kind = TypeKind::kError;
  Scalar scalar = Scalar::kFloat;  // scalar, vector, matrix
  std::uint8_t rows = 1;           // of a matrix: the first number in float{rows}x{columns}
  std::uint8_t columns = 1;  // of a matrix; the components, 1 to 4, of a vector: float1 has one
  // The elements of an array; 0, of textures, samplers and buffers only: any number of them.
  std::uint32_t count = 0;
  // The element type of an array, Buffer<T>, StructuredBuffer<T> or Texture2D<T>; none for an
  // object without <T>.
  TypeId element = {};
  StructId structure = {};
  ObjectKind object = ObjectKind::kOther;

  bool IsNumeric() const {
    return kind == TypeKind::kScalar || kind == TypeKind::kVector || kind == TypeKind::kMatrix;
  }
  bool IsScalarOrVector() const { return kind == TypeKind::kScalar || kind == TypeKind::kVector; }
  std::uint32_t Components() const { return IsNumeric() ? std::uint32_t{rows} * columns : 0; }
  friend bool operator==(const Type&, const Type&) = default;
};

enum class Interpolation : std::uint8_t { kDefault, kLinear, kNoInterpolation, kNoPerspective };

struct Field {
  std::string name;
  TypeId type;
  Span span;
  bool row_major = false;  // how the matrices in it lie in memory (never changes a value)
  std::string semantic;    // as written, with its index ("TEXCOORD3"); empty: none
  Span semantic_span;
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
  bool precise = false;
  std::optional<std::uint32_t> location = {};     // [[vk::location(..)]]
  std::optional<std::uint32_t> blend_index = {};  // [[vk::index(..)]]
  std::optional<std::uint32_t> offset = {};       // [[vk::offset(..)]], in bytes
};
// A struct. Fields of its base structs come first.
struct Struct {
  std::string name;  // as written; "" for an unnamed struct
  std::vector<Field> fields;
  Span span;
  std::uint32_t packed_size = 0;  // PackedExtent(..).size; TypeTable::Measure gives it
};

// The types of one program. The common types are the same in every program: their ids are
// arithmetic, and they are not stored.
class TypeTable {
 public:
  TypeId Error() const { return TypeId{0}; }
  TypeId Void() const { return TypeId{1}; }
  TypeId String() const { return TypeId{2}; }
  TypeId Make(Scalar kind) { return Intern({.kind = TypeKind::kScalar, .scalar = kind}); }
  TypeId Vector(Scalar kind, int components) {
    return Intern({.kind = TypeKind::kVector,
                   .scalar = kind,
                   .columns = static_cast<std::uint8_t>(components)});
  }
  TypeId Matrix(Scalar kind, int rows, int columns) {
    return Intern({.kind = TypeKind::kMatrix,
                   .scalar = kind,
                   .rows = static_cast<std::uint8_t>(rows),
                   .columns = static_cast<std::uint8_t>(columns)});
  }
  TypeId Array(TypeId element, std::uint32_t count) {
    return Intern({.kind = TypeKind::kArray, .count = count, .element = element});
  }
  TypeId Of(StructId structure) {
    return Intern({.kind = TypeKind::kStruct, .structure = structure});
  }
  TypeId Object(ObjectKind kind, TypeId element = {}) {
    return Intern({.kind = TypeKind::kObject, .element = element, .object = kind});
  }
  // The shape of `type` with the component kind `kind`; `type` itself if it is not numeric.
  TypeId WithScalar(TypeId type, Scalar kind);
  // An object of this kind; of an array, an array of such objects.
  TypeId WithKind(TypeId type, ObjectKind kind);

  StructId AddStruct(Struct structure);
  // Computes the packed size of a struct whose fields have changed since it was added. A struct
  // keeps its size because structs of structs have more fields than can be walked for each member
  // after each pass.
  void Measure(StructId structure);
  const Type& operator[](TypeId id) const {
    return id.index < kCommonCount ? kCommon[id.index] : types_[TypeId{id.index - kCommonCount}];
  }
  const Struct& operator[](StructId id) const { return structs_[id]; }
  Struct& operator[](StructId id) { return structs_[id]; }
  const Struct& StructOf(TypeId id) const { return structs_[(*this)[id].structure]; }
  // The innermost element type, T of T[2][3]; the type itself when it is not an array.
  TypeId Innermost(TypeId id) const {
    while ((*this)[id].kind == TypeKind::kArray) id = (*this)[id].element;
    return id;
  }
  // Whether the type is one of numbers of minimum precision, or an array of such.
  bool HasMinPrecision(TypeId id) const {
    const Type& type = (*this)[Innermost(id)];
    return type.IsNumeric() && IsMinPrecision(type.scalar);
  }
  // The parts of a value are the rows of a matrix, the elements of an array or the fields of a
  // struct; a scalar, a vector and an object have none.
  std::uint32_t PartCount(TypeId id) const;
  TypeId PartType(TypeId id, std::uint32_t part);
  const Arena<Struct>& structs() const { return structs_; }

  // HLSL's spelling: "float4x3", "Light[3]", "Texture2D<float4>".
  std::string Name(TypeId id) const;
  // The number of types; the index of every TypeId is below it.
  std::uint32_t size() const { return kCommonCount + types_.size(); }

 private:
  TypeId Intern(const Type& type);

  // Error, void, string, and each scalar type with its vectors and matrices.
  static constexpr std::uint32_t kScalarKinds = static_cast<std::uint32_t>(Scalar::kUint64) + 1;
  static constexpr std::uint32_t kShapes = 1 + 4 + 16;
  static constexpr std::uint32_t kFirstNumeric = 3;
  static constexpr std::uint32_t kCommonCount = kFirstNumeric + kScalarKinds * kShapes;
  static constexpr std::array<Type, kCommonCount> MakeCommon();
  static std::uint32_t NumericIndex(const Type& type);
  static const std::array<Type, kCommonCount> kCommon;

  Arena<Type> types_;  // the types that are not common
  Arena<Struct> structs_;
  KeptMap<std::uint64_t, TypeId> by_key_;  // the same types by a packed key
};

// The kind of each component of a type in order, through structs and arrays; an object counts as
// one kUint.
std::vector<Scalar> KindsOf(const TypeTable& types, TypeId type);

}  // namespace clipc::ir
