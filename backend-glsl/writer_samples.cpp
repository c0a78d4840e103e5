// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Reads through textures and buffers.
#include <variant>

#include "backend-glsl/writer.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

namespace {

bool IsOffsetOp(ObjectOp op) {
  return op != ObjectOp::kD3d9Sample && op != ObjectOp::kD3d9SampleLevel;
}

}  // namespace

Text Writer::ObjectText(const ir::Expr& expr, const ObjectCall& node) {
  NotConstant();
  const auto arguments = program_.expr_lists[node.arguments];
  switch (node.op) {
    case ObjectOp::kSampleLevel:
    case ObjectOp::kSampleGrad:
    case ObjectOp::kD3d9SampleLevel:
    case ObjectOp::kD3d9Sample: return SampleText(expr, node);
    case ObjectOp::kSampleCmpLevelZero: return CompareText(node);
    case ObjectOp::kGather:
    case ObjectOp::kGatherGreen:
    case ObjectOp::kGatherBlue:
    case ObjectOp::kGatherAlpha: return GatherText(expr, node);
    case ObjectOp::kTextureLoad: return TexelText(expr, node);
    case ObjectOp::kBufferLoad:
    case ObjectOp::kStructuredLoad:
    case ObjectOp::kByteLoad: return BufferText(expr, node);
    case ObjectOp::kImageLoad:
      return Narrow(
          "imageLoad(" + ObjectName(arguments[0], {}) + ", " + ArgumentOf(arguments[1]) + ")",
          program_.types[expr.type]);
    case ObjectOp::kStore: return StoreText(node);
    case ObjectOp::kTextureSize:
    case ObjectOp::kTextureLevels:
    case ObjectOp::kTextureSamples:
    case ObjectOp::kBufferSize: return QueryText(node);
  }
  return {};
}

// GLSL reads four components whatever the texture's element type is.
Text Writer::Narrow(std::string four, const Type& type) {
  const int count = ShapeOf(type).size;
  if (count < 4) four += "." + std::string("xyzw").substr(0, static_cast<std::size_t>(count));
  return {std::move(four)};
}

Text Writer::SampleText(const ir::Expr& expr, const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const bool separate = IsOffsetOp(node.op);
  const std::string object = ObjectName(arguments[0], separate ? arguments[1] : ExprId{});
  std::size_t next = separate ? 2 : 1;
  std::string text = object + ", " + ArgumentOf(arguments[next++]);

  std::string function = target_.Has(Feature::kTextureFunctions)
                             ? "texture"
                             : SamplerType(ObjectVar(arguments[0]), false);
  if (!target_.Has(Feature::kTextureFunctions))
    function.replace(0, 7, "texture");  // sampler2D: texture2D
  if (node.op == ObjectOp::kSampleGrad) {
    function += "Grad";
    text += ", " + ArgumentOf(arguments[next]);
    text += ", " + ArgumentOf(arguments[next + 1]);
    next += 2;
  } else if (node.op != ObjectOp::kD3d9Sample) {
    function += "Lod";
    text += ", " + ArgumentOf(arguments[next++]);
  } else if (target_.Has(Feature::kTextureFunctions)) {
    function += "Lod";
    text += ", 0.0";
  }
  if (next < arguments.size()) {
    function += "Offset";
    text += ", " + ArgumentOf(arguments[next]);
  }
  return Narrow(function + "(" + text + ")", program_.types[expr.type]);
}

// Level zero is what texture() reads in a vertex shader; textureLod does not exist for arrays and
// cubes.
Text Writer::CompareText(const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const ObjectKind kind = ObjectTypeOf(ObjectVar(arguments[0])).object;
  const std::string object = ObjectName(arguments[0], arguments[1]);
  const std::string coordinate = ArgumentOf(arguments[2]), reference = ArgumentOf(arguments[3]);
  if (kind == ObjectKind::kTextureCubeArray)
    return {"texture(" + object + ", " + coordinate + ", " + reference + ")"};
  const int components = ShapeAt(arguments[2]).size;
  // A one-dimensional shadow lookup has an unused second component.
  std::string where = components == 1
                          ? "vec3(" + coordinate + ", 0.0, "
                          : "vec" + std::to_string(components + 1) + "(" + coordinate + ", ";
  where += reference + ")";
  const bool has_lod = kind == ObjectKind::kTexture1D || kind == ObjectKind::kTexture2D ||
                       kind == ObjectKind::kTexture1DArray;
  const bool has_offset = arguments.size() > 4;
  std::string text = object + ", " + where + (has_lod ? ", 0.0" : "");
  if (has_offset && !has_lod) {
    return {"textureGradOffset(" + text + ", vec2(0.0), vec2(0.0), " + ArgumentOf(arguments[4]) +
            ")"};
  }
  if (has_offset) return {"textureLodOffset(" + text + ", " + ArgumentOf(arguments[4]) + ")"};
  return {(has_lod ? "textureLod(" : "texture(") + text + ")"};
}

Text Writer::GatherText(const ir::Expr& expr, const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const int component = static_cast<int>(node.op) - static_cast<int>(ObjectOp::kGather);
  std::string text = ObjectName(arguments[0], arguments[1]) + ", " + ArgumentOf(arguments[2]);
  const std::size_t offsets = arguments.size() - 3;
  if (offsets == 1) text += ", " + ArgumentOf(arguments[3]);
  if (offsets == 4) {
    Require(Feature::kGatherOffsets);
    text += ", ivec2[4](";
    for (std::size_t i = 0; i < 4; ++i) text += (i > 0 ? ", " : "") + ArgumentOf(arguments[3 + i]);
    text += ")";
  }
  if (component > 0) text += ", " + std::to_string(component);
  const char* function = offsets == 4   ? "textureGatherOffsets("
                         : offsets == 1 ? "textureGatherOffset("
                                        : "textureGather(";
  return Narrow(function + text + ")", program_.types[expr.type]);
}

Text Writer::TexelText(const ir::Expr& expr, const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  if (target_.IsVulkan()) Require("GL_EXT_samplerless_texture_functions");
  std::string text = ObjectName(arguments[0], {});
  text += ", " + ArgumentOf(arguments[1]);
  text += ", " + ArgumentOf(arguments[2]);
  const bool has_offset = arguments.size() > 3;
  if (has_offset) text += ", " + ArgumentOf(arguments[3]);
  return Narrow((has_offset ? "texelFetchOffset(" : "texelFetch(") + text + ")",
                program_.types[expr.type]);
}

Text Writer::QueryText(const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const VarId var = ObjectVar(arguments[0]);
  const Type& object_type = ObjectTypeOf(var);
  const ObjectKind kind = object_type.object;
  if (IsImage(kind)) return {"imageSize(" + ObjectName(arguments[0], {}) + ")"};
  if (IsByteAddress(kind)) return {var_names_[var.index] + ".length() * 4", Binding::kProduct};
  if (IsStructured(kind)) {
    const std::string length = var_names_[var.index] + ".length()";
    if (Std430(program_.types, object_type.element, program_.vars[var].row_major)) return {length};
    const std::uint32_t words =
        std::max(Structured(program_.types, object_type.element).size / 4, 1u);
    return words == 1 ? Text{length}
                      : Text{length + " / " + std::to_string(words), Binding::kProduct};
  }
  if (target_.IsVulkan()) Require("GL_EXT_samplerless_texture_functions");
  const std::string object = ObjectName(arguments[0], {});
  if (node.op == ObjectOp::kTextureLevels) return {"textureQueryLevels(" + object + ")"};
  if (node.op == ObjectOp::kTextureSamples) return {"textureSamples(" + object + ")"};
  const bool has_level = kind != ObjectKind::kBuffer && kind != ObjectKind::kTexture2DMS &&
                         kind != ObjectKind::kTexture2DMSArray;
  if (!has_level) return {"textureSize(" + object + ")"};
  const std::string level = IndexValue(arguments[1]);
  const bool is_literal = std::holds_alternative<Literal>(program_.exprs[arguments[1]].node);
  return {"textureSize(" + object + ", " + (is_literal ? level : "int(" + level + ")") + ")"};
}

Text Writer::BufferText(const ir::Expr& expr, const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const VarId var = ObjectVar(arguments[0]);
  if (node.op == ObjectOp::kByteLoad) return ByteLoadText(expr, node);
  if (node.op == ObjectOp::kBufferLoad) {
    if (IsImage(ObjectTypeOf(var).object)) {
      return Narrow(
          "imageLoad(" + ObjectName(arguments[0], {}) + ", " + ArgumentOf(arguments[1]) + ")",
          program_.types[expr.type]);
    }
    if (target_.IsVulkan()) Require("GL_EXT_samplerless_texture_functions");
    return Narrow(
        "texelFetch(" + ObjectName(arguments[0], {}) + ", " + ArgumentOf(arguments[1]) + ")",
        program_.types[expr.type]);
  }
  const std::string& name = var_names_[var.index];
  const TypeId element = ObjectTypeOf(var).element;
  const bool row_major = program_.vars[var].row_major;
  const std::string index = IndexValue(arguments[1]);
  if (Std430(program_.types, element, row_major)) return {name + "[" + index + "]"};
  // The elements lie tighter than std430 can say: they are put together from words.
  const std::string helper = Helper(name + "_at", "", [&](const std::string& function) {
    const std::uint32_t words = Structured(program_.types, element).size / 4;
    const std::string i = Fresh("i");
    const Address address{words == 1 ? i : std::to_string(words) + " * " + i, 0};
    return TypeName(element) + " " + function + "(int " + i + ") {\n    return " +
           Load({name, false, false}, element, row_major, address) + ";\n}\n";
  });
  const bool is_int = TypeOf(arguments[1]).scalar == Scalar::kInt ||
                      std::holds_alternative<Literal>(program_.exprs[arguments[1]].node);
  return {helper + "(" + (is_int ? index : "int(" + index + ")") + ")"};
}

// The place is an index, a coordinate or a byte address.
Text Writer::StoreText(const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const ObjectKind kind = ObjectTypeOf(ObjectVar(arguments[0])).object;
  const std::string name = ObjectName(arguments[0], {});
  const std::string value = ArgumentOf(arguments[2]);
  if (IsStructured(kind))
    return {name + "[" + IndexValue(arguments[1]) + "] = " + value, Binding::kAssignment};
  const Shape shape = ShapeAt(arguments[2]);
  if (IsImage(kind)) {
    // An image is written four components at a time; those that its format lacks are dropped.
    const std::string type = TypeName(ShapeOf(shape.scalar, 1, 4));
    const std::string zero = shape.IsFloating()              ? "0.0"
                             : shape.scalar == Scalar::kUint ? "0u"
                                                             : "0";
    std::string four = type + "(" + value;
    for (int i = shape.size; i < 4; ++i) four += ", " + zero;
    return {"imageStore(" + name + ", " + ArgumentOf(arguments[1]) + ", " +
            (shape.size == 4 ? value : four + ")") + ")"};
  }
  const std::string helper =
      Helper(name + "_store" + (shape.size > 1 ? std::to_string(shape.size) : ""), "",
             [&](const std::string& function) {
               const std::string address = Fresh("address"), stored = Fresh("value");
               std::string text = "void " + function + "(uint " + address + ", " + TypeName(shape) +
                                  " " + stored + ") {\n";
               for (int i = 0; i < shape.size; ++i) {
                 const std::string offset = i > 0 ? " + " + std::to_string(i) + "u" : "";
                 const std::string component = shape.size > 1 ? std::string(".") + "xyzw"[i] : "";
                 text += "    " + name + "[" + address + " / 4u" + offset + "] = " + stored +
                         component + ";\n";
               }
               return text + "}\n";
             });
  return {helper + "(" + ArgumentOf(arguments[1]) + ", " + value + ")"};
}

// Load, Load2, Load3, Load4 of a ByteAddressBuffer.
Text Writer::ByteLoadText(const ir::Expr& expr, const ObjectCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const std::string& name = var_names_[ObjectVar(arguments[0]).index];
  const Shape shape = ShapeOf(program_.types[expr.type]);
  const std::string helper =
      Helper(name + "_load" + (shape.size > 1 ? std::to_string(shape.size) : ""), "",
             [&](const std::string& function) {
               const std::string address = Fresh("address"), i = Fresh("i");
               std::string words = name + "[" + i + "]";
               for (int k = 1; k < shape.size; ++k)
                 words += ", " + name + "[" + i + " + " + std::to_string(k) + "u]";
               if (shape.size > 1) words = TypeName(shape) + "(" + words + ")";
               return TypeName(shape) + " " + function + "(uint " + address + ") {\n    uint " + i +
                      " = " + address + " / 4u;\n    return " + words + ";\n}\n";
             });
  return {helper + "(" + ArgumentOf(arguments[1]) + ")"};
}

}  // namespace clipc::glsl
