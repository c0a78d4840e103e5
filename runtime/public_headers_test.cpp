// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Compiled as C++17: what an application may be written in.
#include <type_traits>

#include <gtest/gtest.h>

#include "runtime/box_planner.h"
#include "runtime/clip_device.h"
#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/clipc_runtime.h"
#include "runtime/hidden_planes.h"
#include "runtime/level9_binder.h"
#include "runtime/matrix.h"
#include "runtime/mirror.h"
#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "runtime/projection_shape.h"
#include "runtime/shader_variant.h"
#include "runtime/status.h"
#include "runtime/table.h"

static_assert(__cplusplus == 201703L, "this file is compiled as C++17");

namespace clipc::runtime {
namespace {

TEST(PublicHeaders, AreCpp17) {
  static_assert(sizeof(Float4) == 16, "a constant register");
  static_assert(std::is_trivially_copyable_v<Status>, "errors own nothing");
  static_assert(VariantOf(5).plane_count == 2);
  EXPECT_TRUE(ClipPlaneFromView({0, 0, 1, -1}, Matrix{}).ok());
}

// Whatever is called, nothing is thrown across it.
TEST(PublicHeaders, ThrowNothing) {
  static_assert(noexcept(ReadTable(nullptr, 0)));
  static_assert(noexcept(ClipPlaneFromWorld({}, {}, {})));
  static_assert(noexcept(ClipPlaneFromObject({}, {}, PreparedCamera())));
  static_assert(noexcept(WithoutHiddenPlanes({}, nullptr, 0, 0)));
  static_assert(noexcept(PlaneConstantFor(PlaneSpace::kClip, {}, KnownIn::kWorld, {})));
  static_assert(
      noexcept(std::declval<Level9Binder&>().Bind(std::declval<const Table&>(), nullptr, 0)));
  static_assert(noexcept(ShearNearPlane({}, {}, {}, NearPlaneScale::kAsGiven)));
  static_assert(noexcept(PlanBoxes(std::declval<const BoxArrays&>(), nullptr, 0, nullptr)));
  static_assert(noexcept(UpdateClipStatus(std::declval<ClipStatus&>(), nullptr, 0, {}, true)));
}

}  // namespace
}  // namespace clipc::runtime
