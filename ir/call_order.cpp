// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/call_order.h"

#include <cstddef>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::ir {
namespace {

// A function whose callees are being visited.
struct Visited {
  FunctionId function;
  std::vector<FunctionId> callees;
  std::size_t next = 0;
};

Visited Begin(const Program& program, FunctionId function) {
  Visited visited{function, {}};
  ForEachExpr(program, program.functions[function].body, [&](ExprId expr) {
    if (const auto* call = As<Call>(program, expr)) visited.callees.push_back(call->function);
  });
  return visited;
}

}  // namespace

std::vector<FunctionId> CalleesFirst(const Program& program) {
  std::vector<FunctionId> order;
  std::vector<bool> is_begun(program.functions.size());
  std::vector<Visited> path{Begin(program, program.main)};
  while (!path.empty()) {
    Visited& top = path.back();
    if (top.next == top.callees.size()) {
      order.push_back(top.function);
      path.pop_back();
    } else if (const FunctionId callee = top.callees[top.next++]; !is_begun[callee.index]) {
      is_begun[callee.index] = true;
      path.push_back(Begin(program, callee));
    }
  }
  return order;
}

}  // namespace clipc::ir
