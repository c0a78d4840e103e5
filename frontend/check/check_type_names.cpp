// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/checker.h"

// The types that HLSL has built in, in all their spellings.
namespace clipc {
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
// Of these fxc takes any case.
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
// Known so that they can be declared.
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

// void, float, float3, float3x4, for every scalar type.
std::optional<ir::TypeId> Checker::NumericType(Name name) {
  ir::TypeId& known = numeric_types_[name.index];
  if (known) return known == program_.types.Error() ? std::nullopt : std::optional(known);
  known = program_.types.Error();
  const std::string_view text = Text(name);
  if (text == "void") return known = program_.types.Void();
  if (text == "string") return known = program_.types.String();
  if (std::ranges::find(kPackedNames, text) != std::end(kPackedNames)) {
    return known = program_.types.Make(ir::Scalar::kUint);
  }
  for (const ScalarName& scalar : kScalarNames) {
    if (!text.starts_with(scalar.text)) continue;
    const std::string_view size = text.substr(scalar.text.size());
    if (size.empty()) return known = program_.types.Make(scalar.kind);
    if (size.size() == 1 && IsSize(size[0]))
      return known = program_.types.Vector(scalar.kind, size[0] - '0');
    if (size.size() == 3 && IsSize(size[0]) && size[1] == 'x' && IsSize(size[2])) {
      return known = program_.types.Matrix(scalar.kind, size[0] - '0', size[2] - '0');
    }
  }
  return std::nullopt;
}

// A type as a template argument. Names arrive as expressions.
ir::TypeId Checker::TypeArgument(ast::ExprId id) {
  const ast::Expr& expr = file_.exprs[id];
  if (const auto* type = std::get_if<ast::TypeExpr>(&expr.node)) return ResolveType(type->type);
  if (const auto* name = std::get_if<ast::NameExpr>(&expr.node)) {
    ast::Type type;
    type.span = expr.span;
    type.name = name->name;
    type.arguments = name->arguments;
    type.has_arguments = !name->arguments.empty();
    return ResolveNamedType(type);
  }
  if (!std::holds_alternative<ast::ErrorExpr>(expr.node)) {
    diagnostics_.Report(expr.span, diag::UnknownType, TextOf(id), "");
  }
  return program_.types.Error();
}

// vector, vector<float, 3>, matrix, matrix<float, 3, 4>
std::optional<ir::TypeId> Checker::GenericNumericType(const ast::Type& type,
                                                      std::string_view text) {
  const bool is_vector = EqualIgnoringCase(text, "vector");
  if (!is_vector && !EqualIgnoringCase(text, "matrix")) return std::nullopt;
  ir::Scalar kind = ir::Scalar::kFloat;
  int sizes[2] = {4, 4};
  const std::uint32_t most = is_vector ? 2 : 3;
  if (type.arguments.size > most) {
    diagnostics_.Report(type.span, diag::TooManyTypeArguments, text, most);
    return program_.types.Error();
  }
  for (std::uint32_t i = 0; i < type.arguments.size; ++i) {
    const ast::ExprId argument = file_.expr_lists[type.arguments][i];
    if (i == 0) {
      const ir::TypeId component = TypeArgument(argument);
      if (component == program_.types.Error()) return component;
      if (program_.types[component].kind != ir::TypeKind::kScalar) {
        diagnostics_.Report(file_.exprs[argument].span, diag::ComponentNotScalar,
                            TypeName(component), text);
        return program_.types.Error();
      }
      kind = program_.types[component].scalar;
      continue;
    }
    const auto size = ConstantInteger(argument);
    if (!size) return program_.types.Error();
    if (*size < 1 || *size > 4) {
      diagnostics_.Report(file_.exprs[argument].span, diag::BadVectorSize, *size, text);
      return program_.types.Error();
    }
    sizes[i - 1] = static_cast<int>(*size);
  }
  return is_vector ? program_.types.Vector(kind, sizes[0])
                   : program_.types.Matrix(kind, sizes[0], sizes[1]);
}

std::optional<ir::TypeId> Checker::ObjectType(const ast::Type& type, std::string_view text) {
  const std::string lower = ToLower(text);
  // As a type of its own, where it is no global: a plain T.
  if (text == "ConstantBuffer" || text == "TextureBuffer") {
    if (type.arguments.size == 1) return TypeArgument(file_.expr_lists[type.arguments][0]);
    diagnostics_.Report(type.span, diag::MissingTypeArgument, text);
    return program_.types.Error();
  }
  for (const ObjectName& object : kObjectNames) {
    if (object.text != lower) continue;
    if (!object.has_element) return program_.types.Object(object.kind);
    ir::TypeId element = program_.types.Vector(ir::Scalar::kFloat, 4);
    if (!type.arguments.empty()) element = TypeArgument(file_.expr_lists[type.arguments][0]);
    if (element == program_.types.Error()) return element;
    return program_.types.Object(object.kind, element);
  }
  if (std::ranges::find(kOtherObjects, lower) != std::end(kOtherObjects)) {
    return program_.types.Object(ir::ObjectKind::kOther);
  }
  return std::nullopt;
}

}  // namespace clipc
