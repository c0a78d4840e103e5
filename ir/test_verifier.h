// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <initializer_list>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/test_program.h"
#include "ir/verify.h"

namespace clipc::ir {

// Tests that break one promise of program.h each, and expect Verify to say so.
class Verifier : public testing::Test {
 protected:
  void ExpectProblem(std::string_view text, Form form = Form::kTyped) {
    const auto problem = Verify(shader, form);
    ASSERT_TRUE(problem.has_value()) << "nothing found; expected: " << text;
    EXPECT_THAT(*problem, testing::HasSubstr(text));
  }
  // Puts a broken expression into the entry function.
  void ExpectProblemIn(ExprId expr, std::string_view text) {
    shader.Append({build.Eval(expr)});
    ExpectProblem(text);
  }
  VarId Local(const char* name, TypeId type) {
    const VarId var = shader.AddVar(name, type, Storage::kLocal);
    shader.Append({shader.DeclareVar(var)});
    return var;
  }
  TypeId F(int components = 1) {
    return components == 1 ? shader.types.Make(Scalar::kFloat)
                           : shader.types.Vector(Scalar::kFloat, components);
  }
  TypeId I() { return shader.types.Make(Scalar::kInt); }
  ExprId V() { return build.Ref(shader.parameter); }
  ExprId M() { return build.Ref(shader.view); }
  List<ExprId> Args(std::initializer_list<ExprId> list) { return shader.expr_lists.Add(list); }

  TestProgram shader;
  Builder& build = shader.build;
};

}  // namespace clipc::ir
