// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/box_planner.h"
#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/clipc_runtime.h"
#include "runtime/mirror.h"
#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "runtime/test_cameras.h"

extern "C" clipc_error BindFromC(const void* bytes, size_t size, const float* constants,
                                 size_t constants_size, float* device, char* message);
extern "C" clipc_error FillFromC(const void* bytes, size_t size, const float* world_plane,
                                 const float* view, const float* projection, unsigned char* buffer,
                                 std::size_t buffer_size, char* message);
extern "C" clipc_shader_variant CompactFromC(std::uint8_t plan, const float* from, float* to);

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
  EXPECT_EQ(clipc_edge_error(CLIPC_SPACE_CLIP, nullptr, projection, 720), -1);
  EXPECT_EQ(clipc_edge_error(CLIPC_SPACE_CLIP, plane, nullptr, 720), -1);
  EXPECT_EQ(clipc_edge_error(CLIPC_SPACE_MAX, plane, projection, 720), -1);
  projection[14] = 0;
  EXPECT_EQ(clipc_clip_plane(plane, nullptr, projection, got, nullptr), CLIPC_SINGULAR);
  EXPECT_LT(clipc_edge_error(CLIPC_SPACE_CLIP, plane, projection, 720), 0);
}

Plane PlaneOf(const float (&plane)[4]) {
  return {static_cast<double>(plane[0]), static_cast<double>(plane[1]),
          static_cast<double>(plane[2]), static_cast<double>(plane[3])};
}

struct CMatrices {
  float view[16], projection[16];
  Matrix View() const { return RowVectorMatrix(view); }
  Matrix Projection() const { return RowVectorMatrix(projection); }
};

CMatrices MatricesOf(const Camera& camera) {
  CMatrices made;
  Random random(1);
  const Matrix rigid = random.Rigid(5);
  for (int i = 0; i < 16; ++i) {
    made.view[i] = static_cast<float>(rigid.m[i / 4][i % 4]);
    made.projection[i] = static_cast<float>(camera.projection.m[i / 4][i % 4]);
  }
  return made;
}

// Two planes in b3, the second at byte 32, of a shader that writes clip distances.
constexpr char kJson[] = R"({"schema": "clipc.clip-table", "version": 1, "entry": "main",
  "profile": "vs_5_0", "lowering": "clip-distance", "position_space": "xyw1",
  "plane_scale": "any", "enable_mask": 3, "planes": [
    {"index": 0, "text": "first", "constant": {"cbuffer": "Clip", "cbuffer_element": 0,
      "register": 3, "space": 0, "float4_register": 0, "byte_offset": 0,
      "glsl_block": "Clip", "glsl_member": "Clip.first"}},
    {"index": 1, "text": "second", "constant": {"cbuffer": "Clip", "cbuffer_element": 0,
      "register": 3, "space": 0, "float4_register": 2, "byte_offset": 32,
      "glsl_block": "Clip", "glsl_member": "Clip.second"}}]})";

TEST(CInterface, TablesSayWhereEachPlaneLies) {
  clipc_table* table = nullptr;
  char message[CLIPC_MESSAGE_SIZE];
  ASSERT_EQ(clipc_table_read(kJson, sizeof kJson - 1, &table, message), CLIPC_OK) << message;
  EXPECT_EQ(clipc_table_lowering(table), CLIPC_LOWERING_CLIP_DISTANCE);
  EXPECT_EQ(clipc_table_plane_space(table), CLIPC_SPACE_XYW1);
  clipc_plane_place place;
  ASSERT_EQ(clipc_table_get_plane(table, 1, &place, message), CLIPC_OK) << message;
  EXPECT_EQ(place.in_register, 1);
  EXPECT_EQ(place.register_number, 3u);
  EXPECT_EQ(place.byte_offset, 32u);
  EXPECT_STREQ(place.text, "second");
  EXPECT_STREQ(place.cbuffer, "Clip");
  EXPECT_STREQ(place.glsl_member, "Clip.second");
  EXPECT_EQ(clipc_table_get_plane(table, 2, &place, message), CLIPC_INVALID_ARGUMENT);
  EXPECT_STREQ(message, "plane 2 of a table with 2");
  clipc_table_free(table);
}

TEST(CInterface, ConstantsAreThoseOfTheCppInterface) {
  const CMatrices c = MatricesOf(PerspectiveCamera(0.1, 100));
  const float plane[4] = {0.6F, 0, 0.8F, -3};
  const Plane p = {static_cast<double>(plane[0]), 0, static_cast<double>(plane[2]), -3};
  unsigned char buffer[48] = {};
  char message[CLIPC_MESSAGE_SIZE];
  ASSERT_EQ(FillFromC(kJson, sizeof kJson - 1, plane, c.view, c.projection, buffer, sizeof buffer,
                      message),
            CLIPC_OK)
      << message;
  const auto expected =
      PlaneConstantFor(PlaneSpace::kXyw1, p, KnownIn::kWorld, {Matrix(), c.View(), c.Projection()});
  EXPECT_EQ(std::memcmp(buffer, &expected.value.plane.constant, 16), 0);
  EXPECT_EQ(std::memcmp(buffer + 32, &expected.value.plane.constant, 16), 0);

  // A plane far away, in clip space: a warning and its sentence.
  const float far_plane[4] = {1, 0, 0, -5000};
  const clipc_draw_matrices draw = {nullptr, nullptr, c.projection, CLIPC_ONE_MATRIX};
  clipc_space_constant made;
  ASSERT_EQ(clipc_plane_constant(CLIPC_SPACE_CLIP, far_plane, CLIPC_KNOWN_IN_VIEW, &draw, 1080, 0.5,
                                 &made, message),
            CLIPC_OK);
  EXPECT_EQ(made.warning, CLIPC_ILL_CONDITIONED);
  EXPECT_THAT(made.warning_message, HasSubstr("pixels"));
  EXPECT_GT(made.edge_error, 10);
  const double error = made.edge_error;
  ASSERT_EQ(clipc_plane_constant(CLIPC_SPACE_CLIP, far_plane, CLIPC_KNOWN_IN_VIEW, &draw, 2160,
                                 3 * error, &made, message),
            CLIPC_OK);
  EXPECT_DOUBLE_EQ(made.edge_error, 2 * error);
  EXPECT_EQ(made.warning, CLIPC_OK);
  EXPECT_EQ(clipc_plane_constant(CLIPC_SPACE_MAX, plane, CLIPC_KNOWN_IN_VIEW, &draw, 1080, 0.5,
                                 &made, message),
            CLIPC_INVALID_ARGUMENT);
  EXPECT_EQ(clipc_plane_constant(CLIPC_SPACE_CLIP, plane, CLIPC_KNOWN_IN_MAX, &draw, 1080, 0.5,
                                 &made, message),
            CLIPC_INVALID_ARGUMENT);
}

// The matrices that the shader multiplies by are counted, and a cut that is known is followed.
TEST(CInterface, CountsMatricesAndFollowsCuts) {
  const CMatrices c = MatricesOf(PerspectiveCamera(0.1, 1000));
  float world[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e4F, 0, 10, 1};
  float view[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1e4F, 0, 0, 1};
  const float plane[4] = {0.6F, 0, 0.8F, -6008};
  const DrawMatrices matrices = {RowVectorMatrix(world), RowVectorMatrix(view), c.Projection(),
                                 MatrixOrder::kWorldFirst};
  clipc_draw_matrices draw = {world, view, c.projection, CLIPC_WORLD_FIRST};
  clipc_space_constant made;
  ASSERT_EQ(clipc_plane_constant(CLIPC_SPACE_XYW1, plane, CLIPC_KNOWN_IN_WORLD, &draw, 1080, 0.5,
                                 &made, nullptr),
            CLIPC_OK);
  EXPECT_EQ(made.warning, CLIPC_ILL_CONDITIONED);
  EXPECT_THAT(made.warning_message, HasSubstr("let the world begin at the camera"));
  const double place[3] = {0.5, 0.1, -0.375};
  const double error =
      clipc_cut_error(CLIPC_SPACE_XYW1, plane, CLIPC_KNOWN_IN_WORLD, &draw, place, 1, 0.1, 1080);
  EXPECT_GT(error, 0.1);
  EXPECT_EQ(error, PredictEdgeError(PlaneSpace::kXyw1, PlaneOf(plane), KnownIn::kWorld, matrices,
                                    {place, 1, 0.1}, 1080)
                       .value);
  draw.order = CLIPC_ONE_MATRIX;
  EXPECT_LT(
      clipc_cut_error(CLIPC_SPACE_XYW1, plane, CLIPC_KNOWN_IN_WORLD, &draw, place, 1, 0.1, 1080),
      error / 100);
  draw.order = CLIPC_FLOAT_WORLD_VIEW;
  EXPECT_GT(
      clipc_cut_error(CLIPC_SPACE_XYW1, plane, CLIPC_KNOWN_IN_WORLD, &draw, place, 1, 0.1, 1080),
      error / 10);
  const auto refuses = [&](clipc_plane_space space, const float* p, clipc_known_in known_in,
                           const clipc_draw_matrices* matrices, const double* places,
                           size_t count) {
    return clipc_cut_error(space, p, known_in, matrices, places, count, 0.1, 1080) == -1;
  };
  constexpr clipc_plane_space kXyw1 = CLIPC_SPACE_XYW1;
  constexpr clipc_known_in kWorld = CLIPC_KNOWN_IN_WORLD;
  EXPECT_FALSE(refuses(kXyw1, plane, kWorld, &draw, place, 1));
  EXPECT_TRUE(refuses(CLIPC_SPACE_MAX, plane, kWorld, &draw, place, 1));
  EXPECT_TRUE(refuses(kXyw1, nullptr, kWorld, &draw, place, 1));
  EXPECT_TRUE(refuses(kXyw1, plane, CLIPC_KNOWN_IN_MAX, &draw, place, 1));
  EXPECT_TRUE(refuses(kXyw1, plane, kWorld, nullptr, place, 1));
  EXPECT_TRUE(refuses(kXyw1, plane, kWorld, &draw, nullptr, 1));
  EXPECT_TRUE(refuses(kXyw1, plane, kWorld, &draw, place, 0));
}

TEST(CInterface, MirrorsAndNearPlanes) {
  const CMatrices c = MatricesOf(PerspectiveCamera(0.1, 100));
  const float plane[4] = {0, 0.6F, 0.8F, -3};
  const Plane p = {0, static_cast<double>(plane[1]), static_cast<double>(plane[2]), -3};
  float got[16];
  ASSERT_EQ(clipc_mirror_matrix(plane, got, nullptr), CLIPC_OK);
  const Matrix mirror = MirrorMatrix(p).value;
  for (int i = 0; i < 16; ++i) EXPECT_EQ(got[i], static_cast<float>(mirror.m[i / 4][i % 4])) << i;
  const float none[4] = {0, 0, 0, 1};
  EXPECT_EQ(clipc_mirror_matrix(none, got, nullptr), CLIPC_SINGULAR);

  clipc_sheared_projection sheared;
  char message[CLIPC_MESSAGE_SIZE];
  ASSERT_EQ(clipc_shear_near_plane(plane, c.projection, 0, 1, &sheared, message), CLIPC_OK)
      << message;
  const ShearedProjection expected =
      ShearNearPlane(p, c.Projection(), {}, NearPlaneScale::kKeepFar).value;
  EXPECT_EQ(sheared.scale, expected.scale);
  EXPECT_EQ(sheared.projection[10], static_cast<float>(expected.projection.m[2][2]));
  EXPECT_EQ(sheared.keeps_far, 1);
  // The column of the projection is the one that the function writes into any matrix.
  std::copy_n(c.projection, 16, got);
  clipc_set_depth_column(got, plane, sheared.scale, 0);
  EXPECT_EQ(std::memcmp(got, sheared.projection, sizeof got), 0);
  EXPECT_EQ(clipc_shear_near_plane(plane, c.projection, CLIPC_DEPTH_REVERSED, 1, &sheared, message),
            CLIPC_WRONG_PROJECTION);
}

TEST(CInterface, Variants) {
  const float from[24] = {1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  float to[8] = {};
  const clipc_shader_variant variant = CompactFromC(0b101, from, to);
  EXPECT_EQ(variant.plane_count, 2);
  EXPECT_THAT(to, ElementsAre(1, 1, 1, 1, 3, 3, 3, 3));
  const std::uint8_t plans[4] = {3, CLIPC_CULLED, 0, 1};
  std::uint32_t order[4];
  std::size_t first[8];
  clipc_order_by_plane_count(plans, 4, order, first);
  EXPECT_THAT(std::vector<std::uint32_t>(order, order + first[7]), ElementsAre(2, 3, 0));
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

TEST(CInterface, HiddenPlanes) {
  const float low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};
  const float planes[] = {0, 1, 0, 0.5F, 0, 1, 0, 0};
  EXPECT_EQ(clipc_without_hidden_planes(low, high, planes, 2, 3), 2);
  EXPECT_EQ(clipc_without_hidden_planes(low, high, nullptr, 0, 0), 0);
}

}  // namespace
}  // namespace clipc::runtime
