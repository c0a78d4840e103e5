// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <initializer_list>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "ir/test_verifier.h"

namespace clipc::ir {
namespace {

class ObjectCalls : public Verifier {
 protected:
  ExprId Resource(const char* name, ObjectKind kind, TypeId element = {}) {
    const VarId var = shader.AddVar(name, shader.types.Object(kind, element), Storage::kResource);
    shader.resources.push_back({var, {}});
    return build.Ref(var);
  }
  ExprId Texture() { return Resource("map", ObjectKind::kTexture2D, F(4)); }
  ExprId Sampler() { return Resource("linear", ObjectKind::kSampler); }
  ExprId Buffer() { return Resource("counts", ObjectKind::kRWBuffer, I()); }
  ExprId Uv() { return build.ZeroOf(F(2)); }
  ExprId Offset() { return build.ZeroOf(shader.types.Vector(Scalar::kInt, 2)); }
  ExprId Sample(std::initializer_list<NamedOperand> rest, TypeId type) {
    std::vector<NamedOperand> operands = {{OperandKind::kObject, Texture()},
                                          {OperandKind::kSampler, Sampler()},
                                          {OperandKind::kCoordinate, Uv()}};
    operands.insert(operands.end(), rest);
    return build.ObjectCallOf(ObjectOp::kSampleLevel, type, operands);
  }
  void ExpectNone(ExprId expr) {
    shader.Append({build.Eval(expr), shader.Return(shader.Splat4(build.Float(0)))});
    EXPECT_EQ(Verify(shader, Form::kTyped), std::nullopt);
  }
};

TEST_F(ObjectCalls, TakesObject) {
  ExpectProblemIn(build.Add(F(4), ObjectCall{ObjectOp::kBufferLoad, Args({V(), build.Int(0)})}),
                  "the wrong kind of object");
}
TEST_F(ObjectCalls, IsNoted) {
  const ExprId call = build.ObjectCallOf(ObjectOp::kBufferLoad, F(4),
                                         {{OperandKind::kObject, V()}, {OperandKind::kPlace, V()}});
  shader.calls_objects = false;
  ExpectProblemIn(call, "the program says that it calls objects");
}
TEST_F(ObjectCalls, Sample) { ExpectNone(Sample({{OperandKind::kLevel, build.Float(0)}}, F(4))); }
TEST_F(ObjectCalls, TooFewOperands) {
  ExpectProblemIn(Sample({}, F(4)), "wrong number of operands");
}
TEST_F(ObjectCalls, TooManyOperands) {
  ExpectProblemIn(Sample({{OperandKind::kLevel, build.Float(0)},
                          {OperandKind::kOffset, Offset()},
                          {OperandKind::kOffset, Offset()}},
                         F(4)),
                  "wrong number of operands");
}
TEST_F(ObjectCalls, SamplerIsASampler) {
  const List<ExprId> list = Args({Texture(), V(), Uv(), build.Float(0)});
  ExpectProblemIn(build.Add(F(4), ObjectCall{ObjectOp::kSampleLevel, list}),
                  "the wrong kind of sampler");
}
TEST_F(ObjectCalls, LevelOfASampleIsAFloat) {
  ExpectProblemIn(Sample({{OperandKind::kLevel, build.Int(0)}}, F(4)), "the wrong kind of level");
}
TEST_F(ObjectCalls, LevelOfALoadIsAnInteger) {
  ExpectProblemIn(build.ObjectCallOf(ObjectOp::kTextureLoad, F(4),
                                     {{OperandKind::kObject, Texture()},
                                      {OperandKind::kPlace, Offset()},
                                      {OperandKind::kLevel, build.Float(0)}}),
                  "the wrong kind of level");
}
TEST_F(ObjectCalls, OffsetIsMadeOfIntegers) {
  ExpectProblemIn(
      Sample({{OperandKind::kLevel, build.Float(0)}, {OperandKind::kOffset, Uv()}}, F(4)),
      "the wrong kind of offset");
}
TEST_F(ObjectCalls, OneOffsetOrFour) {
  ExpectProblemIn(build.ObjectCallOf(ObjectOp::kGather, F(4),
                                     {{OperandKind::kObject, Texture()},
                                      {OperandKind::kSampler, Sampler()},
                                      {OperandKind::kCoordinate, Uv()},
                                      {OperandKind::kOffset, Offset()},
                                      {OperandKind::kOffset, Offset()}}),
                  "one offset, or one for each of four texels");
}
TEST_F(ObjectCalls, ObjectHasTheOperation) {
  ExpectProblemIn(
      build.ObjectCallOf(ObjectOp::kBufferLoad, F(4),
                         {{OperandKind::kObject, Texture()}, {OperandKind::kPlace, build.Int(0)}}),
      "the wrong kind of object");
}
TEST_F(ObjectCalls, OnlyAWritableObjectIsWritten) {
  ExpectProblemIn(build.ObjectCallOf(ObjectOp::kStore, shader.types.Void(),
                                     {{OperandKind::kObject, Texture()},
                                      {OperandKind::kPlace, Offset()},
                                      {OperandKind::kValue, V()}}),
                  "the wrong kind of object");
}
TEST_F(ObjectCalls, AtomicsAreOfIntegers) {
  ExpectProblemIn(build.ObjectCallOf(ObjectOp::kAtomicAdd, F(),
                                     {{OperandKind::kObject, Buffer()},
                                      {OperandKind::kPlace, build.Int(0)},
                                      {OperandKind::kValue, build.Float(1)}}),
                  "the wrong kind of value");
}
TEST_F(ObjectCalls, ComparandHasTheTypeOfTheValue) {
  ExpectProblemIn(build.ObjectCallOf(ObjectOp::kAtomicCompareExchange, I(),
                                     {{OperandKind::kObject, Buffer()},
                                      {OperandKind::kPlace, build.Int(0)},
                                      {OperandKind::kComparand, build.Uint(1)},
                                      {OperandKind::kValue, build.Int(1)}}),
                  "the wrong kind of comparand");
}
TEST_F(ObjectCalls, TypeIsThatOfTheResult) {
  ExpectProblemIn(Sample({{OperandKind::kLevel, build.Float(0)}}, F(3)),
                  "that of the operation's result");
}
TEST_F(ObjectCalls, StatusIsAUint) {
  const VarId texel = Local("texel", F(4));
  ExpectProblemIn(
      Sample({{OperandKind::kLevel, build.Float(0)}, {OperandKind::kTexel, build.Ref(texel)}},
             F(4)),
      "a status is a uint");
}

}  // namespace
}  // namespace clipc::ir
