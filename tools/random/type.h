// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// The types of a generated program.
namespace clipc::random {

enum class Kind : std::uint8_t { kFloat, kInt, kUint, kBool };
inline bool IsInteger(Kind kind) { return kind == Kind::kInt || kind == Kind::kUint; }
inline constexpr Kind kKinds[] = {Kind::kFloat, Kind::kInt, Kind::kUint, Kind::kBool};

// The shape of a numeric value: rows is 0 for scalars and vectors.
struct Shape {
  int rows = 0, columns = 1;
  bool IsMatrix() const { return rows > 0; }
  bool IsScalar() const { return rows == 0 && columns == 1; }
  int Components() const { return columns * (rows > 0 ? rows : 1); }
  bool operator==(const Shape&) const = default;
};
inline constexpr Shape kScalar{0, 1};

struct Type {
  Kind kind = Kind::kFloat;
  Shape shape;
  int structure = -1;           // an index into Program::structs; then kind and shape mean nothing
  std::vector<int> sizes = {};  // of an array, the outermost first

  bool IsStruct() const { return structure >= 0 && sizes.empty(); }
  bool IsArray() const { return !sizes.empty(); }
  bool IsNumeric() const { return structure < 0 && sizes.empty(); }
  Type Element() const;
  bool operator==(const Type&) const = default;
};

struct Field {
  std::string name;
  Type type;
  // The qualifier of the matrices in the field: "row_major ", "column_major ", or "".
  std::string major = {};
};
struct Struct {
  std::string name;
  std::vector<Field> fields;
};
using Structs = std::vector<Struct>;

// The name of a kind, "float" or "int".
std::string NameOf(Kind kind);
// The name of a type that is not an array, "float3" or "int2x2".
std::string NameOf(const Structs& structs, const Type& type);
// A declaration, "float3 name[2]".
std::string Declaration(const Structs& structs, const Type& type, const std::string& name);

// A value whose components are all zero, "(S)0".
std::string Zero(const Structs& structs, const Type& type);

// The number of components of all elements and fields.
int ComponentsOf(const Structs& structs, const Type& type);

}  // namespace clipc::random
