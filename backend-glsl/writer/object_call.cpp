// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/object_call.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "backend-glsl/literal.h"
#include "backend-glsl/requirements.h"
#include "backend-glsl/writer/buffer_call.h"
#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/objects.h"
#include "backend-glsl/writer/types.h"
#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The index as an int, as an argument of a call.
std::string IntIndex(Code& code, ExprId index) {
  const bool is_int = code.TypeOf(index).scalar == Scalar::kInt || code.As<Literal>(index);
  const std::string value =
      code.As<Literal>(index) ? IndexValue(code, index) : Argument(code, index);
  return is_int ? value : Concat("int(", value, ")");
}

// The writer of one call of an object's function.
class ObjectCaller {
 public:
  ObjectCaller(Code& code, TypeId type, const ObjectCall& node)
      : code_(code),
        type_(type),
        node_(node),
        path_(code.Operand(node, OperandKind::kObject)),
        object_(RootOf(code.program, path_)),
        kind_(ObjectTypeOf(code, object_).object) {}

  Text Write() {
    switch (node_.op) {
      case ObjectOp::kSampleLevel:
      case ObjectOp::kSampleGrad:
      case ObjectOp::kSample:
      case ObjectOp::kSampleBias:
      case ObjectOp::kD3d9SampleLevel:
      case ObjectOp::kD3d9Sample:
      case ObjectOp::kD3d9SampleBias:
      case ObjectOp::kD3d9SampleGrad:
      case ObjectOp::kD3d9SampleProjected: return Sample();
      case ObjectOp::kSampleCmp:
      case ObjectOp::kSampleCmpLevelZero:
      case ObjectOp::kSampleCmpLevel:
      case ObjectOp::kSampleCmpBias:
      case ObjectOp::kSampleCmpGrad: return Compare();
      case ObjectOp::kLevelOfDetail: return LevelOfDetail(".x");
      case ObjectOp::kLevelOfDetailUnclamped: return LevelOfDetail(".y");
      case ObjectOp::kGather:
      case ObjectOp::kGatherGreen:
      case ObjectOp::kGatherBlue:
      case ObjectOp::kGatherAlpha:
      case ObjectOp::kGatherCmp: return Gather();
      case ObjectOp::kTextureLoad: return Texel();
      case ObjectOp::kBufferLoad:
        if (IsImage(kind_)) return Plain("imageLoad");
        RequireSamplerless();
        return Plain("texelFetch");
      case ObjectOp::kStructuredLoad: return StructuredLoad(code_, node_);
      case ObjectOp::kSubpassLoad: return SubpassLoad();
      case ObjectOp::kImageLoad: return Plain("imageLoad");
      case ObjectOp::kStore: return IsImage(kind_) ? ImageStore() : BufferStore(code_, node_);
      case ObjectOp::kAtomicAdd: return Atomic("Add");
      case ObjectOp::kAtomicAnd: return Atomic("And");
      case ObjectOp::kAtomicOr: return Atomic("Or");
      case ObjectOp::kAtomicXor: return Atomic("Xor");
      case ObjectOp::kAtomicMin: return Atomic("Min");
      case ObjectOp::kAtomicMax: return Atomic("Max");
      case ObjectOp::kAtomicExchange: return Atomic("Exchange");
      case ObjectOp::kAtomicCompareExchange: return Atomic("CompSwap");
      case ObjectOp::kByteLoad:          // LowerByteBuffers replaced it
      case ObjectOp::kIncrementCounter:  // MakeCounters replaced them
      case ObjectOp::kDecrementCounter:
      case ObjectOp::kAppend:  // LowerStreams replaced them
      case ObjectOp::kRestartStrip: break;
      case ObjectOp::kTextureSize:
      case ObjectOp::kTextureLevels:
      case ObjectOp::kTextureSamples:
      case ObjectOp::kBufferSize: return Query();
    }
    return {};
  }

 private:
  ExprId At(OperandKind kind) const { return code_.Operand(node_, kind); }
  bool Has(OperandKind kind) const { return !OperandsOf(node_, kind).empty(); }
  std::string ArgumentAt(OperandKind kind) { return Argument(code_, At(kind)); }
  // ", operand" for each operand of that kind.
  void Add(std::string& text, OperandKind kind) {
    for (const ExprId operand : code_[OperandsOf(node_, kind)])
      Append(text, ", ", Argument(code_, operand));
  }
  std::string More(OperandKind kind) {
    std::string text;
    Add(text, kind);
    return text;
  }
  // The texture, and the sampler that goes with it if there is one.
  std::string Object() { return ObjectName(code_, path_, At(OperandKind::kSampler)); }

  // The call function(object, operands, more). GLSL reads four components, whatever the texture's
  // element type is.
  Text Plain(std::string_view function, std::string_view more = "") {
    std::string text = Concat(TiledName(function), "(", Object());
    for (const OperandSlot& slot : InfoOf(node_.op).Slots()) {
      if (slot.kind > OperandKind::kSampler) Add(text, slot.kind);
    }
    Append(text, TiledArguments(), more, ")");
    return Narrow(std::move(text));
  }

  // GLSL's function with the clamp of a sample, or with a status as its result, instead of
  // `function`; the function itself where the call has neither.
  std::string TiledName(std::string_view function) {
    std::string name(function);
    if (node_.has_clamp) {
      code_.Require(Feature::kLevelClamps);
      name += "Clamp";
    }
    if (node_.has_texel) {
      code_.Require(Feature::kTextureStatus);
      name[0] = static_cast<char>(name[0] - 'a' + 'A');
      name = "sparse" + name;
    }
    return node_.has_clamp || node_.has_texel ? name + "ARB" : name;
  }
  // The arguments of such a function that come after the offset and before a bias or a component.
  std::string TiledArguments() {
    std::string text;
    Add(text, OperandKind::kClamp);
    Add(text, OperandKind::kTexel);
    return text;
  }

  // The status that a call gives, if it has one, as HLSL's uint.
  Text Status(std::string call) {
    return node_.has_texel ? Called("uint", {call}) : Text{std::move(call)};
  }

  Text Narrow(std::string four) {
    if (node_.has_texel) return Status(std::move(four));
    // A modern comparison is a float.
    if (InfoOf(kind_).compares && code_.Has(Feature::kTextureFunctions)) return {std::move(four)};
    const std::size_t count = ShapeOf(code_[type_], code_.needs).size;
    if (count < 4) Append(four, ".", std::string_view("xyzw").substr(0, count));
    return {std::move(four)};
  }

  Text Sample() {
    const bool is_modern = code_.Has(Feature::kTextureFunctions);
    const bool has_level = Has(OperandKind::kLevel), has_gradient = Has(OperandKind::kDdx);
    const bool has_offset = Has(OperandKind::kOffset);
    const std::string_view stem = InfoOf(kind_).compares ? "shadow" : "texture";
    std::string function = is_modern ? "texture" : TextureType(code_, object_, stem);
    const bool has_neighbours = InfoOf(code_.program.stage).has_neighbours;
    const bool is_level_zero = node_.op == ObjectOp::kD3d9Sample && !has_neighbours && is_modern;
    Append(function,
           is_level_zero || has_level                   ? "Lod"
           : has_gradient                               ? "Grad"
           : node_.op == ObjectOp::kD3d9SampleProjected ? "Proj"
                                                        : "",
           has_offset ? "Offset" : "");
    if (!is_modern) function += OldSuffix(has_level || has_gradient, has_gradient);
    // GLSL has the bias after all other arguments.
    if (node_.op == ObjectOp::kSampleBias) {
      return Narrow(Concat(TiledName(function), "(", Object(), More(OperandKind::kCoordinate),
                           More(OperandKind::kOffset), TiledArguments(), More(OperandKind::kBias),
                           ")"));
    }
    return Plain(function, is_level_zero ? ", 0.0" : "");
  }

  // Names the extension that an older target's function with an explicit level needs. Returns the
  // end of the function's name. Vertex shaders of GLSL 1.20 have texture2DLod (8.7); glslang wants
  // the extension as well.
  std::string_view OldSuffix(bool is_explicit, bool is_gradient) {
    const bool is_es = code_.target.IsEs();
    if (!InfoOf(code_.program.stage).draws_pixels) {
      if (!is_es) code_.enabled.emplace("GL_ARB_shader_texture_lod");
      return "";
    }
    if (!is_explicit) return "";
    code_.Require(Feature::kExplicitLevels);
    return is_es ? "EXT" : is_gradient ? "ARB" : "";
  }

  // Compares by SPIR-V's own instruction where GLSL has no function for it, as glslang 12 does not
  // know GL_EXT_texture_shadow_lod. A bias, a level, gradients and an offset are bits of its
  // operands.
  Text CompareBySpirv() {
    constexpr int kImplicitLod = 89, kExplicitLod = 90;  // OpImageSampleDrefImplicitLod, ..
    constexpr int kBias = 1, kLod = 2, kGrad = 4, kConstOffset = 8;
    code_.Require("GL_EXT_spirv_intrinsics");
    const bool has_bias = Has(OperandKind::kBias);
    const bool is_zero = node_.op == ObjectOp::kSampleCmpLevelZero;
    const int operands = (has_bias                 ? kBias
                          : Has(OperandKind::kDdx) ? kGrad
                                                   : kLod) |
                         (Has(OperandKind::kOffset) ? kConstOffset : 0);
    std::string types = Concat(TextureType(code_, object_, "sampler"), "Shadow sampled, ");
    Append(types, TypeName(code_, code_.ShapeAt(At(OperandKind::kCoordinate))),
           " place, float reference, spirv_literal int operands");
    std::string values = fmt::format("{}{}{}, {}", Object(), More(OperandKind::kCoordinate),
                                     More(OperandKind::kReference), operands);
    const auto add = [&](std::string_view type, std::string_view name, const std::string& value) {
      Append(types, ", ", type, " ", name);
      Append(values, ", ", value);
    };
    if (is_zero) add("float", "level", "0.0");
    constexpr std::pair<OperandKind, std::string_view> kRest[] = {{OperandKind::kLevel, "level"},
                                                                  {OperandKind::kBias, "level"},
                                                                  {OperandKind::kDdx, "d1"},
                                                                  {OperandKind::kDdy, "d2"},
                                                                  {OperandKind::kOffset, "offset"}};
    for (const auto& [kind, name] : kRest) {
      if (Has(kind)) add(TypeName(code_, code_.ShapeAt(At(kind))), name, ArgumentAt(kind));
    }
    const std::string name = has_bias ? "sample_compare_bias" : "sample_compare_level";
    const std::string function = Helper(code_, name, types, [&](const std::string& named) {
      return fmt::format("spirv_instruction(id = {}) float {}({});\n",
                         has_bias ? kImplicitLod : kExplicitLod, named, types);
    });
    return {Concat(function, "(", values, ")")};
  }

  // Level zero is what texture() reads in a vertex shader; textureLod does not exist for arrays and
  // cubes, where gradients of zero ask for it.
  Text Compare() {
    if (!HasComparison(node_.op, kind_, InfoOf(code_.program.stage))) return CompareBySpirv();
    const std::string object = Object();
    const std::string coordinate = ArgumentAt(OperandKind::kCoordinate),
                      reference = ArgumentAt(OperandKind::kReference);
    if (kind_ == ObjectKind::kTextureCubeArray) {
      return Status(Concat(TiledName("texture"), "(", object, ", ", coordinate, ", ", reference,
                           TiledArguments(), ")"));
    }
    // A one-dimensional shadow lookup has an unused second component.
    const int components = code_.ShapeAt(At(OperandKind::kCoordinate)).size;
    const std::string place =
        components == 1 ? fmt::format("vec3({}, 0.0, {})", coordinate, reference)
                        : fmt::format("vec{}({}, {})", components + 1, coordinate, reference);
    const bool has_offset = Has(OperandKind::kOffset);
    const std::string_view end = has_offset ? "Offset" : "";
    const auto call = [&](std::string_view function, std::string_view level) {
      return Status(Concat(TiledName(Concat(function, end)), "(", object, ", ", place, level,
                           More(OperandKind::kOffset), TiledArguments(), More(OperandKind::kBias),
                           ")"));
    };
    switch (node_.op) {
      case ObjectOp::kSampleCmp:
      case ObjectOp::kSampleCmpBias: return call("texture", "");
      case ObjectOp::kSampleCmpLevel: return call("textureLod", More(OperandKind::kLevel));
      case ObjectOp::kSampleCmpGrad:
        return call("textureGrad", Concat(More(OperandKind::kDdx), More(OperandKind::kDdy)));
      default: break;
    }
    if (HasShadowLevels(kind_)) return call("textureLod", ", 0.0");
    if (!has_offset && !InfoOf(code_.program.stage).has_neighbours) return call("texture", "");
    return call("textureGrad",
                InfoOf(kind_).is_cube ? ", vec3(0.0), vec3(0.0)" : ", vec2(0.0), vec2(0.0)");
  }

  Text LevelOfDetail(std::string_view component) {
    Text query = Plain("textureQueryLod");
    query.text = Concat(query.text.substr(0, query.text.rfind(')') + 1), component);
    return query;
  }

  Text Gather() {
    const bool compares = node_.op == ObjectOp::kGatherCmp;
    const int component = ComponentOf(node_.op);
    const auto offsets = code_[OperandsOf(node_, OperandKind::kOffset)];
    const std::string last = component > 0 ? fmt::format(", {}", component) : "";
    code_.Require(compares || component > 0 ? Feature::kGatherComponents : Feature::kGather);
    if (HasVaryingOffset(code_.program, node_)) code_.Require(Feature::kGatherOffsets);
    if (offsets.size() != 4)
      return Plain(offsets.empty() ? "textureGather" : "textureGatherOffset", last);
    const std::string object = Object();
    const std::string place = Concat(More(OperandKind::kCoordinate), More(OperandKind::kReference));
    return FourGathers(Concat(object, place, ", "), offsets, last);
  }

  // Component i of Direct3D's result is component i of the gather with offset i: the four calls of
  // DXC's lowering (GenerateDxilGather of its HLOperationLower.cpp). GLSL's function with four
  // offsets reads the upper left texel at each, so the steps to the four texels are added to
  // constants. OpenGL promises offsets up to 31.
  Text FourGathers(const std::string& leading, std::span<const ExprId> offsets,
                   const std::string& last) {
    static constexpr std::int32_t kSteps[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    constexpr std::int32_t kMost = 31;
    std::vector<std::string> constants, calls;
    for (std::size_t i = 0; i < 4; ++i) {
      Append(calls.emplace_back(), "textureGatherOffset(", leading, Argument(code_, offsets[i]),
             last, ").", std::string_view("xyzw").substr(i, 1));
      const auto bits = ConstantBits(code_.program, offsets[i]);
      if (!bits || bits->size() != 2) continue;
      const std::int32_t x = IntOf((*bits)[0]) + kSteps[i][0], y = IntOf((*bits)[1]) + kSteps[i][1];
      if (std::max(x, y) > kMost) continue;
      constants.push_back(x == y ? fmt::format("ivec2({})", x)
                                 : fmt::format("ivec2({}, {})", x, y));
    }
    if (constants.size() == 4 && code_.Has(Feature::kGatherOffsets)) {
      code_.Require(Feature::kGatherOffsets);
      return {fmt::format("textureGatherOffsets({}ivec2[4]({}){})", leading,
                          fmt::join(constants, ", "), last)};
    }
    const std::string type = TypeName(code_, ShapeOf(code_[type_], code_.needs));
    return {fmt::format("{}({})", type, fmt::join(calls, ", "))};
  }

  Text Texel() {
    RequireSamplerless();
    return Plain(Has(OperandKind::kOffset) ? "texelFetchOffset" : "texelFetch");
  }

  // OpenGL has no subpasses: the host binds what was drawn as a texture. Its rows are counted as
  // gl_FragCoord is unless that is declared anew.
  Text SubpassLoad() {
    const std::string name = Object();
    const bool has_sample = Has(OperandKind::kSample);
    const std::string sample = More(OperandKind::kSample);
    if (code_.target.IsVulkan()) return Narrow(Concat("subpassLoad(", name, sample, ")"));
    const std::string place = code_.has_upper_left_origin
                                  ? Concat("ivec2(gl_FragCoord.x, float(textureSize(", name,
                                           has_sample ? ").y" : ", 0).y", ") - gl_FragCoord.y)")
                                  : "ivec2(gl_FragCoord.xy)";
    return Narrow(Concat("texelFetch(", name, ", ", place, has_sample ? sample : ", 0", ")"));
  }

  Text Query() {
    if (IsStructured(kind_)) return BufferSize(code_, path_);
    const std::string object = Object();
    if (IsImage(kind_)) return Called("imageSize", {object});
    RequireSamplerless();
    if (node_.op == ObjectOp::kTextureLevels) return Called("textureQueryLevels", {object});
    if (node_.op == ObjectOp::kTextureSamples) return Called("textureSamples", {object});
    const bool has_level = kind_ != ObjectKind::kBuffer && !InfoOf(kind_).is_multisampled;
    if (!has_level) return Called("textureSize", {object});
    return Called("textureSize", {object, IntIndex(code_, At(OperandKind::kLevel))});
  }

  // The call imageAtomicAdd(image, place, value) or atomicAdd(buffer[place], value).
  Text Atomic(std::string_view what) {
    const bool is_image = IsImage(kind_);
    if (is_image) code_.Require(Feature::kImageAtomics);
    std::string text = is_image
                           ? Concat("imageAtomic", what, "(", Object(), More(OperandKind::kPlace))
                           : Concat("atomic", what, "(", BufferWord(code_, node_));
    Add(text, OperandKind::kComparand);
    Add(text, OperandKind::kValue);
    return {text + ")"};
  }

  // An image is written four components at a time; those that its format lacks are dropped.
  Text ImageStore() {
    const std::string image = Object();
    std::string value = ArgumentAt(OperandKind::kValue);
    const Shape shape = code_.ShapeAt(At(OperandKind::kValue));
    if (shape.size < 4) {
      const std::string zero = LiteralText(0, shape.scalar, code_.target).text;
      for (int i = shape.size; i < 4; ++i) Append(value, ", ", zero);
      value = Called(TypeName(code_, ShapeOf(shape.scalar, 1, 4)), {value}).text;
    }
    return Called("imageStore", {image, ArgumentAt(OperandKind::kPlace), value});
  }

  // Requires the extension for calls without a sampler: Vulkan's textures have none of their own.
  void RequireSamplerless() {
    if (code_.target.IsVulkan()) code_.Require("GL_EXT_samplerless_texture_functions");
  }

  Code& code_;
  TypeId type_;
  const ObjectCall& node_;
  ExprId path_;  // to the object
  VarId object_;
  ObjectKind kind_;
};

}  // namespace

Text ObjectText(Code& code, TypeId type, const ObjectCall& node) {
  return ObjectCaller(code, type, node).Write();
}

std::string ObjectName(Code& code, ExprId object, ExprId sampler) {
  const VarId var = RootOf(code.program, object);
  const VarId sampler_var = sampler ? RootOf(code.program, sampler) : VarId{};
  const std::string indices = IndexPath(code, object);
  if (!code.target.IsVulkan() && !ir::IsWritable(ObjectTypeOf(code, var).object)) {
    return CombinedName(code, var, sampler_var) + indices;
  }
  const std::string name = code.NameOf(var) + indices;
  if (!sampler) return name;
  const std::string type = TextureType(code, var, "sampler");
  return Called(type + (IsShadow(code, sampler_var) ? "Shadow" : ""),
                {name, ObjectName(code, sampler)})
      .text;
}

}  // namespace clipc::glsl
