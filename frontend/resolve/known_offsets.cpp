// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/known_offsets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/resolve/object_choices.h"
#include "frontend/resolve/object_slots.h"
#include "frontend/resolve/unrolled_loop.h"
#include "frontend/typing/constant.h"
#include "frontend/typing/object_call.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/call_order.h"
#include "ir/clone_body.h"
#include "ir/counted_loop.h"
#include "ir/evaluate.h"
#include "ir/value_graph.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

constexpr std::size_t kMaxCopies = 4096;          // of loops' bodies and of functions
constexpr std::size_t kMaxExpressions = 1 << 22;  // of the program with its copies

// Whether the expression is an element of an array of samplers, at an index that is not written as
// a number.
bool ChoosesSampler(const Program& program, ExprId expr) {
  const auto* index = As<Index>(program, expr);
  if (!index || As<Literal>(program, index->index)) return false;
  const Type& type = program.types[program.types.Innermost(TypeIdOf(program, expr))];
  return type.kind == TypeKind::kObject && InfoOf(type.object).category == ObjectCategory::kSampler;
}

// What must be known: the offsets of textures and the indices of samplers in arrays, which OpenGL
// does not have, or the indices that choose local objects.
enum class What : std::uint8_t { kOffsets, kLocalObjects };

class OffsetFinder {
 public:
  OffsetFinder(Program& program, What what, Diagnostics& diagnostics)
      : program_(program), what_(what), diagnostics_(diagnostics) {}

  void Run() {
    FindParts();
    if (!has_parts_) return;
    FindSources();
    // Callers first, since a call gives the parameters that its function's offsets depend on.
    KeptVector<FunctionId> order = CalleesFirst(program_);
    for (auto id = order.rbegin(); id != order.rend(); ++id) {
      if (!IsCopied(*id)) ReadLater(*id);
      while (!unread_.empty()) {
        const FunctionId next = unread_.back();
        unread_.pop_back();
        Read(program_.functions[next].body);
      }
    }
    for (const auto& [var, before] : known_) Restore(var, before);
  }

 private:
  bool IsLiteralOffset(ExprId offset) const {
    return As<Literal>(program_, offset) || IsLiteralList(program_, offset);
  }

  // Marks the variables in the offsets and indices that are not literals.
  void FindParts() {
    const auto has_index = [&](const Index& index) { return !As<Literal>(program_, index.index); };
    const auto has_object = [&](const Index& index) {
      return index.base && has_index(index) &&
             IsObjectType(program_.types, TypeIdOf(program_, index.base));
    };
    const auto has_choice = [&](const Conditional& choice) {
      return IsObjectType(program_.types, program_.exprs[choice.when_true].type);
    };
    const auto has_offset = [&](const ObjectCall& call) {
      return OperandsOf(call, OperandKind::kOffset).size > 0;
    };
    if (!program_.calls_objects) return;
    if (what_ == What::kLocalObjects) {
      branches_choose_ = BranchesChoose(program_);
      const bool may_choose = branches_choose_ || MayHaveExpr<Conditional>(program_, has_choice);
      if (!may_choose && !(choices_.HasVariables() && MayHaveExpr<Index>(program_, has_index)))
        return;
    } else if (!MayHaveExpr<Index>(program_, has_object) &&
               !MayHaveExpr<ObjectCall>(program_, has_offset)) {
      return;
    }
    is_source_.resize(program_.vars.size());
    must_be_known_.resize(program_.vars.size());
    for (const FunctionId id : program_.functions.ids()) {
      const Function& function = program_.functions[id];
      ForEachExpr(program_, function.body, [&](ExprId expr) { FindPart(expr); });
      if (!branches_choose_) continue;
      for (const ExprId condition : ChoosingConditions(program_, function))
        MarkSources(condition, true);
    }
  }

  void FindPart(ExprId expr) {
    for (const ExprId choice : ChoicesIn(expr)) MarkSources(choice, true);
    const auto* call = what_ == What::kOffsets ? As<ObjectCall>(program_, expr) : nullptr;
    if (!call) return;
    for (const ExprId offset : program_.expr_lists[OperandsOf(*call, OperandKind::kOffset)]) {
      if (!IsLiteralOffset(offset))
        MarkSources(offset, call->op != ObjectOp::kTextureLoad && !MayVary(call->op));
    }
  }

  // The parts of the expression that choose what must be known, and are not written as numbers.
  std::vector<ExprId> ChoicesIn(ExprId expr) {
    if (what_ == What::kLocalObjects) return choices_.In(expr);
    return ChoosesSampler(program_, expr) ? OpenIndices(program_, expr) : std::vector<ExprId>();
  }

  void MarkSources(ExprId part, bool must_be_known) {
    has_parts_ = true;
    ForEachExpr(program_, part, [&](ExprId inner) {
      const auto* ref = As<VarRef>(program_, inner);
      if (!ref) return;
      is_source_[ref->var.index] = true;
      if (must_be_known) must_be_known_[ref->var.index] = true;
    });
  }

  // Marks all variables that offsets depend on. A counter depends on its loop's condition too.
  void FindSources() {
    ValueGraph graph(program_);
    std::vector<StmtId> bodies;
    for (const FunctionId id : program_.functions.ids()) {
      bodies.push_back(program_.functions[id].body);
      ForEachStmt(program_, bodies.back(), [&](StmtId stmt) {
        const auto* loop = As<For>(program_, stmt);
        if (!loop) return;
        if (const VarId counter = PartsOf(program_, *loop).counter)
          graph.AddValue(graph.NodeOf(counter), loop->condition);
      });
    }
    is_assigned_ = AssignedIn(program_, bodies);
    for (std::vector<bool>* marks : {&is_source_, &must_be_known_}) {
      marks->resize(graph.size());
      graph.SpreadToSources(*marks);
      marks->resize(program_.vars.size());
    }
  }

  // ---- known values: a variable whose value is known is a constant until it is restored
  struct Before {
    Storage storage;
    ExprId init;
  };

  void Restore(VarId var, const Before& before) {
    program_.vars[var].storage = before.storage;
    program_.vars[var].init = before.init;
  }
  void Forget(VarId var) {
    if (const auto found = known_.find(var); found != known_.end()) {
      Restore(var, found->second);
      known_.erase(found);
    }
  }
  // Returns false, and changes nothing, if the value is not known.
  bool Know(VarId var, ExprId value) {
    const auto bits = ConstantBits(program_, value);
    if (!bits) return false;
    const Var& as_it_is = program_.vars[var];
    known_.try_emplace(var, Before{as_it_is.storage, as_it_is.init});
    const ExprId literal = Builder(program_, as_it_is.span).ValueOf(as_it_is.type, *bits);
    program_.vars[var].storage = Storage::kConstant;
    program_.vars[var].init = literal;
    return true;
  }

  // ---- statements
  void ReadLater(FunctionId id) {
    if (is_read_.insert(id).second) unread_.push_back(id);
  }

  void Read(StmtId stmt) {
    if (const auto* loop = As<For>(program_, stmt); loop && Unroll(stmt, For(*loop))) return;
    if (const auto* branch = As<If>(program_, stmt); branch && branches_choose_) {
      const ExprId condition = branch->condition;
      if (const auto bits = ConstantBits(program_, condition)) ReplaceBy(condition, *bits);
    }
    ForEachPart(
        program_, stmt,
        [&](ExprId root) { ForEachExpr(program_, root, [&](ExprId expr) { ReadExpr(expr); }); },
        [&](StmtId part) { Read(part); });
    const auto* declare = As<Declare>(program_, stmt);
    if (!declare || !declare->init) return;
    const std::uint32_t var = declare->var.index;
    if (is_source_[var] && !is_assigned_[var]) Know(declare->var, declare->init);
  }

  void ReadExpr(ExprId expr) {
    for (const ExprId choice : ChoicesIn(expr)) {
      if (const auto bits = ConstantBits(program_, choice)) ReplaceBy(choice, *bits);
    }
    if (const auto* call = As<Call>(program_, expr)) return ReadCall(expr, Call(*call));
    const auto* call = what_ == What::kOffsets ? As<ObjectCall>(program_, expr) : nullptr;
    if (!call) return;
    const List<ExprId> offsets = OperandsOf(*call, OperandKind::kOffset);
    const ObjectOp op = call->op;
    for (std::uint32_t i = 0; i < offsets.size; ++i) {
      const ExprId offset = program_.expr_lists[offsets][i];
      if (IsLiteralOffset(offset)) continue;
      if (op == ObjectOp::kTextureLoad && !ConstantBits(program_, offset)) {
        AddToPlace(expr, ObjectCall(*call), offset);
      } else {
        const ExprId known = Known(offset, op);
        program_.expr_lists[offsets][i] = known;
      }
    }
  }

  // Makes the offset of a Load a part of its place. From 6.7 on it may be any value ("Programmable
  // Offsets" of the shader model's specification).
  void AddToPlace(ExprId expr, const ObjectCall& call, ExprId offset) {
    Builder at(program_, program_.exprs[offset].span);
    if (!program_.profile.IsAtLeast(6, 7)) {
      diagnostics_.Report(program_.exprs[offset].span, diag::TextureOffsetVaries,
                          InfoOf(call.op).method);
    }
    std::vector<NamedOperand> operands;
    ForEachNamedOperand(program_, call, [&](OperandKind kind, ExprId operand) {
      if (kind != OperandKind::kOffset) operands.push_back({kind, operand});
    });
    ExprId& place = std::ranges::find(operands, OperandKind::kPlace, &NamedOperand::kind)->expr;
    place = Moved(at, program_, place, offset);
    const ExprId moved = at.ObjectCallOf(call.op, program_.exprs[expr].type, operands);
    program_.exprs[expr].node = program_.exprs[moved].node;
  }

  // Whether Direct3D 11 takes the offset as a number like any other, with gather4_po.
  bool MayVary(ObjectOp op) const { return IsGather(op) && program_.profile.IsAtLeast(5, 0); }

  ExprId Known(ExprId offset, ObjectOp op) {
    const Span span = program_.exprs[offset].span;
    const auto bits = ConstantBits(program_, offset);
    if (!bits) {
      if (!MayVary(op))
        diagnostics_.Report(span, diag::TextureOffsetNotConstant, InfoOf(op).method);
      return offset;
    }
    const OffsetRange range = OffsetsOf(IsGather(op), program_.profile);
    for (const std::uint64_t word : *bits) {
      const auto texels = static_cast<std::int32_t>(static_cast<std::uint32_t>(word));
      if (!range.Has(texels)) {
        diagnostics_.Report(span, diag::TextureOffsetRange, texels, InfoOf(op).method, range.least,
                            range.most);
        return offset;
      }
    }
    return Builder(program_, span).ValueOf(TypeIdOf(program_, offset), *bits);
  }

  // ---- functions whose offsets depend on parameters

  // Whether the calls say what an offset of the function, or of one that it calls, is.
  bool IsCopied(FunctionId id) const {
    return std::ranges::any_of(program_.functions[id].parameters,
                               [&](VarId parameter) { return IsGiven(parameter); });
  }
  bool IsGiven(VarId parameter) const {
    return must_be_known_[parameter.index] && !is_assigned_[parameter.index] &&
           program_.vars[parameter].storage == Storage::kIn;
  }

  // Calls the copy of the function for the constants that the call gives:
  //
  //   Near(uv, int2(1, 0))  =>  Near(uv), with `int2(1, 0)` for the parameter
  //
  // fxc inlines every call, so it takes such an offset (its listing of FXAA 1.0). An argument that
  // is not constant leaves the function as it is, whose offset is reported then.
  void ReadCall(ExprId expr, const Call& call) {
    if (!IsCopied(call.function)) return;
    const std::vector<VarId> parameters = program_.functions[call.function].parameters;
    std::vector<std::uint64_t> key{call.function.index};
    std::vector<ExprId> kept;
    std::map<VarId, ExprId> given;
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ExprId argument = program_.expr_lists[call.arguments][i];
      const auto bits = IsGiven(parameters[i]) ? ConstantBits(program_, argument) : std::nullopt;
      if (IsGiven(parameters[i]) && !bits) {
        return ReadLater(call.function);
      }
      if (!bits) {
        kept.push_back(argument);
        continue;
      }
      key.insert(key.end(), bits->begin(), bits->end());
      given[parameters[i]] = argument;
    }
    const auto known = copies_.find(key);
    if (known == copies_.end() && !MayCopy(program_.exprs[expr].span)) return;
    const FunctionId copy = known != copies_.end() ? known->second : CopyFor(call.function, given);
    copies_[key] = copy;
    program_.exprs[expr].node = Call{copy, program_.expr_lists.Add(kept)};
  }

  FunctionId CopyFor(FunctionId id, const std::map<VarId, ExprId>& given) {
    Function function = program_.functions[id];
    BodyCloner cloner(program_);
    std::vector<VarId> kept;
    for (const VarId parameter : function.parameters) {
      const VarId copy = cloner.CloneVar(parameter);
      if (!given.contains(parameter)) kept.push_back(copy);
    }
    function.parameters = kept;
    function.body = cloner.Clone(function.body);
    CopyMarks(cloner);
    std::map<VarId, ExprId> values;
    for (const auto& [from, to] : cloner.vars()) {
      if (const auto found = given.find(from); found != given.end()) values[to] = found->second;
    }
    ForEachExpr(program_, function.body, [&](ExprId part) {
      const auto* ref = As<VarRef>(program_, part);
      const auto found = ref ? values.find(ref->var) : values.end();
      if (found != values.end()) ReplaceBy(part, *ConstantBits(program_, found->second));
    });
    const FunctionId copy = program_.functions.Add(std::move(function));
    unread_.push_back(copy);
    return copy;
  }

  void ReplaceBy(ExprId expr, const std::vector<std::uint64_t>& bits) {
    const Span span = program_.exprs[expr].span;
    const ExprId value = Builder(program_, span).ValueOf(TypeIdOf(program_, expr), bits);
    program_.exprs[expr].node = program_.exprs[value].node;
  }

  // ---- loops
  bool MayCopy(Span span) {
    if (program_.exprs.size() >= kMaxExpressions)
      return Refuse(span, kMaxExpressions, "expressions");
    return ++made_ <= kMaxCopies || Refuse(span, kMaxCopies, "copies of loops and functions");
  }
  bool Refuse(Span span, std::size_t limit, std::string_view of) {
    if (!std::exchange(is_reported_, true))
      diagnostics_.Report(span, diag::TooManyCopies, limit, of);
    return false;
  }

  // Whether each iteration changes the counter only in its step.
  bool IsPlain(const For& loop, const CountedLoop& parts) const {
    return loop.init.size == 1 && parts.start && parts.step &&
           program_.vars[parts.counter].storage == Storage::kLocal &&
           IsPure(program_, loop.condition) && !IsChangedInBody(program_, loop, parts.counter);
  }

  // The counter's value after the step, as an expression in the counter.
  ExprId NextOf(Builder at, const CountedLoop& parts) {
    const Scalar kind = program_.types[program_.vars[parts.counter].type].scalar;
    const ExprId size = parts.step_size ? Clone(program_, parts.step_size) : at.LiteralOf(kind, 1);
    return at.BinaryOf(parts.is_down ? BinaryOp::kSub : BinaryOp::kAdd, at.Ref(parts.counter),
                       size);
  }

  // A copy of the loop's body, whose variables have the marks of the original's.
  StmtId CopyOf(StmtId body) {
    BodyCloner cloner(program_);
    const StmtId copy = cloner.Clone(body);
    CopyMarks(cloner);
    return copy;
  }
  void CopyMarks(const BodyCloner& cloner) {
    for (std::vector<bool>* marks : {&is_source_, &is_assigned_, &must_be_known_}) {
      marks->resize(program_.vars.size());
      for (const auto& [from, to] : cloner.vars()) (*marks)[to.index] = (*marks)[from.index];
    }
  }

  // Replaces the counter, whose value is known, by it in a copy of the loop's body, as well as what
  // is made of the counter in whole numbers; a branch that the value never takes is removed.
  void Insert(VarId counter, StmtId body) {
    ForEachExpr(program_, body, [&](ExprId expr) {
      const auto* ref = As<VarRef>(program_, expr);
      const auto* convert = As<Convert>(program_, expr);
      const Type& type = TypeOf(program_, convert ? convert->operand : expr);
      if (ref ? ref->var != counter : !type.IsNumeric() || IsFloat(type.scalar)) return;
      const bool has_counter = AnyExpr(program_, expr, [&](ExprId part) {
        const auto* inner = As<VarRef>(program_, part);
        return inner && inner->var == counter;
      });
      if (!has_counter) return;
      if (const auto bits = ConstantBits(program_, expr)) ReplaceBy(expr, *bits);
    });
    ForEachStmt(program_, body, [&](StmtId stmt) {
      const auto* branch = As<If>(program_, stmt);
      const auto* literal = branch ? As<Literal>(program_, branch->condition) : nullptr;
      if (!literal) return;
      const StmtId taken = literal->bits != 0 ? branch->then : branch->otherwise;
      program_.stmts[stmt].node =
          taken ? program_.stmts[taken].node : decltype(Stmt::node)(Block{});
    });
  }

  // Unrolls for (int i = 0; i < 2; ++i) body  =>  { body body }, each with the value of `i`.
  // Returns false if no offset depends on the counter or the counter's values are not known.
  bool Unroll(StmtId stmt, const For& loop) {
    const CountedLoop parts = PartsOf(program_, loop);
    if (!parts.counter || !is_source_[parts.counter.index] || !loop.condition ||
        !IsPlain(loop, parts) || !Know(parts.counter, parts.start))
      return false;
    Builder at(program_, program_.stmts[stmt].span);
    // A counter that is declared before the loop may be read after it.
    UnrolledLoop unrolled(program_);
    if (!parts.is_declared) unrolled.Add(program_.stmt_lists[loop.init][0]);
    const ExprId next = NextOf(at, parts);
    bool is_known = true;
    while (is_known) {
      const auto goes_on = ConstantBits(program_, loop.condition);
      is_known = goes_on.has_value();
      if (!is_known || goes_on->front() == 0) break;
      if (!MayCopy(program_.stmts[stmt].span)) break;
      const StmtId body = CopyOf(loop.body);
      Insert(parts.counter, body);
      const LoopJump jump = CutAtJump(program_, body);
      Read(body);
      if (!unrolled.AddIteration(body, jump)) break;
      if (!parts.is_declared) unrolled.Add(at.Eval(Clone(program_, parts.step)));
      is_known = Know(parts.counter, next);
    }
    Forget(parts.counter);
    if (!is_known) return false;
    auto node = unrolled.Finish();
    program_.stmts[stmt].node = std::move(node);
    return true;
  }

  Program& program_;
  const What what_;
  Diagnostics& diagnostics_;
  bool has_parts_ = false;
  bool branches_choose_ = false;  // local objects
  // By VarId: offsets depend on it; it is assigned to; an offset that may not vary depends on it.
  std::vector<bool> is_source_, is_assigned_, must_be_known_;
  std::map<std::vector<std::uint64_t>, FunctionId> copies_;  // by function and constants
  std::set<FunctionId> is_read_;
  std::vector<FunctionId> unread_;
  std::map<VarId, Before> known_;
  ObjectChoices choices_{program_};
  std::size_t made_ = 0;
  bool is_reported_ = false;
};

}  // namespace

void KnowOffsets(Program& program, Diagnostics& diagnostics) {
  OffsetFinder(program, What::kOffsets, diagnostics).Run();
}

void KnowObjectIndices(Program& program, Diagnostics& diagnostics) {
  OffsetFinder(program, What::kLocalObjects, diagnostics).Run();
}

}  // namespace clipc::resolve
