// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/types.h"

#include <fmt/format.h>

#include "backend-glsl/literal.h"
#include "backend-glsl/writer/helper.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

namespace {

struct TypeParts {
  std::string base, dimensions;  // "vec4" and "[2][3]"
};

std::string Dimension(std::uint32_t count) {
  return count == 0 ? "[]" : Concat("[", std::to_string(count), "]");
}

TypeParts PartsOf(const Context& context, const Shape& shape) {
  const bool is_array = shape.kind == Shape::kRows;
  return {GlslName(is_array ? shape.Row() : shape, context.Has(Feature::kUnsigned)),
          is_array ? Dimension(shape.rows) : ""};
}

TypeParts PartsOf(Context& context, TypeId id);

// The struct float_array3 { float e[3]; } that stands for an array as an element of another.
std::string WrapperOf(Context& context, TypeId array) {
  const TypeParts parts = PartsOf(context, array);
  auto [found, is_new] = context.wrappers.try_emplace(parts.base + parts.dimensions);
  if (is_new) {
    const Type& type = context[array];
    const std::uint32_t count = type.kind == TypeKind::kArray ? type.count : type.rows;
    found->second = context.namer.Global(Concat(parts.base, "_array", std::to_string(count)));
    context.sections.structs += fmt::format("struct {} {{\n    {} e{};\n}};\n\n", found->second,
                                            parts.base, parts.dimensions);
  }
  return found->second;
}

void UseStruct(Context& context, StructId id) {
  if (context.used_structs[id.index]) return;
  context.used_structs[id.index] = true;
  std::string text = Concat("struct ", context.struct_names[id.index], " {\n");
  const auto* name = context.field_names[id.index].data();
  for (const Field& field : context.types[id].fields) {
    Append(text, "    ", Declaration(context, field.type, *name++), ";\n");
  }
  // GLSL has no struct without fields.
  if (context.types[id].fields.empty()) text += "    float empty;\n";
  Append(context.sections.structs, text, "};\n\n");
}

TypeParts PartsOf(Context& context, TypeId id) {
  const Type& type = context[id];
  if (type.IsNumeric()) {
    context.RequireType(type);
    return PartsOf(context, ShapeOf(type));
  }
  switch (type.kind) {
    case TypeKind::kArray: {
      const std::string count = Dimension(type.count);
      if (IsWrapped(context, type.element)) return {WrapperOf(context, type.element), count};
      TypeParts element = PartsOf(context, type.element);
      element.dimensions.insert(0, count);
      return element;
    }
    case TypeKind::kStruct:
      UseStruct(context, type.structure);
      return {context.struct_names[type.structure.index], ""};
    case TypeKind::kVoid: return {"void", ""};
    default: break;
  }
  CLIPC_CHECK(!"a type with a value");
  return {};
}

}  // namespace

std::string TypeName(Context& context, TypeId type) {
  TypeParts parts = PartsOf(context, type);
  parts.base += parts.dimensions;
  return std::move(parts.base);
}

std::string TypeName(const Context& context, const Shape& shape) {
  return GlslName(shape, context.Has(Feature::kUnsigned));
}

std::string Declaration(Context& context, TypeId type, std::string_view name) {
  const TypeParts parts = PartsOf(context, type);
  return Concat(parts.base, " ", name, parts.dimensions);
}

std::string Declaration(const Context& context, const Shape& shape, std::string_view name) {
  const TypeParts parts = PartsOf(context, shape);
  return Concat(parts.base, " ", name, parts.dimensions);
}

std::string Declarator(Context& context, TypeId type, std::string_view name) {
  return Concat(name, PartsOf(context, type).dimensions);
}

std::string_view PreciseText(Context& context, bool is_precise) {
  if (!is_precise || !context.Has(Feature::kPrecise)) return "";
  context.Require(Feature::kPrecise);
  return "precise ";
}

std::string ParameterTypes(Context& context, FunctionId function) {
  return ListOf(context[function].parameters,
                [&](VarId parameter) { return TypeName(context, context[parameter].type); });
}

std::string Dimensions(const Context& context, VarId var) {
  std::string dimensions;
  for (const Type* type = &context.TypeOf(var); type->kind == TypeKind::kArray;
       type = &context[type->element]) {
    dimensions += Dimension(type->count);
  }
  return dimensions;
}

bool IsWrapped(const Context& context, TypeId array_element) {
  if (context.Has(Feature::kArraysOfArrays)) return false;
  const Type& type = context[array_element];
  return type.kind == TypeKind::kArray || (type.IsNumeric() && ShapeOf(type).kind == Shape::kRows);
}

std::string ElementText(Context& context, TypeId element, Text text) {
  std::string value = Argument(std::move(text));
  if (!IsWrapped(context, element)) return value;
  return Called(WrapperOf(context, element), {value}).text;
}

std::string ZeroText(const Context& context, const Shape& shape) {
  const std::string zero = LiteralText(0, shape.scalar, context.target).text;
  if (shape.IsScalar()) return zero;
  const bool is_array = shape.kind == Shape::kRows;
  const auto row = [&](int) { return ZeroText(context, shape.Row()); };
  return Called(TypeName(context, shape), {is_array ? ListOf(int{shape.rows}, row) : zero}).text;
}

std::string ZeroText(Context& context, TypeId id) {
  const Type& type = context[id];
  if (type.IsNumeric()) return ZeroText(context, ShapeOf(type));
  const std::string name = TypeName(context, id);
  if (type.kind == TypeKind::kStruct) {
    const auto& fields = context.types.StructOf(id).fields;
    const std::string zeros =
        ListOf(fields, [&](const Field& field) { return ZeroText(context, field.type); });
    return Called(name, {fields.empty() ? "0.0" : zeros}).text;
  }
  CLIPC_CHECK(type.kind == TypeKind::kArray);
  const std::string zero = ElementText(context, type.element, {ZeroText(context, type.element)});
  const auto element = [&](const auto&) { return zero; };
  if (type.count < kLongArray) return Called(name, {ListOf(type.count, element)}).text;
  return Helper(context, "zeros_" + name, "",
                [&](const std::string& helper) {
                  return fmt::format("{} {}() {{\n{}}}\n", name, helper,
                                     FilledArray(context, id, element));
                }) +
         "()";
}

std::string FilledArray(Context& context, TypeId id,
                        const std::function<std::string(const std::string&)>& element) {
  const std::string array = Fresh(context, "result"), index = Fresh(context, "i");
  const std::string declaration = Declaration(context, id, array);
  return fmt::format(
      "    {0};\n    for (int {2} = 0; {2} < {3}; ++{2}) {1}[{2}] = {4};\n    return {1};\n",
      declaration, array, index, context[id].count, element(index));
}

}  // namespace clipc::glsl
