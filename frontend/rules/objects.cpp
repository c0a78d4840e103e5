// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/objects.h"

#include <algorithm>
#include <array>
#include <vector>

#include "frontend/rules/constant.h"
#include "frontend/rules/object_call.h"
#include "ir/access.h"

namespace clipc::rules {
namespace {

// A method call in progress: the object, and the arguments of the ObjectCall made so far.
class MethodCheck : IntrinsicCheck {
 public:
  MethodCheck(const IntrinsicCheck& call, ExprId object, ObjectKind kind)
      : IntrinsicCheck(call),
        object_(object),
        kind_(kind),
        traits_(rules::TraitsOf(kind)),
        arguments_{object} {}

  ExprId SampleLevel(int) {
    if (!TakeSample(3) || !TakeFloats(2, 1) || !TakeOffset(3)) return Error();
    return Finish(ObjectOp::kSampleLevel, Element());
  }

  // Checks a Sample. In a stage without neighbours to take a level of detail from, fxc and DXC
  // refuse (X4532), and OpenGL reads level 0.
  ExprId Sample(int) {
    if (!TakeSample(2) || !HasLevelToClamp()) return Error();
    const bool has_neighbours = ThisStage().has_neighbours;
    if (!has_neighbours) arguments_.push_back(Make().Float(0));
    if (!TakeOffset(2)) return Error();
    WarnOfLevel("0");
    return Finish(has_neighbours ? ObjectOp::kSample : ObjectOp::kSampleLevel, Element());
  }

  ExprId SampleBias(int) {
    if (!TakeSample(3) || !HasLevelToClamp() || !TakeFloats(2, 1) || !TakeOffset(3)) return Error();
    WarnOfLevel("0 plus the bias");
    return Finish(ThisStage().has_neighbours ? ObjectOp::kSampleBias : ObjectOp::kSampleLevel,
                  Element());
  }

  ExprId SampleCmp(int) {
    WarnOfLevel("0");
    return Compare(ThisStage().has_neighbours ? ObjectOp::kSampleCmp
                                              : ObjectOp::kSampleCmpLevelZero);
  }

  ExprId LevelOfDetail(int op) {
    if (!ThisStage().has_neighbours)
      return Fail(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
    // An element of an array has the level of detail that every other has.
    if (!HasCount(2, 2) || !TakeSampler(ObjectKind::kSampler) || !TakeFloats(1, traits_.gradient))
      return Error();
    return Finish(static_cast<ObjectOp>(op), program.types.Make(Scalar::kFloat));
  }

  ExprId SampleGrad(int) {
    if (!TakeSample(4) || !TakeFloats(2, traits_.gradient) || !TakeFloats(3, traits_.gradient) ||
        !TakeOffset(4))
      return Error();
    return Finish(ObjectOp::kSampleGrad, Element());
  }

  ExprId SampleCmpLevelZero(int) { return Compare(ObjectOp::kSampleCmpLevelZero); }

  // Checks a SampleCmpLevel or SampleCmpBias, which take one number after the reference.
  ExprId SampleCmpWith(int op) {
    if (!IsAtLeast(6, op == static_cast<int>(ObjectOp::kSampleCmpLevel) ? 7 : 8) ||
        !TakeCompare(4) || !TakeFloats(3, 1) || !TakeOffset(4))
      return Error();
    return Finish(static_cast<ObjectOp>(op), program.types.Make(Scalar::kFloat));
  }

  ExprId SampleCmpBias(int op) {
    return ThisStage().has_neighbours
               ? SampleCmpWith(op)
               : Fail(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
  }

  ExprId SampleCmpGrad(int) {
    if (!IsAtLeast(6, 8) || !TakeCompare(5) || !TakeFloats(3, traits_.gradient) ||
        !TakeFloats(4, traits_.gradient) || !TakeOffset(5))
      return Error();
    return Finish(ObjectOp::kSampleCmpGrad, program.types.Make(Scalar::kFloat));
  }

  // Checks a Gather, whose arguments are (sampler, coordinate), and perhaps an offset or an offset
  // for each of the four texels.
  ExprId Gather(int op) {
    const Scalar kind = program.types[Element()].scalar;
    return GatherAfter(2, ObjectKind::kSampler, static_cast<ObjectOp>(op), kind);
  }

  // Checks a GatherCmp, which has a reference value after the coordinate. Those of green, blue and
  // alpha compare what GatherCmpRed does, since only formats of one component are compared (vkd3d's
  // gather-cmp.shader_test, checked against native).
  ExprId GatherCmp(int op) {
    return GatherAfter(3, ObjectKind::kSamplerComparison, static_cast<ObjectOp>(op),
                       Scalar::kFloat);
  }

  ExprId TextureLoad(int) {
    if (IsImage(kind_)) {
      return LoadAt(ObjectOp::kImageLoad, VectorOf(Scalar::kInt, traits_.texel), Element());
    }
    if (!CheckCount(traits_.is_multisampled ? 2 : 1)) return Error();
    TypeTable& types = program.types;
    const int texel = traits_.texel;
    ExprId prologue;
    if (traits_.is_multisampled) {
      if (!Take(0, VectorOf(Scalar::kInt, texel)) || !Take(1, types.Make(Scalar::kInt)))
        return Error();
    } else {
      const auto location = Converted(0, types.Vector(Scalar::kInt, texel + 1));
      if (!location) return Error();
      const auto parts = Split(*location, texel, texel);
      arguments_.insert(arguments_.end(), {parts.leading, parts.last});
      prologue = parts.prologue;
    }
    if (!TakeOffset(traits_.is_multisampled ? 2 : 1)) return Error();
    if (traits_.is_multisampled && arguments_.size() > 3) AddOffset();
    return After(*this, {&prologue, 1}, Finish(ObjectOp::kTextureLoad, Element()));
  }

  ExprId BufferLoad(int) {
    return LoadAt(IsStructured(kind_) ? ObjectOp::kStructuredLoad : ObjectOp::kBufferLoad,
                  program.types.Make(Scalar::kInt), Element());
  }

  ExprId Counter(int) { return CheckCounter(*this, object_); }

  ExprId ByteLoad(int words) {
    return LoadAt(ObjectOp::kByteLoad, program.types.Make(Scalar::kUint),
                  VectorOf(Scalar::kUint, words));
  }

  ExprId ByteStore(int words) {
    if (!HasCount(2, 2) || !Take(0, program.types.Make(Scalar::kUint)) ||
        !Take(1, VectorOf(Scalar::kUint, words)))
      return Error();
    return Finish(ObjectOp::kStore, program.types.Void());
  }

  ExprId Atomic(int) { return CheckAtomic(*this, object_); }

  ExprId GetDimensions(int) { return CheckGetDimensions(*this, object_); }

  ExprId SamplePosition(int) {
    if (!traits_.is_multisampled) return Unknown();
    const ExprId count = Finish(ObjectOp::kTextureSamples, program.types.Make(Scalar::kInt));
    return CheckSamplePosition(*this, Convert(count, program.types.Make(Scalar::kUint)));
  }

  ExprId SubpassLoad(int) {
    const std::size_t count = InfoOf(kind_).is_multisampled ? 1 : 0;
    if (!ThisStage().draws_pixels) return Unusable(0);
    if (!HasCount(count, count) || (count == 1 && !Take(0, program.types.Make(Scalar::kInt))))
      return Error();
    return Finish(ObjectOp::kSubpassLoad, Element());
  }

  ExprId Unsupported(int) { return Fail(name_span, diag::MethodUnsupported, name, ObjectName()); }
  ExprId Unusable(int) { return Fail(name_span, diag::ObjectUnusable, name, ThisStage().name); }
  // Refuses a method that the object does not have.
  ExprId Unknown() {
    return kind_ == ObjectKind::kOther ? Unusable(0)
                                       : Fail(name_span, diag::MethodUnknown, ObjectName(), name);
  }

 private:
  // Reports and returns false for a clamp in a stage that has no level of detail to clamp.
  bool HasLevelToClamp() const {
    if (!clamp_ || ThisStage().has_neighbours) return true;
    diagnostics.Report(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
    return false;
  }
  void WarnOfLevel(std::string_view level) const {
    if (!ThisStage().has_neighbours)
      diagnostics.Report(name_span, diag::MethodLevelZero, name, ThisStage().name, level);
  }
  // Takes a sampler, a coordinate and a reference value, the first of `least` arguments.
  bool TakeCompare(std::size_t least) {
    return TakeSample(least, ObjectKind::kSamplerComparison) && TakeFloats(2, 1);
  }
  // Checks the gather of four components of this kind, whose arguments before the offsets are
  // `least`.
  ExprId GatherAfter(std::size_t least, ObjectKind sampler, ObjectOp op, Scalar kind) {
    const std::size_t given = arguments.size();
    const bool has_four = traits_.offset != 0 && (given == least + 4 || given == least + 5);
    if (has_four && given == least + 5 && (!IsAtLeast(5, 0) || !TakeStatus())) return Error();
    if ((!has_four && !CheckCount(least)) || !TakeSampler(sampler) ||
        !TakeFloats(1, traits_.coordinates) || (least == 3 && !TakeFloats(2, 1)))
      return Error();
    // The place may be written four times.
    std::vector<ExprId> steps;
    for (std::size_t i = 2; has_four && i < arguments_.size(); ++i) {
      if (IsPure(program, arguments_[i])) continue;
      const auto place = temporaries.Make(arguments_[i]);
      steps.push_back(place.prologue);
      arguments_[i] = Make().Ref(place.var);
    }
    const TypeId four = program.types.Vector(kind, 4);
    if (has_four && status_) return After(*this, steps, GatherWithStatus(least, op, four));
    const std::size_t end = has_four ? given : std::min(given, least + 1);
    for (std::size_t i = least; i < end; ++i) {
      if (!TakeOffset(i, OffsetsOf(true, program.profile))) return Error();
    }
    return After(*this, steps, Finish(op, four));
  }
  // A gather for each of the four offsets from argument `first` on, which have one status: that of
  // the first of them whose texels are not all in memory, since CheckAccessFullyMapped asks about
  // all that the method read (its page in Direct3D's documentation; DXC has that of the first).
  ExprId GatherWithStatus(std::size_t first, ObjectOp op, TypeId type) {
    const std::vector<ExprId> leading = arguments_;
    const ExprId target = status_;
    const VarId all = temporaries.Make(Make().Uint(0)).var;
    const VarId one = temporaries.Make(Make().Uint(0)).var;
    std::vector<ExprId> steps, texels;
    for (int i = 0; i < 4; ++i) {
      arguments_.clear();
      for (const ExprId argument : leading) arguments_.push_back(Clone(program, argument));
      status_ = Make().Ref(i == 0 ? all : one);
      if (!TakeOffset(first + static_cast<std::size_t>(i), OffsetsOf(true, program.profile)))
        return Error();
      const auto gathered = temporaries.Make(Finish(op, type));
      steps.push_back(gathered.prologue);
      texels.push_back(Make().Swizzled(Make().Ref(gathered.var), {i}));
      if (i == 0) continue;
      const ExprId is_mapped = Make().IntrinsicOf(
          Intrinsic::kCheckAccessFullyMapped, program.types.Make(Scalar::kBool), {Make().Ref(all)});
      const Conditional later{is_mapped, Make().Ref(one), Make().Ref(all)};
      steps.push_back(Make().AssignTo(Make().Ref(all), Make().Add(TypeIdOf(status_), later)));
    }
    steps.push_back(Make().AssignTo(target, Convert(Make().Ref(all), TypeIdOf(target))));
    return After(*this, steps, Make().ConstructOf(type, texels));
  }
  // Adds the offset, the last argument, to the texel's location: GLSL has no texelFetchOffset of
  // multisampled textures.
  void AddOffset() {
    const ExprId offset = arguments_.back();
    arguments_.pop_back();
    arguments_[1] = Moved(Make(), program, arguments_[1], offset);
  }
  // Reports and returns false unless the profile has the method.
  bool IsAtLeast(int major, int minor) const {
    if (program.profile.IsAtLeast(major, minor)) return true;
    diagnostics.Report(name_span, diag::IntrinsicProfile, name,
                       fmt::format("{}_{}_{}", ThisStage().prefix, major, minor),
                       program.profile.name);
    return false;
  }
  ExprId Compare(ObjectOp op) {
    if (!TakeCompare(3) || !HasLevelToClamp() || !TakeOffset(3)) return Error();
    return Finish(op, program.types.Make(Scalar::kFloat));
  }
  std::string ObjectName() const { return program.types.Name(TypeIdOf(object_)); }
  TypeId Element() { return ElementOf(program.types, TypeOf(object_)); }
  ExprId Finish(ObjectOp op, TypeId type) {
    VarId texel;
    if (status_) {
      const TypeId four = program.types.Vector(program.types[type].scalar, 4);
      texel = temporaries.Make(Make().ZeroOf(ComparesOnce(op) ? type : four)).var;
    }
    const auto count = static_cast<std::uint32_t>(arguments_.size());
    if (clamp_) arguments_.push_back(clamp_);
    if (status_) arguments_.push_back(Make().Ref(texel));
    List<ExprId> list = program.expr_lists.Add(arguments_);
    list.size = count;
    const ObjectCall call{op, list, bool(clamp_), bool(status_)};
    if (!status_) return Make().Add(type, call);
    const ExprId value = Make().Add(program.types.Make(Scalar::kUint), call);
    const ExprId assign = Make().AssignTo(status_, Convert(value, TypeIdOf(status_)));
    return Make().CommaOf(assign, ConvertExplicit(program, Make().Ref(texel), type, temporaries));
  }
  static bool ComparesOnce(ObjectOp op) {
    using enum ObjectOp;
    return op == kSampleCmp || op == kSampleCmpLevelZero || op == kSampleCmpLevel ||
           op == kSampleCmpBias || op == kSampleCmpGrad;
  }

  // Reports and returns false unless there are `least` arguments and perhaps an offset. From 5.0 on
  // a clamp of the level of detail may come after it, of a sample that does not name the level, and
  // a status at the end (Direct3D 11.2's tiled resources); both are taken here.
  bool CheckCount(std::size_t least) {
    const std::size_t most = least + (traits_.offset != 0 ? 1 : 0);
    const bool may_clamp = name == "Sample" || name == "SampleBias" || name == "SampleGrad" ||
                           name == "SampleCmp" || name == "SampleCmpBias" ||
                           name == "SampleCmpGrad";
    const std::size_t all = most + (may_clamp ? 2 : 1), given = arguments.size();
    const bool has_status = given == all && RootOf(program, arguments.back());
    if (given <= most || given > all || (given == all && !has_status)) return HasCount(least, most);
    return IsAtLeast(5, 0) && (!may_clamp || TakeClamp(most)) && (!has_status || TakeStatus());
  }
  bool TakeClamp(std::size_t i) {
    const auto value = Converted(i, program.types.Make(Scalar::kFloat));
    if (value) clamp_ = *value;
    return value.has_value();
  }
  bool TakeStatus() {
    if (!TraitsOf(kind_).texel && !TraitsOf(kind_).coordinates) {
      diagnostics.Report(name_span, diag::MethodStatus, name, "a buffer");
      return false;
    }
    const std::size_t last = arguments.size() - 1;
    status_ = arguments[last];
    return IsTargetOf(last, program.types.Make(Scalar::kUint));
  }

  bool TakeSampler(ObjectKind kind) {
    const Type& type = ArgumentType(0);
    if (type.kind != TypeKind::kObject || type.object != kind) {
      BadArgument(0,
                  kind == ObjectKind::kSampler ? "a `SamplerState`" : "a `SamplerComparisonState`");
      return false;
    }
    arguments_.push_back(arguments[0]);
    return true;
  }

  bool Take(std::size_t i, TypeId type) {
    const auto value = Converted(i, type);
    if (value) arguments_.push_back(*value);
    return value.has_value();
  }
  bool TakeFloats(std::size_t i, int count) { return Take(i, VectorOf(Scalar::kFloat, count)); }
  // Takes a sampler and a coordinate, the first of `least` arguments.
  bool TakeSample(std::size_t least, ObjectKind sampler = ObjectKind::kSampler) {
    return CheckCount(least) && TakeSampler(sampler) && TakeFloats(1, traits_.coordinates);
  }
  // Checks a load whose one argument is the place to read.
  ExprId LoadAt(ObjectOp op, TypeId place, TypeId result) {
    return CheckCount(1) && Take(0, place) ? Finish(op, result) : Error();
  }

  // Takes argument `i`, an optional offset in texels.
  bool TakeOffset(std::size_t i, OffsetRange range = {}) {
    if (i >= arguments.size() || traits_.offset == 0) return true;
    const auto value = Converted(i, VectorOf(Scalar::kInt, traits_.offset));
    if (!value) return false;
    // The place of a read is not a part of a stage's interface with another.
    if (program.is_interface_only) return true;
    const auto constant = EvaluateConstant(program, *value);
    if (!constant) {
      arguments_.push_back(*value);  // KnowOffsets finds its value, or reports it
      return true;
    }
    // A clamp and a status come after an offset, which has to be given then.
    const bool is_zero = std::ranges::all_of(constant->components, [](double x) { return x == 0; });
    if (is_zero && (clamp_ || status_)) return true;
    Builder builder(program, SpanOf(arguments[i]));
    std::vector<ExprId> texels;
    for (const double texel : constant->components) {
      const int number = static_cast<int>(texel);
      if (!range.Has(number)) {
        diagnostics.Report(SpanOf(arguments[i]), diag::TextureOffsetRange, number, name,
                           range.least, range.most);
        return false;
      }
      texels.push_back(builder.Int(number));
    }
    arguments_.push_back(texels.size() == 1 ? texels[0]
                                            : builder.ConstructOf(TypeIdOf(*value), texels));
    return true;
  }

  ExprId object_;
  ObjectKind kind_;
  TextureTraits traits_;
  std::vector<ExprId> arguments_;
  ExprId clamp_;
  ExprId status_;  // as the user wrote it
};

// The property that an object must have for a method to exist.
enum class Needs : std::uint8_t {
  kNothing,
  kSampling,
  kComparison,
  kGathering,
  kTexels,  // a cube texture does not have texels to load
  kReading,
  kWriting,
  kAppending,
  kConsuming,
  kCounting,
  kElements,  // an append or consume buffer does not let them be named
};
using enum Needs;

bool Offers(ObjectKind kind, Needs needs) {
  const TextureTraits traits = TraitsOf(kind);
  switch (needs) {
    case kNothing: return true;
    case kSampling: return traits.coordinates != 0;
    case kComparison: return traits.gradient != 0;
    case kGathering: return traits.can_gather;
    case kTexels: return traits.texel != 0;
    case kReading: return !IsWritable(kind);
    case kWriting: return IsWritable(kind);
    case kAppending: return kind == ObjectKind::kAppendStructuredBuffer;
    case kConsuming: return kind == ObjectKind::kConsumeStructuredBuffer;
    case kCounting: return IsStructured(kind) && IsWritable(kind) && HasNamedElements(kind);
    case kElements: return HasNamedElements(kind);
  }
  return false;
}

using Check = ExprId (MethodCheck::*)(int detail);

struct Method {
  std::string_view name;
  Needs needs;
  Check check;
  int detail = 0;  // the ObjectOp of the call; the number of words of a ByteLoad or ByteStore
  Staged staged = {};
};

constexpr auto kTextureMethods = [] {
  using enum ObjectOp;
  const auto gather = [](std::string_view name, ObjectOp op) {
    return Method{name, kGathering, &MethodCheck::Gather, static_cast<int>(op)};
  };
  const auto gather_cmp = [](std::string_view name) {
    return Method{name, kGathering, &MethodCheck::GatherCmp, static_cast<int>(kGatherCmp)};
  };
  return std::to_array<Method>({
      {"SampleLevel", kSampling, &MethodCheck::SampleLevel},
      {"SampleGrad", kSampling, &MethodCheck::SampleGrad},
      {"Sample", kSampling, &MethodCheck::Sample},
      {"SampleBias", kSampling, &MethodCheck::SampleBias},
      {"SampleCmp", kComparison, &MethodCheck::SampleCmp},
      {"SampleCmpLevelZero", kComparison, &MethodCheck::SampleCmpLevelZero},
      gather("Gather", kGather),
      gather("GatherRed", kGather),
      gather("GatherGreen", kGatherGreen),
      gather("GatherBlue", kGatherBlue),
      gather("GatherAlpha", kGatherAlpha),
      {"Load", kTexels, &MethodCheck::TextureLoad},
      {"GetDimensions", kNothing, &MethodCheck::GetDimensions},
      {"SampleCmpBias", kComparison, &MethodCheck::SampleCmpBias, static_cast<int>(kSampleCmpBias)},
      {"SampleCmpGrad", kComparison, &MethodCheck::SampleCmpGrad},
      {"SampleCmpLevel", kComparison, &MethodCheck::SampleCmpWith,
       static_cast<int>(kSampleCmpLevel)},
      gather_cmp("GatherCmp"),
      gather_cmp("GatherCmpRed"),
      gather_cmp("GatherCmpGreen"),
      gather_cmp("GatherCmpBlue"),
      gather_cmp("GatherCmpAlpha"),
      {"CalculateLevelOfDetail", kSampling, &MethodCheck::LevelOfDetail,
       static_cast<int>(kLevelOfDetail)},
      {"CalculateLevelOfDetailUnclamped", kSampling, &MethodCheck::LevelOfDetail,
       static_cast<int>(kLevelOfDetailUnclamped)},
      {"GetSamplePosition", kReading, &MethodCheck::SamplePosition},
      {"GatherRaw", kReading, &MethodCheck::Unsupported},
  });
}();

// The methods of typed and structured buffers.
constexpr Method kBufferMethods[] = {
    {"Load", kElements, &MethodCheck::BufferLoad},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions},
    {"Append", kAppending, &MethodCheck::Counter},
    {"Consume", kConsuming, &MethodCheck::Counter},
    {"IncrementCounter", kCounting, &MethodCheck::Counter},
    {"DecrementCounter", kCounting, &MethodCheck::Counter},
};

constexpr Method kByteMethods[] = {
    {"Load", kNothing, &MethodCheck::ByteLoad, 1},
    {"Load2", kNothing, &MethodCheck::ByteLoad, 2},
    {"Load3", kNothing, &MethodCheck::ByteLoad, 3},
    {"Load4", kNothing, &MethodCheck::ByteLoad, 4},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions},
    {"Store", kWriting, &MethodCheck::ByteStore, 1},
    {"Store2", kWriting, &MethodCheck::ByteStore, 2},
    {"Store3", kWriting, &MethodCheck::ByteStore, 3},
    {"Store4", kWriting, &MethodCheck::ByteStore, 4},
    {"InterlockedAdd", kWriting, &MethodCheck::Atomic},
    {"InterlockedAnd", kWriting, &MethodCheck::Atomic},
    {"InterlockedCompareExchange", kWriting, &MethodCheck::Atomic},
    {"InterlockedCompareStore", kWriting, &MethodCheck::Atomic},
    {"InterlockedExchange", kWriting, &MethodCheck::Atomic},
    {"InterlockedMax", kWriting, &MethodCheck::Atomic},
    {"InterlockedMin", kWriting, &MethodCheck::Atomic},
    {"InterlockedOr", kWriting, &MethodCheck::Atomic},
    {"InterlockedXor", kWriting, &MethodCheck::Atomic},
};

constexpr Method kSubpassMethods[] = {{"SubpassLoad", kNothing, &MethodCheck::SubpassLoad}};

std::span<const Method> MethodsOf(ObjectKind kind) {
  switch (InfoOf(kind).category) {
    case ObjectCategory::kTexture: return kTextureMethods;
    case ObjectCategory::kTypedBuffer:
    case ObjectCategory::kStructuredBuffer: return kBufferMethods;
    case ObjectCategory::kByteAddressBuffer: return kByteMethods;
    case ObjectCategory::kSubpass: return kSubpassMethods;
    default: return {};
  }
}

}  // namespace

TextureTraits TraitsOf(ObjectKind kind) {
  const ObjectInfo& info = InfoOf(kind);
  if (info.category != ObjectCategory::kTexture) return {};
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

TypeId ElementOf(TypeTable& types, const Type& object) {
  return object.element ? object.element : types.Vector(Scalar::kFloat, 4);
}

ExprId Moved(Builder builder, Program& program, ExprId location, ExprId offset) {
  const TypeId type = rules::TypeIdOf(program, location);
  if (TypeOf(program, offset).Components() < program.types[type].Components())
    offset = builder.ConstructOf(type, {offset, builder.Int(0)});
  return builder.BinaryOf(BinaryOp::kAdd, location, offset);
}

ExprId MakeObjectCall(Builder builder, Program& program, TypeId type, ObjectOp op,
                      std::span<const ExprId> arguments) {
  return builder.Add(type, ObjectCall{op, program.expr_lists.Add(arguments)});
}

ExprId CheckMethodCall(const IntrinsicCheck& call, ExprId object) {
  const Type type = call.TypeOf(object);
  if (type.kind == TypeKind::kError || call.HasErrorArgument()) return call.Error();
  if (type.kind != TypeKind::kObject) {
    return call.Fail(call.name_span, diag::MethodUnknown,
                     call.program.types.Name(call.TypeIdOf(object)), call.name);
  }
  if (IsOrdered(type.object) && !call.ThisStage().draws_pixels)
    return call.Fail(call.name_span, diag::ObjectUnusable, call.name, call.ThisStage().name);
  MethodCheck check(call, object, type.object);
  const std::span<const Method> methods = MethodsOf(type.object);
  const auto found = std::ranges::find_if(methods, [&](const Method& each) {
    return each.name == call.name && Offers(type.object, each.needs);
  });
  if (found == methods.end()) return check.Unknown();
  const ExprId value = StandInFor(call, found->staged);
  return value ? value : (check.*found->check)(found->detail);
}

}  // namespace clipc::rules
