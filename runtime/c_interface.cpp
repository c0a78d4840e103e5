// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// clipc_runtime.h: tables and the binder.
#include "runtime/c_interface.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <new>
#include <utility>

#include "runtime/clip_device.h"
#include "runtime/clipc_runtime.h"
#include "runtime/level9_binder.h"
#include "runtime/table.h"

namespace clipc::runtime {
namespace {

// The ends pin everything between, which both enumerations list in the same order.
static_assert(CLIPC_OK == static_cast<int>(Error::kNone));
static_assert(CLIPC_INVALID_CALL == static_cast<int>(Error::kInvalidCall));
static_assert(CLIPC_NOT_FINITE == static_cast<int>(Error::kNotFinite));
static_assert(CLIPC_SINGULAR == static_cast<int>(Error::kSingular));
static_assert(CLIPC_LOOKS_TRANSPOSED == static_cast<int>(Error::kLooksTransposed));
static_assert(CLIPC_NO_DEPTH_LEFT == static_cast<int>(Error::kNoDepthLeft));
static_assert(CLIPC_LOWERING_CLIP_DISTANCE == static_cast<int>(Lowering::kClipDistance));
static_assert(CLIPC_LOWERING_NONE == static_cast<int>(Lowering::kNone));
static_assert(CLIPC_LOWERING_DISCARD == static_cast<int>(Lowering::kDiscard));

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

}  // namespace

clipc_error Report(const Status& status, char* message) noexcept {
  static_assert(Status::kMessageSize == CLIPC_MESSAGE_SIZE);
  if (message != nullptr) std::memcpy(message, status.message(), std::strlen(status.message()) + 1);
  return static_cast<clipc_error>(status.error());
}

bool IsMissing(std::initializer_list<const void*> arguments, char* message) noexcept {
  if (std::find(arguments.begin(), arguments.end(), nullptr) == arguments.end()) return false;
  Report(Status::Failure(Error::kInvalidArgument, "an argument is a null pointer"), message);
  return true;
}

}  // namespace clipc::runtime

using namespace clipc::runtime;

// NOLINTBEGIN(readability-identifier-naming): names of the C interface.
struct clipc_binder {
  clipc_binder(const clipc_device& callbacks, std::uint32_t max_planes)
      : device(callbacks), binder(device, max_planes) {}
  CallbackDevice device;
  Level9Binder binder;
};

extern "C" {

int32_t clipc_hresult(clipc_error error) { return HresultOf(static_cast<Error>(error)); }

clipc_error clipc_table_read(const void* bytes, size_t size, clipc_table** table, char* message) {
  if (IsMissing({static_cast<const void*>(table)}, message)) return CLIPC_INVALID_ARGUMENT;
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

clipc_lowering clipc_table_lowering(const clipc_table* table) {
  return static_cast<clipc_lowering>(table->table.lowering);
}

clipc_error clipc_table_get_plane(const clipc_table* table, uint32_t index,
                                  clipc_plane_place* place, char* message) {
  if (IsMissing({table, place}, message)) return CLIPC_INVALID_ARGUMENT;
  if (index >= table->table.planes.size()) {
    return Report(Status::Failure(Error::kInvalidArgument, "plane %u of a table with %u",
                                  static_cast<unsigned>(index), clipc_table_plane_count(table)),
                  message);
  }
  const TablePlane& plane = table->table.planes[index];
  *place = {plane.in_register ? 1 : 0, plane.register_number,    plane.register_space,
            plane.byte_offset,         plane.text.c_str(),       plane.cbuffer.c_str(),
            plane.glsl_block.c_str(),  plane.glsl_member.c_str()};
  return Report({}, message);
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

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
