// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/type.h"

namespace clipc::random {

Type Type::Element() const {
  Type element = *this;
  element.sizes.erase(element.sizes.begin());
  return element;
}

std::string NameOf(Kind kind) {
  constexpr const char* kNames[] = {"float", "int", "uint", "bool"};
  return kNames[static_cast<int>(kind)];
}

std::string NameOf(const Structs& structs, const Type& type) {
  if (type.structure >= 0) return structs[type.structure].name;
  std::string name = NameOf(type.kind);
  if (type.shape.IsMatrix()) name += std::to_string(type.shape.rows) + "x";
  return type.shape.IsScalar() ? name : name + std::to_string(type.shape.columns);
}

std::string Declaration(const Structs& structs, const Type& type, const std::string& name) {
  std::string text = NameOf(structs, type) + " " + name;
  for (const int size : type.sizes) text += "[" + std::to_string(size) + "]";
  return text;
}

std::string Zero(const Structs& structs, const Type& type) {
  return "(" + NameOf(structs, type) + ")0";
}

int ComponentsOf(const Structs& structs, const Type& type) {
  if (type.IsArray()) return type.sizes[0] * ComponentsOf(structs, type.Element());
  if (type.IsNumeric()) return type.shape.Components();
  int sum = 0;
  for (const Field& field : structs[type.structure].fields)
    sum += ComponentsOf(structs, field.type);
  return sum;
}

}  // namespace clipc::random
