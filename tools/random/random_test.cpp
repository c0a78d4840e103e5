// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>

#include "tools/harness/offscreen.h"
#include "tools/random/choices.h"
#include "tools/random/features.h"
#include "tools/random/judge.h"
#include "tools/random/layout.h"
#include "tools/random/program.h"
#include "tools/random/range.h"
#include "tools/random/reduce.h"
#include "tools/random/type.h"

namespace clipc::random {
namespace {

using ::testing::ElementsAre;
using List = std::vector<std::uint32_t>;

TEST(Choices, AListIsDrawnAgainAndThenZeros) {
  Choices choices(List{3, 9});
  EXPECT_EQ(choices.Below(5), 3u);
  EXPECT_EQ(choices.Below(4), 1u);
  EXPECT_EQ(choices.Below(100), 0u);
  EXPECT_THAT(choices.drawn(), ElementsAre(3, 1, 0));
}

TEST(Choices, ZeroIsTheSimpleAnswer) {
  Choices choices(List{});
  EXPECT_FALSE(choices.Chance(99));
  EXPECT_EQ(choices.Pick({1, 5}), 0u);
  EXPECT_EQ(choices.Between(2, 7), 2);
}

TEST(Choices, SpansEndWithTheirScopes) {
  Choices choices(1);
  {
    const SpanOf outer(choices);
    choices.Below(9);
    const SpanOf inner(choices);
    choices.Below(9);
  }
  ASSERT_EQ(choices.spans().size(), 2u);
  EXPECT_EQ(choices.spans()[0].begin, 1u);
  EXPECT_EQ(choices.spans()[1].begin, 0u);
  EXPECT_EQ(choices.spans()[1].end, 2u);
}

TEST(Features, NamesAreKnown) {
  Features features;
  EXPECT_TRUE(features.Has(Feature::kMatrices));
  features.Set("matrices,loops", false);
  EXPECT_FALSE(features.Has(Feature::kMatrices));
  EXPECT_FALSE(features.Has(Feature::kLoops));
  EXPECT_THROW(features.Set("nothing", true), harness::DrawError);
}

TEST(Program, EqualChoicesGiveEqualPrograms) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Choices choices(seed);
    const std::string text = MakeProgram(choices, {}).text;
    Choices again(choices.drawn());
    EXPECT_EQ(MakeProgram(again, {}).text, text) << seed;
    EXPECT_EQ(again.drawn(), choices.drawn()) << seed;
  }
}

TEST(Program, PixelShadersAreAFeature) {
  Features features;
  features.Set("pixels", true);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Choices choices(seed);
    const Program program = MakeProgram(choices, features);
    EXPECT_EQ(program.stage, Stage::kPixel);
    EXPECT_THAT(program.profile, ::testing::StartsWith("ps_"));
    EXPECT_THAT(program.text, ::testing::HasSubstr(" : SV_Target0;"));
    EXPECT_EQ(program.lowering, "none");
  }
}

TEST(Program, GeometryShadersAreAFeature) {
  Features features;
  features.Set("emitters", true);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Choices choices(seed);
    const Program program = MakeProgram(choices, features);
    EXPECT_EQ(program.stage, Stage::kGeometry);
    EXPECT_THAT(program.profile, ::testing::StartsWith("gs_"));
    EXPECT_THAT(program.text, ::testing::HasSubstr("stream.Append(result);"));
    EXPECT_NE(program.plane_space, "object");
  }
}

TEST(Program, ShadersOfPatchesAreFeatures) {
  for (const auto& [feature, prefix, part] :
       {std::tuple("patches", "hs_", "[patchconstantfunc(\"Constant\")]"),
        std::tuple("domains", "ds_", " t_at : SV_DomainLocation")}) {
    Features features;
    features.Set(feature, true);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      Choices choices(seed);
      const Program program = MakeProgram(choices, features);
      EXPECT_THAT(program.profile, ::testing::StartsWith(prefix));
      EXPECT_THAT(program.text, ::testing::HasSubstr(part));
    }
  }
}

TEST(Program, TheSimplestOneIsSmall) {
  Choices choices(List{});
  EXPECT_LT(MakeProgram(choices, {}).text.size(), 400u);
}

TEST(Range, WrapsToAllValues) {
  EXPECT_EQ(Integers(Kind::kInt, -5, 9).high, 9);
  EXPECT_EQ(Integers(Kind::kUint, -5, 9).high, 0x1p32 - 1);
  EXPECT_EQ(Converted({-1, 1}, Kind::kInt, Kind::kUint).high, 0x1p32 - 1);
  EXPECT_FALSE(CanConvert({-1, 1, 2}, Kind::kFloat, Kind::kUint));
  EXPECT_FALSE(CanConvert(Wild(Kind::kInt), Kind::kInt, Kind::kFloat));
}

TEST(Range, ProductsAddTheirFractions) {
  const Range product = Product({-2, 3, 2}, {-5, 1, 3});
  EXPECT_EQ(product.low, -15);
  EXPECT_EQ(product.high, 10);
  EXPECT_EQ(product.fraction, 5);
  EXPECT_TRUE(IsExact(product));
  EXPECT_FALSE(IsExact({0, 0x1p20, 4}));
}

Type Number(Shape shape, std::vector<int> sizes = {}) {
  return {Kind::kFloat, shape, -1, std::move(sizes)};
}

// The offsets of "Packing rules for constant variables" and of testdata/draw/packing_rules.hlsl.
TEST(Layout, FollowsDirect3DsRules) {
  const ConstantBuffer buffer{"B",
                              {{"a", Number({0, 1})},
                               {"b", Number({0, 4})},
                               {"c", Number({0, 3})},
                               {"d", Number({0, 2})},
                               {"e", Number({0, 1}, {3})},
                               {"f", Number({0, 3})},
                               {"m", Number({3, 3})},
                               {"n", Number({0, 1})},
                               {"o", Number({2, 3}), true}}};
  const auto offsets = OffsetsOf({}, buffer);
  List first;
  for (const List& member : offsets) first.push_back(member[0]);
  EXPECT_THAT(first, ElementsAre(0, 16, 32, 48, 64, 100, 112, 156, 160));
  EXPECT_THAT(offsets[4], ElementsAre(64, 80, 96));
  EXPECT_THAT(offsets[6], ElementsAre(112, 128, 144, 116, 132, 148, 120, 136, 152));
  EXPECT_THAT(offsets[8], ElementsAre(160, 164, 168, 176, 180, 184));
}

TEST(Layout, PutsStructsAtRows) {
  Structs structs = {{"S", {{"a", Number({0, 3})}, {"b", Number({2, 2}), ""}}}};
  WithMajors(structs, false);
  const ConstantBuffer buffer{"B", {{"x", Number({0, 1})}, {"s", {Kind::kFloat, {}, 0, {2}}}}};
  EXPECT_THAT(OffsetsOf(structs, buffer)[1],
              ElementsAre(16, 20, 24, 32, 48, 36, 52, 64, 68, 72, 80, 96, 84, 100));
}

// A fault that two of many choices make: both are left, and little else.
TEST(Reduce, KeepsWhatMatters) {
  List list(300);
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = i % 90;
  const auto make = [](const List& some) {
    Made made{some, {}};
    for (std::size_t i = 0; i + 5 < some.size(); i += 5) made.spans.push_back({i, i + 5});
    return made;
  };
  const auto fails = [](const List& some) {
    return std::ranges::find(some, 77u) != some.end() && std::ranges::count(some, 41u) >= 2;
  };
  const List reduced = Reduce(list, {make, fails});
  EXPECT_THAT(reduced, ElementsAre(41, 41, 77));
}

TEST(Verdict, KeysForgetNamesAndNumbers) {
  const Verdict a{Fault::kRefused, "", "x.hlsl:3:1: error: `a` is not a type 12"};
  const Verdict b{Fault::kRefused, "", "y.hlsl:9:1: error: `b` is not a type 7"};
  EXPECT_EQ(a.Key(), b.Key());
}

}  // namespace
}  // namespace clipc::random
