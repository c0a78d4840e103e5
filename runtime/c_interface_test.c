/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* clipc_runtime.h compiles as C99, and a C program can bind planes with it. Called by
 * c_interface_test.cpp. */
#include <string.h>

#include "runtime/clipc_runtime.h"

static int SetClipPlane(void* context, uint32_t index, const float plane[4]) {
  float* planes = (float*)context;
  memcpy(planes + 4 * index, plane, 4 * sizeof(float));
  return 1;
}

static int SetClipPlaneEnable(void* context, uint32_t mask) {
  float* planes = (float*)context;
  planes[24] = (float)mask;
  return 1;
}

/* Binds the table in `bytes` with `constants` in b1; `device` gets six planes and the mask. */
clipc_error BindFromC(const void* bytes, size_t size, const float* constants, size_t constants_size,
                      float device[25], char* message) {
  const clipc_device callbacks = {device, SetClipPlane, SetClipPlaneEnable};
  const clipc_bound_buffer buffer = {1, 0, constants, constants_size};
  clipc_table* table = NULL;
  clipc_binder* binder = NULL;
  clipc_error error = clipc_table_read(bytes, size, &table, message);
  if (error == CLIPC_OK) error = clipc_binder_create(&callbacks, 6, &binder);
  if (error == CLIPC_OK) error = clipc_binder_bind(binder, table, &buffer, 1, UINT32_MAX, message);
  clipc_binder_free(binder);
  clipc_table_free(table);
  return error;
}
