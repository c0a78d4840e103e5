// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The statements of the source documents about pixels, drawn. The tests of those about numbers and
// calls are in runtime/seed*_test.cpp.
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/gl/clip_plane_device.h"
#include "tools/harness/camera.h"
#include "tools/harness/mesh.h"
#include "tools/harness/offscreen.h"
#include "tools/scenes/comparison.h"
#include "tools/scenes/gl_drawing.h"

namespace clipc::scenes {
namespace {

using runtime::Plane;

constexpr Lowering kWaysOfManyPlanes[] = {Lowering::kClipDistance, Lowering::kLevel9,
                                          Lowering::kDiscard};

// A scene of one mesh, with the eye above it and to its left.
Scene SceneOf(const harness::Mesh& mesh, std::vector<Plane> planes) {
  Scene scene;
  scene.objects.emplace_back();
  for (const std::uint32_t index : mesh.indices) {
    const float* p = mesh.vertices[index].position;
    scene.objects[0].vertices.push_back({{p[0], p[1], p[2]}, 0xFFFFFFFF});
  }
  scene.view = harness::LookAt({-1.9, 2.6, -5.2}, {0, 0.1, 0});
  scene.projection = harness::Perspective(0.62, 1, 1, 20);
  scene.planes = std::move(planes);
  return scene;
}

Scene TeapotScene(std::vector<Plane> planes) {
  return SceneOf(harness::Teapot(16), std::move(planes));
}

int WhitePixels(const harness::Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i] == 0xFF;
  return count;
}

class SeedDrawing : public ::testing::Test {
 protected:
  // Expects that the scene, drawn in every way, shows the points that `kept` names.
  static void ExpectKept(const Scene& scene, Kept kept) {
    const harness::Image expected = DrawKept(scene, kept), cuts = DrawCuts(scene);
    for (const Lowering way : kWaysOfManyPlanes) {
      const Comparison comparison = Compare(expected.rgba, DrawScene(way, scene).rgba, cuts.rgba);
      EXPECT_TRUE(Agree(comparison, CutError(scene)))
          << NameOf(way) << ": " << comparison.differ_at_cut << " pixels differ at cuts, elsewhere "
          << comparison.differ_elsewhere;
    }
    EXPECT_LT(WhitePixels(expected), WhitePixels(DrawKept(TeapotScene({}), Kept::kByAll)))
        << "something is clipped";
  }

  const harness::OpenGl context_{harness::Api::kCompatibility};
};

using Seed000Background = SeedDrawing;
using Seed000SyntaxNote = SeedDrawing;
using Seed001Remarks = SeedDrawing;
using Seed003LeftTeapot = SeedDrawing;
using Seed003RightTeapot = SeedDrawing;
using Seed003TwoPlanes = SeedDrawing;

TEST_F(Seed000Background, NoPixelBehindAnyPlaneIsDrawn) {
  ExpectKept(TeapotScene({{0.6, 0.8, 0, 0.1}, {0, -0.6, 0.8, 0.3}, {-0.8, 0, -0.6, 0.7}}),
             Kept::kByAll);
}

TEST_F(Seed000SyntaxNote, PlanesOfZerosChangeNoPixel) {
  const Scene scene = TeapotScene({{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}});
  const harness::Image expected = DrawKept(TeapotScene({}), Kept::kByAll);
  for (const Lowering way : kWaysOfManyPlanes)
    EXPECT_EQ(DrawScene(way, scene).rgba, expected.rgba) << NameOf(way);
}

// A plane that a surface lies in keeps all of it, from either side.
TEST_F(Seed001Remarks, PointsOnThePlaneAreDrawn) {
  const harness::Mesh ground = harness::Ground(1, 1);
  const int all = WhitePixels(DrawKept(SceneOf(ground, {}), Kept::kByAll));
  EXPECT_GT(all, 1000);
  for (const double side : {1.0, -1.0}) {
    Scene scene = SceneOf(ground, {{0, side, 0, 0}});
    // The eye looks straight ahead, so that positions and distances are exact.
    scene.view = {};
    scene.view.m[3][2] = 2;
    scene.objects[0].world = {{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};
    scene.planes[0] = {0, 0, side, 0};
    const int expected = WhitePixels(DrawKept(scene, Kept::kByAll));
    EXPECT_GT(expected, 1000);
    for (const Lowering way : kWaysOfManyPlanes)
      EXPECT_EQ(WhitePixels(DrawScene(way, scene)), expected) << NameOf(way);
  }
}

TEST_F(Seed001Remarks, APlaneThatIsSetAndNotEnabledClipsNothing) {
  // Clip plane 0, which is the shader's third constant, keeps nothing; kMask leaves it out.
  const Scene scene = TeapotScene({{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, -1}});
  EXPECT_EQ(WhitePixels(DrawScene(Lowering::kLevel9, scene)), 0) << "enabled";
  const int expected = WhitePixels(DrawScene(Lowering::kLevel9, scene, Mistake::kMask));
  EXPECT_GT(expected, 1000) << "neither set nor enabled";
  runtime::gl::ClipPlaneDevice device(runtime::gl::LoadFunctions(harness::OpenGl::Load).value);
  const float nothing[4] = {0, 0, 0, -1};
  ASSERT_TRUE(device.SetClipPlane(0, nothing));
  EXPECT_EQ(WhitePixels(DrawScene(Lowering::kLevel9, scene, Mistake::kMask)), expected)
      << "set and not enabled";
}

TEST_F(Seed003LeftTeapot, ShowsNegativeX) {
  ExpectKept(TeapotScene({{-1, 0, 0, 0}}), Kept::kByAll);
}

TEST_F(Seed003RightTeapot, IsDrawnCutDiagonally) {
  ExpectKept(TeapotScene({{1, 0, 1, 0}}), Kept::kByAll);
}

// The document says that the union is drawn; its own image and every device show the
// intersection.
TEST_F(Seed003TwoPlanes, TheDrawnAreaIsTheIntersection) {
  const Scene scene = TeapotScene({{1, 0, 0, 0}, {0, -1, 0, 0}});
  ExpectKept(scene, Kept::kByAll);
  const int both = WhitePixels(DrawKept(scene, Kept::kByAll)),
            either = WhitePixels(DrawKept(scene, Kept::kByAny));
  EXPECT_LT(2 * both, either);
  const auto to_union = Compare(DrawKept(scene, Kept::kByAny).rgba,
                                DrawScene(Lowering::kLevel9, scene).rgba, DrawCuts(scene).rgba);
  EXPECT_GT(to_union.differ_elsewhere, 1000);
}

}  // namespace
}  // namespace clipc::scenes
