// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Drawn with no more planes than the planner says, by the shader variants, a scene is the same to
// the pixel as with all.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "examples/shared/mesh.h"
#include "examples/shared/offscreen.h"
#include "examples/shared/transform.h"
#include "planner.shader.h"
#include "runtime/clip_plane.h"
#include "runtime/gl/clip_switches.h"
#include "runtime/shader_variant.h"
#include "tools/scenes/crowd.h"

namespace clipc::scenes {
namespace {

using examples::Floats;
using examples::Mesh;
using examples::MeshBuffers;
using examples::Picture;
using examples::Program;
using runtime::BoxPlan;
using runtime::Float4;
using runtime::Matrix;
using runtime::Multiply;
using runtime::ShaderVariant;

const char kFragment[] =
    "#version 130\n"
    "in vec4 vs_COLOR0;\n"
    "out vec4 fragment;\n"
    "void main() { fragment = vec4(vs_COLOR0.rgb, 1.0); }\n";

// Which planes to draw each object with.
enum class Plan {
  kAll,
  kPlanned,
  kOneTooFew,  // of what is planned, one is left out: a mistake that must show
};

struct Drawing {
  Picture picture;
  int planes = 0;  // handed to the device, over all draws
};

class Planner : public ::testing::Test {
 protected:
  Planner() {
    const Mesh meshes[kShapes] = {examples::Teapot(4), examples::Torus(8, 1, 0.4),
                                  examples::Cube()};
    for (int i = 0; i < kShapes; ++i) {
      buffers_[i] = std::make_unique<MeshBuffers>(meshes[i]);
      const auto low = meshes[i].low(), high = meshes[i].high();
      std::copy(low.begin(), low.end(), boxes_[i].low);
      std::copy(high.begin(), high.end(), boxes_[i].high);
    }
    for (const char* vertex : planner_vert) {
      programs_.push_back(std::make_unique<Program>(vertex, kFragment));
    }
  }

  Drawing Draw(const Crowd& crowd, Plan plan, int width, int height) const {
    const examples::Canvas canvas(width, height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    runtime::gl::ClipSwitches switches(gl_);
    Drawing drawing;
    for (std::size_t i = 0; i < crowd.objects.size(); ++i)
      DrawObject(crowd, i, plan, switches, drawing);
    drawing.picture = canvas.Read();
    return drawing;
  }

  static int Differing(const Picture& one, const Picture& other) {
    int count = 0;
    for (std::size_t i = 0; i < one.rgba.size(); i += 4) {
      count += !std::equal(&one.rgba[i], &one.rgba[i] + 4, &other.rgba[i]);
    }
    return count;
  }

  // No pixel differs, and so many times fewer planes are handed over.
  void ExpectSavings(const Crowd& crowd, double at_least) const {
    const Drawing all = Draw(crowd, Plan::kAll, 320, 180),
                  planned = Draw(crowd, Plan::kPlanned, 320, 180);
    EXPECT_EQ(Differing(all.picture, planned.picture), 0);
    const double ratio = all.planes / static_cast<double>(planned.planes);
    std::printf("%s: %d planes, %d where planned: %.1f times fewer\n", crowd.name.c_str(),
                all.planes, planned.planes, ratio);
    EXPECT_GE(ratio, at_least);
    // The planes cut something, or leaving them out would prove nothing.
    EXPECT_GT(Differing(all.picture, Draw(crowd, Plan::kOneTooFew, 320, 180).picture), 0);
    if (const char* folder = std::getenv("CLIPC_PICTURES"); folder != nullptr) {
      WritePng(folder + ("/" + crowd.name) + ".png", planned.picture);
    }
  }

 private:
  void DrawObject(const Crowd& crowd, std::size_t index, Plan how,
                  runtime::gl::ClipSwitches& switches, Drawing& drawing) const {
    const CrowdObject& object = crowd.objects[index];
    const auto shape = static_cast<std::size_t>(object.shape);
    const auto floats = Floats(Multiply(Multiply(object.world, crowd.view), crowd.projection));
    float elements[16];
    std::copy(floats.begin(), floats.end(), elements);
    const Matrix matrix = runtime::RowVectorMatrix(elements);  // what the shader gets, rounded

    Float4 planes[6];
    for (std::size_t i = 0; i < crowd.planes.size(); ++i) {
      const auto plane = runtime::ClipPlaneFromWorld(crowd.planes[i], crowd.view, crowd.projection);
      ASSERT_TRUE(plane.ok()) << plane.status.message();
      planes[i] = plane.value.constant;
    }
    auto plan = static_cast<BoxPlan>((1U << crowd.planes.size()) - 1);
    if (how != Plan::kAll)
      plan = runtime::PlanTransformedBox(boxes_[shape], &matrix, 1, planes, crowd.planes.size());
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
      const std::string name = "planes[" + std::to_string(i) + "]";
      program.Set(name.c_str(), constants[i].x, constants[i].y, constants[i].z, constants[i].w);
    }
    buffers_[shape]->Draw();
  }

  const examples::Context context_{examples::Profile::kCompatibility};
  const runtime::gl::Functions gl_ = runtime::gl::LoadFunctions(examples::Context::Load).value;
  std::array<std::unique_ptr<MeshBuffers>, kShapes> buffers_;
  std::array<runtime::Box, kShapes> boxes_;
  std::vector<std::unique_ptr<Program>> programs_;  // by number of planes
};

TEST_F(Planner, Water) { ExpectSavings(WaterCrowd(), 4); }
TEST_F(Planner, Portal) { ExpectSavings(PortalCrowd(), 30); }
TEST_F(Planner, Cutaway) { ExpectSavings(CutawayCrowd(), 30); }
TEST_F(Planner, Box) { ExpectSavings(BoxCrowd(), 30); }

TEST_F(Planner, AThousandRandomScenes) {
  std::mt19937 random(4);
  int all_planes = 0, planned_planes = 0, mistakes_seen = 0;
  for (int i = 0; i < 1000; ++i) {
    const Crowd crowd = RandomCrowd(random);
    const Drawing all = Draw(crowd, Plan::kAll, 64, 64),
                  planned = Draw(crowd, Plan::kPlanned, 64, 64);
    ASSERT_EQ(Differing(all.picture, planned.picture), 0) << "scene " << i;
    all_planes += all.planes, planned_planes += planned.planes;
    mistakes_seen += Differing(all.picture, Draw(crowd, Plan::kOneTooFew, 64, 64).picture) != 0;
  }
  std::printf("random: %d planes, %d where planned; a plane too few shows in %d scenes\n",
              all_planes, planned_planes, mistakes_seen);
  EXPECT_LT(planned_planes, all_planes);
  EXPECT_GT(mistakes_seen, 500);
}

}  // namespace
}  // namespace clipc::scenes
