// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/std_layout.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace clipc::ir {
namespace {

class StdLayout : public testing::Test {
 protected:
  TypeId F(int n, Scalar kind = Scalar::kFloat) { return types.Vector(kind, n); }
  TypeId M(int rows, int columns) { return types.Matrix(Scalar::kFloat, rows, columns); }
  TypeId S(const std::vector<TypeId>& fields) {
    Struct structure;
    for (const TypeId type : fields) structure.fields.emplace_back().type = type;
    return types.Of(types.AddStruct(std::move(structure)));
  }

  TypeTable types;
};

TEST_F(StdLayout, StructuredBuffers) {
  EXPECT_TRUE(Std430(types, F(4), false));
  EXPECT_TRUE(Std430(types, F(2), false));
  EXPECT_TRUE(Std430(types, F(1), false));
  EXPECT_FALSE(Std430(types, F(3), false)) << "12 bytes each";
  EXPECT_TRUE(Std430(types, M(4, 4), false));
  EXPECT_TRUE(Std430(types, M(2, 4), false)) << "four registers of two";
  EXPECT_FALSE(Std430(types, M(3, 4), false)) << "four registers of three";
  EXPECT_TRUE(Std430(types, S({F(3), F(1)}), false));
  EXPECT_FALSE(Std430(types, S({F(1), F(3)}), false));
  EXPECT_FALSE(Std430(types, S({F(4), F(1)}), false)) << "20 bytes each";
  EXPECT_EQ(Structured(types, S({F(1), F(1, Scalar::kDouble), F(1)})).size, 24u);
  EXPECT_TRUE(IsOfWords(types, S({F(4), types.Array(F(1), 2)})));
  EXPECT_FALSE(IsOfWords(types, S({F(4), M(2, 2)})));
}

}  // namespace
}  // namespace clipc::ir
