// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/advice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/law.h"
#include "study/scene.h"
#include "study/sweeps.h"

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

DrawFacts FactsFor(const Config& config) {
  DrawFacts facts;
  facts.camera = config.camera, facts.cuts = {Prepare(config)};
  return facts;
}

// An oblique plane that crosses the view's axis where the eye is that far from it; the near
// distance is 0.1.
Config PlaneAway(double distance) { return ObliqueAt(distance / 0.77, 0.1, 1e5); }

const Advice& Of(const std::vector<Advice>& all, const char* way) {
  return *std::ranges::find(all, way, &Advice::way);
}

TEST(Advice, FollowsMeansAndNumbers) {
  Config config = PlaneAway(300);
  Means means;
  const auto best = [&] {
    DrawFacts facts = FactsFor(config);
    facts.means = means;
    return Advise(facts, SomeCosts()).front().way;
  };
  EXPECT_EQ(best(), "object");
  means.rigid = false;
  EXPECT_EQ(best(), "xyw1");
  means.clip_distances = false, means.user_planes = true;
  EXPECT_NE(best(), "level9");  // 3.4 pixels
  config.camera.reversed = true;
  EXPECT_EQ(best(), "level9");
  means.user_planes = false;
  EXPECT_EQ(best(), "discard");
  config.camera.orthographic = true;
  for (const Advice& way : Advise(FactsFor(config), SomeCosts()))
    EXPECT_FALSE(way.way == "xyw1" && way.possible);
}

TEST(Advice, DearWaysLoseAgainstCheapOnesThatAreGoodEnough) {
  const DrawFacts facts = FactsFor(PlaneAway(3));  // 0.03 pixels in clip space
  CostTable costs = SomeCosts();
  for (const char* way : {"object", "xyw1", "near-plane", "world", "discard-object", "cpu"})
    costs[{way, 1}] = 1.3;
  EXPECT_EQ(Advise(facts, costs).front().way, "clip");
  EXPECT_NE(Advise(facts, costs, 0.01).front().way, "clip");
}

// A difference that no image shows does not decide: the way that comes first is taken.
TEST(Advice, DigitsThatNobodySeesDoNotCount) {
  DrawFacts facts = FactsFor(PlaneAway(300));
  const std::vector<Advice> all = Advise(facts, SomeCosts());
  EXPECT_LT(Of(all, "cpu").bound, Of(all, "xyw1").bound);
  EXPECT_EQ(all.front().way, "object");
  facts.means.rigid = false;
  EXPECT_EQ(Advise(facts, SomeCosts()).front().way, "xyw1");
}

TEST(Advice, CountsTheDistancesThatFloatsCarry) {
  Config config = PlaneAway(10);
  using enum runtime::MatrixOrder;
  runtime::MatrixOrder order = kOneMatrix;
  runtime::JudgedIn judged_in = runtime::JudgedIn::kSurface;
  const auto bound = [&](const char* way) {
    DrawFacts facts = FactsFor(config);
    facts.means.order = order, facts.judged_in = judged_in;
    return Of(Advise(facts, SomeCosts()), way).bound;
  };
  const double object = bound("object"), xyw1 = bound("xyw1"), cpu = bound("cpu");
  config.world_offset = 1e5;  // one matrix: that costs nothing but in `world`
  EXPECT_NEAR(bound("object") / object, 1, 0.5);
  EXPECT_NEAR(bound("xyw1") / xyw1, 1, 0.5);
  EXPECT_GT(bound("world"), 1);
  order = kWorldFirst;
  EXPECT_NEAR(bound("object") / object, 1, 0.5);
  EXPECT_GT(bound("xyw1"), 100 * xyw1);
  EXPECT_NEAR(bound("cpu") / cpu, 1, 0.01);
  // In the image the object goes with its vertices, and its cut with it.
  judged_in = runtime::JudgedIn::kImage;
  const double in_image = bound("object");
  EXPECT_GT(in_image, 1000 * object);
  EXPECT_LT(in_image, bound("xyw1") / 2);
  EXPECT_NEAR(bound("cpu") / in_image, 1, 0.3);
  judged_in = runtime::JudgedIn::kSurface;
  order = kOneMatrix, config.world_offset = 0, config.mesh_offset = 1e5;
  for (const auto& [way, before] :
       {std::pair{"object", object}, std::pair{"xyw1", xyw1}, std::pair{"cpu", cpu}})
    EXPECT_GT(bound(way), 100 * before) << way;
}

// The worst of an object's planes counts, for each way another.
TEST(Advice, AsksEachPlaneByItself) {
  Config near = PlaneAway(0.5), far = PlaneAway(300);
  near.mesh_offset = far.mesh_offset = 100;  // one mesh
  const auto predicted = [](std::initializer_list<Config> planes, const char* way) {
    DrawFacts facts = FactsFor(*planes.begin());
    facts.cuts.clear(), facts.planes = static_cast<int>(planes.size());
    for (const Config& each : planes) facts.cuts.push_back(Prepare(each));
    return Of(Advise(facts, SomeCosts()), way).predicted;
  };
  EXPECT_GT(predicted({near}, "object"), 10 * predicted({far}, "object"));
  EXPECT_GT(predicted({far}, "clip"), 3 * predicted({near}, "clip"));
  for (const char* way : {"object", "clip", "world", "cpu"}) {
    EXPECT_EQ(predicted({near, far}, way), std::max(predicted({near}, way), predicted({far}, way)))
        << way;
  }
}

TEST(Advice, CostsAreThoseOfEnoughPlanes) {
  DrawFacts facts = FactsFor(PlaneAway(300));
  facts.means.whole_pass = true;
  CostTable costs = SomeCosts();
  for (const int planes : {1, 3, 6}) costs[{"object", planes}] = planes;
  costs.erase({"xyw1", 1}), costs.erase({"xyw1", 3}), costs.erase({"xyw1", 6});
  for (const auto& [planes, cost] : {std::pair{1, 1.0}, std::pair{2, 3.0}, std::pair{4, 6.0}}) {
    facts.planes = planes;
    const std::vector<Advice> all = Advise(facts, costs);
    EXPECT_EQ(Of(all, "object").cost, cost);
    EXPECT_EQ(Of(all, "near-plane").possible, planes == 1);
    // A way that nobody measured is not advised where another meets the tolerance.
    EXPECT_TRUE(Of(all, "xyw1").meets);
    EXPECT_FALSE(Of(all, "xyw1").has_cost());
    EXPECT_NE(all.front().way, "xyw1");
  }
  // It is where no other does.
  facts = FactsFor(PlaneAway(300)), facts.means.rigid = facts.means.can_discard = false;
  for (const int planes : {1, 3, 6}) costs.erase({"world", planes});
  EXPECT_EQ(Advise(facts, costs).front().way, "xyw1");
}

TEST(Advice, OrdersWhatIsNotRecommended) {
  DrawFacts facts = FactsFor(PlaneAway(300));
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
  Config config = PlaneAway(300);
  Means means;
  const auto cure = [&](double tolerance = 0.5) {
    DrawFacts facts = FactsFor(config);
    facts.means = means;
    return CureFor(facts, SomeCosts(), tolerance);
  };
  means.clip_distances = means.can_discard = means.rigid = false;
  means.user_planes = true;
  EXPECT_EQ(cure(), "reverse the depth");
  EXPECT_EQ(cure(1e-9), "");
  config.camera.reversed = true, config.mesh_offset = 1e8;
  EXPECT_THAT(cure(), ::testing::HasSubstr("give the mesh one of its own"));
  config.mesh_offset = 0, config.world_offset = 1e8;
  means.order = runtime::MatrixOrder::kWorldFirst;
  EXPECT_THAT(cure(), ::testing::HasSubstr("multiply its matrices in double"));
}

// A way is advised up to a third of the tolerance, by its law alone.
TEST(Advice, TheBoundIsThreeTimesTheLaw) {
  const DrawFacts facts = FactsFor(PlaneAway(3));
  const Advice clip = Of(Advise(facts, SomeCosts()), "clip");
  EXPECT_DOUBLE_EQ(
      clip.predicted,
      LawOf(facts.cuts.front(), WayOf(WayKind::kClip), runtime::MatrixOrder::kOneMatrix).in_image);
  EXPECT_DOUBLE_EQ(clip.bound, 3 * clip.predicted);
  EXPECT_TRUE(Of(Advise(facts, SomeCosts(), 3.01 * clip.predicted), "clip").meets);
  EXPECT_FALSE(Of(Advise(facts, SomeCosts(), 2.99 * clip.predicted), "clip").meets);
}

// The processor's cut is a line of vertices, which are off by their rounding and not by the plane's
// slant.
TEST(Advice, TheProcessorsCutIsOffByItsVerticesAlone) {
  const auto predicted = [](const Config& config, const char* way, double height = 1080) {
    DrawFacts facts = FactsFor(config);
    facts.image_height = height;
    return Of(Advise(facts, SomeCosts()), way).predicted;
  };
  const Config config = PlaneAway(3);
  Config far = config;
  far.mesh_offset = 1e4;
  EXPECT_DOUBLE_EQ(predicted(config, "cpu", 2160), 2 * predicted(config, "cpu"));
  EXPECT_GT(predicted(far, "cpu"), 100 * predicted(config, "cpu"));
  const auto setup = Prepare(config);
  const auto law = [&](WayKind way, double sine) {
    return LawOf(setup, WayOf(way), runtime::MatrixOrder::kOneMatrix, kImageHeight, sine)
        .along_surface;
  };
  EXPECT_GT(law(WayKind::kObject, 0.01), 10 * law(WayKind::kObject, 1));
  EXPECT_EQ(law(WayKind::kCpu, 0.01), law(WayKind::kCpu, 1));
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
  // An object that is not drawn does not count: below the water, or beside the image.
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
  scene.image_height = 700;
  const Camera& camera = scene.cameras.front().camera;
  const SceneObject& object = scene.objects[0];
  // The eye is 5 below the water, 40 before the wall, and nowhere from a plane without a normal;
  // the last plane does not cut the object.
  scene.planes.push_back({"wall", {0, 0, 1, -40}});
  scene.planes.push_back({"none", {0, 0, 0, 1}});
  scene.planes.push_back({"beyond", {0, 0, -1, 400}});
  const DrawFacts water = FactsOf(object, camera, scene, 0b0001),
                  all = FactsOf(object, camera, scene, 0b1111);
  EXPECT_EQ(water.planes, 1);
  ASSERT_EQ(water.cuts.size(), 1u);
  EXPECT_NEAR(std::abs(water.cuts[0].view_plane.w), 5, 1e-9);
  EXPECT_EQ(all.planes, 4);
  ASSERT_EQ(all.cuts.size(), 2u);
  EXPECT_NEAR(std::abs(all.cuts[0].view_plane.w), 5, 1e-9);
  EXPECT_NEAR(std::abs(all.cuts[1].view_plane.w), 40, 1e-9);
  EXPECT_EQ(all.image_height, 700);
  // The wall removes the part of the water before it.
  for (const Vector& corner : all.cuts[0].cut) EXPECT_GT(corner.z, 40 - 1e-4);
  // The cuts are inside the cube.
  for (const auto& cut : all.cuts) {
    for (const Vector& corner : cut.cut) EXPECT_NEAR(corner.z, 40, 1.001);
  }
  // A plane whose cut is not seen displaces nothing.
  const DrawFacts none = FactsOf(object, camera, scene, 0b1000);
  EXPECT_TRUE(none.cuts.empty());
  EXPECT_EQ(Of(Advise(none, SomeCosts()), "cpu").predicted, 0);
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
