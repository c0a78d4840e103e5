// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/refused.h"

#include "base/stage.h"
#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/counted_loop.h"
#include "ir/value_graph.h"
#include "ir/walk.h"
#include "legalize/es100/loops.h"

namespace clipc::legalize {

using namespace ir;

Refused::Refused(const Program& program)
    : program_(program),
      counters_(program.vars.size()),
      functions_(program.functions.size()),
      outside_(program.vars.size()) {
  std::vector<ExprId> roots;
  for (const FunctionId id : CalleesFirst(program)) ReadFunction(id, roots);
  if (IsAny()) FindSources(roots);
}

bool Refused::IsRefusedIndex(ExprId expr) const {
  const auto* index = As<Index>(program_, expr);
  const auto* ref = index ? As<VarRef>(program_, index->base) : nullptr;
  if (!ref) return false;
  const Storage storage = program_.vars[ref->var].storage;
  if (storage == Storage::kResource) return !As<Literal>(program_, index->index);
  return storage == Storage::kUniform && InfoOf(program_.stage).draws_pixels &&
         !IsConstantIndex(program_, index->index, counters_);
}

// Appends the conditions of refused loops and the refused indices.
void Refused::ReadFunction(FunctionId id, std::vector<ExprId>& roots) {
  const StmtId body = program_.functions[id].body;
  const std::size_t before = roots.size();
  const CountedLoops loops(program_, body);
  bool is_any = false;
  ForEachStmt(program_, body, [&](StmtId stmt) {
    CountedLoop loop;
    if (!loops.WhyNot(stmt, loop).empty()) {
      is_any = true;
      const auto add = [&](ExprId condition) {
        if (condition) roots.push_back(condition);
      };
      if (const auto* node = As<For>(program_, stmt)) add(node->condition), add(loop.step_size);
      if (const auto* node = As<While>(program_, stmt)) add(node->condition);
      if (const auto* node = As<DoWhile>(program_, stmt)) add(node->condition);
    }
    if (loop.counter) counters_[loop.counter.index] = 1;
  });
  ForEachExpr(program_, body, [&](ExprId expr) {
    if (IsRefusedIndex(expr)) roots.push_back(As<Index>(program_, expr)->index);
    const auto* call = As<Call>(program_, expr);
    is_any |= call && functions_[call->function.index];
  });
  functions_[id.index] = is_any || roots.size() > before;
  if (functions_[id.index]) CountUses(body);
}

void Refused::CountUses(StmtId body) {
  std::vector<std::uint32_t> all(program_.vars.size()), counted(program_.vars.size());
  const auto count = [&](auto root, std::vector<std::uint32_t>& uses, VarId only) {
    ForEachExpr(program_, root, [&](ExprId expr) {
      const auto* ref = As<VarRef>(program_, expr);
      if (ref && (!only || ref->var == only)) ++uses[ref->var.index];
    });
  };
  count(body, all, {});
  ForEachStmt(program_, body, [&](StmtId stmt) {
    const auto* loop = As<For>(program_, stmt);
    const CountedLoop parts = loop ? PartsOf(program_, *loop) : CountedLoop{};
    if (parts.counter && !parts.is_declared) count(stmt, counted, parts.counter);
  });
  for (const VarId var : program_.vars.ids()) {
    const std::uint32_t i = var.index;
    if (counted[i] > 0 && counted[i] != all[i]) outside_[i] = true;
  }
}

void Refused::FindSources(const std::vector<ExprId>& roots) {
  const ValueGraph graph(program_);
  std::vector<bool> marks(graph.size());
  for (const ExprId root : roots) {
    ForEachExpr(program_, root, [&](ExprId expr) {
      if (const auto* ref = As<VarRef>(program_, expr)) marks[graph.NodeOf(ref->var)] = true;
      if (const auto* call = As<Call>(program_, expr)) marks[graph.NodeOf(call->function)] = true;
    });
  }
  graph.SpreadToSources(marks);
  marks.resize(program_.vars.size());
  sources_ = std::move(marks);
}

void Refused::AddCopies(const BodyCloner& cloner) {
  const auto add = [&](auto& marks) {
    marks.resize(program_.vars.size());
    for (const auto& [from, to] : cloner.vars()) marks[to.index] = marks[from.index];
  };
  add(counters_), add(sources_), add(outside_);
}

}  // namespace clipc::legalize
