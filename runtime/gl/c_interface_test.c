/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* clipc_runtime_gl.h compiles as C99. Called by gl_test.cpp. */
#include "runtime/gl/clipc_runtime_gl.h"

/* Enables what the table's shader writes, then what a variant of one plane writes. */
clipc_error SwitchFromC(clipc_gl_loader loader, const void* bytes, size_t size, char* message) {
  clipc_gl_switches* switches = NULL;
  clipc_table* table = NULL;
  const clipc_shader_variant one = clipc_variant_of(4);
  clipc_error error = clipc_table_read(bytes, size, &table, message);
  if (error == CLIPC_OK) error = clipc_gl_switches_create(loader, &switches, message);
  if (error == CLIPC_OK) error = clipc_gl_switches_bind(switches, table, message);
  if (error == CLIPC_OK) error = clipc_gl_switches_bind_variant(switches, &one, message);
  clipc_gl_switches_free(switches);
  clipc_table_free(table);
  return error;
}

/* Gives the table's planes to glClipPlane. */
clipc_error ClipFromC(clipc_gl_loader loader, const void* bytes, size_t size,
                      const float* constants, size_t constants_size, char* message) {
  const clipc_bound_buffer buffer = {1, 0, constants, constants_size};
  clipc_gl_device* device = NULL;
  clipc_binder* binder = NULL;
  clipc_table* table = NULL;
  clipc_error error = clipc_table_read(bytes, size, &table, message);
  if (error == CLIPC_OK) error = clipc_gl_device_create(loader, &device, message);
  if (error == CLIPC_OK) {
    const clipc_device callbacks = clipc_gl_device_callbacks(device);
    error = clipc_binder_create(&callbacks, clipc_gl_device_max_planes(device), &binder);
  }
  if (error == CLIPC_OK) error = clipc_binder_bind(binder, table, &buffer, 1, UINT32_MAX, message);
  clipc_binder_free(binder);
  clipc_gl_device_free(device);
  clipc_table_free(table);
  return error;
}
