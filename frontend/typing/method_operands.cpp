// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/typing/constant.h"
#include "frontend/typing/method_check.h"
#include "ir/access.h"

// The operands of a method's ObjectCall, and the call that they make.
namespace clipc::typing {

bool MethodCheck::HasLevelToClamp() const {
  if (!clamp_ || ThisStage().has_neighbours) return true;
  diagnostics.Report(name_span, diag::MethodImplicitLevel, name, ThisStage().name);
  return false;
}

void MethodCheck::AddOffset() {
  if (operands_.back().kind != OperandKind::kOffset) return;
  const ExprId offset = operands_.back().expr;
  operands_.pop_back();
  ExprId& place = std::ranges::find(operands_, OperandKind::kPlace, &NamedOperand::kind)->expr;
  place = Moved(Make(), program, place, offset);
}

TypeId MethodCheck::ResultOf(ObjectOp op) {
  const ObjectResult result = InfoOf(op).result;
  if (result == ObjectResult::kElement) return Element();
  if (result == ObjectResult::kFloat) return program.types.Make(Scalar::kFloat);
  const bool compares = Takes(op, OperandKind::kReference);
  return program.types.Vector(compares ? Scalar::kFloat : program.types[Element()].scalar, 4);
}

ExprId MethodCheck::Finish(ObjectOp op, TypeId type) {
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

bool MethodCheck::CheckCount(std::size_t least) {
  const std::size_t most = least + (traits_.offset != 0 ? 1 : 0);
  const bool may_clamp = name == "Sample" || name == "SampleBias" || name == "SampleGrad" ||
                         name == "SampleCmp" || name == "SampleCmpBias" || name == "SampleCmpGrad";
  const std::size_t all = most + (may_clamp ? 2 : 1), given = arguments.size();
  const bool has_status = given == all && RootOf(program, arguments.back());
  if (given <= most || given > all || (given == all && !has_status)) return HasCount(least, most);
  return HasModel(50) && (!may_clamp || TakeClamp(most)) && (!has_status || TakeStatus());
}

bool MethodCheck::TakeClamp(std::size_t i) {
  const auto value = Converted(i, program.types.Make(Scalar::kFloat));
  if (value) clamp_ = *value;
  return value.has_value();
}

bool MethodCheck::TakeStatus() {
  if (!TraitsOf(kind_).texel && !TraitsOf(kind_).coordinates) {
    diagnostics.Report(name_span, diag::MethodStatus, name, "a buffer");
    return false;
  }
  const std::size_t last = arguments.size() - 1;
  status_ = arguments[last];
  return IsTargetOf(last, program.types.Make(Scalar::kUint));
}

bool MethodCheck::TakeSampler(ObjectKind kind) {
  const Type& type = ArgumentType(0);
  if (type.kind != TypeKind::kObject || type.object != kind) {
    BadArgument(0,
                kind == ObjectKind::kSampler ? "a `SamplerState`" : "a `SamplerComparisonState`");
    return false;
  }
  operands_.push_back({OperandKind::kSampler, arguments[0]});
  return true;
}

bool MethodCheck::Take(OperandKind kind, std::size_t i, TypeId type) {
  const auto value = Converted(i, type);
  if (value) operands_.push_back({kind, *value});
  return value.has_value();
}

bool MethodCheck::TakeFloats(OperandKind kind, std::size_t i, int count) {
  return Take(kind, i, VectorOf(Scalar::kFloat, count));
}

bool MethodCheck::TakeNamed(ObjectOp op) {
  const bool compares = Takes(op, OperandKind::kReference);
  return TakeSampler(compares ? ObjectKind::kSamplerComparison : ObjectKind::kSampler) &&
         TakeFloats(OperandKind::kCoordinate, 1, traits_.coordinates) &&
         (!compares || TakeFloats(OperandKind::kReference, 2, 1));
}

bool MethodCheck::TakeSample(ObjectOp op) {
  return HasFloats(Takes(op, OperandKind::kReference)) && CheckCount(InfoOf(op).least - 1u) &&
         TakeNamed(op) && (!AsksNeighbours(op) || HasLevelToClamp());
}

bool MethodCheck::TakeRest(ObjectOp op) {
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

bool MethodCheck::HasFloats(bool compares) {
  if (IsFloat(program.types[Element()].scalar)) return true;
  if (!compares && program.profile.IsAtLeast(6, 7)) return true;
  diagnostics.Report(name_span, diag::MethodOfIntegers, name, ObjectName(),
                     compares ? "a sampler compares floats only"
                              : "before shader model 6.7 a sampler filters floats only");
  return false;
}

bool MethodCheck::TakeOffset(std::size_t i, OffsetRange range) {
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
      diagnostics.Report(SpanOf(arguments[i]), diag::TextureOffsetRange, number, name, range.least,
                         range.most);
      return false;
    }
    texels.push_back(builder.Int(number));
  }
  const ExprId offset =
      texels.size() == 1 ? texels[0] : builder.ConstructOf(TypeIdOf(*value), texels);
  operands_.push_back({OperandKind::kOffset, offset});
  return true;
}

}  // namespace clipc::typing
