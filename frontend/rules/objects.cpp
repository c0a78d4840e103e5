// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/objects.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/spelling.h"
#include "frontend/rules/constant.h"
#include "frontend/rules/object_call.h"
#include "ir/access.h"

namespace clipc::rules {
namespace {

// A method call in progress: the object, and the operands of the ObjectCall made so far.
class MethodCheck : IntrinsicCheck {
 public:
  MethodCheck(const IntrinsicCheck& call, ExprId object, ObjectKind kind)
      : IntrinsicCheck(call),
        object_(object),
        kind_(kind),
        traits_(rules::TraitsOf(kind)),
        operands_{{OperandKind::kObject, object}} {}

  // Checks a method whose arguments are the operands of `op`.
  template <ObjectOp op>
  ExprId SampleBy() {
    return TakeSample(op) && TakeRest(op) ? Finish(op, ResultOf(op)) : Error();
  }

  // Checks a Sample. In a stage without neighbours to take a level of detail from, fxc and DXC
  // refuse (X4532), and OpenGL reads level 0.
  ExprId Sample() {
    if (!TakeSample(ObjectOp::kSample)) return Error();
    const bool has_neighbours = ThisStage().has_neighbours;
    if (!has_neighbours) operands_.push_back({OperandKind::kLevel, Make().Float(0)});
    if (!TakeRest(ObjectOp::kSample)) return Error();
    WarnOfLevel("0");
    return Finish(has_neighbours ? ObjectOp::kSample : ObjectOp::kSampleLevel, Element());
  }

  ExprId SampleBias() {
    if (!TakeSample(ObjectOp::kSampleBias) || !TakeRest(ObjectOp::kSampleBias)) return Error();
    WarnOfLevel("0 plus the bias");
    if (ThisStage().has_neighbours) return Finish(ObjectOp::kSampleBias, Element());
    std::ranges::find(operands_, OperandKind::kBias, &NamedOperand::kind)->kind =
        OperandKind::kLevel;
    return Finish(ObjectOp::kSampleLevel, Element());
  }

  ExprId SampleCmp() {
    WarnOfLevel("0");
    if (!TakeSample(ObjectOp::kSampleCmp) || !TakeRest(ObjectOp::kSampleCmp)) return Error();
    const bool has_neighbours = ThisStage().has_neighbours;
    return Finish(has_neighbours ? ObjectOp::kSampleCmp : ObjectOp::kSampleCmpLevelZero,
                  program.types.Make(Scalar::kFloat));
  }

  template <ObjectOp op>
  ExprId LevelOfDetail() {
    if (!ThisStage().has_neighbours)
      return Fail(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
    // An element of an array has the level of detail that every other has.
    if (!HasCount(2, 2) || !TakeSampler(ObjectKind::kSampler) ||
        !TakeFloats(OperandKind::kCoordinate, 1, traits_.gradient))
      return Error();
    return Finish(op, ResultOf(op));
  }

  ExprId SampleCmpLevel() { return HasModel(67) ? SampleBy<ObjectOp::kSampleCmpLevel>() : Error(); }
  ExprId SampleCmpGrad() { return HasModel(68) ? SampleBy<ObjectOp::kSampleCmpGrad>() : Error(); }
  ExprId SampleCmpBias() {
    if (!ThisStage().has_neighbours)
      return Fail(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
    return HasModel(68) ? SampleBy<ObjectOp::kSampleCmpBias>() : Error();
  }

  // Checks a gather: after its operands there may be an offset, or one for each of the four texels.
  // GatherCmpGreen, GatherCmpBlue and GatherCmpAlpha are GatherCmp, since only formats of one
  // component are compared (vkd3d's gather-cmp.shader_test, checked against native).
  template <ObjectOp op>
  ExprId Gather() {
    return GatherBy(op);
  }
  ExprId GatherBy(ObjectOp op) {
    const std::size_t least = InfoOf(op).least - 1u;
    const std::size_t given = arguments.size();
    const bool has_four = traits_.offset != 0 && (given == least + 4 || given == least + 5);
    if (has_four && given == least + 5 && (!HasModel(50) || !TakeStatus())) return Error();
    if ((!has_four && !CheckCount(least)) || !TakeNamed(op)) return Error();
    // The place may be written four times.
    std::vector<ExprId> steps;
    for (NamedOperand& operand : operands_) {
      const bool is_place = has_four && operand.kind >= OperandKind::kCoordinate;
      if (!is_place || IsPure(program, operand.expr)) continue;
      const auto place = temporaries.Make(operand.expr);
      steps.push_back(place.prologue);
      operand.expr = Make().Ref(place.var);
    }
    const TypeId four = ResultOf(op);
    if (has_four && status_) return After(*this, steps, GatherWithStatus(least, op, four));
    const std::size_t end = has_four ? given : std::min(given, least + 1);
    for (std::size_t i = least; i < end; ++i) {
      if (!TakeOffset(i, OffsetsOf(true, program.profile))) return Error();
    }
    return After(*this, steps, Finish(op, four));
  }

  ExprId TextureLoad() {
    if (IsImage(kind_)) return LoadAt(ObjectOp::kImageLoad, VectorOf(Scalar::kInt, traits_.texel));
    if (!CheckCount(traits_.is_multisampled ? 2 : 1)) return Error();
    TypeTable& types = program.types;
    const int texel = traits_.texel;
    ExprId prologue;
    if (traits_.is_multisampled) {
      if (!Take(OperandKind::kPlace, 0, VectorOf(Scalar::kInt, texel)) ||
          !Take(OperandKind::kLevel, 1, types.Make(Scalar::kInt)))
        return Error();
    } else {
      const auto location = Converted(0, types.Vector(Scalar::kInt, texel + 1));
      if (!location) return Error();
      const auto parts = Split(*location, texel, texel);
      operands_.push_back({OperandKind::kPlace, parts.leading});
      operands_.push_back({OperandKind::kLevel, parts.last});
      prologue = parts.prologue;
    }
    if (!TakeOffset(traits_.is_multisampled ? 2 : 1)) return Error();
    if (traits_.is_multisampled) AddOffset();
    return After(*this, {&prologue, 1}, Finish(ObjectOp::kTextureLoad, Element()));
  }

  ExprId BufferLoad() {
    return LoadAt(IsStructured(kind_) ? ObjectOp::kStructuredLoad : ObjectOp::kBufferLoad,
                  program.types.Make(Scalar::kInt));
  }

  ExprId Counter() { return CheckCounter(*this, object_); }

  template <int words>
  ExprId ByteLoad() {
    if (!CheckCount(1) || !Take(OperandKind::kPlace, 0, program.types.Make(Scalar::kUint)))
      return Error();
    return Finish(ObjectOp::kByteLoad, VectorOf(Scalar::kUint, words));
  }

  template <int words>
  ExprId ByteStore() {
    if (!HasCount(2, 2) || !Take(OperandKind::kPlace, 0, program.types.Make(Scalar::kUint)) ||
        !Take(OperandKind::kValue, 1, VectorOf(Scalar::kUint, words)))
      return Error();
    return Finish(ObjectOp::kStore, program.types.Void());
  }

  ExprId Atomic() { return CheckAtomic(*this, object_); }

  ExprId GetDimensions() { return CheckGetDimensions(*this, object_); }

  ExprId SamplePosition() {
    if (!traits_.is_multisampled) return Unknown();
    const ExprId count = Finish(ObjectOp::kTextureSamples, program.types.Make(Scalar::kInt));
    return CheckSamplePosition(*this, Convert(count, program.types.Make(Scalar::kUint)));
  }

  ExprId SubpassLoad() {
    const std::size_t count = InfoOf(kind_).is_multisampled ? 1 : 0;
    if (!ThisStage().draws_pixels) return Unusable();
    if (!HasCount(count, count) ||
        (count == 1 && !Take(OperandKind::kSample, 0, program.types.Make(Scalar::kInt))))
      return Error();
    return Finish(ObjectOp::kSubpassLoad, Element());
  }

  ExprId Unsupported() { return Fail(name_span, diag::MethodUnsupported, name, ObjectName()); }
  ExprId Unusable() { return Fail(name_span, diag::ObjectUnusable, name, ThisStage().name); }
  // Refuses a method that the object does not have, but perhaps one of the names that are near.
  ExprId Unknown(std::span<const std::string_view> near = {}) {
    if (kind_ == ObjectKind::kOther) return Unusable();
    const std::string tail = near.empty() ? "" : fmt::format("; did you mean `{}`?", near.front());
    Diagnostic& report =
        diagnostics.Report(name_span, diag::MethodUnknown, ObjectName(), name, tail);
    if (!near.empty()) report.Fix(name_span, std::string(near.front()));
    return Error();
  }
  // Reports and returns false unless the profile has the method, which came with this model.
  bool HasModel(int model) const {
    if (program.profile.HasModel(model)) return true;
    diagnostics.Report(name_span, diag::IntrinsicProfile, name,
                       fmt::format("{}_{}_{}", ThisStage().prefix, model / 10, model % 10),
                       program.profile.name);
    return false;
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
  // A gather for each of the four offsets from argument `first` on, which have one status: that of
  // the first of them whose texels are not all in memory, since CheckAccessFullyMapped asks about
  // all that the method read (its page in Direct3D's documentation; DXC has that of the first).
  ExprId GatherWithStatus(std::size_t first, ObjectOp op, TypeId type) {
    const std::vector<NamedOperand> leading = operands_;
    const ExprId target = status_;
    const VarId all = temporaries.Make(Make().Uint(0)).var;
    const VarId one = temporaries.Make(Make().Uint(0)).var;
    std::vector<ExprId> steps, texels;
    for (int i = 0; i < 4; ++i) {
      operands_.clear();
      for (const auto& [kind, operand] : leading)
        operands_.push_back({kind, Clone(program, operand)});
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
  // Adds the offset, if there is one, to the texel's place: GLSL has no texelFetchOffset of
  // multisampled textures.
  void AddOffset() {
    if (operands_.back().kind != OperandKind::kOffset) return;
    const ExprId offset = operands_.back().expr;
    operands_.pop_back();
    ExprId& place = std::ranges::find(operands_, OperandKind::kPlace, &NamedOperand::kind)->expr;
    place = Moved(Make(), program, place, offset);
  }
  std::string ObjectName() const { return program.types.Name(TypeIdOf(object_)); }
  TypeId Element() { return ElementOf(program.types, TypeOf(object_)); }
  // The type of a read of a texture.
  TypeId ResultOf(ObjectOp op) {
    const ObjectResult result = InfoOf(op).result;
    if (result == ObjectResult::kElement) return Element();
    if (result == ObjectResult::kFloat) return program.types.Make(Scalar::kFloat);
    const bool compares = Takes(op, OperandKind::kReference);
    return program.types.Vector(compares ? Scalar::kFloat : program.types[Element()].scalar, 4);
  }
  ExprId Finish(ObjectOp op, TypeId type) {
    if (clamp_) operands_.push_back({OperandKind::kClamp, clamp_});
    if (!status_) return Make().ObjectCallOf(op, type, operands_);
    const bool compares = InfoOf(op).result == ObjectResult::kFloat;
    const TypeId four = program.types.Vector(program.types[type].scalar, 4);
    const VarId texel = temporaries.Make(Make().ZeroOf(compares ? type : four)).var;
    operands_.push_back({OperandKind::kTexel, Make().Ref(texel)});
    const ExprId value = Make().ObjectCallOf(op, program.types.Make(Scalar::kUint), operands_);
    const ExprId assign = Make().AssignTo(status_, Convert(value, TypeIdOf(status_)));
    return Make().CommaOf(assign, ConvertExplicit(program, Make().Ref(texel), type, temporaries));
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
    return HasModel(50) && (!may_clamp || TakeClamp(most)) && (!has_status || TakeStatus());
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
    operands_.push_back({OperandKind::kSampler, arguments[0]});
    return true;
  }

  // Takes argument `i` as the operand of that kind.
  bool Take(OperandKind kind, std::size_t i, TypeId type) {
    const auto value = Converted(i, type);
    if (value) operands_.push_back({kind, *value});
    return value.has_value();
  }
  bool TakeFloats(OperandKind kind, std::size_t i, int count) {
    return Take(kind, i, VectorOf(Scalar::kFloat, count));
  }
  // Takes the operands that say what a sample reads: sampler, coordinate and reference.
  bool TakeNamed(ObjectOp op) {
    const bool compares = Takes(op, OperandKind::kReference);
    return TakeSampler(compares ? ObjectKind::kSamplerComparison : ObjectKind::kSampler) &&
           TakeFloats(OperandKind::kCoordinate, 1, traits_.coordinates) &&
           (!compares || TakeFloats(OperandKind::kReference, 2, 1));
  }
  // Checks the number of arguments, and takes those operands.
  bool TakeSample(ObjectOp op) {
    return HasFloats(Takes(op, OperandKind::kReference)) && CheckCount(InfoOf(op).least - 1u) &&
           TakeNamed(op) && (!AsksNeighbours(op) || HasLevelToClamp());
  }
  // Takes the other operands, which are numbers, gradients and an offset.
  bool TakeRest(ObjectOp op) {
    std::size_t i = 0;
    for (const OperandSlot& slot : InfoOf(op).Slots().subspan(1)) {
      const std::size_t argument = i++;
      if (slot.kind <= OperandKind::kReference) continue;
      const bool is_step = slot.kind == OperandKind::kDdx || slot.kind == OperandKind::kDdy;
      if (slot.kind == OperandKind::kOffset
              ? !TakeOffset(argument)
              : !TakeFloats(slot.kind, argument, is_step ? traits_.gradient : 1))
        return false;
    }
    return true;
  }
  // Reports and returns false for a texture of integers that a sampler cannot read: DXC's
  // uintSample.hlsl and sampleInteger.hlsl. A gather takes integers (its texture.gather-red.hlsl).
  bool HasFloats(bool compares) {
    if (IsFloat(program.types[Element()].scalar)) return true;
    if (!compares && program.profile.IsAtLeast(6, 7)) return true;
    diagnostics.Report(name_span, diag::MethodOfIntegers, name, ObjectName(),
                       compares ? "a sampler compares floats only"
                                : "before shader model 6.7 a sampler filters floats only");
    return false;
  }
  // Checks a load whose one argument is the place to read.
  ExprId LoadAt(ObjectOp op, TypeId place) {
    return CheckCount(1) && Take(OperandKind::kPlace, 0, place) ? Finish(op, Element()) : Error();
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
      operands_.push_back(
          {OperandKind::kOffset, *value});  // KnowOffsets finds its value, or reports it
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
    const ExprId offset =
        texels.size() == 1 ? texels[0] : builder.ConstructOf(TypeIdOf(*value), texels);
    operands_.push_back({OperandKind::kOffset, offset});
    return true;
  }

  ExprId object_;
  ObjectKind kind_;
  TextureTraits traits_;
  std::vector<NamedOperand> operands_;
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
    // Microsoft's pages list no Texture3D under SampleCmp and SampleCmpLevelZero.
    case kComparison: return traits.gradient != 0 && InfoOf(kind).axes <= 2;
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

using Check = ExprId (MethodCheck::*)();

struct Method {
  std::string_view name;
  Needs needs;
  Check check;
  int model = 10;  // the first shader model that has it, 41 for 4.1
  Staged staged = {};
};

// "Minimum Shader Model" of the methods' pages in Microsoft's HLSL reference, and the model of the
// instructions gather4, lod and samplepos, sm4.1, and gather4_c, sm5. fxc makes the samples that
// have 10 instructions of Direct3D 9.

constexpr Method kTextureMethods[] = {
    {"SampleLevel", kSampling, &MethodCheck::SampleBy<ObjectOp::kSampleLevel>},
    {"SampleGrad", kSampling, &MethodCheck::SampleBy<ObjectOp::kSampleGrad>},
    {"Sample", kSampling, &MethodCheck::Sample},
    {"SampleBias", kSampling, &MethodCheck::SampleBias},
    {"SampleCmp", kComparison, &MethodCheck::SampleCmp, 40},
    {"SampleCmpLevelZero", kComparison, &MethodCheck::SampleBy<ObjectOp::kSampleCmpLevelZero>, 40},
    {"Gather", kGathering, &MethodCheck::Gather<ObjectOp::kGather>, 41},
    {"GatherRed", kGathering, &MethodCheck::Gather<ObjectOp::kGather>, 41},
    {"GatherGreen", kGathering, &MethodCheck::Gather<ObjectOp::kGatherGreen>, 50},
    {"GatherBlue", kGathering, &MethodCheck::Gather<ObjectOp::kGatherBlue>, 50},
    {"GatherAlpha", kGathering, &MethodCheck::Gather<ObjectOp::kGatherAlpha>, 50},
    {"Load", kTexels, &MethodCheck::TextureLoad, 40},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions, 40},
    {"SampleCmpBias", kComparison, &MethodCheck::SampleCmpBias},
    {"SampleCmpGrad", kComparison, &MethodCheck::SampleCmpGrad},
    {"SampleCmpLevel", kComparison, &MethodCheck::SampleCmpLevel},
    {"GatherCmp", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpRed", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpGreen", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpBlue", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpAlpha", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"CalculateLevelOfDetail", kSampling, &MethodCheck::LevelOfDetail<ObjectOp::kLevelOfDetail>,
     41},
    {"CalculateLevelOfDetailUnclamped", kSampling,
     &MethodCheck::LevelOfDetail<ObjectOp::kLevelOfDetailUnclamped>, 41},
    {"GetSamplePosition", kReading, &MethodCheck::SamplePosition, 41},
    {"GatherRaw", kReading, &MethodCheck::Unsupported},
};

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
    {"Load", kNothing, &MethodCheck::ByteLoad<1>},
    {"Load2", kNothing, &MethodCheck::ByteLoad<2>},
    {"Load3", kNothing, &MethodCheck::ByteLoad<3>},
    {"Load4", kNothing, &MethodCheck::ByteLoad<4>},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions},
    {"Store", kWriting, &MethodCheck::ByteStore<1>},
    {"Store2", kWriting, &MethodCheck::ByteStore<2>},
    {"Store3", kWriting, &MethodCheck::ByteStore<3>},
    {"Store4", kWriting, &MethodCheck::ByteStore<4>},
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

ExprId CheckMethodCall(const IntrinsicCheck& call, ExprId object) {
  const Type type = call.TypeOf(object);
  if (type.kind == TypeKind::kError || call.HasErrorArgument()) return call.Error();
  if (type.kind != TypeKind::kObject) {
    return call.Fail(call.name_span, diag::MethodUnknown,
                     call.program.types.Name(call.TypeIdOf(object)), call.name, "");
  }
  if (IsOrdered(type.object) && !call.ThisStage().draws_pixels)
    return call.Fail(call.name_span, diag::ObjectUnusable, call.name, call.ThisStage().name);
  MethodCheck check(call, object, type.object);
  const std::span<const Method> methods = MethodsOf(type.object);
  const auto found = std::ranges::find_if(methods, [&](const Method& each) {
    return each.name == call.name && Offers(type.object, each.needs);
  });
  if (found == methods.end()) {
    std::vector<std::string_view> names;
    for (const Method& each : methods) {
      if (Offers(type.object, each.needs)) names.push_back(each.name);
    }
    return check.Unknown(NearNames(call.name, names));
  }
  if (!call.program.is_interface_only && !check.HasModel(found->model)) return call.Error();
  const ExprId value = StandInFor(call, found->staged);
  return value ? value : (check.*found->check)();
}

}  // namespace clipc::rules
