// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <new>
#include <utility>

#include "runtime/box_planner.h"
#include "runtime/clip_plane.h"
#include "runtime/clip_status.h"
#include "runtime/clipc_runtime.h"
#include "runtime/level9_binder.h"
#include "runtime/plane_space.h"
#include "runtime/table.h"

namespace clipc::runtime {
namespace {

// The ends pin everything between, which both enumerations list in the same order.
static_assert(CLIPC_OK == static_cast<int>(Error::kNone));
static_assert(CLIPC_INVALID_CALL == static_cast<int>(Error::kInvalidCall));
static_assert(CLIPC_NOT_FINITE == static_cast<int>(Error::kNotFinite));
static_assert(CLIPC_SINGULAR == static_cast<int>(Error::kSingular));
static_assert(CLIPC_LOOKS_TRANSPOSED == static_cast<int>(Error::kLooksTransposed));
static_assert(CLIPC_CULLED == kCulled);
static_assert(CLIPC_SPACE_CLIP == static_cast<int>(PlaneSpace::kClip));
static_assert(CLIPC_SPACE_OBJECT == static_cast<int>(PlaneSpace::kObject));

clipc_error Report(const Status& status, char* message) noexcept {
  static_assert(Status::kMessageSize == CLIPC_MESSAGE_SIZE);
  if (message != nullptr) std::memcpy(message, status.message(), std::strlen(status.message()) + 1);
  return static_cast<clipc_error>(status.error());
}

// Whether one of the arguments is a null pointer, which is then reported.
bool IsMissing(std::initializer_list<const void*> arguments, char* message) noexcept {
  if (std::find(arguments.begin(), arguments.end(), nullptr) == arguments.end()) return false;
  Report(Status::Failure(Error::kInvalidArgument, "an argument is a null pointer"), message);
  return true;
}

class CallbackDevice final : public ClipDevice {
 public:
  explicit CallbackDevice(const clipc_device& device) : device_(device) {}
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override {
    return device_.set_clip_plane(device_.context, index, plane) != 0;
  }
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override {
    return device_.set_clip_plane_enable(device_.context, mask) != 0;
  }

 private:
  clipc_device device_;
};

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

}  // namespace
}  // namespace clipc::runtime

using namespace clipc::runtime;

// NOLINTBEGIN(readability-identifier-naming): names of the C interface.
struct clipc_table {
  Table table;
};

struct clipc_binder {
  clipc_binder(const clipc_device& callbacks, std::uint32_t max_planes)
      : device(callbacks), binder(device, max_planes) {}
  CallbackDevice device;
  Level9Binder binder;
};

extern "C" {

int32_t clipc_hresult(clipc_error error) { return HresultOf(static_cast<Error>(error)); }

clipc_error clipc_table_read(const void* bytes, size_t size, clipc_table** table, char* message) {
  if (IsMissing({table}, message)) return CLIPC_INVALID_ARGUMENT;
  *table = nullptr;
  Result<Table> result = ReadTable(bytes, size);
  if (!result.ok()) return Report(result.status, message);
  *table = new (std::nothrow) clipc_table{std::move(result.value)};
  if (*table == nullptr) {
    return Report(Status::Failure(Error::kOutOfMemory, "no memory for the clip table"), message);
  }
  return Report({}, message);
}

void clipc_table_free(clipc_table* table) { delete table; }

uint32_t clipc_table_plane_count(const clipc_table* table) {
  return static_cast<uint32_t>(table->table.planes.size());
}

uint32_t clipc_table_enable_mask(const clipc_table* table) { return table->table.enable_mask; }

clipc_plane_space clipc_table_plane_space(const clipc_table* table) {
  return static_cast<clipc_plane_space>(table->table.plane_space);
}

clipc_error clipc_binder_create(const clipc_device* device, uint32_t max_planes,
                                clipc_binder** binder) {
  if (binder == nullptr) return CLIPC_INVALID_ARGUMENT;
  *binder = nullptr;
  if (device == nullptr || device->set_clip_plane == nullptr ||
      device->set_clip_plane_enable == nullptr)
    return CLIPC_INVALID_ARGUMENT;
  *binder = new (std::nothrow) clipc_binder(*device, max_planes);
  return *binder == nullptr ? CLIPC_OUT_OF_MEMORY : CLIPC_OK;
}

void clipc_binder_free(clipc_binder* binder) { delete binder; }

clipc_error clipc_binder_bind(clipc_binder* binder, const clipc_table* table,
                              const clipc_bound_buffer* buffers, size_t buffer_count,
                              uint32_t needed, char* message) {
  if (IsMissing({binder, table}, message)) return CLIPC_INVALID_ARGUMENT;
  if (buffer_count != 0 && IsMissing({buffers}, message)) return CLIPC_INVALID_ARGUMENT;
  if (buffer_count > CLIPC_MAX_BUFFERS) {
    return Report(Status::Failure(Error::kInvalidArgument, "%llu buffers; at most %d",
                                  static_cast<unsigned long long>(buffer_count), CLIPC_MAX_BUFFERS),
                  message);
  }
  BoundBuffer bound[CLIPC_MAX_BUFFERS];
  for (size_t i = 0; i < buffer_count; ++i) {
    bound[i] = {buffers[i].register_number, buffers[i].register_space, buffers[i].bytes,
                buffers[i].size};
  }
  return Report(binder->binder.Bind(table->table, bound, buffer_count, needed), message);
}

clipc_error clipc_binder_bind_none(clipc_binder* binder, char* message) {
  if (IsMissing({binder}, message)) return CLIPC_INVALID_ARGUMENT;
  return Report(binder->binder.BindNone(), message);
}

void clipc_binder_invalidate(clipc_binder* binder) {
  if (binder != nullptr) binder->binder.Invalidate();
}

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
  plane_count = std::min<size_t>(plane_count, 6);
  if (plane_count != 0)
    std::memcpy(static_cast<void*>(copies), planes, plane_count * sizeof(Float4));
  const BoxArrays boxes = {
      {bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}, count};
  PlanBoxes(boxes, copies, plane_count, plans);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
