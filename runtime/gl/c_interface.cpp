// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/c_interface.h"

#include <algorithm>
#include <new>

#include "runtime/gl/clip_plane_device.h"
#include "runtime/gl/clip_switches.h"
#include "runtime/gl/clipc_runtime_gl.h"
#include "runtime/gl/functions.h"

using namespace clipc::runtime;

// NOLINTBEGIN(readability-identifier-naming): names of the C interface.
struct clipc_gl_switches {
  explicit clipc_gl_switches(const gl::Functions& functions) : switches(functions) {}
  gl::ClipSwitches switches;
};

struct clipc_gl_device {
  explicit clipc_gl_device(const gl::Functions& functions) : device(functions) {}
  gl::ClipPlaneDevice device;
};

namespace {

// Makes the object that `made` is to point to.
template <typename Object>
clipc_error Create(const Result<gl::Functions>& functions, Object** made, char* message) {
  if (!functions.ok()) return Report(functions.status, message);
  *made = new (std::nothrow) Object(functions.value);
  if (*made == nullptr)
    return Report(Status::Failure(Error::kOutOfMemory, "no memory for the clip planes"), message);
  return Report({}, message);
}

int SetClipPlane(void* context, uint32_t index, const float plane[4]) {
  return static_cast<gl::ClipPlaneDevice*>(context)->SetClipPlane(index, plane) ? 1 : 0;
}

int SetClipPlaneEnable(void* context, uint32_t mask) {
  return static_cast<gl::ClipPlaneDevice*>(context)->SetClipPlaneEnable(mask) ? 1 : 0;
}

}  // namespace

extern "C" {

clipc_error clipc_gl_switches_create(clipc_gl_loader loader, clipc_gl_switches** switches,
                                     char* message) {
  if (IsMissing({static_cast<const void*>(switches)}, message)) return CLIPC_INVALID_ARGUMENT;
  *switches = nullptr;
  return Create(gl::LoadFunctions(loader), switches, message);
}

void clipc_gl_switches_free(clipc_gl_switches* switches) { delete switches; }

uint32_t clipc_gl_switches_max_planes(const clipc_gl_switches* switches) {
  return switches->switches.max_planes();
}

clipc_error clipc_gl_switches_bind(clipc_gl_switches* switches, const clipc_table* table,
                                   char* message) {
  if (IsMissing({switches, table}, message)) return CLIPC_INVALID_ARGUMENT;
  return Report(switches->switches.Bind(table->table), message);
}

clipc_error clipc_gl_switches_bind_variant(clipc_gl_switches* switches,
                                           const clipc_shader_variant* variant, char* message) {
  if (IsMissing({switches, variant}, message)) return CLIPC_INVALID_ARGUMENT;
  if (variant->plane_count > clipc::kMaxClipPlanes) {
    return Report(
        Status::Failure(Error::kInvalidArgument, "a variant of %d planes", variant->plane_count),
        message);
  }
  ShaderVariant chosen;
  chosen.plane_count = variant->plane_count;
  std::copy_n(variant->planes, 6, chosen.planes);
  return Report(switches->switches.Bind(chosen), message);
}

clipc_error clipc_gl_switches_enable(clipc_gl_switches* switches, uint32_t mask, char* message) {
  if (IsMissing({switches}, message)) return CLIPC_INVALID_ARGUMENT;
  return Report(switches->switches.Enable(mask), message);
}

void clipc_gl_switches_restore(clipc_gl_switches* switches) { switches->switches.Restore(); }

clipc_error clipc_gl_device_create(clipc_gl_loader loader, clipc_gl_device** device,
                                   char* message) {
  if (IsMissing({static_cast<const void*>(device)}, message)) return CLIPC_INVALID_ARGUMENT;
  *device = nullptr;
  const Result<gl::Functions> functions = gl::LoadFunctions(loader);
  if (functions.ok() && !functions.value.has_clip_planes()) {
    return Report(Status::Failure(Error::kDeviceFailed,
                                  "the context has no glClipPlane; it is not "
                                  "one of the compatibility profile"),
                  message);
  }
  return Create(functions, device, message);
}

void clipc_gl_device_free(clipc_gl_device* device) { delete device; }

uint32_t clipc_gl_device_max_planes(const clipc_gl_device* device) {
  return device->device.max_planes();
}

clipc_device clipc_gl_device_callbacks(clipc_gl_device* device) {
  return {&device->device, SetClipPlane, SetClipPlaneEnable};
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
