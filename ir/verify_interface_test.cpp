// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/access.h"
#include "ir/test_program.h"
#include "ir/verify.h"

namespace clipc::ir {
namespace {

using testing::HasSubstr;

class InterfaceRules : public testing::Test {
 protected:
  void ExpectProblem(std::string_view text, Form form = Form::kTyped) {
    const auto problem = Verify(shader, form);
    ASSERT_TRUE(problem.has_value()) << "nothing found; expected: " << text;
    EXPECT_THAT(*problem, HasSubstr(text));
  }
  IoVar& AddOutput(TypeId type, Builtin builtin) {
    IoVar io;
    io.var = shader.AddVar("extra", type, Storage::kOutput);
    io.builtin = builtin;
    shader.outputs.push_back(io);
    return shader.outputs.back();
  }
  ClipPlane& AddPlane(ExprId value) {
    ClipPlane plane;
    plane.value = value;
    plane.text = "planes[1]";
    plane.cbuffer = shader.camera;
    plane.offset = 80;
    plane.whole_register = true;
    shader.clip_planes.push_back(plane);
    return shader.clip_planes.back();
  }
  ExprId Plane() { return build.At(build.Ref(shader.planes), 1u); }
  TypeId F(int components = 1) {
    return components == 1 ? shader.types.Make(Scalar::kFloat)
                           : shader.types.Vector(Scalar::kFloat, components);
  }

  TestProgram shader;
  Builder& build = shader.build;
};

TEST_F(InterfaceRules, NoMain) {
  shader.main = {};
  ExpectProblem("no main");
}
TEST_F(InterfaceRules, NoEntry) {
  shader.entry = {};
  ExpectProblem("no entry");
}
TEST_F(InterfaceRules, MainHasNoParameters) {
  shader.main = shader.entry;
  ExpectProblem("main is void");
}
TEST_F(InterfaceRules, FormIsReached) {
  ExpectProblem("has not reached the form", Form::kNoClipPlanes);
}

TEST_F(InterfaceRules, OutputStorage) {
  shader.vars[shader.gl_position].storage = Storage::kLocal;
  ExpectProblem("output gl_Position is not of this storage");
}
TEST_F(InterfaceRules, ListedTwice) {
  shader.inputs.push_back(shader.inputs[0]);
  ExpectProblem("listed twice");
}
TEST_F(InterfaceRules, LocationsRise) {
  AddOutput(F(), Builtin::kNone).location = 1;
  AddOutput(F(), Builtin::kNone).location = 1;
  ExpectProblem("a location that is taken or out of order");
}
TEST_F(InterfaceRules, TwoColorsOfOneTarget) {
  AddOutput(F(), Builtin::kNone).location = 1;
  IoVar& second = AddOutput(F(), Builtin::kNone);
  second.location = 1, second.blend_index = 1;
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
}
TEST_F(InterfaceRules, NoBoolOutputs) {
  AddOutput(shader.types.Make(Scalar::kBool), Builtin::kNone);
  ExpectProblem("a scalar or vector of numbers");
}
TEST_F(InterfaceRules, NoMatrixOutputs) {
  AddOutput(shader.types.Matrix(Scalar::kFloat, 4, 4), Builtin::kNone);
  ExpectProblem("a scalar or vector of numbers");
}
TEST_F(InterfaceRules, OnePosition) {
  AddOutput(F(4), Builtin::kPosition);
  ExpectProblem("a second time");
}
TEST_F(InterfaceRules, ClipDistanceIsASmallFloatArray) {
  AddOutput(shader.types.Array(F(), 9), Builtin::kClipDistance);
  ExpectProblem("the direction and type of its builtin");
}
TEST_F(InterfaceRules, ClipDistance) {
  AddOutput(shader.types.Array(F(), 8), Builtin::kClipDistance);
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
}
TEST_F(InterfaceRules, OutputArrayIsATarget) {
  const VarId array = AddOutput(shader.types.Array(F(), 8), Builtin::kClipDistance).var;
  const auto element = [&] {
    return shader.build.Add(F(), Index{shader.build.Ref(array), shader.build.Int(0)});
  };
  const auto write = [&](ExprId value) {
    return shader.build.Eval(shader.build.AssignTo(element(), value));
  };
  AppendToBody(shader, shader.main, std::array{write(shader.build.Float(1))});
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
  AppendToBody(shader, shader.main, std::array{write(element())});
  ExpectProblem("an array of outputs is only the target of a statement");
}
TEST_F(InterfaceRules, VertexIdIsNoOutput) {
  AddOutput(shader.types.Make(Scalar::kUint), Builtin::kVertexId);
  ExpectProblem("the direction and type of its builtin");
}

TEST_F(InterfaceRules, CbufferSize) {
  shader.cbuffers[shader.camera].size = 100;
  ExpectProblem("not a multiple of 16");
}
TEST_F(InterfaceRules, MembersInside) {
  shader.cbuffers[shader.camera].size = 96;
  ExpectProblem("ends before its member scale");
}
TEST_F(InterfaceRules, MembersLieWithinRegisters) {
  shader.cbuffers[shader.camera].members[0].offset = 4;
  ExpectProblem("a member across registers");
}
TEST_F(InterfaceRules, MembersAreTheBuffersOwn) {
  shader.cbuffers[shader.camera].members[0].var = shader.counter;
  ExpectProblem("a member that is not its own");
}
TEST_F(InterfaceRules, UniformInABuffer) {
  shader.AddVar("stray", F(), Storage::kUniform);
  ExpectProblem("is not in a cbuffer");
}
TEST_F(InterfaceRules, MemberOffset) {
  shader.cbuffers[shader.camera].members[2].offset = 98;
  ExpectProblem("between two components");
}
TEST_F(InterfaceRules, ConstantBufferHasOneMember) {
  shader.cbuffers[shader.camera].kind = CbufferKind::kConstantBuffer;
  ExpectProblem("without exactly one member");
}
TEST_F(InterfaceRules, ResourceStorage) {
  shader.resources.push_back({shader.counter, {}});
  ExpectProblem("not of resource storage");
}

TEST_F(InterfaceRules, ClipPlane) {
  AddPlane(Plane());
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
}
TEST_F(InterfaceRules, ClipPlaneHasAValueUntilLowered) {
  AddPlane({});
  ExpectProblem("has no value before its lowering");
  shader.form = Form::kNoClipPlanes;
  EXPECT_EQ(Verify(shader, Form::kNoClipPlanes), std::nullopt);
  EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt) << "a form includes the ones before";
  shader.clip_planes[0].value = Plane();
  ExpectProblem("has a value after its lowering");
}
TEST_F(InterfaceRules, ClipPlaneIsFloat4) {
  AddPlane(build.Swizzled(Plane(), {0, 1, 2}));
  ExpectProblem("a clip plane is a float4");
}
TEST_F(InterfaceRules, ClipPlaneHasNoEffect) {
  AddPlane(build.Add(
      F(4), Comma{build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(shader.counter)), Plane()}));
  ExpectProblem("has no effect");
}
TEST_F(InterfaceRules, ClipPlaneRegister) {
  AddPlane(Plane()).offset = 72;
  ExpectProblem("not a register of its cbuffer");
}
TEST_F(InterfaceRules, ClipPlaneRegisterInside) {
  AddPlane(Plane()).offset = 112;
  ExpectProblem("not a register of its cbuffer");
}
TEST_F(InterfaceRules, ClipPlaneElement) {
  AddPlane(Plane()).element = 1;
  ExpectProblem("past the end of the array");
}
TEST_F(InterfaceRules, ClipPlaneBuffer) {
  AddPlane(Plane()).cbuffer = {};
  ExpectProblem("a whole register without a cbuffer");
}
TEST_F(InterfaceRules, SixClipPlanes) {
  for (int i = 0; i < 7; ++i) AddPlane(Plane());
  ExpectProblem("more than six clip planes");
}

}  // namespace
}  // namespace clipc::ir
