// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/evaluate.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/intrinsic_list.h"
#include "ir/test_evaluator.h"

namespace clipc::ir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

TEST_F(Evaluator, PassesInputsToOutputs) {
  shader.Append({shader.Return(build.Ref(shader.parameter))});
  EXPECT_THAT(Run(), ElementsAre(1, 2, 3, 4));
}

// ---- cbuffers

TEST_F(Evaluator, ReadsMatricesColumnMajorUnlessTheVariableSaysRowMajor) {
  for (int i = 0; i < 16; ++i) shader.SetFloat(4 * i, static_cast<float>(i));
  shader.Append({shader.Return(build.At(build.Ref(shader.view), 1u))});
  EXPECT_THAT(Run(), ElementsAre(1, 5, 9, 13));
  shader.vars[shader.view].row_major = true;
  EXPECT_THAT(Run(), ElementsAre(4, 5, 6, 7));
}

TEST_F(Evaluator, ReadsMembersAtTheirOffsets) {
  shader.SetFloat(64 + 16 + 8, 7);
  shader.SetFloat(96, 5);
  const ExprId plane = build.At(build.Ref(shader.planes), 1u);
  shader.Append({shader.Return(
      build.BinaryOf(BinaryOp::kAdd, plane, shader.Splat4(build.Ref(shader.scale))))});
  EXPECT_THAT(Run(), ElementsAre(5, 5, 12, 5));
  shader.cbuffers[shader.camera].members[2].offset = 88;
  EXPECT_THAT(Run(), ElementsAre(7, 7, 14, 7));
}

TEST_F(Evaluator, ReadsZeroAfterTheEndOfABuffer) {
  shader.camera_bytes.assign(3, 0xff);
  EXPECT_EQ(Result(build.Ref(shader.scale)), 0);
}

TEST_F(Evaluator, ReadsStructsBoolsAndDoublesFromCbuffers) {
  Struct structure;
  structure.name = "Mixed";
  structure.fields = {{.name = "flag",
                       .type = shader.types.Make(Scalar::kBool),
                       .span = {},
                       .semantic = {},
                       .semantic_span = {}},
                      {.name = "wide",
                       .type = shader.types.Make(Scalar::kDouble),
                       .span = {},
                       .semantic = {},
                       .semantic_span = {}}};
  const TypeId mixed = shader.types.Of(shader.types.AddStruct(std::move(structure)));
  const VarId var = shader.AddVar("mixed", shader.types.Array(mixed, 2), Storage::kUniform);
  shader.vars[var].cbuffer = shader.camera;
  CbufferMember member;
  member.var = var;
  shader.cbuffers[shader.camera].members.push_back(member);
  LayOut(shader.types, shader.vars, shader.cbuffers[shader.camera]);
  EXPECT_EQ(shader.cbuffers[shader.camera].members[3].offset, 112u);
  shader.SetFloat(128, 1e-40f);  // any bit set is true
  shader.SetFloat(136, 0);
  shader.SetFloat(140, 1.875f);  // the upper half of the double 1.0 is the float 1.875
  const auto element = [&] { return build.At(build.Ref(var), 1u); };
  const ExprId flag = ToFloat(build.Field(element(), 0));
  EXPECT_EQ(Result(build.BinaryOf(BinaryOp::kAdd, flag, ToFloat(build.Field(element(), 1)))), 2);
}

TEST_F(Evaluator, ReadsArraysOfConstantBuffersOneByOne) {
  Struct structure;
  structure.name = "Frame";
  structure.fields = {
      {.name = "a",
       .type = shader.types.Vector(Scalar::kFloat, 3),
       .span = {},
       .semantic = {},
       .semantic_span = {}},
      {.name = "b", .type = Float(), .span = {}, .semantic = {}, .semantic_span = {}}};
  const TypeId frame = shader.types.Of(shader.types.AddStruct(std::move(structure)));
  Cbuffer& buffer = shader.cbuffers[shader.camera];
  buffer.kind = CbufferKind::kConstantBuffer;
  buffer.count = 2;
  const VarId var = shader.AddVar("frames", shader.types.Array(frame, 2), Storage::kUniform);
  shader.vars[var].cbuffer = shader.camera;
  buffer.members.resize(1);
  buffer.members[0] = {};
  buffer.members[0].var = var;
  LayOut(shader.types, shader.vars, buffer);
  shader.SetFloat(16 + 12, 42);
  EXPECT_EQ(Result(build.Field(build.At(build.Ref(var), 1u), 1)), 42);
}

// ---- operators and conversions

TEST_F(Evaluator, FloatOperators) {
  const auto f = [&](BinaryOp op, float a, float b) {
    return FloatOf((ValueOf(shader, build.BinaryOf(op, build.Float(a), build.Float(b))))[0]);
  };
  EXPECT_EQ(f(BinaryOp::kMod, -5.5f, 2), -1.5f);
  EXPECT_EQ(f(BinaryOp::kDiv, 1, 0), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(f(BinaryOp::kDiv, 0, 0)));
  EXPECT_EQ(f(BinaryOp::kAdd, 16777216, 1), 16777216);
  EXPECT_EQ(f(BinaryOp::kSub, 1, 3), -2);
  EXPECT_EQ(f(BinaryOp::kMul, 1e-30f, 1e-30f), 0);
}

TEST_F(Evaluator, ComparisonsWithNanAreFalseButNotEqual) {
  const float nan = std::nanf("");
  const auto compare = [&](BinaryOp op) {
    return (ValueOf(shader, build.BinaryOf(op, build.Float(nan), build.Float(1))))[0];
  };
  for (BinaryOp op : {BinaryOp::kLess, BinaryOp::kGreater, BinaryOp::kLessEqual,
                      BinaryOp::kGreaterEqual, BinaryOp::kEqual}) {
    EXPECT_EQ(compare(op), 0u);
  }
  EXPECT_EQ(compare(BinaryOp::kNotEqual), 1u);
}

TEST_F(Evaluator, IntOperators) {
  const auto i = [&](BinaryOp op, std::int32_t a, std::int32_t b) {
    return IntOf((ValueOf(shader, build.BinaryOf(op, build.Int(a), build.Int(b))))[0]);
  };
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
  EXPECT_EQ(i(BinaryOp::kDiv, -7, 2), -3);
  EXPECT_EQ(i(BinaryOp::kMod, -7, 2), -1);
  EXPECT_EQ(i(BinaryOp::kMod, 7, -2), 1);
  EXPECT_EQ(i(BinaryOp::kDiv, 5, 0), -1);
  EXPECT_EQ(i(BinaryOp::kDiv, -5, 0), 1);
  EXPECT_EQ(i(BinaryOp::kDiv, kMin, -1), kMin);
  EXPECT_EQ(i(BinaryOp::kMod, kMin, -1), 0);
  EXPECT_EQ(i(BinaryOp::kAdd, 2147483647, 1), kMin);
  EXPECT_EQ(i(BinaryOp::kMul, 65536, 65536), 0);
  EXPECT_EQ(i(BinaryOp::kShiftLeft, 1, 33), 2);
  EXPECT_EQ(i(BinaryOp::kShiftRight, -8, 1), -4);
  EXPECT_EQ(i(BinaryOp::kBitXor, 6, 3), 5);
}

TEST_F(Evaluator, UintOperators) {
  const auto u = [&](BinaryOp op, std::uint32_t a, std::uint32_t b) {
    return UintOf((ValueOf(shader, build.BinaryOf(op, build.Uint(a), build.Uint(b))))[0]);
  };
  EXPECT_EQ(u(BinaryOp::kDiv, 7, 0), 0xffffffffu);
  EXPECT_EQ(u(BinaryOp::kMod, 7, 0), 0xffffffffu);
  EXPECT_EQ(u(BinaryOp::kShiftRight, 0x80000000u, 31), 1u);
  EXPECT_EQ(u(BinaryOp::kSub, 0, 1), 0xffffffffu);
  EXPECT_EQ(u(BinaryOp::kLess, 1, 0xffffffffu), 1u);
}

TEST_F(Evaluator, SixtyFourBitOperators) {
  const auto wide = [&](Scalar kind, double value) { return build.LiteralOf(kind, value); };
  const auto value = [&](BinaryOp op, Scalar kind, double x, double y) {
    return (ValueOf(shader, build.BinaryOf(op, wide(kind, x), wide(kind, y))))[0];
  };
  EXPECT_EQ(value(BinaryOp::kMul, Scalar::kInt64, 0x1p40, -4),
            static_cast<std::uint64_t>(-(std::int64_t{1} << 42)));
  EXPECT_EQ(value(BinaryOp::kShiftLeft, Scalar::kUint64, 1, 65), 2u);
  EXPECT_EQ(value(BinaryOp::kLess, Scalar::kInt64, -1, 1), 1u);
}

TEST_F(Evaluator, Conversions) {
  const auto convert = [&](Scalar from, double value, Scalar to) {
    return NumberOf((ValueOf(shader, build.ConvertTo(to, build.LiteralOf(from, value))))[0], to);
  };
  EXPECT_EQ(convert(Scalar::kFloat, -1.9, Scalar::kInt), -1);
  EXPECT_EQ(convert(Scalar::kFloat, std::nan(""), Scalar::kInt), 0);
  EXPECT_EQ(convert(Scalar::kFloat, 1e20, Scalar::kInt), 2147483647);
  EXPECT_EQ(convert(Scalar::kFloat, -1e20, Scalar::kInt), -2147483648.0);
  EXPECT_EQ(convert(Scalar::kFloat, -5, Scalar::kUint), 0);
  EXPECT_EQ(convert(Scalar::kFloat, 1e20, Scalar::kUint), 4294967295.0);
  EXPECT_EQ(convert(Scalar::kInt, -1, Scalar::kUint), 4294967295.0);
  EXPECT_EQ(convert(Scalar::kUint, 4294967295.0, Scalar::kFloat), 4294967296.0);
  EXPECT_EQ(convert(Scalar::kInt, -16777217, Scalar::kFloat), -16777216);
  EXPECT_EQ(convert(Scalar::kFloat, 0.25, Scalar::kBool), 1);
  EXPECT_EQ(convert(Scalar::kFloat, -0.0, Scalar::kBool), 0);
  EXPECT_EQ(convert(Scalar::kBool, 1, Scalar::kFloat), 1);
  EXPECT_EQ(convert(Scalar::kDouble, 0.1, Scalar::kFloat), 0.1f);
  EXPECT_EQ(convert(Scalar::kInt, -3, Scalar::kInt64), -3);
  EXPECT_EQ(convert(Scalar::kHalf, 0.1, Scalar::kFloat), 0.1f);  // half is computed as float
}

TEST_F(Evaluator, ShapesOfValues) {
  const TypeId m23 = shader.types.Matrix(Scalar::kInt, 2, 3);
  const auto matrix = [&] {
    return build.ConstructOf(
        m23, {build.Int(1), build.Int(2), build.Int(3), build.Int(4), build.Int(5), build.Int(6)});
  };
  EXPECT_THAT(ValueOf(shader, build.At(matrix(), 1u)), ElementsAre(4, 5, 6));
  EXPECT_THAT(ValueOf(shader, build.Swizzled(build.At(matrix(), 0u), {2, 0})), ElementsAre(3, 1));
  EXPECT_THAT(
      ValueOf(shader, build.Add(shader.types.Matrix(Scalar::kInt, 2, 2), MatrixTruncate{matrix()})),
      ElementsAre(1, 2, 4, 5));
  EXPECT_THAT(ValueOf(shader, build.Add(shader.types.Vector(Scalar::kInt, 2),
                                        MatrixSwizzle{matrix(), {1, 0}, {2, 1}, 2})),
              ElementsAre(6, 2));
  EXPECT_THAT(ValueOf(shader, build.At(matrix(), build.Int(-1))), ElementsAre(0, 0, 0));
  EXPECT_THAT(ValueOf(shader, build.At(build.Ref(shader.table), 2u)), ElementsAre(BitsOf(30.0f)));
}

TEST_F(Evaluator, ConstantsAreWhatEveryShaderComputesAlike) {
  const auto divide = [&](std::int32_t by) {
    return build.BinaryOf(BinaryOp::kDiv, build.Int(6), build.Int(by));
  };
  const auto element = [&](std::uint32_t i) { return build.At(build.Ref(shader.table), i); };
  EXPECT_THAT(ConstantBits(shader, divide(3)), Optional(ElementsAre(2)));
  EXPECT_EQ(ConstantBits(shader, divide(0)), std::nullopt);
  EXPECT_THAT(ConstantBits(shader, element(2)), Optional(ElementsAre(BitsOf(30.0f))));
  EXPECT_EQ(ConstantBits(shader, element(3)), std::nullopt);
  EXPECT_EQ(ConstantBits(shader, build.At(build.Ref(shader.planes), 1u)), std::nullopt);
  EXPECT_EQ(ConstantBits(shader, build.Ref(shader.counter)), std::nullopt);
  const ExprId increment = build.UnaryOf(UnaryOp::kPreIncrement, build.Ref(shader.counter));
  EXPECT_EQ(ConstantBits(shader, build.CommaOf(increment, build.Int(1))), std::nullopt);
}

TEST_F(Evaluator, SelectChoosesByComponent) {
  const TypeId bool2 = shader.types.Vector(Scalar::kBool, 2);
  const TypeId int2 = shader.types.Vector(Scalar::kInt, 2);
  const ExprId condition = build.ConstructOf(bool2, {build.Bool(true), build.Bool(false)});
  const ExprId yes = build.ConstructOf(int2, {build.Int(1), build.Int(2)});
  const ExprId no = build.ConstructOf(int2, {build.Int(3), build.Int(4)});
  EXPECT_THAT(ValueOf(shader, build.Add(int2, Select{condition, yes, no})), ElementsAre(1, 4));
}

// ---- assignments

TEST_F(Evaluator, SwizzledAndIndexedTargets) {
  const VarId v = Local("v", Float4());
  const TypeId float2 = shader.types.Vector(Scalar::kFloat, 2);
  shader.Append(
      {shader.DeclareVar(v, build.Ref(shader.parameter)),
       build.Eval(build.AssignTo(build.Swizzled(build.Ref(v), {3, 0}),
                                 build.ConstructOf(float2, {build.Float(7), build.Float(8)}))),
       build.Eval(
           build.AssignTo(build.At(build.Ref(v), build.Int(1)), build.Float(5), BinaryOp::kMul)),
       shader.Return(build.Ref(v))});
  EXPECT_THAT(Run(), ElementsAre(8, 10, 3, 7));
}

TEST_F(Evaluator, OutOfBoundsReadsZeroAndWritesNothing) {
  const VarId a = Local("a", shader.types.Array(Float4(), 2));
  const VarId i = Local("i", Int());
  shader.Append(
      {shader.DeclareVar(a), shader.DeclareVar(i, build.Int(2)),
       build.Eval(build.AssignTo(build.At(build.Ref(a), 1u), build.Ref(shader.parameter))),
       build.Eval(
           build.AssignTo(build.At(build.Ref(a), build.Ref(i)), shader.Splat4(build.Float(9)))),
       shader.Return(build.BinaryOf(BinaryOp::kAdd, build.At(build.Ref(a), 1u),
                                    build.At(build.Ref(a), build.Ref(i))))});
  EXPECT_THAT(Run(), ElementsAre(1, 2, 3, 4));
}

TEST_F(Evaluator, IncrementsGiveOldOrNewValue) {
  const VarId i = Local("i", Int());
  const ExprId post = build.UnaryOf(UnaryOp::kPostIncrement, build.Ref(i));
  const ExprId pre = build.UnaryOf(UnaryOp::kPreDecrement, build.Ref(i));
  shader.Append({shader.DeclareVar(i, build.Int(5))});
  // 5 * 10 + 5, then i is 5
  const ExprId sum =
      build.BinaryOf(BinaryOp::kAdd, build.BinaryOf(BinaryOp::kMul, post, build.Int(10)), pre);
  EXPECT_EQ(Result(ToFloat(build.BinaryOf(BinaryOp::kAdd, sum, build.Ref(i)))), 60);
}

TEST_F(Evaluator, WritingIntrinsics) {
  const VarId whole = Local("whole", Float());
  const VarId s = Local("s", Float());
  const VarId c = Local("c", Float());
  const ExprId modf =
      build.IntrinsicOf(Intrinsic::kModf, Float(), {build.Float(-2.75f), build.Ref(whole)});
  const ExprId frexp =
      build.IntrinsicOf(Intrinsic::kFrexp, Float(), {build.Float(12), build.Ref(c)});
  shader.Append({shader.DeclareVar(whole), shader.DeclareVar(s), shader.DeclareVar(c),
                 build.Eval(build.IntrinsicOf(Intrinsic::kSincos, shader.types.Void(),
                                              {build.Float(0), build.Ref(s), build.Ref(c)}))});
  // -0.75 + -2 + (sin 0 + cos 0) * 100, then 12 = 0.75 * 2^4
  const auto add = [&](ExprId x, ExprId y) { return build.BinaryOf(BinaryOp::kAdd, x, y); };
  const ExprId first =
      add(add(modf, build.Ref(whole)),
          build.BinaryOf(BinaryOp::kMul, add(build.Ref(s), build.Ref(c)), build.Float(100)));
  const ExprId second = add(frexp, build.Ref(c));
  shader.Append({shader.Return(
      build.ConstructOf(Float4(), {first, second, build.Float(0), build.Float(0)}))});
  EXPECT_THAT(Run(), ElementsAre(97.25, 4.75, 0, 0));
}

// ---- objects

TEST_F(Evaluator, ObjectReadsGoThroughTheCallback) {
  const TypeId texture = shader.types.Object(ObjectKind::kTexture2D, Float4());
  const VarId maps = shader.AddVar("maps", shader.types.Array(texture, 4), Storage::kResource);
  const VarId linear =
      shader.AddVar("linear", shader.types.Object(ObjectKind::kSampler), Storage::kResource);
  shader.resources = {{maps, {}}, {linear, {}}};
  const ExprId uv = build.Swizzled(build.Ref(shader.parameter), {0, 1});
  const ExprId sample = build.ObjectCallOf(ObjectOp::kSampleLevel, Float4(),
                                           {{OperandKind::kObject, build.At(build.Ref(maps), 3u)},
                                            {OperandKind::kSampler, build.Ref(linear)},
                                            {OperandKind::kCoordinate, uv},
                                            {OperandKind::kLevel, build.Float(2)}});
  shader.Append({shader.Return(sample)});
  shader.read_object = [&](const ObjectRequest& request, std::span<std::uint64_t> result) {
    EXPECT_EQ(request.op, ObjectOp::kSampleLevel);
    EXPECT_EQ(request.object, maps);
    EXPECT_EQ(request.object_element, 3u);
    EXPECT_EQ(request.sampler, linear);
    EXPECT_THAT(request.Of(OperandKind::kCoordinate), ElementsAre(BitsOf(1.0f), BitsOf(2.0f)));
    EXPECT_THAT(request.Of(OperandKind::kLevel), ElementsAre(BitsOf(2.0f)));
    EXPECT_THAT(request.Of(OperandKind::kOffset), ElementsAre());
    ASSERT_EQ(result.size(), 4u);
    result[2] = BitsOf(0.5f);
  };
  EXPECT_THAT(Run(), ElementsAre(0, 0, 0.5, 0));
  options.in_double = true;
  EXPECT_THAT(Run(), ElementsAre(0, 0, 0.5, 0));
}

TEST_F(Evaluator, ObjectReadsHaveAClampAndAStatus) {
  const VarId map = shader.AddVar("map", shader.types.Object(ObjectKind::kTexture2D, Float4()),
                                  Storage::kResource);
  const VarId linear =
      shader.AddVar("linear", shader.types.Object(ObjectKind::kSampler), Storage::kResource);
  shader.resources = {{map, {}}, {linear, {}}};
  const VarId texel = build.Local("texel", Float4());
  const ExprId uv = build.Swizzled(build.Ref(shader.parameter), {0, 1});
  const ExprId status = build.ObjectCallOf(ObjectOp::kSampleLevel, shader.types.Make(Scalar::kUint),
                                           {{OperandKind::kObject, build.Ref(map)},
                                            {OperandKind::kSampler, build.Ref(linear)},
                                            {OperandKind::kCoordinate, uv},
                                            {OperandKind::kLevel, build.Float(2)},
                                            {OperandKind::kClamp, build.Float(3)},
                                            {OperandKind::kTexel, build.Ref(texel)}});
  const ExprId is_mapped = build.IntrinsicOf(Intrinsic::kCheckAccessFullyMapped,
                                             shader.types.Make(Scalar::kBool), {status});
  const ExprId sum =
      build.BinaryOf(BinaryOp::kAdd, build.SplatTo(Float4(), ToFloat(is_mapped)), build.Ref(texel));
  shader.Append({build.Stmt(Declare{texel, {}}), shader.Return(sum)});
  shader.read_object = [&](const ObjectRequest& request, std::span<std::uint64_t> result) {
    EXPECT_THAT(request.Of(OperandKind::kLevel), ElementsAre(BitsOf(2.0f)));
    EXPECT_THAT(request.Of(OperandKind::kClamp), ElementsAre(BitsOf(3.0f)));
    ASSERT_EQ(result.size(), 4u);
    result[2] = BitsOf(0.5f);
  };
  EXPECT_THAT(Run(), ElementsAre(1, 1, 1.5, 1));
  options.in_double = true;
  EXPECT_THAT(Run(), ElementsAre(1, 1, 1.5, 1));
}

// ---- in double

TEST_F(Evaluator, DoubleModeKeepsWhatFloatRounds) {
  const ExprId third = build.BinaryOf(BinaryOp::kDiv, build.Float(1), build.Float(3));
  const ExprId big = build.BinaryOf(BinaryOp::kAdd, build.Float(16777216), third);
  const ExprId back = build.BinaryOf(BinaryOp::kSub, big, build.Float(16777216));
  EXPECT_EQ(Result(back), 0);
  options.in_double = true;
  EXPECT_NEAR(Run()[0], 1.0 / 3, 1e-8);
}

TEST_F(Evaluator, DoubleModeKeepsTheBitsOfFloats) {
  options.in_double = true;
  const ExprId bits =
      build.IntrinsicOf(Intrinsic::kAsUint, shader.types.Make(Scalar::kUint), {build.Float(1)});
  EXPECT_EQ(Result(ToFloat(build.BinaryOf(BinaryOp::kEqual, bits, build.Uint(0x3f800000u)))), 1);
}

TEST_F(Evaluator, OutputsNotWrittenAreZero) {
  shader.functions[shader.entry].body = build.BlockOf({});
  EXPECT_THAT(Run(), ElementsAre(0, 0, 0, 0));
}

TEST_F(Evaluator, RefusesVariablesThatDoNotFitMemory) {
  const VarId huge = Local("huge", shader.types.Array(shader.types.Array(Float4(), 65536), 65536));
  shader.Append({shader.DeclareVar(huge), shader.Return(build.Ref(shader.parameter))});
  EXPECT_TRUE(Run().empty());
  EXPECT_THAT(shader.error, HasSubstr("too large"));
}

// g++ 12's SLP vectoriser drops such a round trip under -mavx, unless the build says otherwise.
TEST(FloatingPoint, TheCompilerKeepsRoundTripsThroughFloat) {
  volatile double inputs[4] = {0.1, 0.2, 0.3, 0.7};
  double outputs[4];
  for (int i = 0; i < 4; ++i)
    outputs[i] = static_cast<double>(static_cast<float>(inputs[i])) - inputs[i];
  for (double difference : outputs) EXPECT_NE(difference, 0);
}

}  // namespace
}  // namespace clipc::ir
