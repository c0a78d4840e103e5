// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/known_offsets.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/rules/call_depth.h"
#include "frontend/rules/constant.h"
#include "frontend/rules/object_slots.h"
#include "frontend/rules/wanted_values.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

constexpr std::size_t kMaxCopies = 4096;          // of functions and of loops' bodies
constexpr std::size_t kMaxExpressions = 1 << 22;  // of the program with its copies
constexpr std::size_t kMaxWords = 4096;           // of a known value

std::string_view MethodOf(ObjectOp op) {
  using enum ObjectOp;
  switch (op) {
    case kSampleLevel: return "SampleLevel";
    case kSampleGrad: return "SampleGrad";
    case kSampleCmpLevelZero: return "SampleCmpLevelZero";
    case kTextureLoad: return "Load";
    case kGatherGreen: return "GatherGreen";
    case kGatherBlue: return "GatherBlue";
    case kGatherAlpha: return "GatherAlpha";
    default: return "Gather";
  }
}

class OffsetFinder {
 public:
  OffsetFinder(Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics), wanted_(program) {}

  void Run() {
    if (wanted_.IsEmpty()) return;
    program_.main = CopyOf(program_.main, {});
    program_.entry = entry_;
    program_.functions = std::move(functions_);
  }

 private:
  using Bits = std::vector<std::uint64_t>;
  using Key = std::vector<std::uint64_t>;

  // ---- known values
  // The bits of an expression if its value is known; otherwise nullopt. Each name in it is replaced
  // by a copy of the value, so the program grows.
  std::optional<Bits> BitsOf(ExprId expr) {
    if (!MayGrow(program_.exprs[expr].span)) return std::nullopt;
    const ExprId copy = Clone(program_, expr);
    const ExprId closed = Substitute(copy);
    if (KindsOf(program_.types, TypeIdOf(program_, closed)).size() > kMaxWords) return std::nullopt;
    return ConstantBits(program_, closed);
  }

  ExprId Substitute(ExprId expr) {
    if (const auto* ref = As<VarRef>(program_, expr)) {
      const auto known = known_.find(ref->var);
      return known == known_.end() ? expr : Clone(program_, known->second);
    }
    MapOperands(program_, expr, [&](ExprId operand) { return Substitute(operand); });
    return Picked(expr);
  }

  // Simplifies a swizzle of a Construct: int4(1, 2, 3, i).xy  =>  int2(1, 2).
  ExprId Picked(ExprId expr) {
    const auto* node = As<Swizzle>(program_, expr);
    if (!node || !As<Construct>(program_, node->base)) return expr;
    const Swizzle swizzle = *node;
    std::vector<ExprId> parts;
    for (std::uint8_t i = 0; i < swizzle.count; ++i)
      parts.push_back(Component(swizzle.base, swizzle.components[i]));
    const TypeId type = TypeIdOf(program_, expr);
    return parts.size() == 1 ? parts[0] : Builder(program_).ConstructOf(type, parts);
  }

  // A copy of one component of a Construct.
  ExprId Component(ExprId construct, int component) {
    const List<ExprId> parts = As<Construct>(program_, construct)->arguments;
    std::uint32_t i = 0;
    for (;; ++i) {
      const int size =
          static_cast<int>(TypeOf(program_, program_.expr_lists[parts][i]).Components());
      if (component < size) break;
      component -= size;
    }
    const ExprId part = Clone(program_, program_.expr_lists[parts][i]);
    if (TypeOf(program_, part).kind == TypeKind::kScalar) return part;
    return Picked(Builder(program_).Swizzled(part, {component}));
  }

  // Makes a value of literals with the given bits.
  ExprId Make(TypeId type, const Bits& bits, Span span) {
    return Builder(program_, span).ValueOf(type, bits);
  }

  bool Know(VarId var, ExprId value) {
    const auto bits = BitsOf(value);
    if (!bits) return false;
    known_[var] = Make(program_.vars[var].type, *bits, program_.vars[var].span);
    return true;
  }

  // Notes the known components of a vector that has unknown ones too: int4 a = {1, 2, 3, i}.
  void KnowComponents(VarId var, ExprId value) {
    const TypeId type = program_.vars[var].type;
    if (program_.types[type].kind != TypeKind::kVector) return;
    Builder at(program_, program_.vars[var].span);
    std::vector<ExprId> parts;
    for (int i = 0; i < program_.types[type].columns; ++i) {
      const auto bits = BitsOf(at.Swizzled(Clone(program_, value), {i}));
      const ExprId own = at.Swizzled(at.Ref(var), {i});
      parts.push_back(bits ? Make(TypeIdOf(program_, own), *bits, program_.vars[var].span) : own);
    }
    known_[var] = at.ConstructOf(type, parts);
  }

  // ---- functions
  VarId Original(VarId var) const {
    const auto found = originals_.find(var);
    return found == originals_.end() ? var : found->second;
  }
  bool IsWanted(VarId var) const { return wanted_.Has(Original(var)); }
  void NoteCopies(const BodyCloner& cloner) {
    for (const auto& [from, to] : cloner.vars()) originals_[to] = Original(from);
  }

  bool MayCopy(Span span) {
    return MayGrow(span) &&
           (++made_ <= kMaxCopies || Refuse(span, kMaxCopies, "copies of functions and loops"));
  }
  bool MayGrow(Span span) {
    if (program_.exprs.size() < kMaxExpressions) return true;
    return Refuse(span, kMaxExpressions, "expressions");
  }
  bool Refuse(Span span, std::size_t limit, std::string_view of) {
    if (!is_reported_) diagnostics_.Report(span, diag::TooManyCopies, limit, of);
    is_reported_ = true;
    return false;
  }

  // The copy of the function for known arguments of the parameters that its offsets depend on.
  FunctionId CopyOf(FunctionId id, const std::map<std::size_t, Bits>& arguments) {
    Key key{id.index};
    for (const auto& [parameter, bits] : arguments) {
      key.push_back(parameter);
      key.insert(key.end(), bits.begin(), bits.end());
    }
    if (const auto found = copies_.find(key); found != copies_.end()) return found->second;
    Function function = program_.functions[id];
    const bool is_too_deep = depth_ >= kMaxCallDepth;
    const bool is_copied = !is_too_deep && wanted_.Has(id) && MayCopy(function.span);
    if (!is_copied) {
      // A body that is not copied is read once: its calls then name functions of `functions_`.
      key.resize(1);
      if (const auto found = copies_.find(key); found != copies_.end()) return found->second;
    }
    if (is_too_deep) {
      diagnostics_.Report(function.span, diag::CheckTooDeep, kMaxCallDepth);
    } else if (is_copied) {
      BodyCloner cloner(program_);
      for (VarId& parameter : function.parameters) parameter = cloner.CloneVar(parameter);
      function.body = cloner.Clone(function.body);
      NoteCopies(cloner);
      const auto outer = std::exchange(known_, {});
      for (const auto& [parameter, bits] : arguments) {
        const VarId var = function.parameters[parameter];
        known_[var] = Make(program_.vars[var].type, bits, program_.vars[var].span);
      }
      ++depth_;
      Read(function.body);
      --depth_;
      known_ = outer;
    } else {
      ++depth_;
      ForEachExpr(program_, function.body, [&](ExprId expr) { ReadCall(expr); });
      --depth_;
    }
    const FunctionId added = functions_.Add(std::move(function));
    if (id == program_.entry) entry_ = added;
    return copies_[key] = added;
  }

  void ReadCall(ExprId expr) {
    const auto* node = As<Call>(program_, expr);
    if (!node) return;
    const Call call = *node;
    std::map<std::size_t, Bits> arguments;
    const std::vector<VarId>& parameters = program_.functions[call.function].parameters;
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const VarId parameter = parameters[i];
      if (!wanted_.IsUnchanged(parameter) || program_.vars[parameter].storage != Storage::kIn)
        continue;
      if (const auto bits = BitsOf(program_.expr_lists[call.arguments][i])) arguments[i] = *bits;
    }
    const FunctionId copy = CopyOf(call.function, arguments);
    program_.exprs[expr].node = Call{copy, call.arguments};
  }

  // ---- statements
  void Read(StmtId stmt) {
    if (const auto* loop = As<For>(program_, stmt); loop && Unroll(stmt, For(*loop))) return;
    ForEachPart(
        program_, stmt,
        [&](ExprId root) { ForEachExpr(program_, root, [&](ExprId expr) { ReadExpr(expr); }); },
        [&](StmtId part) { Read(part); });
    const auto* declare = As<Declare>(program_, stmt);
    if (!declare || !declare->init || !wanted_.IsUnchanged(Original(declare->var))) return;
    if (!Know(declare->var, declare->init)) KnowComponents(declare->var, declare->init);
  }

  void ReadExpr(ExprId expr) {
    ReadCall(expr);
    const auto* call = As<ObjectCall>(program_, expr);
    if (!call) return;
    const List<ExprId> arguments = call->arguments;
    const ObjectOp op = call->op;
    for (std::uint32_t i = FirstOffset(op); i < arguments.size; ++i) {
      const ExprId offset = program_.expr_lists[arguments][i];
      if (!IsLiteralOffset(program_, offset))
        program_.expr_lists[arguments][i] = Known(offset, op, MayVary(op, arguments.size));
    }
  }

  // Whether Direct3D 11 takes the offset as a number like any other, with gather4_po.
  bool MayVary(ObjectOp op, std::uint32_t arguments) const {
    return IsGather(op) && arguments == FirstOffset(op) + 1 && program_.profile.IsAtLeast(5, 0);
  }

  ExprId Known(ExprId offset, ObjectOp op, bool may_vary) {
    const Span span = program_.exprs[offset].span;
    const auto bits = BitsOf(offset);
    if (!bits || !IsPure(program_, offset)) {
      if (!may_vary) diagnostics_.Report(span, diag::TextureOffsetNotConstant, MethodOf(op));
      return offset;
    }
    for (const std::uint64_t word : *bits) {
      const auto texels = static_cast<std::int32_t>(static_cast<std::uint32_t>(word));
      if (texels < -8 || texels > 7) {
        diagnostics_.Report(span, diag::TextureOffsetRange, texels, MethodOf(op));
        return offset;
      }
    }
    return Make(TypeIdOf(program_, offset), *bits, span);
  }

  // ---- loops
  // Unrolls for (int i = 0; i < 2; ++i) body  =>  { int i = 0; body ++i; body ++i; }. Returns false
  // if the loop is not wanted or its turns are not known.
  bool Unroll(StmtId stmt, const For& loop) {
    ExprId start;
    const VarId counter = wanted_.CounterOf(loop, start);
    if (!counter || !IsWanted(counter) || !loop.condition || !loop.step) return false;
    if (!wanted_.IsPlain(loop) || AssignedIn(program_, {&loop.body, 1})[counter.index])
      return false;
    if (!Know(counter, start)) return false;
    std::vector<StmtId> stmts;
    for (std::uint32_t i = 0; i < loop.init.size; ++i)
      stmts.push_back(program_.stmt_lists[loop.init][i]);
    Builder at(program_, program_.stmts[stmt].span);
    bool is_known = true;
    while (is_known) {
      const auto goes_on = BitsOf(loop.condition);
      is_known = goes_on.has_value();
      if (!is_known || goes_on->front() == 0) break;
      if (!MayCopy(program_.stmts[stmt].span)) return true;
      BodyCloner cloner(program_);
      const StmtId body = cloner.Clone(loop.body);
      NoteCopies(cloner);
      Read(body);
      stmts.push_back(body);
      stmts.push_back(at.Eval(Clone(program_, loop.step)));
      const ExprId next = WantedValues::NextOf(program_, loop.step, counter);
      is_known = next && Know(counter, next);
    }
    known_.erase(counter);
    if (!is_known) return false;
    const StmtId block = at.BlockOf(stmts);
    program_.stmts[stmt].node = program_.stmts[block].node;
    return true;
  }

  Program& program_;
  Diagnostics& diagnostics_;
  WantedValues wanted_;
  std::map<VarId, ExprId> known_;     // by variable, in the function that is being copied
  std::map<VarId, VarId> originals_;  // by variable of a copy: its original
  std::map<Key, FunctionId> copies_;
  Arena<Function> functions_;  // callees before callers
  FunctionId entry_;
  std::size_t made_ = 0;
  bool is_reported_ = false;
  int depth_ = 0;
};

}  // namespace

void KnowOffsets(Program& program, Diagnostics& diagnostics) {
  OffsetFinder(program, diagnostics).Run();
}

}  // namespace clipc::rules
