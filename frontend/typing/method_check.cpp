// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/method_check.h"

#include <algorithm>

#include "ir/access.h"

namespace clipc::typing {

ExprId MethodCheck::Sample() {
  if (!TakeSample(ObjectOp::kSample)) return Error();
  const bool has_neighbours = ThisStage().has_neighbours;
  if (!has_neighbours) operands_.push_back({OperandKind::kLevel, Make().Float(0)});
  if (!TakeRest(ObjectOp::kSample)) return Error();
  WarnOfLevel("0");
  return Finish(has_neighbours ? ObjectOp::kSample : ObjectOp::kSampleLevel, Element());
}

ExprId MethodCheck::SampleBias() {
  if (!TakeSample(ObjectOp::kSampleBias) || !TakeRest(ObjectOp::kSampleBias)) return Error();
  WarnOfLevel("0 plus the bias");
  if (ThisStage().has_neighbours) return Finish(ObjectOp::kSampleBias, Element());
  std::ranges::find(operands_, OperandKind::kBias, &NamedOperand::kind)->kind = OperandKind::kLevel;
  return Finish(ObjectOp::kSampleLevel, Element());
}

ExprId MethodCheck::SampleCmp() {
  WarnOfLevel("0");
  if (!TakeSample(ObjectOp::kSampleCmp) || !TakeRest(ObjectOp::kSampleCmp)) return Error();
  const bool has_neighbours = ThisStage().has_neighbours;
  return Finish(has_neighbours ? ObjectOp::kSampleCmp : ObjectOp::kSampleCmpLevelZero,
                program.types.Make(Scalar::kFloat));
}

ExprId MethodCheck::LevelOfDetailBy(ObjectOp op) {
  if (!ThisStage().has_neighbours)
    return Fail(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
  // An element of an array has the level of detail that every other has.
  if (!HasCount(2, 2) || !TakeSampler(ObjectKind::kSampler) ||
      !TakeFloats(OperandKind::kCoordinate, 1, traits_.gradient))
    return Error();
  return Finish(op, ResultOf(op));
}

ExprId MethodCheck::SampleCmpBias() {
  if (!ThisStage().has_neighbours)
    return Fail(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
  return HasModel(68) ? SampleBy<ObjectOp::kSampleCmpBias>() : Error();
}

ExprId MethodCheck::GatherBy(ObjectOp op) {
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

ExprId MethodCheck::TextureLoad() {
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

ExprId MethodCheck::BufferLoad() {
  return LoadAt(IsStructured(kind_) ? ObjectOp::kStructuredLoad : ObjectOp::kBufferLoad,
                program.types.Make(Scalar::kInt));
}

ExprId MethodCheck::ByteLoadOf(int words) {
  if (!CheckCount(1) || !Take(OperandKind::kPlace, 0, program.types.Make(Scalar::kUint)))
    return Error();
  return Finish(ObjectOp::kByteLoad, VectorOf(Scalar::kUint, words));
}

ExprId MethodCheck::ByteStoreOf(int words) {
  if (!HasCount(2, 2) || !Take(OperandKind::kPlace, 0, program.types.Make(Scalar::kUint)) ||
      !Take(OperandKind::kValue, 1, VectorOf(Scalar::kUint, words)))
    return Error();
  return Finish(ObjectOp::kStore, program.types.Void());
}

ExprId MethodCheck::SamplePosition() {
  if (!traits_.is_multisampled) return Unknown();
  const ExprId count = Finish(ObjectOp::kTextureSamples, program.types.Make(Scalar::kInt));
  return CheckSamplePosition(*this, Convert(count, program.types.Make(Scalar::kUint)));
}

ExprId MethodCheck::SubpassLoad() {
  const std::size_t count = InfoOf(kind_).is_multisampled ? 1 : 0;
  if (!ThisStage().draws_pixels) return Unusable();
  if (!HasCount(count, count) ||
      (count == 1 && !Take(OperandKind::kSample, 0, program.types.Make(Scalar::kInt))))
    return Error();
  return Finish(ObjectOp::kSubpassLoad, Element());
}

ExprId MethodCheck::Append() {
  if (!HasCount(1, 1) || !Take(OperandKind::kValue, 0, Element())) return Error();
  return Finish(ObjectOp::kAppend, program.types.Void());
}

ExprId MethodCheck::RestartStrip() {
  return HasCount(0, 0) ? Finish(ObjectOp::kRestartStrip, program.types.Void()) : Error();
}

ExprId MethodCheck::Unknown(std::span<const std::string_view> near) {
  if (kind_ == ObjectKind::kOther) return Unusable();
  const std::string tail = near.empty() ? "" : fmt::format("; did you mean `{}`?", near.front());
  Diagnostic& report = diagnostics.Report(name_span, diag::MethodUnknown, ObjectName(), name, tail);
  if (!near.empty()) report.Fix(name_span, std::string(near.front()));
  return Error();
}

bool MethodCheck::HasModel(int model) const {
  if (program.profile.HasModel(model)) return true;
  diagnostics.Report(name_span, diag::IntrinsicProfile, name,
                     fmt::format("{}_{}_{}", ThisStage().prefix, model / 10, model % 10),
                     program.profile.name);
  return false;
}

void MethodCheck::WarnOfLevel(std::string_view level) const {
  if (!ThisStage().has_neighbours)
    diagnostics.Report(name_span, diag::MethodLevelZero, name, ThisStage().name, level);
}

ExprId MethodCheck::GatherWithStatus(std::size_t first, ObjectOp op, TypeId type) {
  const std::vector<NamedOperand> leading = operands_;
  const ExprId target = status_;
  // The first status has a value before the first read, which writes a texel that is made later:
  // its declaration cannot be that read.
  const auto status = temporaries.Make(Make().Uint(0));
  const VarId all = status.var;
  const VarId one = temporaries.Make(Make().Uint(0)).var;
  std::vector<ExprId> steps{status.prologue}, texels;
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
    const ExprId is_mapped =
        Make().IntrinsicOf(CommonIntrinsic::kCheckAccessFullyMapped,
                           program.types.Make(Scalar::kBool), {Make().Ref(all)});
    const Conditional later{is_mapped, Make().Ref(one), Make().Ref(all)};
    steps.push_back(Make().AssignTo(Make().Ref(all), Make().Add(TypeIdOf(status_), later)));
  }
  steps.push_back(Make().AssignTo(target, Convert(Make().Ref(all), TypeIdOf(target))));
  return After(*this, steps, Make().ConstructOf(type, texels));
}

ExprId MethodCheck::LoadAt(ObjectOp op, TypeId place) {
  return CheckCount(1) && Take(OperandKind::kPlace, 0, place) ? Finish(op, Element()) : Error();
}

}  // namespace clipc::typing
