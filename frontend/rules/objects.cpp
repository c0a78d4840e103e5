// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "frontend/rules/constant.h"
#include "frontend/rules/intrinsics.h"
#include "frontend/rules/object_call.h"

namespace clipc {
namespace {

using ir::ExprId;
using ir::ObjectKind;
using ir::ObjectOp;
using ir::Scalar;
using ir::Type;
using ir::TypeId;

enum class Method : std::uint8_t {
  kSampleLevel,
  kSampleGrad,
  kSampleCmpLevelZero,
  kGather,
  kLoad,
  kByteLoad,
  kByteStore,
  kGetDimensions,
  kSample,  // takes the level of detail from neighbouring pixels: level 0 here
  kSampleBias,
  kSampleCmp,
  kImplicitLevel,  // refused: asks for the level of detail of neighbouring pixels
  kUnsupported,
};
struct MethodName {
  std::string_view name;
  Method method;
  std::uint8_t detail = 0;  // kGather: the ObjectOp; kByteLoad, kByteStore: how many words
};
constexpr std::uint8_t Detail(ObjectOp op) { return static_cast<std::uint8_t>(op); }

constexpr MethodName kTextureMethods[] = {
    {"SampleLevel", Method::kSampleLevel},
    {"SampleGrad", Method::kSampleGrad},
    {"SampleCmpLevelZero", Method::kSampleCmpLevelZero},
    {"Gather", Method::kGather, Detail(ObjectOp::kGather)},
    {"GatherRed", Method::kGather, Detail(ObjectOp::kGather)},
    {"GatherGreen", Method::kGather, Detail(ObjectOp::kGatherGreen)},
    {"GatherBlue", Method::kGather, Detail(ObjectOp::kGatherBlue)},
    {"GatherAlpha", Method::kGather, Detail(ObjectOp::kGatherAlpha)},
    {"Load", Method::kLoad},
    {"GetDimensions", Method::kGetDimensions},
    {"Sample", Method::kSample},
    {"SampleBias", Method::kSampleBias},
    {"SampleCmp", Method::kSampleCmp},
    {"SampleCmpBias", Method::kImplicitLevel},
    {"CalculateLevelOfDetail", Method::kImplicitLevel},
    {"CalculateLevelOfDetailUnclamped", Method::kImplicitLevel},
    {"SampleCmpGrad", Method::kUnsupported},
    {"SampleCmpLevel", Method::kUnsupported},
    {"GatherCmp", Method::kUnsupported},
    {"GatherCmpRed", Method::kUnsupported},
    {"GatherCmpGreen", Method::kUnsupported},
    {"GatherCmpBlue", Method::kUnsupported},
    {"GatherCmpAlpha", Method::kUnsupported},
    {"GatherRaw", Method::kUnsupported},
    {"GetSamplePosition", Method::kUnsupported},
};
constexpr MethodName kBufferMethods[] = {{"Load", Method::kLoad},
                                         {"GetDimensions", Method::kGetDimensions}};
constexpr MethodName kByteMethods[] = {{"Load", Method::kByteLoad, 1},
                                       {"Load2", Method::kByteLoad, 2},
                                       {"Load3", Method::kByteLoad, 3},
                                       {"Load4", Method::kByteLoad, 4},
                                       {"GetDimensions", Method::kGetDimensions},
                                       {"Store", Method::kByteStore, 1},
                                       {"Store2", Method::kByteStore, 2},
                                       {"Store3", Method::kByteStore, 3},
                                       {"Store4", Method::kByteStore, 4}};
constexpr std::size_t kByteReaders = 5;

std::span<const MethodName> MethodsOf(ObjectKind kind) {
  if (IsTexture(kind)) return kTextureMethods;
  switch (kind) {
    case ObjectKind::kBuffer:
    case ObjectKind::kStructuredBuffer:
    case ObjectKind::kRWStructuredBuffer: return kBufferMethods;
    case ObjectKind::kByteAddressBuffer: return std::span(kByteMethods).first(kByteReaders);
    case ObjectKind::kRWByteAddressBuffer: return kByteMethods;
    default:
      return IsImage(kind) ? std::span<const MethodName>(kBufferMethods)
                           : std::span<const MethodName>();
  }
}

// A method call in progress: the object, and the arguments of the ObjectCall made so far.
class MethodCheck {
 public:
  MethodCheck(const IntrinsicCheck& call, ExprId object, ObjectKind kind)
      : call_(call),
        object_(object),
        kind_(kind),
        traits_(clipc::TraitsOf(kind)),
        arguments_{object} {}

  ExprId SampleLevel() {
    if (!CheckCount(3) || !TakeSampler(ObjectKind::kSampler) || !TakeFloats(1, traits_.coordinates))
      return call_.Error();
    if (!TakeFloats(2, 1) || !TakeOffset(3)) return call_.Error();
    return Finish(ObjectOp::kSampleLevel, Element());
  }

  // A vertex has no neighbours to take a level of detail from: fxc and DXC refuse (X4532), OpenGL
  // reads level 0.
  ExprId SampleImplicit(bool has_bias) {
    const std::size_t least = has_bias ? 3 : 2;
    if (!CheckCount(least) || !TakeSampler(ObjectKind::kSampler) ||
        !TakeFloats(1, traits_.coordinates))
      return call_.Error();
    if (!has_bias) {
      arguments_.push_back(call_.Make().Float(0));
    } else if (!TakeFloats(2, 1)) {
      return call_.Error();
    }
    if (!TakeOffset(least)) return call_.Error();
    WarnOfLevel(has_bias ? "0 plus the bias" : "0");
    return Finish(ObjectOp::kSampleLevel, Element());
  }

  ExprId SampleCmp() {
    WarnOfLevel("0");
    return SampleCmpLevelZero();
  }

  ExprId SampleGrad() {
    if (!CheckCount(4) || !TakeSampler(ObjectKind::kSampler) || !TakeFloats(1, traits_.coordinates))
      return call_.Error();
    if (!TakeFloats(2, traits_.gradient) || !TakeFloats(3, traits_.gradient) || !TakeOffset(4))
      return call_.Error();
    return Finish(ObjectOp::kSampleGrad, Element());
  }

  ExprId SampleCmpLevelZero() {
    if (!CheckCount(3) || !TakeSampler(ObjectKind::kSamplerComparison)) return call_.Error();
    if (!TakeFloats(1, traits_.coordinates) || !TakeFloats(2, 1) || !TakeOffset(3))
      return call_.Error();
    return Finish(ObjectOp::kSampleCmpLevelZero, call_.program.types.Make(Scalar::kFloat));
  }

  ExprId Gather(ObjectOp op) {
    constexpr std::size_t kFourOffsets =
        6;  // sampler, coordinate, and an offset for each of the four texels
    const bool has_four = traits_.offset != 0 && call_.arguments.size() == kFourOffsets;
    if ((!has_four && !CheckCount(2)) || !TakeSampler(ObjectKind::kSampler) ||
        !TakeFloats(1, traits_.coordinates))
      return call_.Error();
    for (std::size_t i = 2; i < (has_four ? kFourOffsets : 3); ++i) {
      if (!TakeOffset(i)) return call_.Error();
    }
    const Scalar kind = call_.program.types[Element()].scalar;
    return Finish(op, call_.program.types.Vector(kind, 4));
  }

  ExprId Load() {
    if (!CheckCount(traits_.is_multisampled ? 2 : 1)) return call_.Error();
    ir::TypeTable& types = call_.program.types;
    const int texel = traits_.texel;
    ExprId prologue;
    if (traits_.is_multisampled) {
      const auto coordinate = call_.Converted(0, call_.VectorOf(Scalar::kInt, texel));
      const auto sample = coordinate ? call_.Converted(1, types.Make(Scalar::kInt)) : std::nullopt;
      if (!sample) return call_.Error();
      arguments_.insert(arguments_.end(), {*coordinate, *sample});
    } else {
      const auto location = call_.Converted(0, types.Vector(Scalar::kInt, texel + 1));
      if (!location) return call_.Error();
      const auto parts = call_.Split(*location, texel, texel);
      arguments_.insert(arguments_.end(), {parts.leading, parts.last});
      prologue = parts.prologue;
    }
    if (!TakeOffset(traits_.is_multisampled ? 2 : 1)) return call_.Error();
    return WithPrologue(call_, prologue, Finish(ObjectOp::kTextureLoad, Element()));
  }

  ExprId BufferLoad() {
    if (!CheckCount(1)) return call_.Error();
    const auto index = call_.Converted(0, call_.program.types.Make(Scalar::kInt));
    if (!index) return call_.Error();
    arguments_.push_back(*index);
    return Finish(IsStructured(kind_) ? ObjectOp::kStructuredLoad : ObjectOp::kBufferLoad,
                  Element());
  }

  ExprId ImageLoad() {
    if (!CheckCount(1)) return call_.Error();
    const auto coordinate = call_.Converted(0, call_.VectorOf(Scalar::kInt, traits_.texel));
    if (!coordinate) return call_.Error();
    arguments_.push_back(*coordinate);
    return Finish(ObjectOp::kImageLoad, Element());
  }

  ExprId ByteStore(int words) {
    if (!call_.HasCount(2, 2)) return call_.Error();
    const auto address = call_.Converted(0, call_.program.types.Make(Scalar::kUint));
    const auto value = call_.Converted(1, call_.VectorOf(Scalar::kUint, words));
    if (!address || !value) return call_.Error();
    arguments_.insert(arguments_.end(), {*address, *value});
    return Finish(ObjectOp::kStore, call_.program.types.Void());
  }

  ExprId ByteLoad(int words) {
    if (!CheckCount(1)) return call_.Error();
    const auto address = call_.Converted(0, call_.program.types.Make(Scalar::kUint));
    if (!address) return call_.Error();
    arguments_.push_back(*address);
    return Finish(ObjectOp::kByteLoad, call_.VectorOf(Scalar::kUint, words));
  }

  ExprId Unsupported() {
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

  // `least` arguments, then perhaps an offset; a status behind it asks about tiled resources.
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

  bool TakeFloats(std::size_t i, int count) {
    const auto value = call_.Converted(i, call_.VectorOf(Scalar::kFloat, count));
    if (value) arguments_.push_back(*value);
    return value.has_value();
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
    arguments_.push_back(
        texels.size() == 1
            ? texels[0]
            : builder.ConstructOf(call_.VectorOf(Scalar::kInt, traits_.offset), texels));
    return true;
  }

  const IntrinsicCheck& call_;
  ExprId object_;
  ObjectKind kind_;
  TextureTraits traits_;
  std::vector<ExprId> arguments_;
};

// Whether the texture has what the method needs: cube textures have no texels to load, only some
// can gather.
bool Offers(const TextureTraits& traits, Method method) {
  switch (method) {
    case Method::kSampleLevel:
    case Method::kSampleGrad:
    case Method::kSample:
    case Method::kSampleBias:
    case Method::kImplicitLevel: return traits.coordinates != 0;
    case Method::kSampleCmp:
    case Method::kSampleCmpLevelZero: return traits.coordinates != 0 && traits.gradient != 0;
    case Method::kGather: return traits.can_gather;
    case Method::kLoad: return traits.texel != 0;
    default: return true;
  }
}

ExprId Dispatch(const IntrinsicCheck& call, ExprId object, ObjectKind kind,
                const MethodName* method) {
  MethodCheck check(call, object, kind);
  if (method == nullptr || (IsTexture(kind) && !Offers(TraitsOf(kind), method->method)))
    return check.Unknown();
  switch (method->method) {
    case Method::kSampleLevel: return check.SampleLevel();
    case Method::kSampleGrad: return check.SampleGrad();
    case Method::kSample: return check.SampleImplicit(false);
    case Method::kSampleBias: return check.SampleImplicit(true);
    case Method::kSampleCmp: return check.SampleCmp();
    case Method::kSampleCmpLevelZero: return check.SampleCmpLevelZero();
    case Method::kGather: return check.Gather(static_cast<ObjectOp>(method->detail));
    case Method::kLoad:
      if (IsTexture(kind)) return check.Load();
      return TraitsOf(kind).texel != 0 ? check.ImageLoad() : check.BufferLoad();
    case Method::kByteLoad: return check.ByteLoad(method->detail);
    case Method::kByteStore: return check.ByteStore(method->detail);
    case Method::kGetDimensions: return CheckGetDimensions(call, object);
    case Method::kImplicitLevel:
      call.diagnostics.Report(call.name_span, diag::MethodImplicitLevel, call.name);
      return call.Error();
    case Method::kUnsupported: return check.Unsupported();
  }
  return call.Error();
}

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
  const auto methods = MethodsOf(type.object);
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const MethodName& each) { return each.name == method; });
  return Dispatch(call, object, type.object, found == methods.end() ? nullptr : &*found);
}

}  // namespace clipc
