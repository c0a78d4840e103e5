// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Drawn with no more planes than the planner says, by the shader variants, a scene is the same to
// the pixel as with all of its planes.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner.shader.h"
#include "runtime/clip_plane.h"
#include "runtime/gl/clip_switches.h"
#include "runtime/hidden_planes.h"
#include "runtime/shader_variant.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/random.h"
#include "tools/harness/scenes.h"

namespace clipc::scenes {
namespace {

using harness::Camera;
using harness::Floats;
using harness::Image;
using harness::Mesh;
using harness::MeshBuffers;
using harness::Program;
using harness::Random;
using harness::Scene;
using harness::Vector;
using runtime::BoxPlan;
using runtime::Float4;
using runtime::Matrix;
using runtime::Multiply;
using runtime::Plane;
using runtime::ShaderVariant;

const char kFragment[] =
    "#version 130\n"
    "in vec4 vs_COLOR0;\n"
    "out vec4 fragment;\n"
    "void main() { fragment = vec4(vs_COLOR0.rgb, 1.0); }\n";

// Object i of a scene is drawn as a teapot, a torus or a cube, in turn.
constexpr std::uint32_t kShapes = 3, kCube = 2;

// The cut-away scene inside of a box of six planes.
Scene BoxScene() {
  Scene scene = harness::BuiltInScenes()[2];
  scene.name = "box";
  scene.planes.clear();
  for (const double side : {-1.0, 1.0}) {
    scene.planes.push_back({side, 0, 0, 2.5});
    scene.planes.push_back({0, side, 0, 2.5});
    scene.planes.push_back({0, 0, side, 2.5});
  }
  return scene;
}

// The plane of a cube's face, kept to one side or the other.
Plane FaceOf(Random& random, const Matrix& world) {
  const double(&row)[4] = world.m[random.Below(3)];
  const double side = random.Below(2) == 0 ? 1 : -1, kept = random.Below(2) == 0 ? 1 : -1;
  const Vector half{row[0], row[1], row[2]};
  const Vector point = Vector{world.m[3][0], world.m[3][1], world.m[3][2]} + side * half;
  const Vector normal = kept * Unit(half);
  return {normal.x, normal.y, normal.z, -Dot(normal, point)};
}

// Some objects and one to six planes, of which some lie exactly in a face of a cube; perspective or
// orthographic.
Scene RandomScene(Random& random) {
  Scene scene;
  const std::uint32_t objects = 4 + random.Below(9), planes = 1 + random.Below(6);
  for (std::uint32_t i = 0; i < objects; ++i) {
    const double yaw = random.Between(-3, 3), pitch = random.Between(-1.5, 1.5),
                 roll = random.Between(-3, 3), size = random.Between(0.3, 1.2);
    Matrix& world = scene.objects.emplace_back().world;
    world = Multiply(harness::Scaling(size), harness::Rotation(yaw, pitch, roll));
    for (int c = 0; c < 3; ++c) world.m[3][c] = random.Between(-4, 4);
  }
  for (std::uint32_t i = 0; i < planes; ++i) {
    if (random.Below(3) == 0) {
      const std::size_t cube = kCube + kShapes * random.Below(objects / kShapes);
      scene.planes.push_back(FaceOf(random, scene.objects.at(cube).world));
    } else {
      const Vector normal = random.Direction();
      // Each plane keeps most of the space, or six would leave nothing.
      scene.planes.push_back({normal.x, normal.y, normal.z, random.Between(-1, 5)});
    }
  }
  Camera camera;
  camera.yaw = random.Between(-3, 3), camera.pitch = random.Between(-1.5, 1.5);
  const Matrix axes = harness::Rotation(camera.yaw, camera.pitch);
  const double distance = random.Between(7, 16);
  for (int c = 0; c < 3; ++c) camera.eye[c] = -distance * axes.m[2][c];
  camera.near = random.Magnitude(0.01, 1), camera.far = 100, camera.aspect = 1;
  camera.fov = random.Between(23, 80);
  camera.orthographic = random.Below(4) == 0, camera.half_height = 5;
  scene.camera = camera;
  return scene;
}

// The planes that each object is drawn with.
enum class Plan {
  kAll,
  kPlanned,
  kNotHidden,  // without the planes whose cut others hide
  kOneTooFew,  // one of the planned planes is left out: a mistake that must show
};

struct Drawing {
  Image image;
  int planes = 0;  // handed to the device, over all draws
};

class Planner : public ::testing::Test {
 protected:
  Planner() {
    const Mesh meshes[kShapes] = {harness::Teapot(4), harness::Torus(8, 1, 0.4), harness::Cube()};
    for (std::size_t i = 0; i < kShapes; ++i) {
      buffers_[i] = std::make_unique<MeshBuffers>(meshes[i]);
      const auto low = meshes[i].low(), high = meshes[i].high();
      std::copy(low.begin(), low.end(), boxes_[i].low);
      std::copy(high.begin(), high.end(), boxes_[i].high);
    }
    for (const char* vertex : planner_vert) {
      programs_.push_back(std::make_unique<Program>(vertex, kFragment));
    }
  }

  Drawing Draw(const Scene& scene, Plan plan, int width, int height) const {
    const harness::Canvas canvas(width, height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    runtime::gl::ClipSwitches switches(gl_);
    Drawing drawing;
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      DrawObject(scene, i, plan, switches, drawing);
    drawing.image = canvas.Read();
    return drawing;
  }

  static int Differing(const Image& one, const Image& other) {
    int count = 0;
    for (std::size_t i = 0; i < one.rgba.size(); i += 4) {
      count += !std::equal(&one.rgba[i], &one.rgba[i] + 4, &other.rgba[i]);
    }
    return count;
  }

  // Expects that no pixel differs, and that `planes` planes are handed to the device. The
  // boxes are those of teapots, tori and cubes; docs/runtime.md has the scenes' own.
  void ExpectSavings(const Scene& scene, int planes) const {
    const Drawing all = Draw(scene, Plan::kAll, 320, 180),
                  planned = Draw(scene, Plan::kPlanned, 320, 180);
    EXPECT_EQ(Differing(all.image, planned.image), 0);
    const double ratio = all.planes / static_cast<double>(planned.planes);
    std::printf("%s: %d planes, %d where planned: %.1f times fewer\n", scene.name.c_str(),
                all.planes, planned.planes, ratio);
    EXPECT_EQ(planned.planes, planes);
    // The planes cut something, or leaving them out would prove nothing.
    EXPECT_GT(Differing(all.image, Draw(scene, Plan::kOneTooFew, 320, 180).image), 0);
    if (const char* folder = std::getenv("CLIPC_IMAGES"); folder != nullptr) {
      WritePng(folder + ("/" + scene.name) + ".png", planned.image);
    }
  }

 private:
  void DrawObject(const Scene& scene, std::size_t index, Plan how,
                  runtime::gl::ClipSwitches& switches, Drawing& drawing) const {
    const Camera& camera = scene.camera;
    const Matrix view = camera.View(), projection = camera.Projection();
    const std::size_t shape = index % kShapes;
    const auto floats = Floats(Multiply(Multiply(scene.objects[index].world, view), projection));
    float elements[16];
    std::copy(floats.begin(), floats.end(), elements);
    const Matrix matrix = runtime::RowVectorMatrix(elements);  // rounded, as the shader gets it

    Float4 planes[6];
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
      const auto plane = runtime::ClipPlaneFromWorld(scene.planes[i], view, projection);
      ASSERT_TRUE(plane.ok()) << plane.status.message();
      planes[i] = plane.value.constant;
    }
    auto plan = static_cast<BoxPlan>((1U << scene.planes.size()) - 1);
    if (how != Plan::kAll)
      plan = runtime::PlanTransformedBox(boxes_[shape], &matrix, 1, planes, scene.planes.size());
    if (how == Plan::kNotHidden) {
      Float4 in_object[6];
      for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        in_object[i] = runtime::ObjectPlaneFromWorld(scene.planes[i], scene.objects[index].world)
                           .value.constant;
      }
      plan = runtime::WithoutHiddenPlanes(boxes_[shape], in_object, scene.planes.size(), plan);
    }
    if (plan == runtime::kCulled) return;
    if (how == Plan::kOneTooFew) plan &= static_cast<BoxPlan>(plan - 1);

    const ShaderVariant variant = runtime::VariantOf(plan);
    Float4 constants[6];
    CompactPlanes(variant, planes, constants);
    const Program& program = *programs_[variant.plane_count];
    program.Use();
    ASSERT_TRUE(switches.Bind(variant).ok());
    drawing.planes += variant.plane_count;
    program.Set("world_view_projection", floats);
    const auto shade = [&](int k) {
      return 0.3F + 0.7F * static_cast<float>(index * (2 * k + 37) % 101) / 100;
    };
    program.Set("color", shade(0), shade(1), shade(2), 1);
    for (int i = 0; i < variant.plane_count; ++i) {
      program.Set("planes[" + std::to_string(i) + "]", constants[i].x, constants[i].y,
                  constants[i].z, constants[i].w);
    }
    buffers_[shape]->Draw();
  }

  const harness::OpenGl context_{harness::Api::kCompatibility};
  const runtime::gl::Functions gl_ = runtime::gl::LoadFunctions(harness::OpenGl::Load).value;
  std::array<std::unique_ptr<MeshBuffers>, kShapes> buffers_;
  std::array<runtime::Box, kShapes> boxes_;
  std::vector<std::unique_ptr<Program>> programs_;  // by number of planes
};

TEST_F(Planner, Water) { ExpectSavings(harness::BuiltInScenes()[0], 173); }
TEST_F(Planner, Portal) { ExpectSavings(harness::BuiltInScenes()[1], 54); }
TEST_F(Planner, CutAway) { ExpectSavings(harness::BuiltInScenes()[2], 78); }
TEST_F(Planner, Cascade) { ExpectSavings(harness::BuiltInScenes()[3], 11); }
TEST_F(Planner, Box) { ExpectSavings(BoxScene(), 104); }

TEST_F(Planner, AThousandRandomScenes) {
  Random random(4);
  int all_planes = 0, planned_planes = 0, mistakes_seen = 0, not_hidden = 0, moved = 0;
  for (int i = 0; i < 1000; ++i) {
    const Scene scene = RandomScene(random);
    const Drawing all = Draw(scene, Plan::kAll, 64, 64),
                  planned = Draw(scene, Plan::kPlanned, 64, 64);
    ASSERT_EQ(Differing(all.image, planned.image), 0) << "scene " << i;
    const Drawing least = Draw(scene, Plan::kNotHidden, 64, 64);
    not_hidden += least.planes;
    moved += Differing(all.image, least.image);
    all_planes += all.planes, planned_planes += planned.planes;
    mistakes_seen += Differing(all.image, Draw(scene, Plan::kOneTooFew, 64, 64).image) != 0;
  }
  std::printf("random: %d planes, %d where planned; a plane too few shows in %d scenes\n",
              all_planes, planned_planes, mistakes_seen);
  std::printf("%d planes that are not hidden; %d pixels differ\n", not_hidden, moved);
  EXPECT_LT(planned_planes, all_planes);
  EXPECT_LT(not_hidden, planned_planes);
  EXPECT_LE(moved, 4) << "of the image's four million";
  EXPECT_GT(mistakes_seen, 500);
}

}  // namespace
}  // namespace clipc::scenes
