// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "ir/evaluate.h"
#include "ir/test_program.h"
#include "ir/verify.h"

namespace clipc::ir {

// A shader that a test builds statement by statement and runs.
class Evaluator : public testing::Test {
 protected:
  // Runs the shader, which is verified first: the evaluator promises nothing for other programs.
  std::vector<double> Run(std::vector<float> p = {1, 2, 3, 4}) {
    const auto problem = Verify(shader, Form::kTyped);
    EXPECT_EQ(problem, std::nullopt) << *problem;
    return shader.Run(p, options);
  }
  // The value of a float expression, which the shader returns in every component.
  double Result(ExprId scalar) {
    shader.Append({shader.Return(shader.Splat4(scalar))});
    const auto result = Run();
    return result.empty() ? std::nan("") : result[0];
  }
  VarId Local(const char* name, TypeId type) { return shader.AddVar(name, type, Storage::kLocal); }
  TypeId Float() { return shader.types.Make(Scalar::kFloat); }
  TypeId Int() { return shader.types.Make(Scalar::kInt); }
  TypeId Float4() { return shader.types.Vector(Scalar::kFloat, 4); }
  ExprId ToFloat(ExprId expr) { return build.ConvertTo(Scalar::kFloat, expr); }
  StmtId Set(VarId var, ExprId value, std::optional<BinaryOp> op = std::nullopt) {
    return build.Eval(build.AssignTo(build.Ref(var), value, op));
  }

  TestProgram shader;
  Builder& build = shader.build;
  EvalOptions options;
};

}  // namespace clipc::ir
