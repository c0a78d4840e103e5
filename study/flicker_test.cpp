// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The cuts that flicker while the camera pans, and those that do not.
#include "study/flicker.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "runtime/plane_space.h"
#include "study/sweeps.h"

namespace clipc::study {
namespace {

// A sixth of a degree a frame: ten degrees a second.
constexpr double kStep = 0.003;

Flicker Of(const Config& config, const Method& method) {
  const Flicker flicker = MeasureFlicker(config, {method}, 12, kStep, 300, 5).front();
  EXPECT_TRUE(flicker.applies) << method.name;
  return flicker;
}

double Law(const Config& config, PlaneSpace space) {
  return PredictEdgeError(space, config.view_plane, config.camera.Projection(), kImageHeight).value;
}

// Each frame's constant and matrix round in a way of their own, so that the cut moves by as much as
// a frame is off.
TEST(Flicker, IsTheDisplacementOfAFrameForWhatFollowsTheCamera) {
  for (const double ratio : {10.0, 100.0, 400.0, 1000.0}) {
    const Config config = ObliqueAt(0.1 * ratio / 0.77, 0.1, 1e6);
    for (const auto& [method, space] :
         {std::pair{ClipSpace(), PlaneSpace::kClip}, std::pair{Xyw1Space(), PlaneSpace::kXyw1}}) {
      const double share = Of(config, method).p99 / Law(config, space);
      EXPECT_GT(share, 0.2) << method.name << ' ' << ratio;
      EXPECT_LT(share, 3) << method.name << ' ' << ratio;
    }
    EXPECT_LT(Of(config, NearPlane()).p99, 0.002);
  }
  EXPECT_GT(Of(ObliqueAt(400 * 0.1 / 0.77, 0.1, 1e6), ClipSpace()).p99, 0.2);
}

// Neither the object's constant nor its vertices know of the camera.
TEST(Flicker, IsExactlyNoneInObjectSpace) {
  for (const double ratio : {10.0, 1000.0, 1e5}) {
    const Config config = ObliqueAt(0.1 * ratio / 0.77, 0.1, 1e6);
    EXPECT_EQ(Of(config, ObjectSpace()).largest, 0) << ratio;
    EXPECT_EQ(Of(config, WorldSpace()).largest, 0) << ratio;
    EXPECT_EQ(Of(config, CpuDouble()).largest, 0) << ratio;
    // Mutation: a view-space vertex does know.
    EXPECT_GT(Of(config, ViewSpace()).largest, 0) << ratio;
  }
}

TEST(Flicker, ReversedDepthCuresIt) {
  Config config = ObliqueAt(100, 0.1, 1e6);
  config.camera.reversed = true;
  EXPECT_LT(Of(config, ClipSpace()).p99, 0.005);
}

// A method whose cut turns with the camera up to that angle; beyond it, the method does not apply.
Method Drifting(double last_yaw) {
  return {"drifting", [last_yaw](const Setup& setup) -> std::optional<Distance> {
            const double yaw = setup.config.camera.yaw;
            if (yaw > last_yaw) return std::nullopt;
            const Plane p = setup.object_plane;
            return [p, yaw](const Vec4<float>& vertex) {
              const Vec4<double> v = ConvertTo<double>(vertex);
              return p.x * v[0] + p.y * v[1] + p.z * v[2] + p.w + 0.1 * yaw;
            };
          }};
}

// The measurement itself: such a drift is as large in each frame.
TEST(Flicker, IsMeasuredFromFrameToFrame) {
  const Config config = ObliqueAt(10, 0.1, 1e6);
  const auto flicker = [&](int frames, double last_yaw) {
    return MeasureFlicker(config, {Drifting(last_yaw)}, frames, kStep, 300, 5).front();
  };
  const double yaw = Prepare(config).config.camera.yaw;
  EXPECT_GT(flicker(2, INFINITY).p99, 0.01);
  EXPECT_LT(flicker(12, INFINITY).p99 / flicker(2, INFINITY).p99, 2);
  EXPECT_TRUE(flicker(4, yaw + 3.5 * kStep).applies);
  EXPECT_FALSE(flicker(5, yaw + 3.5 * kStep).applies);
  EXPECT_LT(Of(config, ViewSpace()).p99, 0.01);
}

}  // namespace
}  // namespace clipc::study
