// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "backend-glsl/literal.h"
#include "backend-glsl/needs.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

namespace {

bool IsArrayInGlsl(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  return type.kind == TypeKind::kArray || (type.IsNumeric() && ShapeOf(type).kind == Shape::kRows);
}

}  // namespace

bool Writer::IsWrapped(TypeId array_element) const {
  return !target_.Has(Feature::kArraysOfArrays) && IsArrayInGlsl(program_.types, array_element);
}

void Writer::RequireType(const Type& type) {
  if (!type.IsNumeric()) return;
  if (const Need* need = NeedOf(BaseOf(type.scalar))) Require(need->feature);
}

// `struct float_array3 { float e[3]; }`: an array as the element of another where GLSL has no
// arrays of arrays.
std::string Writer::WrapperOf(TypeId array) {
  const TypeParts parts = PartsOf(array);
  auto [found, is_new] = wrappers_.try_emplace(parts.base + parts.dimensions);
  if (is_new) {
    const std::string size = parts.dimensions.substr(1, parts.dimensions.size() - 2);
    found->second = namer_.Global(parts.base + "_array" + size);
    structs_ +=
        "struct " + found->second + " {\n    " + parts.base + " e" + parts.dimensions + ";\n};\n\n";
  }
  return found->second;
}

Writer::TypeParts Writer::PartsOf(TypeId id) {
  const Type& type = program_.types[id];
  switch (type.kind) {
    case TypeKind::kScalar:
    case TypeKind::kVector:
    case TypeKind::kMatrix: {
      RequireType(type);
      const std::string name = TypeName(ShapeOf(type));
      const std::size_t bracket = name.find('[');
      if (bracket == std::string::npos) return {name, ""};
      return {name.substr(0, bracket), name.substr(bracket)};
    }
    case TypeKind::kArray: {
      const std::string count = "[" + std::to_string(type.count) + "]";
      if (IsWrapped(type.element)) return {WrapperOf(type.element), count};
      TypeParts element = PartsOf(type.element);
      return {std::move(element.base), count + element.dimensions};
    }
    case TypeKind::kStruct:
      UseStruct(type.structure);
      return {struct_names_[type.structure.index], ""};
    case TypeKind::kVoid: return {"void", ""};
    default: break;
  }
  CLIPC_CHECK(!"a type with a value");
  return {};
}

std::string Writer::TypeName(TypeId type) {
  TypeParts parts = PartsOf(type);
  parts.base += parts.dimensions;
  return std::move(parts.base);
}

std::string Writer::Declaration(TypeId type, std::string_view name) {
  const TypeParts parts = PartsOf(type);
  return Concat(parts.base, " ", name, parts.dimensions);
}

std::string Writer::Declaration(const Shape& shape, std::string_view name) const {
  const std::string type_name = TypeName(shape);
  const std::string_view type = type_name;
  const std::size_t bracket = std::min(type.find('['), type.size());
  return Concat(type.substr(0, bracket), " ", name, type.substr(bracket));
}

void Writer::UseStruct(StructId id) {
  if (struct_used_[id.index]) return;
  struct_used_[id.index] = true;
  const Struct& structure = program_.types[id];
  std::string text = "struct " + struct_names_[id.index] + " {\n";
  for (std::uint32_t i = 0; i < structure.fields.size(); ++i) {
    text += "    " + Declaration(structure.fields[i].type, FieldName(id, i)) + ";\n";
  }
  if (structure.fields.empty()) text += "    float empty;\n";  // GLSL has no struct without fields
  structs_ += text + "};\n\n";
}

// The body of a function that returns an array of element(index variable).
std::string Writer::FilledArray(TypeId id,
                                const std::function<std::string(const std::string&)>& element) {
  const std::string array = Fresh("result"), index = Fresh("i");
  return "    " + Declaration(id, array) + ";\n    for (int " + index + " = 0; " + index + " < " +
         std::to_string(program_.types[id].count) + "; ++" + index + ") " + array + "[" + index +
         "] = " + element(index) + ";\n    return " + array + ";\n";
}

std::string Writer::ElementText(TypeId element, Text text) {
  if (!IsWrapped(element)) return Argument(std::move(text));
  return WrapperOf(element) + "(" + Argument(std::move(text)) + ")";
}

std::string Writer::ZeroText(const Shape& shape) const {
  const std::string zero = LiteralText(0, shape.scalar, target_).text;
  if (shape.IsScalar()) return zero;
  if (shape.kind != Shape::kRows) return TypeName(shape) + "(" + zero + ")";
  std::string text = TypeName(shape) + "(";
  for (int i = 0; i < shape.rows; ++i) text += (i > 0 ? ", " : "") + ZeroText(shape.Row());
  return text + ")";
}

std::string Writer::ZeroText(TypeId id) {
  const Type& type = program_.types[id];
  if (type.IsNumeric()) return ZeroText(ShapeOf(type));
  const std::string name = TypeName(id);
  std::string text = name + "(";
  if (type.kind == TypeKind::kStruct) {
    const Struct& structure = program_.types[type.structure];
    for (std::size_t i = 0; i < structure.fields.size(); ++i) {
      text += (i > 0 ? ", " : "") + ZeroText(structure.fields[i].type);
    }
    return text + (structure.fields.empty() ? "0.0)" : ")");
  }
  CLIPC_CHECK(type.kind == TypeKind::kArray);
  const std::string zero = ElementText(type.element, {ZeroText(type.element)});
  if (type.count >= kLongArray) {
    return Helper("zeros_" + name, "",
                  [&](const std::string& helper) {
                    return name + " " + helper + "() {\n" +
                           FilledArray(id, [&](const std::string&) { return zero; }) + "}\n";
                  }) +
           "()";
  }
  for (std::uint32_t i = 0; i < type.count; ++i) text += (i > 0 ? ", " : "") + zero;
  return text + ")";
}

}  // namespace clipc::glsl
