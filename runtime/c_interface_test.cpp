// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/box_planner.h"
#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/clipc_runtime.h"
#include "runtime/plane_space.h"
#include "runtime/test_cameras.h"

extern "C" clipc_error BindFromC(const void* bytes, size_t size, const float* constants,
                                 size_t constants_size, float* device, char* message);

namespace clipc::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// One plane in b1, register 2.
constexpr unsigned char kTable[] = {0x35, 0x28, 0, 0, 5, 0, 0, 0, 1, 0,
                                    0,    0,    1, 0, 2, 0, 1, 0, 0, 0};

TEST(CInterface, BindsFromC) {
  const float constants[12] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4};
  float device[25] = {};
  char message[CLIPC_MESSAGE_SIZE] = "old";
  ASSERT_EQ(BindFromC(kTable, sizeof kTable, constants, sizeof constants, device, message),
            CLIPC_OK)
      << message;
  EXPECT_STREQ(message, "");
  EXPECT_THAT(std::vector<float>(device, device + 4), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(device[24], 1);
}

TEST(CInterface, ErrorsAreValuesWithMessages) {
  const float constants[12] = {};
  float device[25] = {};
  char message[CLIPC_MESSAGE_SIZE];
  EXPECT_EQ(BindFromC("rubbish", 7, constants, sizeof constants, device, message),
            CLIPC_DAMAGED_TABLE);
  EXPECT_THAT(message, HasSubstr("no JSON"));
  EXPECT_EQ(BindFromC(kTable, sizeof kTable, constants, 40, device, message), CLIPC_SHORT_BUFFER);
  EXPECT_THAT(message, HasSubstr("which has 40"));
  EXPECT_EQ(BindFromC(kTable, sizeof kTable, constants, 40, device, nullptr), CLIPC_SHORT_BUFFER);
  EXPECT_EQ(clipc_hresult(CLIPC_SHORT_BUFFER), kD3dErrInvalidCall);
}

TEST(CInterface, NullPointersAreErrors) {
  clipc_table* table = nullptr;
  clipc_binder* binder = nullptr;
  const clipc_device device = {};
  EXPECT_EQ(clipc_table_read(nullptr, 4, &table, nullptr), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_table_read(kTable, sizeof kTable, nullptr, nullptr), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_binder_create(&device, 6, &binder), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_binder_create(nullptr, 6, &binder), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_binder_bind(nullptr, nullptr, nullptr, 0, ~0u, nullptr), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_binder_bind_none(nullptr, nullptr), CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_clip_plane(nullptr, nullptr, nullptr, nullptr, nullptr), CLIPC_INVALID_ARGUMENT);
  clipc_table_free(nullptr);
  clipc_binder_free(nullptr);
  clipc_binder_invalidate(nullptr);
}

TEST(CInterface, TablesSayWhatTheyHold) {
  clipc_table* table = nullptr;
  ASSERT_EQ(clipc_table_read(kTable, sizeof kTable, &table, nullptr), CLIPC_OK);
  EXPECT_EQ(clipc_table_plane_count(table), 1u);
  EXPECT_EQ(clipc_table_enable_mask(table), 1u);
  EXPECT_EQ(clipc_table_plane_space(table), CLIPC_SPACE_CLIP);
  clipc_table_free(table);
}

TEST(CInterface, PlanesAreThoseOfTheCppInterface) {
  const Camera camera = PerspectiveCamera(0.1, 100);
  Random random(1);
  const Matrix rigid = random.Rigid(5);
  float projection[16], view[16], got[4];
  for (int i = 0; i < 16; ++i) {
    projection[i] = static_cast<float>(camera.projection.m[i / 4][i % 4]);
    view[i] = static_cast<float>(rigid.m[i / 4][i % 4]);
  }
  const Matrix p = RowVectorMatrix(projection), v = RowVectorMatrix(view);
  const float plane[4] = {0.6f, 0, 0.8f, -3};
  const Plane c = {static_cast<double>(plane[0]), static_cast<double>(plane[1]),
                   static_cast<double>(plane[2]), static_cast<double>(plane[3])};
  const auto is = [&](const Result<PlaneConstant>& expected) {
    return std::memcmp(got, &expected.value.constant, sizeof got) == 0;
  };
  ASSERT_EQ(clipc_clip_plane(plane, nullptr, projection, got, nullptr), CLIPC_OK);
  EXPECT_TRUE(is(ClipPlaneFromView(c, p)));
  ASSERT_EQ(clipc_clip_plane(plane, view, projection, got, nullptr), CLIPC_OK);
  EXPECT_TRUE(is(ClipPlaneFromWorld(c, v, p)));
  ASSERT_EQ(clipc_xyw1_plane(plane, projection, got, nullptr), CLIPC_OK);
  EXPECT_TRUE(is(Xyw1PlaneFromView(c, p)));
  ASSERT_EQ(clipc_object_plane(plane, view, got, nullptr), CLIPC_OK);
  EXPECT_TRUE(is(ObjectPlaneFromWorld(c, v)));
  EXPECT_EQ(clipc_edge_error(CLIPC_SPACE_CLIP, plane, projection, 720),
            PredictEdgeError(PlaneSpace::kClip, c, p, 720).value);
  EXPECT_LT(clipc_edge_error(CLIPC_SPACE_OBJECT, plane, projection, 720),
            clipc_edge_error(CLIPC_SPACE_CLIP, plane, projection, 720));
  EXPECT_LT(clipc_edge_error(CLIPC_SPACE_CLIP, nullptr, projection, 720), 0);
  projection[14] = 0;
  EXPECT_EQ(clipc_clip_plane(plane, nullptr, projection, got, nullptr), CLIPC_SINGULAR);
  EXPECT_LT(clipc_edge_error(CLIPC_SPACE_CLIP, plane, projection, 720), 0);
}

TEST(CInterface, ClipStatusAndPlans) {
  const float positions[8] = {0, 0, 0.5f, 1, 2, 0, 0.5f, 1};
  float planes[24] = {1, 0, 0, -1};
  clipc_clip_status status = {0, 0xFFFFFFFFu};
  clipc_update_clip_status(&status, positions, 2, planes, 1, 1);
  EXPECT_EQ(status.clip_union, std::uint32_t{kClipRight} | kClipPlane0);
  EXPECT_EQ(status.clip_intersection, 0u);
  clipc_update_clip_status(&status, positions, 2, nullptr, 1, 0);
  EXPECT_EQ(status.clip_union, 0u);

  const float low[3] = {0, 2, -5}, high[3] = {3, 3, -4}, other[3] = {};
  const float* const bounds[6] = {low, other, other, high, other, other};
  std::uint8_t plans[3];
  clipc_plan_boxes(bounds, 3, planes, 1, plans);
  EXPECT_THAT(plans, ElementsAre(1, 0, CLIPC_CULLED));
}

}  // namespace
}  // namespace clipc::runtime
