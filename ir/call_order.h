// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/kept_blocks.h"
#include "ir/access.h"
#include "ir/program.h"
#include "ir/walk.h"

namespace clipc::ir {

// The functions that `main` reaches, each once, callees before callers and `main` last: what is
// asked of them in this order needs no recursion, as generated shaders have call chains of any
// length. Requires functions without recursion.
KeptVector<FunctionId> CalleesFirst(const Program& program);

// The same for the functions that enters(FunctionId) is true for, `main` among them, and calls
// visit(ExprId, const Expr&) for every expression of each before those of its callees. With the
// number of `calls` that the program has, only as many bodies are walked as it takes to find them.
template <typename OnExpr, typename Enters>
KeptVector<FunctionId> CalleesFirst(const Program& program, OnExpr&& visit, Enters&& enters,
                                    std::size_t calls = SIZE_MAX) {
  struct Begun {
    FunctionId function;
    KeptVector<FunctionId> callees;
    std::size_t next = 0;
  };
  const auto begin = [&](FunctionId function) {
    Begun begun{function, {}};
    if (calls == 0) return begun;
    ForEachExpr(program, program.functions[function].body, [&](ExprId id) {
      const Expr& expr = program.exprs[id];
      visit(id, expr);
      const auto* call = std::get_if<Call>(&expr.node);
      if (!call) return;
      --calls;
      if (enters(call->function)) begun.callees.push_back(call->function);
    });
    return begun;
  };
  KeptVector<FunctionId> order;
  KeptVector<bool> is_begun(program.functions.size());
  KeptVector<Begun> path;
  order.reserve(is_begun.size()), path.reserve(8);
  path.push_back(begin(program.main));
  while (!path.empty()) {
    Begun& top = path.back();
    if (top.next == top.callees.size()) {
      order.push_back(top.function);
      path.pop_back();
    } else if (const FunctionId callee = top.callees[top.next++]; !is_begun[callee.index]) {
      is_begun[callee.index] = true;
      path.push_back(begin(callee));
    }
  }
  return order;
}

}  // namespace clipc::ir
