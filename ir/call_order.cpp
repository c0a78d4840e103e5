// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/call_order.h"

namespace clipc::ir {

std::vector<FunctionId> CalleesFirst(const Program& program) {
  return CalleesFirst(program, [](const Expr&) {}, [](FunctionId) { return true; });
}

}  // namespace clipc::ir
