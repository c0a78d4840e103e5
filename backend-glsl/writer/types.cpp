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
  std::string_view base;   // "vec4", a text that lives as long as the context
  std::string dimensions;  // "[2][3]"
};

std::string Dimension(std::uint32_t count) {
  std::string text = "[";
  if (count != 0) AppendPart(text, count);
  text += ']';
  return text;
}

// The name of the struct with these fields in place of an array: `name`, or one like it.
std::string_view ArrayStruct(WriterContext& context, const std::string& key, std::string_view name,
                             std::string_view fields) {
  auto [found, is_new] = context.wrappers.try_emplace(key);
  if (is_new) {
    found->second = context.namer.Global(name);
    context.structs += fmt::format("struct {} {{\n    {};\n}};\n\n", found->second, fields);
  }
  return found->second;
}

// The struct vec4_array3 { vec4 e0, e1, e2; } in place of an array where arrays are not values.
std::string_view StructOfFields(WriterContext& context, std::string_view element,
                                std::uint32_t count) {
  const std::string fields =
      ListOf(count, [](std::uint32_t i) { return Concat("e", std::to_string(i)); });
  return ArrayStruct(context, Concat(element, Dimension(count)),
                     Concat(element, "_array", std::to_string(count)),
                     Concat(element, " ", fields));
}

TypeParts PartsOf(WriterContext& context, const Shape& shape) {
  const bool is_array = shape.kind == Shape::kRows;
  TypeParts parts{legalize::WordOf(is_array ? shape.Row() : shape, !context.needs.signed_integers),
                  ""};
  if (is_array && !context.Has(Feature::kArrayValues))
    parts.base = StructOfFields(context, parts.base, shape.rows);
  else if (is_array)
    parts.dimensions = Dimension(shape.rows);
  return parts;
}

TypeParts PartsOf(WriterContext& context, TypeId id);

// The struct float_array3 { float e[3]; } in place of an array that is an element of another.
std::string_view WrapperOf(WriterContext& context, TypeId array) {
  const TypeParts parts = PartsOf(context, array);
  const Type& type = context[array];
  const std::uint32_t count = type.kind == TypeKind::kArray ? type.count : type.rows;
  return ArrayStruct(context, Concat(parts.base, parts.dimensions),
                     Concat(parts.base, "_array", std::to_string(count)),
                     Concat(parts.base, " e", parts.dimensions));
}

bool MayBeRelaxed(const WriterContext& context) {
  return context.options.relaxed_precision && context.target.IsEs();
}

// Marks the structs that values of the type have in them.
void MarkStructs(const TypeTable& types, TypeId id, std::vector<bool>& marked) {
  const Type& type = types[types.Innermost(id)];
  if (type.kind == TypeKind::kObject && type.element) MarkStructs(types, type.element, marked);
  if (type.kind != TypeKind::kStruct || marked[type.structure.index]) return;
  marked[type.structure.index] = true;
  for (const Field& field : types[type.structure].fields) MarkStructs(types, field.type, marked);
}

// Whether values of the struct lie in a buffer, which another stage declares in the same words.
bool IsInBuffer(WriterContext& context, StructId id) {
  if (context.buffer_structs.empty()) {
    context.buffer_structs.resize(context.used_structs.size());
    const auto mark = [&](VarId var) {
      MarkStructs(context.types, context[var].type, context.buffer_structs);
    };
    for (const CbufferId cbuffer : context.program.cbuffers.ids())
      for (const CbufferMember& member : context[cbuffer].members) mark(member.var);
    for (const Resource& resource : context.program.resources) mark(resource.var);
  }
  return context.buffer_structs[id.index];
}

void UseStruct(WriterContext& context, StructId id) {
  if (context.used_structs[id.index]) return;
  context.used_structs[id.index] = true;
  std::string text = Concat("struct ", context.names.structs[id.index], " {\n");
  const auto* name = context.FieldsOf(id).data();
  for (const Field& field : context.types[id].fields) {
    const bool is_relaxed = !PrecisionText(context, field.type).empty() && !IsInBuffer(context, id);
    Append(text, "    ", is_relaxed ? PrecisionText(context, field.type) : "",
           Declaration(context, field.type, *name++), ";\n");
  }
  // GLSL has no struct without fields.
  if (context.types[id].fields.empty()) text += "    float empty;\n";
  Append(context.structs, text, "};\n\n");
}

TypeParts PartsOf(WriterContext& context, TypeId id) {
  const Type& type = context[id];
  if (type.IsNumeric()) {
    context.RequireType(type);
    return PartsOf(context, ShapeOf(type, context.needs));
  }
  switch (type.kind) {
    case TypeKind::kArray: {
      if (!context.Has(Feature::kArrayValues))
        return {StructOfFields(context, PartsOf(context, type.element).base, type.count), ""};
      const std::string count = Dimension(type.count);
      if (IsWrapped(context, type.element)) return {WrapperOf(context, type.element), count};
      TypeParts element = PartsOf(context, type.element);
      element.dimensions.insert(0, count);
      return element;
    }
    case TypeKind::kStruct:
      UseStruct(context, type.structure);
      return {context.names.structs[type.structure.index], ""};
    case TypeKind::kVoid: return {"void", ""};
    default: break;
  }
  CLIPC_CHECK(!"a type with a value");
  return {};
}

}  // namespace

std::string_view PrecisionText(const WriterContext& context, TypeId id) {
  if (!MayBeRelaxed(context) || !context.types.HasMinPrecision(id)) return "";
  // A struct has no precision, and takes the place of some arrays.
  const Type& type = context[id];
  const bool is_struct = HasFields(context, type) ||
                         (type.kind == TypeKind::kArray && IsWrapped(context, type.element));
  return is_struct ? "" : "mediump ";
}

std::string_view PrecisionText(const WriterContext& context, const IoVar& io) {
  return MayBeRelaxed(context) && io.has_min_precision ? "mediump " : "";
}

std::string TypeName(WriterContext& context, TypeId type) {
  const TypeParts parts = PartsOf(context, type);
  return Concat(parts.base, parts.dimensions);
}

std::string TypeName(WriterContext& context, const Shape& shape) {
  const TypeParts parts = PartsOf(context, shape);
  return Concat(parts.base, parts.dimensions);
}

std::string Declaration(WriterContext& context, TypeId type, std::string_view name) {
  const TypeParts parts = PartsOf(context, type);
  return Concat(parts.base, " ", name, parts.dimensions);
}

std::string Declaration(WriterContext& context, const Shape& shape, std::string_view name) {
  const TypeParts parts = PartsOf(context, shape);
  return Concat(parts.base, " ", name, parts.dimensions);
}

void AppendDeclaration(WriterContext& context, std::string& text, TypeId type,
                       std::string_view name) {
  const TypeParts parts = PartsOf(context, type);
  Append(text, parts.base, " ", name, parts.dimensions);
}

void AppendDeclaration(WriterContext& context, std::string& text, const Shape& shape,
                       std::string_view name) {
  const TypeParts parts = PartsOf(context, shape);
  Append(text, parts.base, " ", name, parts.dimensions);
}

std::string UniformDeclaration(WriterContext& context, TypeId id, std::string_view name) {
  const Type& type = context[id];
  if (type.kind != TypeKind::kArray || context.Has(Feature::kArrayValues))
    return Declaration(context, id, name);
  return Declaration(context, type.element, name) + Dimension(type.count);
}

std::string Declarator(WriterContext& context, TypeId type, std::string_view name) {
  return Concat(name, PartsOf(context, type).dimensions);
}

std::string_view PreciseText(WriterContext& context, bool is_precise) {
  if (!is_precise || !context.Has(Feature::kPrecise)) return "";
  context.Require(Feature::kPrecise);
  return "precise ";
}

std::string ParameterTypes(WriterContext& context, FunctionId function) {
  return ListOf(context[function].parameters,
                [&](VarId parameter) { return TypeName(context, context[parameter].type); });
}

std::string Dimensions(const WriterContext& context, VarId var) {
  std::string dimensions;
  for (const Type* type = &context.TypeOf(var); type->kind == TypeKind::kArray;
       type = &context[type->element]) {
    dimensions += Dimension(type->count);
  }
  return dimensions;
}

bool HasFields(const WriterContext& context, const Type& type) {
  if (context.Has(Feature::kArrayValues)) return false;
  return type.kind == TypeKind::kArray ||
         (type.IsNumeric() && ShapeOf(type, context.needs).kind == Shape::kRows);
}

std::string RowOf(const WriterContext& context, const Shape& matrix, std::string_view text,
                  int row) {
  const bool has_fields = matrix.kind == Shape::kRows && !context.Has(Feature::kArrayValues);
  return Concat(text, has_fields ? ".e" : "[", std::to_string(row), has_fields ? "" : "]");
}

bool IsWrapped(const WriterContext& context, TypeId array_element) {
  if (context.Has(Feature::kArraysOfArrays) || !context.Has(Feature::kArrayValues)) return false;
  const Type& type = context[array_element];
  return type.kind == TypeKind::kArray ||
         (type.IsNumeric() && ShapeOf(type, context.needs).kind == Shape::kRows);
}

std::string ElementText(WriterContext& context, TypeId element, Text text) {
  std::string value = std::move(text).At(Binding::kAssignment);
  if (!IsWrapped(context, element)) return value;
  return Called(WrapperOf(context, element), {value}).text;
}

std::string ZeroText(WriterContext& context, const Shape& shape) {
  const std::string zero = LiteralText(0, shape.scalar, context.target).text;
  if (shape.IsScalar()) return zero;
  const bool is_array = shape.kind == Shape::kRows;
  const auto row = [&](int) { return ZeroText(context, shape.Row()); };
  return Called(TypeName(context, shape), {is_array ? ListOf(int{shape.rows}, row) : zero}).text;
}

std::string ZeroText(WriterContext& context, TypeId id) {
  const Type& type = context[id];
  if (type.IsNumeric()) return ZeroText(context, ShapeOf(type, context.needs));
  const std::string name = TypeName(context, id);
  if (type.kind == TypeKind::kStruct) {
    const auto& fields = context.types.StructOf(id).fields;
    const std::string zeros =
        ListOf(fields, [&](const Field& field) { return ZeroText(context, field.type); });
    return Called(name, {fields.empty() ? "0.0" : zeros}).text;
  }
  CLIPC_CHECK(type.kind == TypeKind::kArray);
  const std::string zero = ElementText(context, type.element, {ZeroText(context, type.element)});
  const auto all = [&] {
    return Called(name, {ListOf(type.count, [&](std::uint32_t) { return zero; })}).text;
  };
  if (type.count < kLongArray) return all();
  const auto define = [&](const std::string& helper) {
    if (!context.Has(Feature::kArrayValues))
      return fmt::format("{} {}() {{\n    return {};\n}}\n", name, helper, all());
    const std::string array = Fresh(context, "result"), index = Fresh(context, "i");
    return fmt::format(
        "{0} {1}() {{\n    {2};\n    for (int {4} = 0; {4} < {5}; ++{4}) {3}[{4}] = {6};\n"
        "    return {3};\n}}\n",
        name, helper, Declaration(context, id, array), array, index, type.count, zero);
  };
  return Helper(context, "zeros_" + name, "", define) + "()";
}

}  // namespace clipc::glsl
