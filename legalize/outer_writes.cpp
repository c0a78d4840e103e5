// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/outer_writes.h"

#include <algorithm>
#include <utility>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

const OuterWrites::Set& OuterWrites::Of(FunctionId function) {
  std::unique_ptr<Set>& set = sets_[function.index];
  if (!set && depth_ == kMostCalls) return beyond_;
  if (!set) {
    ++depth_;
    Set found = Find(function);
    --depth_;
    set = std::make_unique<Set>(std::move(found));
  }
  return *set;
}

OuterWrites::Set OuterWrites::Find(FunctionId function) {
  Set found;
  ForEachExpr(program_, program_.functions[function].body, [&](ExprId expr) {
    ForEachWrite(program_, expr, [&](ExprId target) { Add(found, RootOf(program_, target)); });
    const auto* object = As<ObjectCall>(program_, expr);
    if (object && WritesObject(object->op))
      Add(found, RootOf(program_, OperandOf(program_, *object, OperandKind::kObject)));
    // Where the group waits, its other threads have written.
    const auto* asked = As<IntrinsicCall>(program_, expr);
    found.is_all |= asked && WaitsForGroup(asked->op);
    if (const auto* call = As<Call>(program_, expr)) {
      const Set& inner = Of(call->function);
      found.is_all |= inner.is_all;
      for (const VarId var : inner.vars) Add(found, var);
    }
  });
  return found;
}

void OuterWrites::Add(Set& set, VarId var) {
  if (set.is_all || !var) return;
  const Storage storage = program_.vars[var].storage;
  if (storage != Storage::kStatic && storage != Storage::kShared && storage != Storage::kResource)
    return;
  if (std::ranges::find(set.vars, var) != set.vars.end()) return;
  set.vars.push_back(var);
  set.is_all = set.vars.size() > kMost;
}

}  // namespace clipc::legalize
