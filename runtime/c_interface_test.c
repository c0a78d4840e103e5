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

/* Draws with clip distances from a table, as a C program does it: where each plane of the table
 * lies, and the constant for it. `buffer` is the constant buffer that plane 0 names. */
clipc_error FillFromC(const void* bytes, size_t size, const float world_plane[4],
                      const float view[16], const float projection[16], unsigned char* buffer,
                      size_t buffer_size, char* message) {
  clipc_table* table = NULL;
  clipc_error error = clipc_table_read(bytes, size, &table, message);
  uint32_t i;
  for (i = 0; error == CLIPC_OK && i < clipc_table_plane_count(table); ++i) {
    clipc_plane_place place;
    clipc_space_constant constant;
    clipc_draw_matrices draw = {NULL, NULL, NULL, CLIPC_ONE_MATRIX};
    draw.view = view;
    draw.projection = projection;
    error = clipc_table_get_plane(table, i, &place, message);
    if (error == CLIPC_OK) {
      error = clipc_plane_constant(clipc_table_plane_space(table), world_plane,
                                   CLIPC_KNOWN_IN_WORLD, &draw, 1080, 0.5, &constant, message);
    }
    if (error == CLIPC_OK && place.in_register && place.byte_offset + 16 <= buffer_size)
      memcpy(buffer + place.byte_offset, constant.constant, 16);
  }
  clipc_table_free(table);
  return error;
}

/* The variant for a plan, and the planes that it takes. */
clipc_shader_variant CompactFromC(uint8_t plan, const float* from, float* to) {
  const clipc_shader_variant variant = clipc_variant_of(plan);
  clipc_compact_planes(&variant, from, to);
  return variant;
}
