// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/print.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ir/test_program.h"

namespace clipc::ir {
namespace {

class PrintTest : public testing::Test {
 protected:
  std::string Text(ExprId expr) { return PrintExpr(shader, expr); }
  // The lines of the entry function's body.
  std::string Body() {
    const std::string text = Print(shader);
    const std::string head = "entry float4 entry(float4 p) {\n";
    const std::size_t begin = text.find(head) + head.size();
    return text.substr(begin, text.find("\n}\n", begin) - begin + 1);
  }
  TypeId F(int components) { return shader.types.Vector(Scalar::kFloat, components); }
  ExprId P() { return build.Ref(shader.parameter); }

  TestProgram shader;
  Builder& build = shader.build;
};

TEST_F(PrintTest, WholeProgram) {
  ClipPlane plane;
  plane.value = build.At(build.Ref(shader.planes), 1u);
  plane.text = "planes[1]";
  plane.cbuffer = shader.camera;
  plane.offset = 80;
  plane.whole_register = true;
  shader.clip_planes.push_back(plane);
  shader.Append({shader.Return(P())});
  EXPECT_EQ(Print(shader), R"(program vs_5_0 form resolved
cbuffer Camera : b0, 112 bytes {
  float4x4 view at 0, 64 bytes
  float4 planes[2] at 64, 32 bytes
  float scale at 96, 4 bytes
}
input float4 position : POSITION0 location 0
output float4 gl_Position : SV_Position0 builtin position
clip_plane 0 `planes[1]` = planes[1u] at Camera+80
static float counter = 1.0
const float table[3] = float[3]{10.0, 20.0, 30.0}
entry float4 entry(float4 p) {
  return p
}
main void main() {
  gl_Position = entry(position)
}
)");
}

TEST_F(PrintTest, LiteralsShowTheirKind) {
  EXPECT_EQ(Text(build.Float(1)), "1.0");
  EXPECT_EQ(Text(build.Float(-0.0f)), "-0.0");
  EXPECT_EQ(Text(build.Float(1e30f)), "1e+30");
  EXPECT_EQ(Text(build.Float(INFINITY)), "inf");
  EXPECT_EQ(Text(build.Add(shader.types.Make(Scalar::kFloat), Literal{0x7fc00000u})),
            "nan(0x7fc00000)");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kHalf, 2)), "2.0h");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kDouble, 0.1)), "0.1L");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kMin16Float, 2)), "2.0:min16float");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kMin16Int, -2)), "-2:min16int");
  EXPECT_EQ(Text(build.Uint(3)), "3u");
  EXPECT_EQ(Text(build.Int(-3)), "-3");
  EXPECT_EQ(Text(build.LiteralOf(Scalar::kInt64, -3)), "-3LL");
  EXPECT_EQ(Text(build.Bool(false)), "false");
}

TEST_F(PrintTest, OperatorsAreParenthesised) {
  const auto f = [&](float value) { return build.Float(value); };
  const ExprId sum =
      build.BinaryOf(BinaryOp::kAdd, f(1), build.BinaryOf(BinaryOp::kMul, f(2), f(3)));
  EXPECT_EQ(Text(build.UnaryOf(UnaryOp::kNegate, sum)), "-(1.0 + (2.0 * 3.0))");
  EXPECT_EQ(Text(build.UnaryOf(UnaryOp::kPostIncrement, build.Ref(shader.counter))), "counter++");
  EXPECT_EQ(Text(build.BinaryOf(BinaryOp::kShortCircuitAnd, build.Bool(true), build.Bool(false))),
            "true and_then false");
  EXPECT_EQ(Text(build.AssignTo(build.Ref(shader.counter), f(2), BinaryOp::kMul)),
            "counter *= 2.0");
  EXPECT_EQ(
      Text(build.Add(shader.types.Make(Scalar::kFloat), Conditional{build.Bool(true), f(1), f(2)})),
      "true ? 1.0 : 2.0");
}

TEST_F(PrintTest, ConversionsShowTheirType) {
  EXPECT_EQ(Text(build.ConvertTo(Scalar::kInt, P())), "convert<int4>(p)");
  EXPECT_EQ(Text(build.SplatTo(F(3), build.Float(1))), "splat<float3>(1.0)");
  EXPECT_EQ(Text(build.ConstructOf(F(4), {build.Swizzled(P(), {2, 1, 0}), build.Float(1)})),
            "float4(p.zyx, 1.0)");
  EXPECT_EQ(Text(build.Add(shader.types.Matrix(Scalar::kFloat, 3, 3),
                           MatrixTruncate{build.Ref(shader.view)})),
            "truncate<float3x3>(view)");
  EXPECT_EQ(Text(build.ZeroOf(shader.types.Array(F(2), 3))), "zero<float2[3]>");
  EXPECT_EQ(Text(build.Add(F(2), MatrixSwizzle{build.Ref(shader.view), {0, 1}, {3, 2}, 2})),
            "view._m03_m12");
}

TEST_F(PrintTest, Statements) {
  const VarId i = shader.AddVar("i", shader.types.Make(Scalar::kInt), Storage::kLocal);
  const std::vector<SwitchCase> arms = {{shader.expr_lists.Add({build.Int(1), build.Int(2)}), false,
                                         shader.Stmts({build.Stmt(Break{})})},
                                        {{}, true, {}}};
  const StmtId the_switch =
      build.Stmt(Switch{build.Ref(i), shader.switch_cases.Add(std::span<const SwitchCase>(arms))});
  const StmtId choice = build.Stmt(If{build.Bool(true), build.Stmt(Continue{}), the_switch});
  shader.Append({build.Stmt(For{shader.Stmts({shader.DeclareVar(i, build.Int(0))}),
                                build.BinaryOf(BinaryOp::kLess, build.Ref(i), build.Int(3)),
                                build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(i)), choice}),
                 build.Stmt(DoWhile{build.BlockOf({}), build.Bool(false)}),
                 build.Stmt(While{build.Bool(true), build.Stmt(Break{})}), shader.Return(P())});
  EXPECT_EQ(Body(), R"(  for (int i = 0; i < 3; ++i) {
    if (true) {
      continue
    } else {
      switch (i) {
      case 1:
      case 2:
        break
      default:
      }
    }
  }
  do {
  } while (false)
  while (true) {
    break
  }
  return p
)");
}

TEST_F(PrintTest, EqualNamesAreToldApart) {
  const VarId shadow = shader.AddVar("p", F(2), Storage::kLocal);
  shader.Append({shader.DeclareVar(shadow), shader.Return(P())});
  EXPECT_EQ(Body(), "  float2 p.1\n  return p\n");
}

TEST_F(PrintTest, StructsAndResources) {
  Struct light;
  light.name = "Light";
  Field direction;
  direction.name = "direction";
  direction.type = F(3);
  direction.semantic = "NORMAL0";
  Field matrix;
  matrix.name = "m";
  matrix.type = shader.types.Matrix(Scalar::kFloat, 3, 4);
  matrix.row_major = true;
  light.fields = {direction, matrix};
  shader.types.AddStruct(light);
  const VarId map =
      shader.AddVar("map", shader.types.Object(ObjectKind::kTexture2D, F(4)), Storage::kResource);
  shader.resources.push_back({map, {.letter = 't', .number = 2, .space = 1, .is_explicit = true}});
  const std::string text = Print(shader);
  EXPECT_NE(text.find("struct Light {\n  float3 direction : NORMAL0\n  row_major float3x4 m\n}\n"),
            std::string::npos);
  EXPECT_NE(text.find("resource Texture2D<float4> map : t2, space1 explicit\n"), std::string::npos);
}

}  // namespace
}  // namespace clipc::ir
