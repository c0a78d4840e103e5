// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/advice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/scene.h"
#include "study/way.h"

namespace clipc::study {
namespace {

// Any costs do for what is tested here; these have the order that llvmpipe has.
CostTable SomeCosts() {
  CostTable costs;
  for (const int planes : {1, 3, 6}) {
    for (const char* way : {"clip", "xyw1", "object", "world", "level9"})
      costs[{way, planes}] = 1.0;
    for (const char* way : {"discard", "discard-object"}) costs[{way, planes}] = 1.1;
    costs[{"discard-world", planes}] = 1.4, costs[{"cpu", planes}] = 1.08;
  }
  costs[{"near-plane", 1}] = 1.0;
  return costs;
}

TEST(Advice, FollowsMeansAndNumbers) {
  DrawFacts facts;
  facts.camera.far = 1e5;
  facts.cuts[0].view_plane = {0, 0, 1, -300};
  const auto best = [&] { return Advise(facts, SomeCosts()).front().way; };
  EXPECT_EQ(best(), "object");
  facts.means.rigid = false;
  EXPECT_EQ(best(), "xyw1");
  facts.means.clip_distances = false, facts.means.user_planes = true;
  EXPECT_NE(best(), "level9");  // 3.4 pixels
  facts.camera.reversed = true;
  EXPECT_EQ(best(), "level9");
  facts.means.user_planes = false;
  EXPECT_EQ(best(), "discard");
  facts.camera.orthographic = true, facts.means.clip_distances = true;
  for (const Advice& way : Advise(facts, SomeCosts()))
    EXPECT_FALSE(way.way == "xyw1" && way.possible);
}

TEST(Advice, DearWaysLoseAgainstCheapOnesThatAreGoodEnough) {
  DrawFacts facts;
  facts.cuts[0].view_plane = {0, 0, 1, -3};  // 0.03 pixels in clip space
  CostTable costs = SomeCosts();
  for (const char* way : {"object", "xyw1", "near-plane", "world", "discard-object", "cpu"})
    costs[{way, 1}] = 1.3;
  EXPECT_EQ(Advise(facts, costs).front().way, "clip");
  EXPECT_NE(Advise(facts, costs, 0.01).front().way, "clip");
}

// A difference that no picture shows does not decide: the way that comes first is taken.
TEST(Advice, DigitsThatNobodySeesDoNotCount) {
  DrawFacts facts;
  facts.camera.far = 1e5;
  facts.cuts[0].view_plane = {0, 0, 1, -300};
  const std::vector<Advice> all = Advise(facts, SomeCosts());
  const auto of = [&](const char* way) { return *std::ranges::find(all, way, &Advice::way); };
  EXPECT_LT(of("cpu").bound, of("xyw1").bound);
  EXPECT_EQ(all.front().way, "object");
  facts.means.rigid = false;
  EXPECT_EQ(Advise(facts, SomeCosts()).front().way, "xyw1");
}

TEST(Advice, CountsTheDistancesThatFloatsCarry) {
  DrawFacts facts;
  facts.camera.far = 1e5;
  facts.cuts[0].view_plane = {0, 0, 1, -10};
  const auto bound = [&](const char* way) {
    for (const Advice& advice : Advise(facts, SomeCosts())) {
      if (advice.way == way) return advice.bound;
    }
    return -1.0;
  };
  const double object = bound("object"), xyw1 = bound("xyw1"), cpu = bound("cpu");
  facts.cuts[0].world_reach = 1e4;  // one matrix: that costs nothing but in `world`
  EXPECT_EQ(bound("object"), object);
  EXPECT_EQ(bound("xyw1"), xyw1);
  EXPECT_GT(bound("world"), 1);
  facts.means.order = runtime::MatrixOrder::kWorldFirst;
  EXPECT_EQ(bound("object"), object);
  EXPECT_GT(bound("xyw1"), 100 * xyw1);
  EXPECT_EQ(bound("cpu"), cpu);
  facts.means.order = runtime::MatrixOrder::kOneMatrix, facts.cuts[0].reach = 1e4;
  for (const auto& [way, before] :
       {std::pair{"object", object}, std::pair{"xyw1", xyw1}, std::pair{"cpu", cpu}})
    EXPECT_GT(bound(way), 100 * before) << way;
  facts.cuts[0].world_reach = 0;  // the vertex begins in its own space
  EXPECT_GT(bound("world"), 100 * object);
}

const Advice& Of(const std::vector<Advice>& all, const char* way) {
  return *std::ranges::find(all, way, &Advice::way);
}

TEST(Advice, PredictsByTheLengthOfEdges) {
  DrawFacts facts;
  facts.cuts[0].view_plane = {0, 0, 1, -3}, facts.cuts[0].reach = 2;
  const std::vector<Advice> points = Advise(facts, SomeCosts());
  facts.extent = 8;
  const std::vector<Advice> edges = Advise(facts, SomeCosts());
  for (const char* way : {"object", "xyw1", "clip", "world", "discard"})
    EXPECT_DOUBLE_EQ(Of(edges, way).predicted, 2 * Of(points, way).predicted) << way;
  EXPECT_DOUBLE_EQ(Of(points, "cpu").predicted, 0x1p-24 * 1080 * (0.5 + 2));
  EXPECT_DOUBLE_EQ(Of(edges, "cpu").predicted, 0x1p-24 * 1080 * (0.5 + 2 + 4));
}

TEST(Advice, CostsAreThoseOfEnoughPlanes) {
  DrawFacts facts;
  facts.camera.far = 1e5, facts.cuts[0].view_plane = {0, 0, 1, -300};
  facts.means.whole_pass = true;
  CostTable costs = SomeCosts();
  for (const int planes : {1, 3, 6}) costs[{"object", planes}] = planes;
  costs.erase({"xyw1", 1}), costs.erase({"xyw1", 3}), costs.erase({"xyw1", 6});
  for (const auto& [planes, cost] : {std::pair{1, 1.0}, std::pair{2, 3.0}, std::pair{4, 6.0}}) {
    facts.planes = planes;
    const std::vector<Advice> all = Advise(facts, costs);
    EXPECT_EQ(Of(all, "object").cost, cost);
    EXPECT_EQ(Of(all, "near-plane").possible, planes == 1);
    // A way that nobody measured is not advised.
    EXPECT_FALSE(Of(all, "xyw1").meets);
    EXPECT_NE(all.front().way, "xyw1");
  }
}

TEST(Advice, OrdersWhatIsNotRecommended) {
  DrawFacts facts;
  facts.camera.far = 1e5, facts.cuts[0].view_plane = {0, 0, 1, -300};
  // A way that does not meet the tolerance says nothing of how cheap the others should be.
  CostTable costs = SomeCosts();
  costs[{"clip", 1}] = 0.5, costs[{"object", 1}] = 1.1;
  std::vector<Advice> all = Advise(facts, costs);
  EXPECT_EQ(all.front().way, "object");
  // The dear ones follow, the cheapest first.
  costs[{"cpu", 1}] = 2, costs[{"world", 1}] = 3, facts.means.can_discard = false;
  all = Advise(facts, costs);
  const auto place = [&](const char* way) { return std::ranges::find(all, way, &Advice::way); };
  EXPECT_TRUE(Of(all, "world").meets);
  EXPECT_LT(place("cpu"), place("world"));
  // Where none meets it, digits count that nobody sees.
  all = Advise(facts, costs, 1e-9);
  for (const Advice& way : all) {
    if (!way.possible) continue;
    EXPECT_GE(way.predicted, all.front().predicted) << way.way;
  }
}

TEST(Advice, KnowsCures) {
  DrawFacts facts;
  facts.camera.far = 1e5, facts.cuts[0].view_plane = {0, 0, 1, -300};
  const auto cure = [&](double tolerance = 0.5) { return CureFor(facts, SomeCosts(), tolerance); };
  facts.means.clip_distances = facts.means.can_discard = facts.means.rigid = false;
  facts.means.user_planes = true;
  EXPECT_EQ(cure(), "reverse the depth");
  EXPECT_EQ(cure(1e-9), "");
  facts.camera.reversed = true, facts.cuts[0].reach = 1e5;
  EXPECT_THAT(cure(), ::testing::HasSubstr("give the mesh one of its own"));
  facts.cuts[0].reach = 0.5, facts.cuts[0].world_reach = 1e5,
  facts.means.order = runtime::MatrixOrder::kWorldFirst;
  EXPECT_THAT(cure(), ::testing::HasSubstr("multiply its matrices in double"));
}

// The errors that the law leaves open are measured, and nothing else is.
TEST(Advice, MeasuresWhatIsOpen) {
  DrawFacts facts;
  facts.cuts[0].view_plane = {0, 0, 1, -3}, facts.means.can_discard = false;
  const double law = Of(Advise(facts, SomeCosts()), "object").predicted;
  std::vector<std::string> measured;
  const auto object = [&](double tolerance, double loses) {
    measured.clear();
    return Of(Advise(facts, SomeCosts(), tolerance,
                     [&](const Way& way) -> std::optional<double> {
                       measured.push_back(way.name);
                       return loses;
                     }),
              "object");
  };
  EXPECT_TRUE(object(13 * law, 99).meets);
  EXPECT_THAT(measured, ::testing::Not(::testing::Contains("object")));
  EXPECT_THAT(measured, ::testing::Contains("clip"));
  EXPECT_THAT(measured, ::testing::Not(::testing::Contains("discard")));
  const Advice close = object(6 * law, 5 * law);
  EXPECT_FALSE(close.meets);
  EXPECT_DOUBLE_EQ(close.predicted, 5 * law);
  EXPECT_DOUBLE_EQ(close.bound, 5 * law * kMeasuredFactor);
  EXPECT_TRUE(object(6 * law, 3 * law).meets);
}

// The processor's cut is a line of vertices, which are off by their rounding and not by the plane's
// slant.
TEST(Advice, TheProcessorsCutIsOffByItsVerticesAlone) {
  const auto predicted = [](const DrawFacts& facts, const char* way) {
    const std::vector<Advice> all = Advise(facts, SomeCosts());
    return std::ranges::find(all, way, &Advice::way)->predicted;
  };
  DrawFacts facts;
  facts.cuts[0].view_plane = {0, 0, 1, -3};
  DrawFacts slanted = facts;
  slanted.sine = facts.sine / 100;
  EXPECT_GT(predicted(slanted, "object"), 10 * predicted(facts, "object"));
  EXPECT_EQ(predicted(slanted, "cpu"), predicted(facts, "cpu"));
  DrawFacts tall = facts;
  tall.picture_height *= 2;
  EXPECT_DOUBLE_EQ(predicted(tall, "cpu"), 2 * predicted(facts, "cpu"));
  DrawFacts far = facts;
  far.cuts[0].reach = 1e4;
  EXPECT_GT(predicted(far, "cpu"), 100 * predicted(facts, "cpu"));
}

// A scene of small cubes at these heights over the plane y >= 0, before the camera.
Scene Cubes(std::initializer_list<double> heights) {
  Scene scene;
  Camera camera;
  camera.eye[1] = -5;
  scene.cameras = {{"main", camera}};
  scene.planes = {{"water", {0, 1, 0, 0}}};
  for (const double height : heights) {
    SceneObject& object = scene.objects.emplace_back();
    object.box = {{-1, -1, -1}, {1, 1, 1}};
    object.world.m[3][1] = height, object.world.m[3][2] = 40;
  }
  scene.means.clip_distances = scene.means.can_discard = false;
  return scene;
}

std::vector<std::string> WaysOf(const Scene& scene) {
  CostTable costs = SomeCosts();
  for (const int planes : {1, 3, 6}) costs[{"cpu", planes}] = 2;
  std::vector<std::string> ways;
  for (const ObjectAdvice& advice : AdviseScene(scene, scene.cameras.front().camera, costs))
    ways.push_back(advice.best ? advice.best->way : "");
  return ways;
}

// Next to ordinary depth, a depth that begins at the plane hides what is nearer.
TEST(Scenes, TheNearPlaneIsForWholePasses) {
  using ::testing::ElementsAre;
  EXPECT_THAT(WaysOf(Cubes({0, 0.5})), ElementsAre("near-plane", "near-plane"));
  EXPECT_THAT(WaysOf(Cubes({0, 3})), ElementsAre("cpu", ""));  // the second is drawn as it is
  // An object that is not drawn does not count: below the water, or beside the picture.
  Scene hidden = Cubes({0, 0.5, -5, 0});
  hidden.objects[3].world.m[3][0] = 1000;
  EXPECT_THAT(WaysOf(hidden), ElementsAre("near-plane", "near-plane", "", ""));
  hidden = Cubes({0, 3, 0});
  hidden.objects[2].world.m[3][0] = 1000;
  EXPECT_THAT(WaysOf(hidden), ElementsAre("cpu", "", ""));
  Scene moved = Cubes({0, 0.5});
  moved.objects[1].rigid = false;  // cannot be drawn so
  EXPECT_EQ(WaysOf(moved)[0], "cpu");
  Scene two = Cubes({0, 0.5});
  two.planes.push_back({"side", {1, 0, 0, 0}});
  EXPECT_THAT(WaysOf(two), ElementsAre("cpu", "cpu"));
  for (const Scene& scene : BuiltInScenes()) {
    for (const std::string& way : WaysOf(scene)) EXPECT_NE(way, "near-plane") << scene.name;
  }
}

TEST(Scenes, RefusedPlanesAreNamed) {
  Scene scene = Cubes({0});
  scene.planes[0].plane = {0, 1e-31, 0, 0};
  const ObjectAdvice advice = AdviseScene(scene, scene.cameras.front().camera, SomeCosts()).front();
  EXPECT_THAT(advice.plan.refused, ::testing::HasSubstr("water: the plane's largest component"));
  EXPECT_TRUE(advice.fails());
  EXPECT_FALSE(advice.best);
}

TEST(Scenes, NothingIsPlannedWithARefusedPlane) {
  Scene scene = Cubes({0});
  scene.planes.push_back({"first", {0, 1e-31, 0, 0}});
  scene.planes.push_back({"second", {0, 1e-31, 0, 0}});
  const ObjectPlan plan = PlanObject(scene.objects[0], scene.cameras.front().camera, scene.planes);
  EXPECT_THAT(plan.refused, ::testing::StartsWith("first: "));
  EXPECT_EQ(plan.needed, 0);
}

TEST(Scenes, FactsAreThoseOfTheObjectAndEachOfItsPlanes) {
  Scene scene = Cubes({0});
  scene.picture_height = 700;
  const Camera& camera = scene.cameras.front().camera;
  SceneObject& object = scene.objects[0];
  object.world.m[0][0] = object.world.m[1][1] = object.world.m[2][2] = 0.5;
  // The eye is 5 below the water, 40 before the wall, and nowhere from a plane without a normal.
  scene.planes.push_back({"wall", {0, 0, 1, -40}});
  scene.planes.push_back({"none", {0, 0, 0, 1}});
  const DrawFacts water = FactsOf(object, camera, scene, 0b001),
                  all = FactsOf(object, camera, scene, 0b111);
  EXPECT_EQ(water.planes, 1);
  ASSERT_EQ(water.cuts.size(), 1u);
  EXPECT_NEAR(std::abs(water.cuts[0].view_plane.w), 5, 1e-9);
  EXPECT_EQ(all.planes, 3);
  ASSERT_EQ(all.cuts.size(), 2u);
  EXPECT_NEAR(std::abs(all.cuts[0].view_plane.w), 5, 1e-9);
  EXPECT_NEAR(std::abs(all.cuts[1].view_plane.w), 40, 1e-9);
  EXPECT_EQ(all.picture_height, 700);
  EXPECT_NEAR(all.extent, std::sqrt(3.0) / camera.HalfHeightAt(40), 1e-9);
  EXPECT_TRUE(FactsOf(object, camera, scene, 0).cuts.empty());
}

TEST(Scenes, MostObjectsNeedNoPlane) {
  for (const Scene& scene : BuiltInScenes()) {
    int drawn = 0, without = 0, culled = 0;
    for (const SceneObject& object : scene.objects) {
      const ObjectPlan plan = PlanObject(object, scene.cameras.front().camera, scene.planes);
      if (plan.outside_frustum) continue;
      culled += plan.culled;
      drawn += !plan.culled, without += !plan.culled && plan.needed == 0;
    }
    EXPECT_GT(drawn, 10) << scene.name;
    EXPECT_GT(culled, 0) << scene.name;
    EXPECT_GT(without, drawn / 2) << scene.name;
  }
}

// The plans are compared with the corners themselves, in double.
TEST(Scenes, PlansAreRight) {
  for (const Scene& scene : BuiltInScenes()) {
    for (std::size_t i = 0; i < scene.objects.size(); i += 7) {
      const SceneObject& object = scene.objects[i];
      const ObjectPlan plan = PlanObject(object, scene.cameras.front().camera, scene.planes);
      bool some_plane_takes_all = false;
      for (std::size_t p = 0; p < scene.planes.size(); ++p) {
        const runtime::Plane plane = runtime::PlaneBefore(object.world, scene.planes[p].plane);
        int inside = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const auto at = [&](int axis) {
            return static_cast<double>((corner >> axis & 1) != 0 ? object.box.high[axis]
                                                                 : object.box.low[axis]);
          };
          inside += plane.x * at(0) + plane.y * at(1) + plane.z * at(2) + plane.w >= 0;
        }
        some_plane_takes_all = some_plane_takes_all || inside == 0;
        if (!plan.culled) {
          EXPECT_EQ(plan.needed >> p & 1, inside < 8) << scene.name << " " << i;
        }
      }
      EXPECT_EQ(plan.culled, some_plane_takes_all) << scene.name << ' ' << i;
      if (plan.culled) {
        EXPECT_EQ(plan.needed, 0) << scene.name << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace clipc::study
