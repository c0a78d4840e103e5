// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/unroll_loops.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/clone_body.h"
#include "ir/evaluate.h"
#include "ir/walk.h"
#include "legalize/es100/known_values.h"
#include "legalize/es100/refused.h"
#include "legalize/es100/unrolled_body.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// The functions of a program, each of which is walked once, and its copies.
class Functions {
 public:
  Functions(Program& program, Refused& refused)
      : program_(program), refused_(refused), known_(program, refused) {
    known_.on_call = [this](ExprId call) { ReadCall(call); };
  }

  std::vector<LongLoop> Run() {
    Add(program_.main, {});
    while (!waiting_.empty()) {
      auto [id, values] = std::move(waiting_.back());
      waiting_.pop_back();
      known_.now = std::move(values);
      UnrolledBody(program_, refused_, known_, limits_).Walk(program_.functions[id].body);
      CleanUp(program_.functions[id].body);
    }
    return std::move(limits_.found);
  }

 private:
  void Add(FunctionId id, Values values) {
    if (is_added_.insert(id).second) waiting_.emplace_back(id, std::move(values));
  }

  // Calls the copy of the function for the constants that the call gives.
  void ReadCall(ExprId expr) {
    const Call call = *As<Call>(program_, expr);
    if (!refused_.Has(call.function)) return;
    const std::vector<VarId> parameters = program_.functions[call.function].parameters;
    std::vector<std::uint64_t> key{call.function.index};
    std::vector<ExprId> kept;
    Values given;
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ExprId argument = program_.expr_lists[call.arguments][i];
      const bool may_be =
          program_.vars[parameters[i]].storage == Storage::kIn && known_.MayKnow(parameters[i]);
      const auto bits = may_be ? ConstantBits(program_, argument) : std::nullopt;
      if (!bits) {
        kept.push_back(argument);
        continue;
      }
      key.push_back(i);
      key.insert(key.end(), bits->begin(), bits->end());
      given[parameters[i]] = {*bits, false};
    }
    const auto known = copies_.find(key);
    const bool may_copy = !given.empty() && limits_.Allows(program_);
    if (known == copies_.end() && !may_copy) return Add(call.function, {});
    const FunctionId copy = known != copies_.end() ? known->second : CopyFor(call.function, given);
    copies_[key] = copy;
    program_.exprs[expr].node = Call{copy, program_.expr_lists.Add(kept)};
  }

  // A copy of the function in which the given parameters are variables with these values.
  FunctionId CopyFor(FunctionId id, const Values& given) {
    Function function = program_.functions[id];
    BodyCloner cloner(program_);
    Builder b(program_, function.span);
    std::vector<VarId> kept;
    std::vector<StmtId> body;
    Values values;
    for (const VarId parameter : function.parameters) {
      const VarId copy = cloner.CloneVar(parameter);
      const auto known = given.find(parameter);
      if (known == given.end()) {
        kept.push_back(copy);
        continue;
      }
      program_.vars[copy].storage = Storage::kLocal;
      body.push_back(b.Stmt(Declare{copy, {}}));
      values[copy] = known->second;
    }
    const std::vector<StmtId> copies = PartsOf(cloner.Clone(function.body));
    body.insert(body.end(), copies.begin(), copies.end());
    refused_.AddCopies(cloner);
    function.parameters = kept;
    function.body = b.BlockOf(body);
    const FunctionId copy = program_.functions.Add(std::move(function));
    Add(copy, std::move(values));
    return copy;
  }

  // Removes declarations of variables that nothing uses any more, and braces that no variable
  // needs.
  void CleanUp(StmtId body) {
    std::vector<char> is_used(program_.vars.size());
    ForEachExpr(program_, body, [&](ExprId expr) {
      if (const auto* ref = As<VarRef>(program_, expr)) is_used[ref->var.index] = 1;
    });
    const auto is_unused = [&](StmtId part) {
      const auto* declare = As<Declare>(program_, part);
      return declare && (!declare->init || IsPure(program_, declare->init)) &&
             is_used[declare->var.index] == 0;
    };
    std::vector<StmtId> blocks;
    ForEachStmt(program_, body, [&](StmtId stmt) {
      if (As<Block>(program_, stmt)) blocks.push_back(stmt);
    });
    std::ranges::reverse(blocks);  // inner ones first
    for (const StmtId stmt : blocks) {
      const auto parts = PartsOf(stmt);
      std::vector<StmtId> kept;
      for (const StmtId part : parts) {
        if (is_unused(part)) continue;
        const bool is_block = As<Block>(program_, part) != nullptr;
        const std::vector<StmtId> inner = is_block ? PartsOf(part) : std::vector{part};
        const bool is_scope = parts.size() > 1 && std::ranges::any_of(inner, [&](StmtId each) {
                                return As<Declare>(program_, each) != nullptr;
                              });
        if (is_block && is_scope)
          kept.push_back(part);
        else
          kept.insert(kept.end(), inner.begin(), inner.end());
      }
      program_.stmts[stmt].node = Block{program_.stmt_lists.Add(kept)};
    }
  }
  std::vector<StmtId> PartsOf(StmtId block) const {
    const auto list = program_.stmt_lists[As<Block>(program_, block)->body];
    return {list.begin(), list.end()};
  }

  Program& program_;
  Refused& refused_;
  KnownValues known_;
  UnrollLimits limits_{program_.exprs.size()};
  std::map<std::vector<std::uint64_t>, FunctionId> copies_;  // by function and constants
  std::set<FunctionId> is_added_;
  std::vector<std::pair<FunctionId, Values>> waiting_;
};

}  // namespace

std::vector<LongLoop> UnrollLoops(Program& program, const Needs& needs) {
  if (!needs.constant_loops) return {};
  Refused refused(program);
  return refused.IsAny() ? Functions(program, refused).Run() : std::vector<LongLoop>();
}

}  // namespace clipc::legalize
