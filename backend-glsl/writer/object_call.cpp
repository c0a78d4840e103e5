// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/object_call.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "backend-glsl/literal.h"
#include "backend-glsl/needs.h"
#include "backend-glsl/writer/buffer_call.h"
#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/objects.h"
#include "backend-glsl/writer/types.h"
#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The writer of one call of an object's function.
class ObjectCaller {
 public:
  ObjectCaller(Code& code, TypeId type, const ObjectCall& node)
      : code_(code),
        type_(type),
        node_(node),
        arguments_(code[node.arguments]),
        object_(RootOf(code.program, arguments_[0])),
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
        if (IsImage(kind_)) return Rest("imageLoad", 1);
        RequireSamplerless();
        return Rest("texelFetch", 1);
      case ObjectOp::kStructuredLoad: return StructuredLoad(code_, node_);
      case ObjectOp::kByteLoad: return ByteLoad(code_, type_, node_);
      case ObjectOp::kSubpassLoad: return SubpassLoad();
      case ObjectOp::kImageLoad: return Rest("imageLoad", 1);
      case ObjectOp::kStore: return IsImage(kind_) ? ImageStore() : BufferStore(code_, node_);
      case ObjectOp::kAtomicAdd: return Atomic("Add");
      case ObjectOp::kAtomicAnd: return Atomic("And");
      case ObjectOp::kAtomicOr: return Atomic("Or");
      case ObjectOp::kAtomicXor: return Atomic("Xor");
      case ObjectOp::kAtomicMin: return Atomic("Min");
      case ObjectOp::kAtomicMax: return Atomic("Max");
      case ObjectOp::kAtomicExchange: return Atomic("Exchange");
      case ObjectOp::kAtomicCompareExchange: return Atomic("CompSwap");
      case ObjectOp::kIncrementCounter:
      case ObjectOp::kDecrementCounter: break;  // MakeCounters replaced them
      case ObjectOp::kTextureSize:
      case ObjectOp::kTextureLevels:
      case ObjectOp::kTextureSamples:
      case ObjectOp::kBufferSize: return Query();
    }
    return {};
  }

 private:
  std::string ArgumentAt(std::size_t i) { return Argument(code_, arguments_[i]); }

  // The call function(object, the arguments from `first` on and `more`). GLSL reads four
  // components, whatever the texture's element type is.
  Text Rest(std::string_view function, std::size_t first, ExprId sampler = {},
            std::string_view more = "") {
    std::string text = Concat(TiledName(function), "(", ObjectName(code_, arguments_[0], sampler));
    for (const ExprId argument : arguments_.subspan(first)) {
      Append(text, ", ", Argument(code_, argument));
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
    if (node_.has_clamp) Append(text, ", ", Argument(code_, ClampOf(code_.program, node_)));
    if (node_.has_texel) Append(text, ", ", Argument(code_, TexelOf(code_.program, node_)));
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
    const std::size_t count = ShapeOf(code_[type_], code_.target).size;
    if (count < 4) Append(four, ".", std::string_view("xyzw").substr(0, count));
    return {std::move(four)};
  }

  // The way in which a call samples: the parts of the GLSL function's name, and the number of
  // arguments between the coordinate and the offset.
  struct Way {
    std::string_view suffix;
    std::size_t more = 0;
  };
  Way WayOf() const {
    switch (node_.op) {
      case ObjectOp::kSampleLevel:
      case ObjectOp::kD3d9SampleLevel: return {"Lod", 1};
      case ObjectOp::kSampleGrad:
      case ObjectOp::kD3d9SampleGrad: return {"Grad", 2};
      case ObjectOp::kSampleBias:
      case ObjectOp::kD3d9SampleBias: return {"", 1};
      case ObjectOp::kD3d9SampleProjected: return {"Proj", 0};
      default: return {"", 0};
    }
  }

  Text Sample() {
    const bool is_d3d9 = !TakesSampler(node_.op);
    const Way way = WayOf();
    const bool is_modern = code_.Has(Feature::kTextureFunctions);
    const bool is_explicit = way.suffix == "Lod" || way.suffix == "Grad";
    const std::size_t first = is_d3d9 ? 1 : 2;
    const ExprId sampler = is_d3d9 ? ExprId{} : arguments_[1];
    const bool has_offset = arguments_.size() > first + 1 + way.more;
    const std::string_view stem = InfoOf(kind_).compares ? "shadow" : "texture";
    std::string function = is_modern ? "texture" : TextureType(code_, object_, stem);
    const bool has_neighbours = InfoOf(code_.program.stage).has_neighbours;
    const bool is_level_zero = node_.op == ObjectOp::kD3d9Sample && !has_neighbours && is_modern;
    Append(function, is_level_zero ? "Lod" : way.suffix, has_offset ? "Offset" : "");
    if (!is_modern) function += OldSuffix(is_explicit, way.suffix == "Grad");
    // GLSL has the bias after all other arguments.
    if (node_.op == ObjectOp::kSampleBias) {
      return Narrow(Concat(TiledName(function), "(", ObjectName(code_, arguments_[0], sampler),
                           ", ", ArgumentAt(2), has_offset ? ", " + ArgumentAt(4) : "",
                           TiledArguments(), ", ", ArgumentAt(3), ")"));
    }
    return Rest(function, first, sampler, is_level_zero ? ", 0.0" : "");
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

  // Level zero is what texture() reads in a vertex shader; textureLod does not exist for arrays and
  // cubes, where gradients of zero ask for it.
  Text Compare() {
    const std::string object = ObjectName(code_, arguments_[0], arguments_[1]);
    const std::string coordinate = ArgumentAt(2), reference = ArgumentAt(3);
    if (kind_ == ObjectKind::kTextureCubeArray) {
      return Status(Concat(TiledName("texture"), "(", object, ", ", coordinate, ", ", reference,
                           TiledArguments(), ")"));
    }
    // A one-dimensional shadow lookup has an unused second component.
    const int components = code_.ShapeAt(arguments_[2]).size;
    const std::string place =
        components == 1 ? fmt::format("vec3({}, 0.0, {})", coordinate, reference)
                        : fmt::format("vec{}({}, {})", components + 1, coordinate, reference);
    const std::size_t more = node_.op == ObjectOp::kSampleCmpGrad    ? 2
                             : node_.op == ObjectOp::kSampleCmpLevel ? 1
                             : node_.op == ObjectOp::kSampleCmpBias  ? 1
                                                                     : 0;
    const bool has_offset = arguments_.size() > 4 + more;
    const std::string offset = has_offset ? Concat(", ", ArgumentAt(4 + more)) : "";
    const std::string_view end = has_offset ? "Offset" : "";
    const auto call = [&](std::string_view function, std::string_view values,
                          std::string_view bias = "") {
      return Status(Concat(TiledName(Concat(function, end)), "(", object, ", ", place, values,
                           offset, TiledArguments(), bias, ")"));
    };
    switch (node_.op) {
      case ObjectOp::kSampleCmp: return call("texture", "");
      case ObjectOp::kSampleCmpLevel: return call("textureLod", Concat(", ", ArgumentAt(4)));
      case ObjectOp::kSampleCmpGrad:
        return call("textureGrad", Concat(", ", ArgumentAt(4), ", ", ArgumentAt(5)));
      case ObjectOp::kSampleCmpBias: return call("texture", "", Concat(", ", ArgumentAt(4)));
      default: break;
    }
    if (HasShadowLevels(kind_)) return call("textureLod", ", 0.0");
    if (!has_offset && !InfoOf(code_.program.stage).has_neighbours) return call("texture", "");
    return call("textureGrad",
                InfoOf(kind_).is_cube ? ", vec3(0.0), vec3(0.0)" : ", vec2(0.0), vec2(0.0)");
  }

  Text LevelOfDetail(std::string_view component) {
    Text query = Rest("textureQueryLod", 2, arguments_[1]);
    query.text = Concat(query.text.substr(0, query.text.rfind(')') + 1), component);
    return query;
  }

  Text Gather() {
    const bool compares = node_.op == ObjectOp::kGatherCmp;
    const int component =
        compares ? 0 : static_cast<int>(node_.op) - static_cast<int>(ObjectOp::kGather);
    const std::string last = component > 0 ? fmt::format(", {}", component) : "";
    const std::size_t first = compares ? 4 : 3;  // the first offset
    if (arguments_.size() != first + 4) {
      const bool has_offset = arguments_.size() > first;
      if (has_offset && !ConstantBits(code_.program, arguments_[first]))
        code_.Require(Feature::kGatherOffsets);
      return Rest(has_offset ? "textureGatherOffset" : "textureGather", 2, arguments_[1], last);
    }
    code_.Require(Feature::kGatherOffsets);
    const std::string object = ObjectName(code_, arguments_[0], arguments_[1]);
    const std::string place = compares ? Concat(ArgumentAt(2), ", ", ArgumentAt(3)) : ArgumentAt(2);
    return FourGathers(Concat(object, ", ", place, ", "), arguments_.subspan(first), last);
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
    if (constants.size() == 4) {
      return {fmt::format("textureGatherOffsets({}ivec2[4]({}){})", leading,
                          fmt::join(constants, ", "), last)};
    }
    const std::string type = TypeName(code_, ShapeOf(code_[type_], code_.target));
    return {fmt::format("{}({})", type, fmt::join(calls, ", "))};
  }

  Text Texel() {
    RequireSamplerless();
    return Rest(arguments_.size() > 3 ? "texelFetchOffset" : "texelFetch", 1);
  }

  // OpenGL has no subpasses: the host binds what was drawn as a texture. Its rows are counted as
  // gl_FragCoord is unless that is declared anew.
  Text SubpassLoad() {
    const std::string name = ObjectName(code_, arguments_[0]);
    const bool has_sample = arguments_.size() > 1;
    if (code_.target.IsVulkan())
      return Narrow(Concat("subpassLoad(", name, has_sample ? ", " + ArgumentAt(1) : "", ")"));
    const std::string place = code_.has_upper_left_origin
                                  ? Concat("ivec2(gl_FragCoord.x, float(textureSize(", name,
                                           has_sample ? ").y" : ", 0).y", ") - gl_FragCoord.y)")
                                  : "ivec2(gl_FragCoord.xy)";
    return Narrow(
        Concat("texelFetch(", name, ", ", place, ", ", has_sample ? ArgumentAt(1) : "0", ")"));
  }

  Text Query() {
    if (IsByteAddress(kind_) || IsStructured(kind_)) return BufferSize(code_, arguments_[0]);
    if (IsImage(kind_)) return Called("imageSize", {ObjectName(code_, arguments_[0])});
    RequireSamplerless();
    const std::string object = ObjectName(code_, arguments_[0]);
    if (node_.op == ObjectOp::kTextureLevels) return Called("textureQueryLevels", {object});
    if (node_.op == ObjectOp::kTextureSamples) return Called("textureSamples", {object});
    const bool has_level = kind_ != ObjectKind::kBuffer && !InfoOf(kind_).is_multisampled;
    if (!has_level) return Called("textureSize", {object});
    return Called("textureSize", {object, IntIndex(code_, arguments_[1])});
  }

  // The call imageAtomicAdd(image, place, value) or atomicAdd(buffer[place], value).
  Text Atomic(std::string_view what) {
    const bool is_image = IsImage(kind_);
    if (is_image) code_.Require(Feature::kImageAtomics);
    std::string text = is_image ? Concat("imageAtomic", what, "(", ObjectName(code_, arguments_[0]),
                                         ", ", ArgumentAt(1))
                                : Concat("atomic", what, "(", BufferWord(code_, node_));
    for (const ExprId value : arguments_.last(ValuesOf(node_.op)))
      Append(text, ", ", Argument(code_, value));
    return {text + ")"};
  }

  // An image is written four components at a time; those that its format lacks are dropped.
  Text ImageStore() {
    const std::string image = ObjectName(code_, arguments_[0]);
    std::string value = ArgumentAt(2);
    const Shape shape = code_.ShapeAt(arguments_[2]);
    if (shape.size < 4) {
      const std::string zero = LiteralText(0, shape.scalar, code_.target).text;
      for (int i = shape.size; i < 4; ++i) Append(value, ", ", zero);
      value = Called(TypeName(code_, ShapeOf(shape.scalar, 1, 4)), {value}).text;
    }
    return Called("imageStore", {image, ArgumentAt(1), value});
  }

  // Requires the extension for calls without a sampler: Vulkan's textures have none of their own.
  void RequireSamplerless() {
    if (code_.target.IsVulkan()) code_.Require("GL_EXT_samplerless_texture_functions");
  }

  Code& code_;
  TypeId type_;
  const ObjectCall& node_;
  std::span<const ExprId> arguments_;
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
