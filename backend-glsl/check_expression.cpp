// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/check_expression.h"

#include <algorithm>
#include <string>
#include <utility>

#include "backend-glsl/writer/wave_call.h"
#include "ir/scalar.h"
#include "ir/std_layout.h"
#include "legalize/es100/loops.h"
#include "legalize/shape.h"
#include "legalize/split_arrays.h"
#include "legalize/word_buffers.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether the operation is a sample that gives the element itself.
bool IsPlainSample(ObjectOp op) {
  return Takes(op, OperandKind::kSampler) && InfoOf(op).result == ObjectResult::kElement;
}

}  // namespace

void TargetReport::Type(TypeId id, Span span) {
  if (std::exchange(seen_types_[id.index], true)) return;
  const ir::Type& type = program_.types[id];
  if (type.kind == TypeKind::kArray) return Type(type.element, span);
  if (type.kind == TypeKind::kStruct) {
    for (const Field& field : program_.types.StructOf(id).fields) {
      Type(field.type, field.span ? field.span : span);
    }
    return;
  }
  if (!type.IsNumeric()) return;
  const Requirement* requirement = RequirementOf(BaseOf(type.scalar));
  if (!requirement || target_.Has(requirement->feature)) return;
  if (!std::exchange(reported_[requirement->feature == Feature::kDoubles ? 0 : 1], true)) {
    Lack(*requirement, span, {});
  }
}

bool ExpressionCheck::MayReportAll() const {
  const auto lacks = [&](Scalar kind) {
    const Requirement* requirement = RequirementOf(kind);
    return requirement && !target_.Has(requirement->feature);
  };
  return !has_unsigned_ || !target_.Has(Feature::kDynamicBlockIndex) ||
         (!target_.Has(Feature::kFreeIndices) && clipc::InfoOf(program_.stage).draws_pixels) ||
         (target_.IsVulkan() && target_.bindings.splits_arrays) || lacks(Scalar::kDouble) ||
         lacks(Scalar::kInt64) || lacks(Scalar::kUint64);
}

void ExpressionCheck::Expression(ExprId id) {
  const ir::Expr& expr = program_.exprs[id];
  Type(expr.type, expr.span);
  Visit(Overloaded{
            [&](const IntrinsicCall& call) { IntrinsicUse(call, expr.span); },
            [&](const ObjectCall& call) { ObjectUse(call, expr.span); },
            [&](const Index& index) {
              SplitElement(id);
              BufferIndex(index, expr.span);
            },
            [](const auto&) {},
        },
        expr.node);
  if (!has_unsigned_) SmallIntegers(id, expr);
}

// Reports operators and numbers that GLSL 1.20 lacks: it has no uint, and only the four
// arithmetic operators for int.
void ExpressionCheck::SmallIntegers(ExprId id, const ir::Expr& expr) {
  const auto* binary = As<Binary>(id);
  const auto* assign = As<Assign>(id);
  const auto* unary = As<Unary>(id);
  if (binary) BitOperator(binary->op, TypeOf(binary->left), expr.span);
  if (assign && assign->op) BitOperator(*assign->op, TypeOf(assign->target), expr.span);
  if (unary && unary->op == UnaryOp::kComplement) Report(expr.span, diag::TargetBitOperator, "~");

  const auto* literal = As<Literal>(id);
  const bool is_uint = TypeOf(id).IsNumeric() && BaseOf(TypeOf(id).scalar) == Scalar::kUint;
  if (literal && is_uint && UintOf(literal->bits) > 0x7fffffffu) {
    Report(expr.span, diag::TargetUintTooLarge, UintOf(literal->bits));
  }
  if (const auto* convert = As<Convert>(id)) UintOperand(TypeOf(convert->operand), expr.span);
}

void ExpressionCheck::BitOperator(BinaryOp op, const ir::Type& type, Span span) {
  switch (op) {
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr: Report(span, diag::TargetBitOperator, SpellingOf(op)); return;
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
    case BinaryOp::kAdd:
    case BinaryOp::kSub:
    case BinaryOp::kMul: return;  // these give the same bits for int and uint
    default: return UintOperand(type, span);
  }
}

void ExpressionCheck::UintOperand(const ir::Type& type, Span span) {
  const bool is_uint = type.IsNumeric() && BaseOf(type.scalar) == Scalar::kUint;
  if (is_uint && !std::exchange(uint_reported_, true)) Report(span, diag::TargetUintAsInt);
}

void ExpressionCheck::IntrinsicUse(const IntrinsicCall& call, Span span) {
  if (CategoryOf(call.op) == IntrinsicCategory::kInterpolants) Interpolant(call, span);
  if (CategoryOf(call.op) == IntrinsicCategory::kWave ||
      CategoryOf(call.op) == IntrinsicCategory::kQuad)
    Check(FeatureOfWave(call.op), diag::TargetWave, span, NameOf(call.op));
  if (call.op == CommonIntrinsic::kCheckAccessFullyMapped)
    Check(Feature::kTextureStatus, diag::TargetTiled, span, "a status");
  if (CategoryOf(call.op) == IntrinsicCategory::kMemory)
    Check(Feature::kMemoryBarriers, diag::TargetBarrier, span, NameOf(call.op));
  if (InfoOf(call.op).gate == TargetGate::kBitCasts) {
    Check(Feature::kBitCasts, diag::TargetBitCast, span, NameOf(call.op));
  }
  if (call.op == CommonIntrinsic::kNonUniform && !target_.IsVulkan() &&
      !std::exchange(non_uniform_reported_, true))
    Report(span, diag::TargetNonUniform);
}

// Checks the evaluation of an input at another place: the argument is that input.
void ExpressionCheck::Interpolant(const IntrinsicCall& call, Span span) {
  const bool is_vertex = call.op == CommonIntrinsic::kAttributeAtVertex;
  Check(is_vertex ? Feature::kBarycentrics : Feature::kInterpolants, diag::TargetInterpolant, span,
        NameOf(call.op));
  ExprId place = program_.expr_lists[call.arguments][0];
  const auto* swizzle = As<Swizzle>(place);
  if (swizzle && TypeOf(swizzle->base).Components() > 1) place = swizzle->base;
  const auto* ref = As<VarRef>(place);
  const auto input =
      ref ? std::ranges::find(program_.inputs, ref->var, &IoVar::var) : program_.inputs.end();
  // GLSL interpolates what the shader before writes, and not gl_FragCoord.
  if (input == program_.inputs.end() || input->builtin != Builtin::kNone) {
    diagnostics_.Report(span, diag::InterpolantNotInput, NameOf(call.op));
    return;
  }
  if (!is_vertex) return;
  const auto* vertex = As<Literal>(program_.expr_lists[call.arguments][1]);
  if (vertex && vertex->bits > 2)
    diagnostics_.Report(span, diag::AttributeVertex, std::to_string(vertex->bits));
  if (input->interpolation != Interpolation::kNoInterpolation)
    diagnostics_.Report(span, diag::AttributeInterpolated,
                        input->semantic + std::to_string(input->index));
}

void ExpressionCheck::ObjectUse(const ObjectCall& call, Span span) {
  const ExprId path = OperandOf(program_, call, OperandKind::kObject);
  const ObjectKind object = Innermost(program_.exprs[path].type).object;
  const ExprId sampler = OperandOf(program_, call, OperandKind::kSampler);
  const bool has_offset = !OperandsOf(call, OperandKind::kOffset).empty();
  if (sampler) ObjectArgument(sampler);
  if (WritesObject(call.op)) StoreUse(path, call, span);
  const TypeId element = Innermost(program_.exprs[path].type).element;
  if (Takes(call.op, OperandKind::kReference) && element &&
      !IsFloat(program_.types[element].scalar))
    diagnostics_.Report(span, diag::MethodOfIntegers, InfoOf(call.op).method,
                        program_.types.Name(program_.exprs[path].type),
                        "a sampler compares floats only");
  const bool has_instruction = target_.IsVulkan() && !call.has_clamp && !call.has_texel;
  if (!has_instruction && !HasComparison(call.op, object, clipc::InfoOf(program_.stage)))
    Report(span, diag::TargetSampleCompare);
  if (has_offset && IsPlainSample(call.op))
    Check(Feature::kTextureFunctions, diag::TargetSampleOffset, span);
  if (call.op == ObjectOp::kSampleCmp && object == ObjectKind::kTexture2DArray && has_offset)
    Check(Feature::kShadowArrayOffsets, diag::TargetSampleOffset, span);
  if (HasVaryingOffset(program_, call))
    Check(Feature::kGatherOffsets, diag::TargetGather, span, "`Gather` at an offset that varies");
  if (call.has_clamp)
    Check(Feature::kLevelClamps, diag::TargetTiled, span, "a clamp of the level of detail");
  if (call.has_texel) Status(object, span);
  const bool is_length = call.op == ObjectOp::kBufferSize && IsStorageBuffer(object);
  if (!is_length) Check(RequirementOf(call.op), span);
}

// Reports a read with a status that GLSL does not have: textures of one dimension have none there.
void ExpressionCheck::Status(ObjectKind object, Span span) {
  constexpr std::string_view kStatus = "a status";
  if (InfoOf(object).axes == 1) return Report(span, diag::TargetTiled, kStatus);
  Check(Feature::kTextureStatus, diag::TargetTiled, span, kStatus);
}

// Reports a change of elements that are words for the target, because they lie tighter than std430
// says or atomic operations exchange floats in them, where words cannot be changed like that.
void ExpressionCheck::StoreUse(ExprId object, const ObjectCall& call, Span span) {
  const ir::Type& type = Innermost(program_.exprs[object].type);
  if (!IsStructured(type.object)) return;
  const auto* ref = As<VarRef>(object);
  const bool row_major = ref && program_.vars[ref->var].row_major;
  // The words are unsigned.
  const bool is_signed =
      (call.op == ObjectOp::kAtomicMin || call.op == ObjectOp::kAtomicMax) &&
      !ir::IsUnsigned(TypeOf(OperandOf(program_, call, OperandKind::kValue)).scalar);
  if (!is_signed && IsOfWords(program_.types, type.element)) return;
  if (!exchanged_) exchanged_ = legalize::BuffersOfExchangedFloats(program_);
  if (!Std430(program_.types, type.element, row_major) || (ref && exchanged_->contains(ref->var)))
    Report(span, diag::TargetStructuredStore, program_.types.Name(type.element));
}

// Reports an element of an array of samplers, unless a literal names it: OpenGL has none.
void ExpressionCheck::ObjectArgument(ExprId object) {
  const auto* index = As<Index>(object);
  if (!index || target_.IsVulkan() || legalize::SplitElementAt(program_, split_, object).array)
    return;
  if (InfoOf(TypeOf(object).object).category != ObjectCategory::kSampler) return;
  const auto* var = As<VarRef>(index->base);
  Report(program_.exprs[object].span, diag::TargetSamplerArray,
         var ? program_.vars[var->var].name : "sampler");
}

// Reports an element, unless literals name it, of an array that Vulkan would not have.
void ExpressionCheck::SplitElement(ExprId element) {
  const VarId root = RootOf(program_, element);
  const bool is_split = target_.IsVulkan() && root &&
                        legalize::SplitCount(program_, split_, root) > 0 &&
                        TypeOf(element).kind == TypeKind::kObject;
  if (is_split && !legalize::SplitElementAt(program_, split_, element).array)
    diagnostics_.Report(program_.exprs[element].span, diag::TargetSplitIndex,
                        program_.vars[root].name);
}

void ExpressionCheck::BufferIndex(const Index& index, Span span) {
  ExprId array = index.base;
  while (const auto* outer = As<Index>(array)) array = outer->base;
  const bool is_object_array = Innermost(program_.exprs[index.base].type).kind == TypeKind::kObject;
  const auto* ref = As<VarRef>(is_object_array ? array : index.base);
  const bool is_uniform = ref && program_.vars[ref->var].storage == Storage::kUniform;
  if (is_uniform && !target_.Has(Feature::kFreeIndices) &&
      clipc::InfoOf(program_.stage).draws_pixels &&
      !legalize::IsConstantIndex(program_, index.index, loop_indices_))
    return Report(span, diag::TargetUniformIndex, program_.vars[ref->var].name);
  if (!ref || As<Literal>(index.index) || target_.Has(Feature::kDynamicBlockIndex)) return;
  const Var& var = program_.vars[ref->var];
  const bool is_buffer = var.storage == Storage::kUniform && has_blocks_ &&
                         program_.cbuffers[var.cbuffer].kind == CbufferKind::kConstantBuffer;
  if (is_object_array || is_buffer) Report(span, diag::TargetBufferIndexNotConstant, var.name);
}

}  // namespace clipc::glsl
