// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// clipc_runtime.h: the plane mathematics, the planner and the clip status.
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "runtime/box_planner.h"
#include "runtime/c_interface.h"
#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/clipc_runtime.h"
#include "runtime/hidden_planes.h"
#include "runtime/matrix.h"
#include "runtime/mirror.h"
#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "runtime/shader_variant.h"

namespace clipc::runtime {
namespace {

static_assert(CLIPC_CULLED == kCulled);
static_assert(CLIPC_SPACE_CLIP == static_cast<int>(PlaneSpace::kClip));
static_assert(CLIPC_SPACE_OBJECT == static_cast<int>(PlaneSpace::kObject));
static_assert(CLIPC_KNOWN_IN_OBJECT == static_cast<int>(KnownIn::kObject));
static_assert(CLIPC_KNOWN_IN_VIEW == static_cast<int>(KnownIn::kView));

Plane PlaneFrom(const float* p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]),
          static_cast<double>(p[3])};
}

Matrix MatrixFrom(const float* elements) {
  float copy[16];
  std::copy_n(elements, 16, copy);
  return RowVectorMatrix(copy);
}

clipc_error Give(const Result<PlaneConstant>& result, float* to, char* message) {
  if (result.ok()) std::memcpy(to, &result.value.constant, sizeof(Float4));
  return Report(result.status, message);
}

Matrix MatrixOrIdentity(const float* elements) {
  return elements == nullptr ? Matrix() : MatrixFrom(elements);
}

DrawMatrices MatricesFrom(const clipc_draw_matrices& draw) {
  const bool is_known = draw.order <= CLIPC_FLOAT_VIEW_PROJECTION;
  return {MatrixOrIdentity(draw.world), MatrixOrIdentity(draw.view),
          MatrixOrIdentity(draw.projection),
          is_known ? static_cast<MatrixOrder>(draw.order) : MatrixOrder::kOneMatrix};
}

void Put(const Matrix& matrix, float* to) {
  for (int i = 0; i < 16; ++i) to[i] = static_cast<float>(matrix.m[i / 4][i % 4]);
}

DepthRange RangeOf(uint32_t flags) {
  return {(flags & CLIPC_DEPTH_NEGATIVE_ONE_TO_ONE) != 0, (flags & CLIPC_DEPTH_REVERSED) != 0};
}

// Copies the planes that the planner reads, and returns their number.
size_t CopyPlanes(const float* from, size_t plane_count, Float4 (&to)[6]) {
  plane_count = std::min<size_t>(plane_count, 6);
  if (plane_count != 0) std::memcpy(static_cast<void*>(to), from, plane_count * sizeof(Float4));
  return plane_count;
}

}  // namespace
}  // namespace clipc::runtime

using namespace clipc::runtime;

// NOLINTBEGIN(readability-identifier-naming): names of the C interface.
extern "C" {

clipc_error clipc_clip_plane(const float plane[4], const float* view_or_null,
                             const float projection[16], float clip_plane[4], char* message) {
  if (IsMissing({plane, projection, clip_plane}, message)) return CLIPC_INVALID_ARGUMENT;
  const Plane from = PlaneFrom(plane);
  const Matrix to_clip = MatrixFrom(projection);
  return Give(view_or_null == nullptr ? ClipPlaneFromView(from, to_clip)
                                      : ClipPlaneFromWorld(from, MatrixFrom(view_or_null), to_clip),
              clip_plane, message);
}

clipc_error clipc_xyw1_plane(const float view_plane[4], const float projection[16],
                             float constant[4], char* message) {
  if (IsMissing({view_plane, projection, constant}, message)) return CLIPC_INVALID_ARGUMENT;
  return Give(Xyw1PlaneFromView(PlaneFrom(view_plane), MatrixFrom(projection)), constant, message);
}

clipc_error clipc_object_plane(const float world_plane[4], const float world[16],
                               float object_plane[4], char* message) {
  if (IsMissing({world_plane, world, object_plane}, message)) return CLIPC_INVALID_ARGUMENT;
  return Give(ObjectPlaneFromWorld(PlaneFrom(world_plane), MatrixFrom(world)), object_plane,
              message);
}

double clipc_edge_error(clipc_plane_space space, const float view_plane[4],
                        const float projection[16], double rows) {
  if (space > CLIPC_SPACE_OBJECT || view_plane == nullptr || projection == nullptr) return -1;
  const Result<double> error = PredictEdgeError(
      static_cast<PlaneSpace>(space), PlaneFrom(view_plane), MatrixFrom(projection), rows);
  return error.ok() ? error.value : -1;
}

double clipc_cut_error(clipc_plane_space space, const float plane[4], clipc_known_in known_in,
                       const clipc_draw_matrices* draw, const double* places, size_t count,
                       double edge, double rows) {
  if (space > CLIPC_SPACE_OBJECT || known_in > CLIPC_KNOWN_IN_VIEW || plane == nullptr ||
      draw == nullptr || places == nullptr)
    return -1;
  const Result<double> error = PredictEdgeError(static_cast<PlaneSpace>(space), PlaneFrom(plane),
                                                static_cast<KnownIn>(known_in), MatricesFrom(*draw),
                                                {places, count, edge}, rows);
  return error.ok() ? error.value : -1;
}

void clipc_update_clip_status(clipc_clip_status* status, const float* positions, size_t count,
                              const float* planes, uint32_t enable_mask, int clipping) {
  UserClipPlanes user;
  if (planes != nullptr) {
    std::memcpy(user.planes, planes, sizeof user.planes);
    user.enable_mask = enable_mask;
  }
  ClipStatus updated = {status->clip_union, status->clip_intersection};
  UpdateClipStatus(updated, positions, count, user, clipping != 0);
  *status = {updated.clip_union, updated.clip_intersection};
}

void clipc_plan_boxes(const float* const bounds[6], size_t count, const float* planes,
                      size_t plane_count, uint8_t* plans) {
  Float4 copies[6];
  plane_count = CopyPlanes(planes, plane_count, copies);
  const BoxArrays boxes = {
      {bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}, count};
  PlanBoxes(boxes, copies, plane_count, plans);
}

uint8_t clipc_without_hidden_planes(const float low[3], const float high[3], const float* planes,
                                    size_t plane_count, uint8_t plan) {
  Float4 copies[6];
  plane_count = CopyPlanes(planes, plane_count, copies);
  const Box box = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  return WithoutHiddenPlanes(box, copies, plane_count, plan);
}

clipc_error clipc_plane_constant(clipc_plane_space space, const float plane[4],
                                 clipc_known_in known_in, const clipc_draw_matrices* draw,
                                 double rows, double most_pixels, clipc_space_constant* constant,
                                 char* message) {
  if (IsMissing({plane, draw, constant}, message)) return CLIPC_INVALID_ARGUMENT;
  if (space > CLIPC_SPACE_OBJECT || known_in > CLIPC_KNOWN_IN_VIEW) {
    return Report(Status::Failure(Error::kInvalidArgument, "the space of the plane is not known"),
                  message);
  }
  const Result<SpaceConstant> made =
      PlaneConstantFor(static_cast<PlaneSpace>(space), PlaneFrom(plane),
                       static_cast<KnownIn>(known_in), MatricesFrom(*draw), {rows, most_pixels});
  *constant = {};
  if (made.ok()) {
    std::memcpy(constant->constant, &made.value.plane.constant, sizeof(Float4));
    constant->edge_error = made.value.edge_error;
    constant->warning = Report(made.value.warning, constant->warning_message);
  }
  return Report(made.status, message);
}

clipc_error clipc_mirror_matrix(const float plane[4], float matrix[16], char* message) {
  if (IsMissing({plane, matrix}, message)) return CLIPC_INVALID_ARGUMENT;
  const Result<Matrix> mirror = MirrorMatrix(PlaneFrom(plane));
  if (mirror.ok()) Put(mirror.value, matrix);
  return Report(mirror.status, message);
}

clipc_error clipc_shear_near_plane(const float view_plane[4], const float projection[16],
                                   uint32_t depth_range, int keep_far,
                                   clipc_sheared_projection* sheared, char* message) {
  if (IsMissing({view_plane, projection, sheared}, message)) return CLIPC_INVALID_ARGUMENT;
  const Result<ShearedProjection> made =
      ShearNearPlane(PlaneFrom(view_plane), MatrixFrom(projection), RangeOf(depth_range),
                     keep_far != 0 ? NearPlaneScale::kKeepFar : NearPlaneScale::kAsGiven);
  *sheared = {};
  if (made.ok()) {
    const ShearedProjection& value = made.value;
    Put(value.projection, sheared->projection);
    sheared->scale = value.scale;
    sheared->effective_near = value.effective_near;
    sheared->depth_ratio = value.depth_ratio;
    sheared->keeps_far = value.keeps_far ? 1 : 0;
  }
  return Report(made.status, message);
}

void clipc_set_depth_column(float to_clip[16], const float plane[4], double scale,
                            uint32_t depth_range) {
  Matrix matrix = MatrixFrom(to_clip);
  SetDepthColumn(matrix, PlaneFrom(plane), scale, RangeOf(depth_range));
  Put(matrix, to_clip);
}

clipc_shader_variant clipc_variant_of(uint8_t plan) {
  const ShaderVariant variant = VariantOf(plan);
  clipc_shader_variant made = {variant.plane_count, {}};
  std::copy_n(variant.planes, 6, made.planes);
  return made;
}

void clipc_compact_planes(const clipc_shader_variant* variant, const float* from, float* to) {
  const std::size_t count = std::min<std::size_t>(variant->plane_count, 6);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t plane = std::min<std::size_t>(variant->planes[i], 5);
    std::memmove(to + 4 * i, from + 4 * plane, sizeof(Float4));
  }
}

void clipc_order_by_plane_count(const uint8_t* plans, size_t count, uint32_t* order,
                                size_t first[8]) {
  std::size_t starts[8];
  OrderByPlaneCount(plans, count, order, starts);
  std::copy_n(starts, 8, first);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
