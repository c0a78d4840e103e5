// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/object_op.h"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "ir/access.h"
#include "ir/print.h"
#include "ir/test_program.h"

namespace clipc::ir {
namespace {

// Tests what every row of ir/ops.def promises.
TEST(ObjectOps, HaveRowsThatHold) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kObjectOps; ++i) {
    const ObjectOp op{static_cast<std::uint8_t>(i)};
    const ObjectOpInfo& info = InfoOf(op);
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_NE(info.objects, 0) << info.name;
    ASSERT_FALSE(info.Slots().empty()) << info.name;
    EXPECT_EQ(info.Slots()[0].kind, OperandKind::kObject) << info.name;
    int variable = 0;
    for (std::size_t s = 0; s < info.Slots().size(); ++s) {
      const OperandSlot& slot = info.Slots()[s];
      EXPECT_TRUE(s == 0 || info.Slots()[s - 1].kind < slot.kind) << info.name;
      EXPECT_LT(slot.kind, OperandKind::kClamp) << info.name;
      variable += slot.IsVariable();
    }
    EXPECT_LE(variable, 1) << info.name;
  }
}

// Tests that every operand of a call, of each length that it may have, has one name.
TEST(ObjectOps, NameEachOperandOnce) {
  for (std::size_t i = 0; i < kObjectOps; ++i) {
    const ObjectOp op{static_cast<std::uint8_t>(i)};
    const ObjectOpInfo& info = InfoOf(op);
    const std::uint32_t most =
        info.most == ObjectOpInfo::kUnlimited ? info.least + 3u : std::uint32_t{info.most};
    for (std::uint32_t size = info.least; size <= most; ++size) {
      std::uint32_t next = 0;
      for (const OperandSlot& slot : info.Slots()) {
        const OperandRun run = RunOf(op, slot.kind, size);
        EXPECT_TRUE(run.count == 0 || run.first == next) << info.name << " of " << size;
        EXPECT_TRUE(run.count == 1 || slot.IsVariable()) << info.name << " of " << size;
        next += run.count;
      }
      EXPECT_EQ(next, size) << info.name;
    }
  }
}

TEST(ObjectOps, HaveNoOperandThatTheyDoNotTake) {
  EXPECT_FALSE(Takes(ObjectOp::kBufferLoad, OperandKind::kSampler));
  EXPECT_EQ(RunOf(ObjectOp::kBufferLoad, OperandKind::kSampler, 2).count, 0u);
  EXPECT_EQ(RunOf(ObjectOp::kSample, OperandKind::kOffset, 3).count, 0u);
  EXPECT_EQ(RunOf(ObjectOp::kStore, OperandKind::kStep, 3).count, 0u);
}

TEST(ObjectOps, SayWhatTheyDo) {
  EXPECT_TRUE(IsGather(ObjectOp::kGatherCmp));
  EXPECT_EQ(ComponentOf(ObjectOp::kGatherCmp), 0);
  EXPECT_EQ(ComponentOf(ObjectOp::kGatherAlpha), 3);
  EXPECT_TRUE(LoadsElement(ObjectOp::kImageLoad));
  EXPECT_FALSE(LoadsElement(ObjectOp::kByteLoad));
  EXPECT_FALSE(LoadsElement(ObjectOp::kSample));
  EXPECT_TRUE(ReadsObject(ObjectOp::kAtomicMax));
  EXPECT_FALSE(ReadsObject(ObjectOp::kStore));
  EXPECT_FALSE(ReadsObject(ObjectOp::kTextureSize));
  EXPECT_TRUE(WritesObject(ObjectOp::kIncrementCounter));
  EXPECT_TRUE(AsksNeighbours(ObjectOp::kLevelOfDetail));
  EXPECT_FALSE(AsksNeighbours(ObjectOp::kSampleCmpLevelZero));
}

class NamedOperands : public testing::Test {
 protected:
  TestProgram shader;
  Builder& build = shader.build;
};

TEST_F(NamedOperands, FollowSteps) {
  const TypeId type = shader.types.Object(ObjectKind::kRWStructuredBuffer, shader.types.Error());
  const VarId list = shader.AddVar("list", type, Storage::kResource);
  const ExprId call =
      build.ObjectCallOf(ObjectOp::kAtomicCompareExchange, shader.types.Make(Scalar::kInt),
                         {{OperandKind::kObject, build.Ref(list)},
                          {OperandKind::kPlace, build.Int(7)},
                          {OperandKind::kStep, build.Uint(1)},
                          {OperandKind::kStep, build.Uint(2)},
                          {OperandKind::kComparand, build.Int(3)},
                          {OperandKind::kValue, build.Int(4)}});
  EXPECT_EQ(PrintExpr(shader, call),
            "atomic_compare_exchange(list, 7, step: 1u, step: 2u, comparand: 3, value: 4)");
  const auto& node = *As<ObjectCall>(shader, call);
  EXPECT_EQ(OperandsOf(node, OperandKind::kStep).size, 2u);
  EXPECT_EQ(PrintExpr(shader, OperandOf(shader, node, OperandKind::kValue)), "4");
  EXPECT_FALSE(OperandOf(shader, node, OperandKind::kSampler));
  EXPECT_FALSE(OperandOf(shader, node, OperandKind::kClamp));
}

TEST_F(NamedOperands, HaveThoseOfTiledResources) {
  const VarId map =
      shader.AddVar("map", shader.types.Object(ObjectKind::kTexture2D), Storage::kResource);
  const VarId texel = build.Local("texel", shader.types.Vector(Scalar::kFloat, 4));
  const ExprId call = build.ObjectCallOf(ObjectOp::kSample, shader.types.Make(Scalar::kUint),
                                         {{OperandKind::kObject, build.Ref(map)},
                                          {OperandKind::kSampler, build.Ref(map)},
                                          {OperandKind::kCoordinate, build.Float(0)},
                                          {OperandKind::kClamp, build.Float(2)},
                                          {OperandKind::kTexel, build.Ref(texel)}});
  EXPECT_EQ(PrintExpr(shader, call), "sample(map, map, 0.0, clamp: 2.0, texel: texel)");
  const auto& node = *As<ObjectCall>(shader, Clone(shader, call));
  EXPECT_EQ(OperandsOf(node, OperandKind::kOffset).size, 0u);
  EXPECT_EQ(PrintExpr(shader, OperandOf(shader, node, OperandKind::kClamp)), "2.0");
}

TEST_F(NamedOperands, ComeInOrder) {
  EXPECT_DEATH(build.ObjectCallOf(
                   ObjectOp::kBufferLoad, shader.types.Void(),
                   {{OperandKind::kPlace, build.Int(0)}, {OperandKind::kObject, build.Int(0)}}),
               "invariant");
}

}  // namespace
}  // namespace clipc::ir
