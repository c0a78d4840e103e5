// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/fold_arguments.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/overloaded.h"
#include "frontend/resolve/object_choices.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/call_order.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

// What is known of a parameter: nothing yet, one constant for all calls, or several values.
struct Value {
  enum class Kind : std::uint8_t { kNone, kConstant, kAny } kind = Kind::kNone;
  std::uint64_t bits = 0;
};

class Folder {
 public:
  Folder(Program& program, bool folds_locals)
      : program_(program), folds_locals_(folds_locals), values_(program.vars.size()) {}

  void Run() {
    KeptVector<FunctionId> order = CalleesFirst(program_);
    // The calls of a function have their last form before its own body is folded.
    for (auto id = order.rbegin(); id != order.rend(); ++id) {
      const StmtId body = program_.functions[*id].body;
      Substitute(*id);
      if (folds_locals_) SubstituteLocals(body);
      Fold(body);
      ForEachExpr(program_, body, [&](ExprId expr) {
        if (const auto* call = As<Call>(program_, expr)) Note(*call);
      });
    }
  }

  void FoldBody(StmtId body) {
    SubstituteLocals(body);
    Fold(body);
  }

 private:
  // ---- parameters

  void Note(const Call& call) {
    const std::vector<VarId>& parameters = program_.functions[call.function].parameters;
    for (std::uint32_t i = 0; i < call.arguments.size && i < parameters.size(); ++i) {
      const ExprId argument = program_.expr_lists[call.arguments][i];
      const auto bits = ConstantOf(argument);
      Value& value = values_[parameters[i].index];
      if (!bits || (value.kind != Value::Kind::kNone && value.bits != *bits)) {
        value.kind = Value::Kind::kAny;
      } else if (value.kind == Value::Kind::kNone) {
        value = {Value::Kind::kConstant, *bits};
      }
    }
  }

  std::optional<std::uint64_t> ConstantOf(ExprId expr) const {
    if (TypeOf(program_, expr).kind != TypeKind::kScalar) return std::nullopt;
    const auto bits = ConstantBits(program_, expr);
    return bits ? std::optional(bits->front()) : std::nullopt;
  }

  // Puts the constants in the place of the parameters that the function does not change.
  void Substitute(FunctionId id) {
    const StmtId body = program_.functions[id].body;
    std::vector<bool> assigned;
    for (const VarId parameter : program_.functions[id].parameters) {
      Value& value = values_[parameter.index];
      if (value.kind != Value::Kind::kConstant) continue;
      if (assigned.empty()) assigned = AssignedIn(program_, {&body, 1});
      if (program_.vars[parameter].storage != Storage::kIn || assigned[parameter.index])
        value.kind = Value::Kind::kAny;
    }
    if (assigned.empty()) return;
    ForEachExpr(program_, body, [&](ExprId expr) {
      const auto* ref = As<VarRef>(program_, expr);
      if (!ref || values_[ref->var.index].kind != Value::Kind::kConstant) return;
      program_.exprs[expr].node = Literal{values_[ref->var.index].bits};
    });
  }

  // ---- locals

  // What the body writes to a local variable, or to one of its fields: kWhole is the variable.
  struct LocalWrites {
    int times = 0;
    ExprId value;
  };
  using LocalPart = std::pair<VarId, std::uint32_t>;
  static constexpr std::uint32_t kWhole = ~0u;

  // The local variable, or a field of one, that the expression is.
  std::optional<LocalPart> PlaceOf(ExprId expr) const {
    const auto* field = As<FieldRef>(program_, expr);
    const auto* ref = As<VarRef>(program_, field ? field->base : expr);
    if (!ref || program_.vars[ref->var].storage != Storage::kLocal) return std::nullopt;
    return LocalPart{ref->var, field ? field->field : kWhole};
  }

  // Puts constants in the place of the calls of functions that only return one, and of local
  // variables that get one value, a constant. What reads one before that is not defined.
  void SubstituteLocals(StmtId body) {
    std::map<LocalPart, LocalWrites> written;
    std::set<ExprId> targets;
    ForEachStmt(program_, body, [&](StmtId id) {
      const auto* declare = As<Declare>(program_, id);
      if (declare && declare->init) Write(written, {declare->var, kWhole}, declare->init);
    });
    ForEachExpr(program_, body, [&](ExprId expr) {
      ForEachWrite(program_, expr, [&](ExprId target) {
        const auto* assign = As<Assign>(program_, expr);
        const auto place = PlaceOf(target);
        for (ExprId part = target; part; part = WholeOf(program_, part)) targets.insert(part);
        if (place) return Write(written, *place, assign && !assign->op ? assign->value : ExprId{});
        if (const VarId root = RootOf(program_, target)) Write(written, {root, kWhole}, {});
      });
    });
    ForEachExpr(program_, body, [&](ExprId expr) {
      if (targets.contains(expr)) return;
      const auto* call = As<Call>(program_, expr);
      const auto value = call ? ResultOf(*call) : ValueAt(written, expr);
      if (value) program_.exprs[expr].node = Literal{*value};
    });
  }

  static void Write(std::map<LocalPart, LocalWrites>& written, LocalPart place, ExprId value) {
    LocalWrites& known = written[place];
    ++known.times;
    known.value = value;
  }

  std::optional<std::uint64_t> ValueAt(const std::map<LocalPart, LocalWrites>& written,
                                       ExprId expr) const {
    const auto* swizzle = As<Swizzle>(program_, expr);
    const bool is_component = swizzle && swizzle->count == 1;
    const auto place = PlaceOf(is_component ? swizzle->base : expr);
    const auto found = place ? written.find(*place) : written.end();
    if (found == written.end() || found->second.times != 1 || !found->second.value)
      return std::nullopt;
    if (place->second != kWhole && written.contains({place->first, kWhole})) return std::nullopt;
    if (!is_component) return ConstantOf(found->second.value);
    const auto bits = ConstantBits(program_, found->second.value);
    return bits ? std::optional((*bits)[swizzle->components[0]]) : std::nullopt;
  }

  // The constant that a function returns, if it does nothing else.
  std::optional<std::uint64_t> ResultOf(const Call& call) const {
    for (const ExprId argument : program_.expr_lists[call.arguments]) {
      if (!IsPure(program_, argument)) return std::nullopt;
    }
    const auto* block = As<Block>(program_, program_.functions[call.function].body);
    if (!block || block->body.size != 1) return std::nullopt;
    const auto* result = As<Return>(program_, program_.stmt_lists[block->body][0]);
    return result && result->value ? ConstantOf(result->value) : std::nullopt;
  }

  // ---- conditions

  std::optional<bool> Decided(ExprId condition) const {
    const auto bits = ConstantOf(condition);
    return bits ? std::optional(*bits != 0) : std::nullopt;
  }

  // Removes from an expression the sides that a constant condition does not choose.
  ExprId Folded(ExprId expr) {
    MapOperands(program_, expr, [&](ExprId operand) { return Folded(operand); });
    if (const auto* choice = As<Conditional>(program_, expr)) {
      if (const auto chosen = Decided(choice->condition))
        return *chosen ? choice->when_true : choice->when_false;
    }
    if (const auto* index = As<Index>(program_, expr); index && ChoosesElement(program_, expr)) {
      const ExprId number = index->index;
      if (const auto bits = ConstantOf(number)) program_.exprs[number].node = Literal{*bits};
    }
    const auto* binary = As<Binary>(program_, expr);
    if (!binary || TypeOf(program_, expr).kind != TypeKind::kScalar) return expr;
    switch (binary->op) {
      case BinaryOp::kLogicalAnd:
      case BinaryOp::kShortCircuitAnd: return OneSide(expr, *binary, true);
      case BinaryOp::kLogicalOr:
      case BinaryOp::kShortCircuitOr: return OneSide(expr, *binary, false);
      default: return expr;
    }
  }

  // A side that is `neutral` leaves the other side; one that is not decides alone.
  ExprId OneSide(ExprId expr, const Binary& binary, bool neutral) const {
    const ExprId sides[] = {binary.left, binary.right};
    for (const int i : {0, 1}) {
      const auto decided = Decided(sides[i]);
      if (!decided) continue;
      if (*decided == neutral) return sides[1 - i];
      if (IsPure(program_, sides[1 - i])) return sides[i];
    }
    return expr;
  }

  // Folds the statement in its place.
  void Fold(StmtId id) {
    auto changed = program_.stmts[id];
    ForEachPartSlot(
        changed, [&](ExprId& expr) { expr = Folded(expr); }, [&](StmtId& part) { Fold(part); },
        [&](List<StmtId>& list) { list = FoldedList(list); },
        [&](List<SwitchCase> cases) {
          for (std::uint32_t i = 0; i < cases.size; ++i) {
            const List<StmtId> body = FoldedList(program_.switch_cases[cases][i].body);
            program_.switch_cases[cases][i].body = body;
          }
        });
    program_.stmts[id] = changed;
    if (const auto* choice = As<Switch>(program_, id); choice && folds_locals_)
      FoldSwitch(id, Switch(*choice));
    const auto* branch = As<If>(program_, id);
    const auto chosen = branch ? Decided(branch->condition) : std::nullopt;
    if (!chosen) return;
    const StmtId arm = *chosen ? branch->then : branch->otherwise;
    if (arm) {
      const auto taken = program_.stmts[arm];
      program_.stmts[id] = taken;
    } else {
      program_.stmts[id].node = Block{};
      program_.stmts[id].hint = {};
    }
  }

  // Removes the arms that a constant value of a `switch` does not run.
  void FoldSwitch(StmtId id, const Switch& node) {
    const auto value = ConstantOf(node.value);
    if (!value) return;
    const std::span<const SwitchCase> arms = program_.switch_cases[node.cases];
    const auto has_value = [&](const SwitchCase& arm) {
      return std::ranges::any_of(program_.expr_lists[arm.labels], [&](ExprId label) {
        const auto* literal = As<Literal>(program_, label);
        return literal && literal->bits == *value;
      });
    };
    auto arm = std::ranges::find_if(arms, has_value);
    if (arm == arms.end()) arm = std::ranges::find_if(arms, &SwitchCase::is_default);
    std::vector<SwitchCase> left;
    for (bool goes_on = true; goes_on && arm != arms.end(); ++arm) {
      left.push_back(*arm);
      const auto body = program_.stmt_lists[arm->body];
      goes_on = body.empty() || !Ends(body.back());
    }
    program_.stmts[id].node = Switch{node.value, program_.switch_cases.Add(left)};
    if (left.empty()) program_.stmts[id].node = Block{};
  }

  // The statements folded, without those that an arm before them keeps from running. An arm that
  // took the place of its `if` is not a separate block.
  List<StmtId> FoldedList(List<StmtId> list) {
    std::vector<StmtId> left;
    for (std::uint32_t i = 0; i < list.size; ++i) {
      const StmtId id = program_.stmt_lists[list][i];
      const bool is_branch = As<If>(program_, id) != nullptr;
      Fold(id);
      const auto* block = is_branch ? As<Block>(program_, id) : nullptr;
      if (!block) {
        left.push_back(id);
      } else {
        for (const StmtId inner : program_.stmt_lists[block->body]) left.push_back(inner);
      }
      if (is_branch && !left.empty() && Ends(left.back())) break;
    }
    return program_.stmt_lists.Add(left);
  }

  bool Ends(StmtId id) const {
    return As<Return>(program_, id) || As<Break>(program_, id) || As<Continue>(program_, id);
  }

  Program& program_;
  const bool folds_locals_;
  std::vector<Value> values_;  // by VarId, of parameters
};

// Whether the call is one of an object that is not a resource's own name.
bool NamesObject(const Program& program, ExprId expr) {
  if (const auto* swizzle = As<Swizzle>(program, expr)) expr = swizzle->base;
  const auto* call = As<ObjectCall>(program, expr);
  if (!call) return false;
  const VarId root = RootOf(program, OperandOf(program, *call, OperandKind::kObject));
  return !root || program.vars[root].storage != Storage::kResource;
}

bool ChoosesObject(const Program& program) {
  if (!program.calls_objects) return false;
  if (BranchesChoose(program)) return true;
  bool chooses = false;
  program.exprs.ForEach([&](ExprId id, const Expr& expr) {
    if (const auto* choice = std::get_if<Conditional>(&expr.node)) {
      chooses = chooses || program.types[expr.type].kind == TypeKind::kObject ||
                NamesObject(program, choice->when_true) || NamesObject(program, choice->when_false);
    } else if (std::holds_alternative<Index>(expr.node) ||
               std::holds_alternative<FieldRef>(expr.node)) {
      chooses = chooses || ChoosesElement(program, id);
    }
  });
  return chooses;
}

}  // namespace

void FoldArguments(Program& program) { Folder(program, false).Run(); }

void FoldBody(Program& program, StmtId body) { Folder(program, true).FoldBody(body); }

void FoldObjectChoices(Program& program) {
  if (ChoosesObject(program)) Folder(program, true).Run();
}

}  // namespace clipc::resolve
