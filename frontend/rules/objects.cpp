// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/objects.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "frontend/rules/constant.h"
#include "frontend/rules/object_call.h"

namespace clipc {
namespace {

using ir::ExprId;
using ir::ObjectKind;
using ir::ObjectOp;
using ir::Scalar;
using ir::Type;
using ir::TypeId;

// A method call in progress: the object, and the arguments of the ObjectCall made so far.
class MethodCheck {
 public:
  MethodCheck(const IntrinsicCheck& call, ExprId object, ObjectKind kind)
      : call_(call),
        object_(object),
        kind_(kind),
        traits_(clipc::TraitsOf(kind)),
        arguments_{object} {}

  ExprId SampleLevel(int) {
    if (!TakeSample(3) || !TakeFloats(2, 1) || !TakeOffset(3)) return call_.Error();
    return Finish(ObjectOp::kSampleLevel, Element());
  }

  // A vertex has no neighbours to take a level of detail from: fxc and DXC refuse (X4532), OpenGL
  // reads level 0.
  ExprId Sample(int) {
    if (!TakeSample(2)) return call_.Error();
    arguments_.push_back(call_.Make().Float(0));
    if (!TakeOffset(2)) return call_.Error();
    WarnOfLevel("0");
    return Finish(ObjectOp::kSampleLevel, Element());
  }

  ExprId SampleBias(int) {
    const ExprId sample = SampleLevel(0);
    if (call_.TypeIdOf(sample) != call_.program.types.Error()) WarnOfLevel("0 plus the bias");
    return sample;
  }

  ExprId SampleCmp(int) {
    WarnOfLevel("0");
    return SampleCmpLevelZero(0);
  }

  ExprId SampleGrad(int) {
    if (!TakeSample(4) || !TakeFloats(2, traits_.gradient) || !TakeFloats(3, traits_.gradient) ||
        !TakeOffset(4))
      return call_.Error();
    return Finish(ObjectOp::kSampleGrad, Element());
  }

  ExprId SampleCmpLevelZero(int) {
    if (!TakeSample(3, ObjectKind::kSamplerComparison) || !TakeFloats(2, 1) || !TakeOffset(3))
      return call_.Error();
    return Finish(ObjectOp::kSampleCmpLevelZero, call_.program.types.Make(Scalar::kFloat));
  }

  // (sampler, coordinate), and an offset or one for each of the four texels
  ExprId Gather(int op) {
    const std::size_t given = call_.arguments.size();
    const bool has_four = traits_.offset != 0 && given == 6;
    if ((!has_four && !CheckCount(2)) || !TakeSampler(ObjectKind::kSampler) ||
        !TakeFloats(1, traits_.coordinates))
      return call_.Error();
    for (std::size_t i = 2; i < given; ++i) {
      if (!TakeOffset(i)) return call_.Error();
    }
    const Scalar kind = call_.program.types[Element()].scalar;
    return Finish(static_cast<ObjectOp>(op), call_.program.types.Vector(kind, 4));
  }

  ExprId TextureLoad(int) {
    if (ir::IsImage(kind_)) {
      return LoadAt(ObjectOp::kImageLoad, call_.VectorOf(Scalar::kInt, traits_.texel), Element());
    }
    if (!CheckCount(traits_.is_multisampled ? 2 : 1)) return call_.Error();
    ir::TypeTable& types = call_.program.types;
    const int texel = traits_.texel;
    ExprId prologue;
    if (traits_.is_multisampled) {
      if (!Take(0, call_.VectorOf(Scalar::kInt, texel)) || !Take(1, types.Make(Scalar::kInt)))
        return call_.Error();
    } else {
      const auto location = call_.Converted(0, types.Vector(Scalar::kInt, texel + 1));
      if (!location) return call_.Error();
      const auto parts = call_.Split(*location, texel, texel);
      arguments_.insert(arguments_.end(), {parts.leading, parts.last});
      prologue = parts.prologue;
    }
    if (!TakeOffset(traits_.is_multisampled ? 2 : 1)) return call_.Error();
    return After(call_, {&prologue, 1}, Finish(ObjectOp::kTextureLoad, Element()));
  }

  ExprId BufferLoad(int) {
    return LoadAt(IsStructured(kind_) ? ObjectOp::kStructuredLoad : ObjectOp::kBufferLoad,
                  call_.program.types.Make(Scalar::kInt), Element());
  }

  ExprId ByteLoad(int words) {
    return LoadAt(ObjectOp::kByteLoad, call_.program.types.Make(Scalar::kUint),
                  call_.VectorOf(Scalar::kUint, words));
  }

  ExprId ByteStore(int words) {
    if (!call_.HasCount(2, 2) || !Take(0, call_.program.types.Make(Scalar::kUint)) ||
        !Take(1, call_.VectorOf(Scalar::kUint, words)))
      return call_.Error();
    return Finish(ObjectOp::kStore, call_.program.types.Void());
  }

  ExprId GetDimensions(int) { return CheckGetDimensions(call_, object_); }

  // What asks for the level of detail of neighbouring pixels.
  ExprId ImplicitLevel(int) {
    call_.diagnostics.Report(call_.name_span, diag::MethodImplicitLevel, call_.name);
    return call_.Error();
  }
  ExprId Unsupported(int) {
    call_.diagnostics.Report(call_.name_span, diag::MethodUnsupported, call_.name, ObjectName());
    return call_.Error();
  }
  ExprId Unknown() {
    call_.diagnostics.Report(call_.name_span, diag::MethodUnknown, ObjectName(), call_.name);
    return call_.Error();
  }

 private:
  void WarnOfLevel(std::string_view level) const {
    call_.diagnostics.Report(call_.name_span, diag::MethodLevelZero, call_.name, level);
  }
  std::string ObjectName() const { return call_.program.types.Name(call_.TypeIdOf(object_)); }
  TypeId Element() { return ElementOf(call_.program.types, call_.TypeOf(object_)); }
  ExprId Finish(ObjectOp op, TypeId type) {
    return MakeObjectCall(call_.Make(), call_.program, type, op, arguments_);
  }

  // `least` arguments, then perhaps an offset; a status after it asks about tiled resources.
  bool CheckCount(std::size_t least) {
    const std::size_t most = least + (traits_.offset != 0 ? 1 : 0);
    if (call_.arguments.size() == most + 1 &&
        call_.TypeOf(call_.arguments.back()).scalar == Scalar::kUint) {
      call_.diagnostics.Report(call_.name_span, diag::MethodStatus, call_.name);
      return false;
    }
    return call_.HasCount(least, most);
  }

  bool TakeSampler(ObjectKind kind) {
    const Type& type = call_.ArgumentType(0);
    if (type.kind != ir::TypeKind::kObject || type.object != kind) {
      call_.BadArgument(
          0, kind == ObjectKind::kSampler ? "a `SamplerState`" : "a `SamplerComparisonState`");
      return false;
    }
    arguments_.push_back(call_.arguments[0]);
    return true;
  }

  bool Take(std::size_t i, TypeId type) {
    const auto value = call_.Converted(i, type);
    if (value) arguments_.push_back(*value);
    return value.has_value();
  }
  bool TakeFloats(std::size_t i, int count) {
    return Take(i, call_.VectorOf(Scalar::kFloat, count));
  }
  // A sampler and a coordinate, the first of `least` arguments.
  bool TakeSample(std::size_t least, ObjectKind sampler = ObjectKind::kSampler) {
    return CheckCount(least) && TakeSampler(sampler) && TakeFloats(1, traits_.coordinates);
  }
  // One argument that tells where to read.
  ExprId LoadAt(ObjectOp op, TypeId place, TypeId result) {
    return CheckCount(1) && Take(0, place) ? Finish(op, result) : call_.Error();
  }

  // An optional offset in texels, which must be known now.
  bool TakeOffset(std::size_t i) {
    if (i >= call_.arguments.size()) return true;
    const auto value = call_.Converted(i, call_.VectorOf(Scalar::kInt, traits_.offset));
    if (!value) return false;
    const auto constant = EvaluateConstant(call_.program, *value);
    if (!constant) {
      call_.diagnostics.Report(call_.SpanOf(call_.arguments[i]), diag::TextureOffsetNotConstant,
                               call_.name);
      return false;
    }
    ir::Builder builder(call_.program, call_.SpanOf(call_.arguments[i]));
    std::vector<ExprId> texels;
    for (const double texel : constant->components) {
      if (texel < -8 || texel > 7) {
        call_.diagnostics.Report(call_.SpanOf(call_.arguments[i]), diag::TextureOffsetRange,
                                 static_cast<int>(texel), call_.name);
        return false;
      }
      texels.push_back(builder.Int(static_cast<int>(texel)));
    }
    arguments_.push_back(texels.size() == 1 ? texels[0]
                                            : builder.ConstructOf(call_.TypeIdOf(*value), texels));
    return true;
  }

  const IntrinsicCheck& call_;
  ExprId object_;
  ObjectKind kind_;
  TextureTraits traits_;
  std::vector<ExprId> arguments_;
};

// What an object must have for a method to exist.
enum class Needs : std::uint8_t {
  kNothing,
  kSampling,
  kComparison,
  kGathering,
  kTexels,  // cube textures have none to load
  kReading,
  kWriting,
};

bool Offers(ObjectKind kind, Needs needs) {
  const TextureTraits traits = TraitsOf(kind);
  switch (needs) {
    case Needs::kNothing: return true;
    case Needs::kSampling: return traits.coordinates != 0;
    case Needs::kComparison: return traits.gradient != 0;
    case Needs::kGathering: return traits.can_gather;
    case Needs::kTexels: return traits.texel != 0;
    case Needs::kReading: return !ir::IsWritable(kind);
    case Needs::kWriting: return ir::IsWritable(kind);
  }
  return false;
}

using Category = ir::ObjectCategory;

struct Method {
  Category category;  // of the objects that have the method
  std::string_view name;
  Needs needs;
  ExprId (MethodCheck::*check)(int detail);
  int detail = 0;  // Gather: the ObjectOp; ByteLoad, ByteStore: how many words
};

constexpr Method Texture(std::string_view name, Needs needs, ExprId (MethodCheck::*check)(int),
                         ObjectOp op = {}) {
  return {Category::kTexture, name, needs, check, static_cast<int>(op)};
}
constexpr Method Bytes(std::string_view name, Needs needs, ExprId (MethodCheck::*check)(int),
                       int words = 0) {
  return {Category::kByteAddressBuffer, name, needs, check, words};
}

constexpr Method kMethods[] = {
    Texture("SampleLevel", Needs::kSampling, &MethodCheck::SampleLevel),
    Texture("SampleGrad", Needs::kSampling, &MethodCheck::SampleGrad),
    Texture("Sample", Needs::kSampling, &MethodCheck::Sample),
    Texture("SampleBias", Needs::kSampling, &MethodCheck::SampleBias),
    Texture("SampleCmp", Needs::kComparison, &MethodCheck::SampleCmp),
    Texture("SampleCmpLevelZero", Needs::kComparison, &MethodCheck::SampleCmpLevelZero),
    Texture("Gather", Needs::kGathering, &MethodCheck::Gather, ObjectOp::kGather),
    Texture("GatherRed", Needs::kGathering, &MethodCheck::Gather, ObjectOp::kGather),
    Texture("GatherGreen", Needs::kGathering, &MethodCheck::Gather, ObjectOp::kGatherGreen),
    Texture("GatherBlue", Needs::kGathering, &MethodCheck::Gather, ObjectOp::kGatherBlue),
    Texture("GatherAlpha", Needs::kGathering, &MethodCheck::Gather, ObjectOp::kGatherAlpha),
    Texture("Load", Needs::kTexels, &MethodCheck::TextureLoad),
    Texture("GetDimensions", Needs::kNothing, &MethodCheck::GetDimensions),
    Texture("SampleCmpBias", Needs::kSampling, &MethodCheck::ImplicitLevel),
    Texture("CalculateLevelOfDetail", Needs::kSampling, &MethodCheck::ImplicitLevel),
    Texture("CalculateLevelOfDetailUnclamped", Needs::kSampling, &MethodCheck::ImplicitLevel),
    Texture("SampleCmpGrad", Needs::kReading, &MethodCheck::Unsupported),
    Texture("SampleCmpLevel", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GatherCmp", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GatherCmpRed", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GatherCmpGreen", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GatherCmpBlue", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GatherCmpAlpha", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GatherRaw", Needs::kReading, &MethodCheck::Unsupported),
    Texture("GetSamplePosition", Needs::kReading, &MethodCheck::Unsupported),
    {Category::kTypedBuffer, "Load", Needs::kNothing, &MethodCheck::BufferLoad},
    {Category::kTypedBuffer, "GetDimensions", Needs::kNothing, &MethodCheck::GetDimensions},
    {Category::kStructuredBuffer, "Load", Needs::kNothing, &MethodCheck::BufferLoad},
    {Category::kStructuredBuffer, "GetDimensions", Needs::kNothing, &MethodCheck::GetDimensions},
    Bytes("Load", Needs::kNothing, &MethodCheck::ByteLoad, 1),
    Bytes("Load2", Needs::kNothing, &MethodCheck::ByteLoad, 2),
    Bytes("Load3", Needs::kNothing, &MethodCheck::ByteLoad, 3),
    Bytes("Load4", Needs::kNothing, &MethodCheck::ByteLoad, 4),
    Bytes("GetDimensions", Needs::kNothing, &MethodCheck::GetDimensions),
    Bytes("Store", Needs::kWriting, &MethodCheck::ByteStore, 1),
    Bytes("Store2", Needs::kWriting, &MethodCheck::ByteStore, 2),
    Bytes("Store3", Needs::kWriting, &MethodCheck::ByteStore, 3),
    Bytes("Store4", Needs::kWriting, &MethodCheck::ByteStore, 4),
};

}  // namespace

TextureTraits TraitsOf(ObjectKind kind) {
  const ir::ObjectInfo& info = ir::InfoOf(kind);
  if (info.category != ir::ObjectCategory::kTexture) return {};
  const bool is_sampled = !info.is_writable && !info.is_multisampled;
  const int layers = info.is_array;
  const int direction = info.is_cube ? 3 : info.axes;
  return {.coordinates = is_sampled ? direction + layers : 0,
          .texel = info.is_cube ? 0 : info.axes + layers,
          .size = info.axes + layers,
          .offset = info.is_cube || info.is_writable ? 0 : info.axes,
          .gradient = is_sampled ? direction : 0,
          .is_multisampled = info.is_multisampled,
          .can_gather = is_sampled && info.axes == 2};
}

TypeId ElementOf(ir::TypeTable& types, const Type& object) {
  return object.element ? object.element : types.Vector(Scalar::kFloat, 4);
}

ExprId MakeObjectCall(ir::Builder builder, ir::Program& program, TypeId type, ObjectOp op,
                      std::span<const ExprId> arguments) {
  return builder.Add(type, ir::ObjectCall{op, program.expr_lists.Add(arguments)});
}

ExprId CheckMethodCall(ir::Program& program, ExprId object, std::string_view method,
                       Span method_span, std::span<const ExprId> arguments, Span call_span,
                       TemporaryMaker& temporaries, Diagnostics& diagnostics) {
  const IntrinsicCheck call(program, method, method_span, arguments, call_span, temporaries,
                            diagnostics);
  const Type type = call.TypeOf(object);
  if (type.kind == ir::TypeKind::kError) return call.Error();
  for (const ExprId argument : arguments) {
    if (call.TypeIdOf(argument) == program.types.Error()) return call.Error();
  }
  if (type.kind != ir::TypeKind::kObject) {
    diagnostics.Report(method_span, diag::MethodUnknown, program.types.Name(call.TypeIdOf(object)),
                       method);
    return call.Error();
  }
  if (type.object == ObjectKind::kOther) {
    diagnostics.Report(method_span, diag::ObjectUnusable, method);
    return call.Error();
  }
  MethodCheck check(call, object, type.object);
  const Category category = ir::InfoOf(type.object).category;
  const auto* found = std::ranges::find_if(kMethods, [&](const Method& each) {
    return each.category == category && each.name == method && Offers(type.object, each.needs);
  });
  return found == std::end(kMethods) ? check.Unknown() : (check.*found->check)(found->detail);
}

}  // namespace clipc
