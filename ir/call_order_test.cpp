// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/call_order.h"

#include <gtest/gtest.h>

#include "ir/builder.h"

namespace clipc::ir {
namespace {

FunctionId Define(Program& program, std::vector<FunctionId> callees) {
  Builder b(program);
  std::vector<StmtId> body;
  for (const FunctionId callee : callees) body.push_back(b.Eval(b.CallOf(callee, {})));
  return program.functions.Add({.name = "f",
                                .return_type = program.types.Void(),
                                .parameters = {},
                                .body = b.BlockOf(body),
                                .span = {}});
}

TEST(CallOrder, CalleesStandBeforeCallersAndEachFunctionOnce) {
  Program program;
  const FunctionId shared = Define(program, {});
  const FunctionId left = Define(program, {shared});
  Define(program, {left});  // nothing reaches it
  const FunctionId right = Define(program, {left, shared});
  program.main = Define(program, {right, left});
  const KeptVector<FunctionId> expected = {shared, left, right, program.main};
  EXPECT_EQ(CalleesFirst(program), expected);
}

TEST(CallOrder, AChainMayHaveAnyLength) {
  Program program;
  program.main = Define(program, {});
  for (int i = 0; i < 200000; ++i) program.main = Define(program, {program.main});
  EXPECT_EQ(CalleesFirst(program).size(), 200001u);
}

}  // namespace
}  // namespace clipc::ir
