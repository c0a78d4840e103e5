// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/type_names.h"

#include <algorithm>
#include <iterator>

#include "base/spelling.h"
#include "frontend/check/text.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

template <typename Kind>
struct BuiltinName {
  std::string_view text;
  Kind kind;
};

constexpr BuiltinName<Scalar> kScalarNames[] = {
#define SCALAR(Enumerator, Spelling) {Spelling, Scalar::k##Enumerator},
#define SCALAR_ALIAS(Enumerator, Spelling) {Spelling, Scalar::k##Enumerator},
#include "base/builtin_types.def"
};

// The names of object types, which fxc accepts in upper and lower case.
constexpr BuiltinName<ObjectKind> kObjectNames[] = {
#define OBJECT(Enumerator, Spelling, ...) {Spelling, ObjectKind::k##Enumerator},
#define OBJECT_ALIAS(Enumerator, Spelling, ...) {Spelling, ObjectKind::k##Enumerator},
#define UNUSABLE(Spelling, ...) {Spelling, ObjectKind::kOther},
#define UNUSABLE_SHADER(Spelling) {Spelling, ObjectKind::kOther},
#include "base/builtin_types.def"
};

constexpr std::string_view kPatchNames[] = {
#define PATCH(Spelling) Spelling,
#include "base/builtin_types.def"
};

bool IsSize(char c) { return c >= '1' && c <= '4'; }

// float[2][3], whose last size is that of the innermost array.
TypeId ArrayArgument(Context& context, const ast::IndexExpr& array, Span span) {
  std::vector<ast::ExprId> sizes = {array.index};
  ast::ExprId element = array.base;
  while (const auto* outer = context.GetIf<ast::IndexExpr>(element)) {
    sizes.insert(sizes.begin(), outer->index);
    element = outer->base;
  }
  return ArrayOf(context, TypeArgument(context, element), sizes, span);
}

bool IsConstantBufferName(std::string_view text) {
  return text == "ConstantBuffer" || text == "TextureBuffer";
}

// The type argument of a ConstantBuffer or TextureBuffer, or the error type if it is not a struct,
// which is reported: fxc says "can only be a struct" even of a class, dxc takes both (DXC's
// cbuffer_struct.hlsl and cbufferArray.hlsl under HLSLFileCheck/hlsl/types/cbuffer).
TypeId ConstantBufferArgument(Context& context, const ast::Type& type, std::string_view text) {
  if (type.arguments.size != 1) return context.FailType(type.span, diag::MissingTypeArgument, text);
  const ast::ExprId argument = context[type.arguments][0];
  const TypeId contents = TypeArgument(context, argument);
  if (context.IsError(contents) || context[contents].kind == TypeKind::kStruct) return contents;
  return context.FailType(context[argument].span, diag::ConstantBufferType, text,
                          context.TypeName(contents));
}

// The type argument of a texture or buffer, or the error type if a value of it is not made of
// numbers, which is reported.
TypeId ElementArgument(Context& context, const ast::Type& type, std::string_view text) {
  if (type.arguments.empty()) return context.types.Vector(Scalar::kFloat, 4);
  const ast::ExprId argument = context[type.arguments][0];
  const TypeId element = TypeArgument(context, argument);
  const Span span = context[argument].span;
  if (element == context.types.Void())
    return context.FailType(span, diag::VoidValue, fmt::format("`{}` of `void`", text));
  if (!IsOrHoldsObject(context, element)) return element;
  return context.FailType(span, diag::ElementHoldsObject, text, context.TypeName(element));
}

}  // namespace

std::optional<TypeId> NumericType(Context& context, Name name) {
  TypeId& known = context.numeric_types[name.index];
  if (known) return context.IsError(known) ? std::nullopt : std::optional(known);
  known = context.types.Error();
  const std::string_view text = context[name];
  if (text == "void") return known = context.types.Void();
  if (text == "string") return known = context.types.String();
  for (const auto& scalar : kScalarNames) {
    if (!text.starts_with(scalar.text)) continue;
    const std::string_view size = text.substr(scalar.text.size());
    if (size.empty()) return known = context.types.Make(scalar.kind);
    if (size.size() == 1 && IsSize(size[0]))
      return known = context.types.Vector(scalar.kind, size[0] - '0');
    if (size.size() == 3 && IsSize(size[0]) && size[1] == 'x' && IsSize(size[2])) {
      return known = context.types.Matrix(scalar.kind, size[0] - '0', size[2] - '0');
    }
  }
  return std::nullopt;
}

std::vector<std::string> NearTypes(std::string_view text) {
  std::vector<std::string_view> scalars, objects;
  for (const auto& scalar : kScalarNames) scalars.push_back(scalar.text);
  for (const auto& object : kObjectNames) {
    if (object.kind != ObjectKind::kOther) objects.push_back(object.text);
  }
  const std::string_view stem = text.substr(0, text.find_last_not_of("1234x") + 1);
  std::vector<std::string> near;
  for (const std::string_view scalar : NearNames(stem, scalars))
    near.push_back(std::string(scalar) + std::string(text.substr(stem.size())));
  for (const std::string_view object : NearNames(text, objects)) near.emplace_back(object);
  return near;
}

TypeId TypeArgument(Context& context, ast::ExprId id) {
  const ast::Expr& expr = context[id];
  if (const auto* type = std::get_if<ast::TypeExpr>(&expr.node))
    return ResolveType(context, type->type);
  if (const auto* name = std::get_if<ast::NameExpr>(&expr.node)) {
    ast::Type type;
    type.span = expr.span;
    type.name = name->name;
    type.arguments = name->arguments;
    type.has_arguments = !name->arguments.empty();
    return ResolveNamedType(context, type);
  }
  if (const auto* array = std::get_if<ast::IndexExpr>(&expr.node))
    return ArrayArgument(context, *array, expr.span);
  if (!std::holds_alternative<ast::ErrorExpr>(expr.node)) {
    context.Report(expr.span, diag::UnknownType, TextOf(context, id), "");
  }
  return context.types.Error();
}

std::optional<TypeId> GenericNumericType(Context& context, const ast::Type& type,
                                         std::string_view text) {
  const bool is_vector = EqualIgnoringCase(text, "vector");
  if (!is_vector && !EqualIgnoringCase(text, "matrix")) return std::nullopt;
  Scalar kind = Scalar::kFloat;
  int sizes[2] = {4, 4};
  const std::uint32_t most = is_vector ? 2 : 3;
  if (type.arguments.size > most) {
    return context.FailType(type.span, diag::TooManyTypeArguments, text, most);
  }
  for (std::uint32_t i = 0; i < type.arguments.size; ++i) {
    const ast::ExprId argument = context[type.arguments][i];
    if (i == 0) {
      const TypeId component = TypeArgument(context, argument);
      if (context.IsError(component)) return component;
      if (context[component].kind != TypeKind::kScalar) {
        return context.FailType(context[argument].span, diag::ComponentNotScalar,
                                context.TypeName(component), text);
      }
      kind = context[component].scalar;
      continue;
    }
    const auto size = ConstantInteger(context, argument);
    if (!size) return context.types.Error();
    if (*size < 1 || *size > 4) {
      return context.FailType(context[argument].span, diag::BadVectorSize, *size, text);
    }
    sizes[i - 1] = static_cast<int>(*size);
  }
  return is_vector ? context.types.Vector(kind, sizes[0])
                   : context.types.Matrix(kind, sizes[0], sizes[1]);
}

bool IsPatchName(std::string_view text) {
  return std::ranges::find(kPatchNames, text) != std::end(kPatchNames);
}

std::optional<TypeId> ObjectType(Context& context, const ast::Type& type, std::string_view text) {
  // The type is a plain T if the declaration is not a global.
  if (IsConstantBufferName(text)) return ConstantBufferArgument(context, type, text);
  if (IsPatchName(text)) {
    if (type.arguments.size != 2)
      return context.FailType(type.span, diag::MissingTypeArgument, text);
    const auto arguments = context[type.arguments];
    return ArrayOf(context, TypeArgument(context, arguments[0]), arguments.subspan(1), type.span);
  }
  for (const auto& object : kObjectNames) {
    if (!EqualIgnoringCase(object.text, text)) continue;
    if (!HasElement(object.kind)) return context.types.Object(object.kind);
    if (IsStream(object.kind) && type.arguments.empty())
      return context.FailType(type.span, diag::MissingTypeArgument, text);
    const TypeId element = ElementArgument(context, type, text);
    if (context.IsError(element)) return element;
    const bool is_texel = context[element].IsScalarOrVector() && !IsWide(context[element].scalar);
    if (HasTexels(object.kind) && !is_texel) {
      context.Report(type.span, diag::TexelType, text, context.TypeName(element));
      return context.types.Error();
    }
    return context.types.Object(object.kind, element);
  }
  return std::nullopt;
}

bool IsWritableObjectName(std::string_view text) {
  return std::ranges::any_of(kObjectNames, [&](const auto& object) {
    return IsWritable(object.kind) && EqualIgnoringCase(object.text, text);
  });
}

bool MayMisfit(const Context& context, const ast::Type& type) {
  if (type.struct_definition || !type.name.name || !type.name.scopes.empty()) return false;
  return type.has_arguments || IsConstantBufferName(context[type.name.name]);
}

bool CheckTypeArgument(Context& context, const ast::Type& type) {
  if (context.names.FindUnqualified(type.name.name, true)) return true;
  const std::string_view text = context[type.name.name];
  if (IsConstantBufferName(text))
    return !context.IsError(ConstantBufferArgument(context, type, text));
  const auto* object = std::ranges::find_if(
      kObjectNames, [&](const auto& each) { return EqualIgnoringCase(each.text, text); });
  return object == std::end(kObjectNames) || !HasElement(object->kind) ||
         !context.IsError(ElementArgument(context, type, text));
}

}  // namespace clipc::check
