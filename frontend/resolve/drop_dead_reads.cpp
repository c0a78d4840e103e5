// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/drop_dead_reads.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "frontend/resolve/fold_arguments.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/clone_body.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

constexpr std::size_t kMaxSpecialised = 4096;

// A copier of functions for the constants of their calls, which folds each copy.
class Specialiser {
 public:
  explicit Specialiser(Program& program) : program_(program) {}

  void Run() {
    Reach(program_.main);
    while (!open_.empty()) {
      const FunctionId id = open_.back();
      open_.pop_back();
      const StmtId body = program_.functions[id].body;
      FoldBody(program_, body);
      ForEachExpr(program_, body, [&](ExprId expr) {
        if (const auto* call = As<Call>(program_, expr)) Replace(expr, Call(*call));
      });
    }
    for (const FunctionId id : program_.functions.ids()) {
      if (!reached_.contains(id)) program_.stmts[program_.functions[id].body].node = Block{};
    }
  }

 private:
  void Reach(FunctionId id) {
    if (reached_.insert(id).second) open_.push_back(id);
  }

  // Calls the copy of the function for the constants among the arguments.
  void Replace(ExprId expr, const Call& call) {
    const Function& function = program_.functions[call.function];
    const std::vector<bool> assigned = AssignedIn(program_, {&function.body, 1});
    std::vector<std::uint64_t> key{call.function.index};
    std::map<VarId, std::uint64_t> given;
    std::vector<ExprId> kept;
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ExprId argument = program_.expr_lists[call.arguments][i];
      const VarId parameter = function.parameters[i];
      const bool may_be_given = program_.vars[parameter].storage == Storage::kIn &&
                                !assigned[parameter.index] &&
                                TypeOf(program_, argument).kind == TypeKind::kScalar;
      const auto bits = may_be_given ? ConstantBits(program_, argument) : std::nullopt;
      if (!bits) {
        kept.push_back(argument);
        continue;
      }
      given[parameter] = bits->front();
      key.insert(key.end(), {i, bits->front()});
    }
    if (given.empty() || call.function == program_.entry || copies_.size() >= kMaxSpecialised)
      return Reach(call.function);
    const auto known = copies_.find(key);
    const FunctionId copy = known != copies_.end() ? known->second : CopyFor(call.function, given);
    copies_[key] = copy;
    program_.exprs[expr].node = Call{copy, program_.expr_lists.Add(kept)};
    Reach(copy);
  }

  FunctionId CopyFor(FunctionId id, const std::map<VarId, std::uint64_t>& given) {
    Function function = program_.functions[id];
    BodyCloner cloner(program_);
    std::vector<VarId> kept;
    std::map<VarId, std::uint64_t> values;
    for (const VarId parameter : function.parameters) {
      const VarId copy = cloner.CloneVar(parameter);
      const auto found = given.find(parameter);
      if (found == given.end())
        kept.push_back(copy);
      else
        values[copy] = found->second;
    }
    function.parameters = kept;
    function.body = cloner.Clone(function.body);
    ForEachExpr(program_, function.body, [&](ExprId part) {
      const auto* ref = As<VarRef>(program_, part);
      const auto found = ref ? values.find(ref->var) : values.end();
      if (found != values.end()) program_.exprs[part].node = Literal{found->second};
    });
    return program_.functions.Add(std::move(function));
  }

  Program& program_;
  std::set<FunctionId> reached_;
  std::vector<FunctionId> open_;
  std::map<std::vector<std::uint64_t>, FunctionId> copies_;  // by function and constants
};

// A remover of values that go to local variables and parameters that nothing reads.
class UnusedValues {
 public:
  explicit UnusedValues(Program& program) : program_(program) {}

  void Run() {
    do {
      changed_ = false;
      CountReads();
      for (const FunctionId id : program_.functions.ids()) Remove(program_.functions[id].body);
    } while (changed_);
  }

 private:
  // The variable that the whole statement assigns to, wholly or in part; none for every other
  // statement.
  VarId TargetOf(StmtId stmt) const {
    const Assign* assign = AsAssignment(program_, stmt);
    return assign ? RootOf(program_, assign->target) : VarId{};
  }

  void CountReads() {
    reads_.assign(program_.vars.size(), 0);
    ForEachLiveExpr(program_, [&](ExprId expr) {
      if (const auto* ref = As<VarRef>(program_, expr)) ++reads_[ref->var.index];
    });
    for (const FunctionId id : program_.functions.ids()) {
      ForEachStmt(program_, program_.functions[id].body, [&](StmtId stmt) {
        if (const VarId var = TargetOf(stmt)) --reads_[var.index];
      });
    }
  }

  bool IsUnread(VarId var) const {
    const Storage storage = program_.vars[var].storage;
    return (storage == Storage::kLocal || storage == Storage::kIn) && reads_[var.index] == 0;
  }
  // Whether removing the value removes a read of an object or a variable, and nothing else that
  // matters.
  bool IsDeadRead(ExprId value) const {
    return value && IsPure(program_, value) && AnyExpr(program_, value, [&](ExprId part) {
             return As<ObjectCall>(program_, part) || As<VarRef>(program_, part);
           });
  }

  void Remove(StmtId body) {
    ForEachStmt(program_, body, [&](StmtId stmt) {
      if (auto* declare = std::get_if<Declare>(&program_.stmts[stmt].node)) {
        if (!IsUnread(declare->var) || !IsDeadRead(declare->init)) return;
        declare->init = {};
        changed_ = true;
        return;
      }
      const VarId var = TargetOf(stmt);
      if (!var || !IsUnread(var)) return;
      const Assign& assign = *AsAssignment(program_, stmt);
      if (!IsDeadRead(assign.value) || !IsPure(program_, assign.target)) return;
      program_.stmts[stmt].node = Block{};
      changed_ = true;
    });
    ForEachExpr(program_, body, [&](ExprId expr) {
      const auto* call = As<Call>(program_, expr);
      if (!call) return;
      const List<ExprId> arguments = call->arguments;
      const FunctionId callee = call->function;
      for (std::uint32_t i = 0; i < arguments.size; ++i) {
        const VarId parameter = program_.functions[callee].parameters[i];
        const ExprId argument = program_.expr_lists[arguments][i];
        if (!IsUnread(parameter) || !IsDeadRead(argument)) continue;
        Builder at(program_, program_.exprs[argument].span);
        program_.expr_lists[arguments][i] = at.ZeroOf(TypeIdOf(program_, argument));
        changed_ = true;
      }
    });
  }

  Program& program_;
  std::vector<int> reads_;  // by VarId: the references but those that only assign
  bool changed_ = false;
};

}  // namespace

void DropDeadReads(Program& program) {
  Specialiser(program).Run();
  UnusedValues(program).Run();
}

}  // namespace clipc::resolve
