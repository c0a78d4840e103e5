// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/type_names.h"

#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/text.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

struct ScalarName {
  std::string_view text;
  ir::Scalar kind;
};

constexpr ScalarName kScalarNames[] = {
    {"float", ir::Scalar::kFloat},
    {"int", ir::Scalar::kInt},
    {"uint", ir::Scalar::kUint},
    {"half", ir::Scalar::kHalf},
    {"bool", ir::Scalar::kBool},
    {"double", ir::Scalar::kDouble},
    {"min16float", ir::Scalar::kMin16Float},
    {"min10float", ir::Scalar::kMin10Float},
    {"min16int", ir::Scalar::kMin16Int},
    {"min12int", ir::Scalar::kMin12Int},
    {"min16uint", ir::Scalar::kMin16Uint},
    {"int16_t", ir::Scalar::kMin16Int},
    {"uint16_t", ir::Scalar::kMin16Uint},
    {"float16_t", ir::Scalar::kHalf},
    {"int32_t", ir::Scalar::kInt},
    {"uint32_t", ir::Scalar::kUint},
    {"float32_t", ir::Scalar::kFloat},
    {"int64_t", ir::Scalar::kInt64},
    {"uint64_t", ir::Scalar::kUint64},
    {"float64_t", ir::Scalar::kDouble},
};

constexpr std::string_view kPackedNames[] = {"int8_t4_packed", "uint8_t4_packed"};

struct ObjectName {
  std::string_view text;  // in lower case
  ir::ObjectKind kind;
  bool has_element = false;
};

// Object types; fxc accepts their names in upper and lower case.
constexpr ObjectName kObjectNames[] = {
    {"texture1d", ir::ObjectKind::kTexture1D, true},
    {"texture1darray", ir::ObjectKind::kTexture1DArray, true},
    {"texture2d", ir::ObjectKind::kTexture2D, true},
    {"texture2darray", ir::ObjectKind::kTexture2DArray, true},
    {"texture2dms", ir::ObjectKind::kTexture2DMS, true},
    {"texture2dmsarray", ir::ObjectKind::kTexture2DMSArray, true},
    {"texture3d", ir::ObjectKind::kTexture3D, true},
    {"texturecube", ir::ObjectKind::kTextureCube, true},
    {"texturecubearray", ir::ObjectKind::kTextureCubeArray, true},
    {"sampler", ir::ObjectKind::kSampler},
    {"samplerstate", ir::ObjectKind::kSampler},
    {"samplercomparisonstate", ir::ObjectKind::kSamplerComparison},
    {"sampler1d", ir::ObjectKind::kSampler1D},
    {"sampler2d", ir::ObjectKind::kSampler2D},
    {"sampler3d", ir::ObjectKind::kSampler3D},
    {"samplercube", ir::ObjectKind::kSamplerCube},
    {"buffer", ir::ObjectKind::kBuffer, true},
    {"structuredbuffer", ir::ObjectKind::kStructuredBuffer, true},
    {"byteaddressbuffer", ir::ObjectKind::kByteAddressBuffer},
    {"rwbuffer", ir::ObjectKind::kRWBuffer, true},
    {"rwstructuredbuffer", ir::ObjectKind::kRWStructuredBuffer, true},
    {"rwbyteaddressbuffer", ir::ObjectKind::kRWByteAddressBuffer},
    {"rwtexture1d", ir::ObjectKind::kRWTexture1D, true},
    {"rwtexture1darray", ir::ObjectKind::kRWTexture1DArray, true},
    {"rwtexture2d", ir::ObjectKind::kRWTexture2D, true},
    {"rwtexture2darray", ir::ObjectKind::kRWTexture2DArray, true},
    {"rwtexture3d", ir::ObjectKind::kRWTexture3D, true},
};

// Object types that can be declared but not used.
constexpr std::string_view kOtherObjects[] = {
    "texture",
    "rwtexture2dms",
    "rwtexture2dmsarray",
    "rasterizerorderedbuffer",
    "rasterizerorderedbyteaddressbuffer",
    "rasterizerorderedstructuredbuffer",
    "rasterizerorderedtexture1d",
    "rasterizerorderedtexture1darray",
    "rasterizerorderedtexture2d",
    "rasterizerorderedtexture2darray",
    "rasterizerorderedtexture3d",
    "feedbacktexture2d",
    "feedbacktexture2darray",
    "appendstructuredbuffer",
    "consumestructuredbuffer",
    "pointstream",
    "linestream",
    "trianglestream",
    "inputpatch",
    "outputpatch",
    "rayquery",
    "raytracingaccelerationstructure",
    "subpassinput",
    "subpassinputms",
    "blendstate",
    "depthstencilstate",
    "rasterizerstate",
    "rendertargetview",
    "depthstencilview",
    "stateblock",
    "vertexshader",
    "pixelshader",
    "geometryshader",
    "hullshader",
    "domainshader",
    "computeshader",
    "vertexfragment",
    "pixelfragment",
};

bool IsSize(char c) { return c >= '1' && c <= '4'; }

}  // namespace

std::optional<ir::TypeId> NumericType(Context& context, Name name) {
  ir::TypeId& known = context.numeric_types[name.index];
  if (known) return context.IsError(known) ? std::nullopt : std::optional(known);
  known = context.types.Error();
  const std::string_view text = context[name];
  if (text == "void") return known = context.types.Void();
  if (text == "string") return known = context.types.String();
  if (std::ranges::find(kPackedNames, text) != std::end(kPackedNames)) {
    return known = context.types.Make(ir::Scalar::kUint);
  }
  for (const ScalarName& scalar : kScalarNames) {
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

ir::TypeId TypeArgument(Context& context, ast::ExprId id) {
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
  if (!std::holds_alternative<ast::ErrorExpr>(expr.node)) {
    context.Report(expr.span, diag::UnknownType, TextOf(context, id), "");
  }
  return context.types.Error();
}

std::optional<ir::TypeId> GenericNumericType(Context& context, const ast::Type& type,
                                             std::string_view text) {
  const bool is_vector = EqualIgnoringCase(text, "vector");
  if (!is_vector && !EqualIgnoringCase(text, "matrix")) return std::nullopt;
  ir::Scalar kind = ir::Scalar::kFloat;
  int sizes[2] = {4, 4};
  const std::uint32_t most = is_vector ? 2 : 3;
  if (type.arguments.size > most) {
    context.Report(type.span, diag::TooManyTypeArguments, text, most);
    return context.types.Error();
  }
  for (std::uint32_t i = 0; i < type.arguments.size; ++i) {
    const ast::ExprId argument = context[type.arguments][i];
    if (i == 0) {
      const ir::TypeId component = TypeArgument(context, argument);
      if (context.IsError(component)) return component;
      if (context[component].kind != ir::TypeKind::kScalar) {
        context.Report(context[argument].span, diag::ComponentNotScalar,
                       context.TypeName(component), text);
        return context.types.Error();
      }
      kind = context[component].scalar;
      continue;
    }
    const auto size = ConstantInteger(context, argument);
    if (!size) return context.types.Error();
    if (*size < 1 || *size > 4) {
      context.Report(context[argument].span, diag::BadVectorSize, *size, text);
      return context.types.Error();
    }
    sizes[i - 1] = static_cast<int>(*size);
  }
  return is_vector ? context.types.Vector(kind, sizes[0])
                   : context.types.Matrix(kind, sizes[0], sizes[1]);
}

std::optional<ir::TypeId> ObjectType(Context& context, const ast::Type& type,
                                     std::string_view text) {
  const std::string lower = ToLower(text);
  // Where the declaration is not a global, the type is a plain T.
  if (text == "ConstantBuffer" || text == "TextureBuffer") {
    if (type.arguments.size == 1) return TypeArgument(context, context[type.arguments][0]);
    context.Report(type.span, diag::MissingTypeArgument, text);
    return context.types.Error();
  }
  for (const ObjectName& object : kObjectNames) {
    if (object.text != lower) continue;
    if (!object.has_element) return context.types.Object(object.kind);
    ir::TypeId element = context.types.Vector(ir::Scalar::kFloat, 4);
    if (!type.arguments.empty()) element = TypeArgument(context, context[type.arguments][0]);
    if (context.IsError(element)) return element;
    return context.types.Object(object.kind, element);
  }
  if (std::ranges::find(kOtherObjects, lower) != std::end(kOtherObjects)) {
    return context.types.Object(ir::ObjectKind::kOther);
  }
  return std::nullopt;
}

}  // namespace clipc::check
