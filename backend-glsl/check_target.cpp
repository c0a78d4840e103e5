// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/check_target.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/reach.h"
#include "backend-glsl/shape.h"
#include "backend-glsl/writer.h"
#include "base/overloaded.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

namespace {

class TargetCheck {
 public:
  TargetCheck(const Program& program, const Reached& reached, const Target& target,
              Diagnostics& diagnostics)
      : program_(program),
        target_(target),
        diagnostics_(diagnostics),
        reached_(reached),
        seen_types_(program.types.size()) {}

  void Run() {
    for (const IoVar& input : program_.inputs) Input(input);
    for (const IoVar& output : program_.outputs) Output(output);
    for (CbufferId id : program_.cbuffers.ids()) {
      if (reached_.Has(id)) Cbuffer(program_.cbuffers[id]);
    }
    for (const Resource& resource : program_.resources) {
      if (reached_.Has(resource.var)) Object(program_.vars[resource.var]);
    }
    if (target_.IsVulkan()) Bindings();
    for (VarId global : reached_.globals) {
      Type(program_.vars[global].type, program_.vars[global].span);
      if (program_.vars[global].init) {
        ForEachExpr(program_, program_.vars[global].init, [&](ExprId expr) { Expression(expr); });
      }
    }
    for (FunctionId id : reached_.functions) Function(program_.functions[id]);
  }

 private:
  std::string_view target_name() const { return target_.name(); }
  const ir::Type& TypeOf(ExprId expr) const { return program_.types[program_.exprs[expr].type]; }
  const ir::Type& Innermost(TypeId id) const {
    while (program_.types[id].kind == TypeKind::kArray) id = program_.types[id].element;
    return program_.types[id];
  }

  // ---- inputs and outputs
  void Input(const IoVar& input) {
    if (!reached_.Has(input.var)) return;
    const Var& var = program_.vars[input.var];
    const std::string name = input.semantic + std::to_string(input.index);
    switch (input.builtin) {
      case Builtin::kVertexId:
      case Builtin::kVertexIndex:
        if (!target_.HasVertexId())
          diagnostics_.Report(var.span, diag::TargetVertexId, target_name());
        break;
      case Builtin::kBaseVertex:
      case Builtin::kBaseInstance:
      case Builtin::kInstanceIndex:
      case Builtin::kDrawIndex:
        if (!target_.DrawParameters())
          diagnostics_.Report(var.span, diag::TargetDrawParameter, input.semantic, target_name());
        break;
      case Builtin::kViewId:
        if (!target_.ViewIndex()) diagnostics_.Report(var.span, diag::TargetViewId, target_name());
        break;
      default: break;
    }
    DoubleVarying(var, name);
  }

  void Output(const IoVar& output) {
    const Var& var = program_.vars[output.var];
    const std::string name = output.semantic + std::to_string(output.index);
    switch (output.builtin) {
      case Builtin::kNone: return Varying(output, var, name);
      case Builtin::kClipDistance:
        if (!target_.ClipDistance())
          diagnostics_.Report(PlaceOf(output), diag::TargetClipDistance, target_name());
        break;
      case Builtin::kCullDistance:
        if (!target_.CullDistance())
          diagnostics_.Report(PlaceOf(output), diag::TargetCullDistance, target_name());
        break;
      case Builtin::kClipVertex:
        if (!target_.HasClipVertex())
          diagnostics_.Report(PlaceOf(output), diag::TargetClipVertex, target_name());
        break;
      case Builtin::kShadingRate:
        if (!target_.ShadingRate())
          diagnostics_.Report(PlaceOf(output), diag::TargetShadingRate, target_name());
        break;
      case Builtin::kLayer:
      case Builtin::kViewportIndex:
        if (!target_.LayerAndViewport())
          diagnostics_.Report(PlaceOf(output), diag::TargetLayer, output.semantic, target_name());
        break;
      default: break;
    }
  }

  // Lowered outputs have no place of their own: the clip planes, or the entry point.
  Span PlaceOf(const IoVar& output) const {
    if (program_.vars[output.var].span) return program_.vars[output.var].span;
    if (!program_.clip_planes.empty()) return program_.clip_planes.front().span;
    return program_.functions[program_.entry].span;
  }

  void Varying(const IoVar& output, const Var& var, const std::string& name) {
    const Shape shape = ShapeOf(program_.types[var.type]);
    if (!shape.IsFloating() && !target_.HasIntegerVaryings()) {
      diagnostics_.Report(var.span, diag::TargetIntegerVarying, name, target_name());
    }
    const bool is_flat = output.interpolation == Interpolation::kNoInterpolation;
    if (is_flat && shape.IsFloating() && !target_.HasInAndOut()) {
      diagnostics_.Report(var.span, diag::TargetFlat, name, target_name());
    }
    if (output.interpolation == Interpolation::kNoPerspective && !target_.HasNoPerspective()) {
      diagnostics_.Report(var.span, diag::TargetNoPerspective, name, target_name());
    }
    if (output.sample && !target_.PerSample())
      diagnostics_.Report(var.span, diag::TargetPerSample, name, target_name());
    DoubleVarying(var, name);
  }

  void DoubleVarying(const Var& var, const std::string& name) {
    const ir::Type& type = program_.types[var.type];
    if (type.IsNumeric() && BaseOf(type.scalar) == Scalar::kDouble &&
        !target_.HasDoubleVaryings()) {
      diagnostics_.Report(var.span, diag::TargetDoubleVarying, name, target_name());
    }
  }

  // ---- buffers and textures
  void Cbuffer(const ir::Cbuffer& cbuffer) {
    for (const CbufferMember& member : cbuffer.members) {
      const Var& var = program_.vars[member.var];
      if (reached_.Has(member.var) || target_.HasUniformBlocks()) Type(var.type, var.span);
    }
    const bool is_array =
        cbuffer.kind == CbufferKind::kConstantBuffer &&
        program_.types[program_.vars[cbuffer.members[0].var].type].kind == TypeKind::kArray;
    if (!is_array || !target_.HasUniformBlocks()) return;
    const Var& var = program_.vars[cbuffer.members[0].var];
    const bool is_nested =
        program_.types[program_.types[var.type].element].kind == TypeKind::kArray;
    const bool in_rows = LayOutBlock(program_, cbuffer, target_).form == BlockForm::kRows;
    const bool fits = in_rows ? target_.HasDynamicBlockIndex() && !is_nested
                              : !is_nested || target_.HasArraysOfArrays();
    if (!fits || !target_.HasBlockInstances()) {
      diagnostics_.Report(cbuffer.span, diag::TargetConstantBufferArray, cbuffer.name,
                          target_name());
    }
  }

  void Object(const Var& var) {
    const ir::Type& type = Innermost(var.type);
    const auto report = [&](bool has, const auto& kind) {
      if (!has) diagnostics_.Report(var.span, kind, var.name, target_name());
    };
    const bool is_array = program_.types[var.type].kind == TypeKind::kArray;
    if (is_array && program_.types[program_.types[var.type].element].kind == TypeKind::kArray) {
      report(target_.HasArraysOfArrays(), diag::TargetObjectArrays);
    }
    switch (type.object) {
      case ObjectKind::kTexture1D:
      case ObjectKind::kSampler1D: report(target_.Has1D(), diag::TargetTexture1D); break;
      case ObjectKind::kTexture1DArray:
        report(target_.Has1D(), diag::TargetTexture1D);
        report(target_.HasTextureArrays(), diag::TargetTextureArray);
        break;
      case ObjectKind::kTexture2DArray:
        report(target_.HasTextureArrays(), diag::TargetTextureArray);
        break;
      case ObjectKind::kTextureCubeArray:
        report(bool(target_.CubeArrays()), diag::TargetCubeArray);
        break;
      case ObjectKind::kTexture2DMS:
        report(target_.HasMultisample(), diag::TargetMultisample);
        break;
      case ObjectKind::kTexture2DMSArray:
        report(bool(target_.MultisampleArrays()), diag::TargetMultisample);
        break;
      case ObjectKind::kBuffer:
        report(bool(target_.TextureBuffers()), diag::TargetTextureBuffer);
        break;
      case ObjectKind::kStructuredBuffer:
      case ObjectKind::kByteAddressBuffer:
      case ObjectKind::kRWStructuredBuffer:
      case ObjectKind::kRWByteAddressBuffer:
        report(target_.HasStorageBuffers(), diag::TargetStorageBuffer);
        report(!is_array, diag::TargetArrayOfBuffers);
        break;
      default:
        if (IsImage(type.object)) report(target_.HasImages(), diag::TargetImage);
        break;
    }
    if (!type.element) return;
    if (program_.types[type.element].IsNumeric() &&
        !ShapeOf(program_.types[type.element]).IsFloating()) {
      report(target_.HasTextureFunctions(), diag::TargetIntegerTexture);
    }
    Type(type.element, var.span);
  }

  // Registers of all kinds share the bindings of a set.
  void Bindings() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> taken;
    const auto take = [&](const Register& reg, const std::string& name, Span span) {
      const std::uint32_t binding = VulkanBinding(reg);
      const auto [found, is_free] = taken.try_emplace({reg.space, binding}, name);
      if (!is_free)
        diagnostics_.Report(span, diag::TargetBindingsCollide, found->second, name, binding,
                            reg.space);
    };
    for (CbufferId id : program_.cbuffers.ids()) {
      const ir::Cbuffer& cbuffer = program_.cbuffers[id];
      if (reached_.Has(id)) take(cbuffer.reg, cbuffer.name, cbuffer.span);
    }
    for (const Resource& resource : program_.resources) {
      const Var& var = program_.vars[resource.var];
      if (reached_.Has(resource.var)) take(resource.reg, var.name, var.span);
    }
  }

  // ---- types, each missing one reported once
  void Type(TypeId id, Span span) {
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
    const Scalar base = BaseOf(type.scalar);
    if (base == Scalar::kDouble && !target_.Doubles() && !std::exchange(double_reported_, true)) {
      diagnostics_.Report(span, diag::TargetDouble, target_name());
    }
    const bool is_wide = base == Scalar::kInt64 || base == Scalar::kUint64;
    if (is_wide && !target_.Int64() && !std::exchange(int64_reported_, true)) {
      diagnostics_.Report(span, diag::TargetInt64, target_name());
    }
  }

  // ---- code
  void Function(const ir::Function& function) {
    for (VarId parameter : function.parameters) {
      Type(program_.vars[parameter].type, program_.vars[parameter].span);
    }
    Statement(function.body);
  }

  void Statement(StmtId id) {
    const ir::Stmt& stmt = program_.stmts[id];
    if (std::holds_alternative<Switch>(stmt.node) && !target_.HasSwitch()) {
      diagnostics_.Report(stmt.span, diag::TargetSwitch, target_name());
    }
    if (const auto* declare = std::get_if<Declare>(&stmt.node)) {
      Type(program_.vars[declare->var].type, stmt.span);
    }
    ForEachPart(
        program_, id,
        [&](ExprId expr) { ForEachExpr(program_, expr, [&](ExprId part) { Expression(part); }); },
        [&](StmtId part) { Statement(part); });
  }

  void Expression(ExprId id) {
    const ir::Expr& expr = program_.exprs[id];
    Type(expr.type, expr.span);
    if (const auto* call = std::get_if<IntrinsicCall>(&expr.node)) IntrinsicUse(*call, expr.span);
    if (const auto* call = std::get_if<ObjectCall>(&expr.node)) ObjectUse(*call, expr.span);
    if (const auto* index = std::get_if<Index>(&expr.node)) BufferIndex(*index, expr.span);
    if (!target_.HasUnsigned()) SmallIntegers(id, expr);
  }

  // GLSL 1.20 has int, and only the four arithmetic operators for it.
  void SmallIntegers(ExprId id, const ir::Expr& expr) {
    const auto* binary = std::get_if<Binary>(&expr.node);
    const auto* assign = std::get_if<Assign>(&expr.node);
    const auto* unary = std::get_if<Unary>(&expr.node);
    if (binary) BitOperator(binary->op, TypeOf(binary->left), expr.span);
    if (assign && assign->op) BitOperator(*assign->op, TypeOf(assign->target), expr.span);
    if (unary && unary->op == UnaryOp::kComplement)
      diagnostics_.Report(expr.span, diag::TargetBitOperator, "~", target_name());

    const auto* literal = std::get_if<Literal>(&expr.node);
    const bool is_uint = TypeOf(id).IsNumeric() && BaseOf(TypeOf(id).scalar) == Scalar::kUint;
    if (literal && is_uint && UintOf(literal->bits) > 0x7fffffffu) {
      diagnostics_.Report(expr.span, diag::TargetUintTooLarge, UintOf(literal->bits),
                          target_name());
    }
    if (const auto* convert = std::get_if<Convert>(&expr.node))
      UintOperand(TypeOf(convert->operand), expr.span);
  }

  void BitOperator(BinaryOp op, const ir::Type& type, Span span) {
    switch (op) {
      case BinaryOp::kShiftLeft:
        return diagnostics_.Report(span, diag::TargetBitOperator, "<<", target_name()), void();
      case BinaryOp::kShiftRight:
        return diagnostics_.Report(span, diag::TargetBitOperator, ">>", target_name()), void();
      case BinaryOp::kBitAnd:
        return diagnostics_.Report(span, diag::TargetBitOperator, "&", target_name()), void();
      case BinaryOp::kBitXor:
        return diagnostics_.Report(span, diag::TargetBitOperator, "^", target_name()), void();
      case BinaryOp::kBitOr:
        return diagnostics_.Report(span, diag::TargetBitOperator, "|", target_name()), void();
      case BinaryOp::kEqual:
      case BinaryOp::kNotEqual:
      case BinaryOp::kAdd:
      case BinaryOp::kSub:
      case BinaryOp::kMul: return;  // the same bits for int and uint
      default: return UintOperand(type, span);
    }
  }

  void UintOperand(const ir::Type& type, Span span) {
    const bool is_uint = type.IsNumeric() && BaseOf(type.scalar) == Scalar::kUint;
    if (is_uint && !std::exchange(uint_reported_, true))
      diagnostics_.Report(span, diag::TargetUintAsInt, target_name());
  }

  void IntrinsicUse(const IntrinsicCall& call, Span span) {
    if (InfoOf(call.op).gate == TargetGate::kBitCasts && !target_.BitCasts())
      diagnostics_.Report(span, diag::TargetBitCast, NameOf(call.op), target_name());
  }

  void ObjectUse(const ObjectCall& call, Span span) {
    const auto arguments = program_.expr_lists[call.arguments];
    const ObjectKind object = Innermost(program_.exprs[arguments[0]].type).object;
    if (TakesSampler(call.op)) ObjectArgument(arguments[1]);
    switch (call.op) {
      case ObjectOp::kStore: StoreUse(arguments[0], span); break;
      case ObjectOp::kSampleGrad:
        if (!target_.HasTextureFunctions())
          diagnostics_.Report(span, diag::TargetSampleGradient, target_name());
        break;
      case ObjectOp::kGather:
      case ObjectOp::kGatherGreen:
      case ObjectOp::kGatherBlue:
      case ObjectOp::kGatherAlpha:
        if (!target_.HasGather()) diagnostics_.Report(span, diag::TargetGather, target_name());
        break;
      case ObjectOp::kTextureLoad:
        if (!target_.HasTextureFunctions())
          diagnostics_.Report(span, diag::TargetTextureLoad, target_name());
        break;
      case ObjectOp::kSampleCmpLevelZero:
        if (!target_.HasTextureFunctions())
          diagnostics_.Report(span, diag::TargetSampleCompare, target_name());
        break;
      case ObjectOp::kTextureSize: Query(target_.HasTextureFunctions(), "size", span); break;
      case ObjectOp::kTextureLevels:
        Query(target_.HasTextureLevels(), "number of levels", span);
        break;
      case ObjectOp::kTextureSamples:
        Query(target_.HasTextureSamples(), "number of samples", span);
        break;
      case ObjectOp::kBufferSize:
        Query(IsStorageBuffer(object) || target_.HasTextureFunctions(), "size", span);
        break;
      default: break;
    }
  }

  // Elements that lie tighter than std430 says are read as words, and not written.
  void StoreUse(ExprId object, Span span) {
    const ir::Type& type = Innermost(program_.exprs[object].type);
    const auto* ref = std::get_if<VarRef>(&program_.exprs[object].node);
    const bool row_major = ref && program_.vars[ref->var].row_major;
    if (type.object == ObjectKind::kRWStructuredBuffer &&
        !Std430(program_.types, type.element, row_major)) {
      diagnostics_.Report(span, diag::TargetStructuredStore, program_.types.Name(type.element),
                          target_name());
    }
  }

  void Query(bool has, std::string_view what, Span span) {
    if (!has) diagnostics_.Report(span, diag::TargetTextureQuery, what, target_name());
  }

  // Samplers and textures in arrays.
  void ObjectArgument(ExprId object) {
    const auto* index = std::get_if<Index>(&program_.exprs[object].node);
    const bool is_sampler = InfoOf(TypeOf(object).object).category == ObjectCategory::kSampler;
    if (!index || !is_sampler || target_.IsVulkan()) return;
    const auto* var = std::get_if<VarRef>(&program_.exprs[index->base].node);
    diagnostics_.Report(program_.exprs[object].span, diag::TargetSamplerArray,
                        var ? program_.vars[var->var].name : "sampler", target_name());
  }

  void BufferIndex(const Index& index, Span span) {
    const auto* ref = std::get_if<VarRef>(&program_.exprs[index.base].node);
    if (!ref || std::holds_alternative<Literal>(program_.exprs[index.index].node) ||
        target_.HasDynamicBlockIndex())
      return;
    const Var& var = program_.vars[ref->var];
    const bool is_object = Innermost(var.type).kind == TypeKind::kObject;
    const bool is_buffer = var.storage == Storage::kUniform && target_.HasUniformBlocks() &&
                           program_.cbuffers[var.cbuffer].kind == CbufferKind::kConstantBuffer;
    if (is_object || is_buffer)
      diagnostics_.Report(span, diag::TargetBufferIndexNotConstant, var.name, target_name());
  }

  const Program& program_;
  const Target& target_;
  Diagnostics& diagnostics_;
  const Reached& reached_;
  std::vector<char> seen_types_;  // by TypeId
  bool double_reported_ = false, int64_reported_ = false, uint_reported_ = false;
};

}  // namespace

void CheckTarget(const Program& program, const Reached& reached, const Target& target,
                 Diagnostics& diagnostics) {
  TargetCheck(program, reached, target, diagnostics).Run();
}

}  // namespace clipc::glsl
