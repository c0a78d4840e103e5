/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_RUNTIME_H
#define CLIPC_RUNTIME_H 1

#include <stddef.h>
#include <stdint.h>

/* clipc::runtime for C99 and for other languages. What a function means is said in full in the C++ header named with
 * it.
 *
 * Errors: every function that can fail returns a clipc_error. Where there is a `message`, NULL or room for
 * CLIPC_MESSAGE_SIZE chars, it gets one sentence saying what is wrong, empty on success. No function throws or exits.
 * Threads: functions without an object may be called from any thread. A clipc_table may be read from many threads at
 * once; a clipc_binder belongs to one thread at a time, that of its device. Matrices: 16 floats with the translation in
 * elements 12, 13, 14 (D3DMATRIX; OpenGL's column-major). Planes: {A, B, C, D}; Ax + By + Cz + Dw >= 0 is kept. */

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): C's own habits. */
#ifdef __cplusplus
extern "C" {
#endif

#define CLIPC_MESSAGE_SIZE 200

/* status.h: clipc::runtime::Error. */
typedef enum clipc_error {
  CLIPC_OK = 0,
  CLIPC_OUT_OF_MEMORY,
  CLIPC_INVALID_ARGUMENT,
  CLIPC_DAMAGED_TABLE,
  CLIPC_WRONG_LOWERING,
  CLIPC_INVALID_CALL,
  CLIPC_MISSING_BUFFER,
  CLIPC_SHORT_BUFFER,
  CLIPC_NOT_FINITE,
  CLIPC_DEVICE_FAILED,
  CLIPC_SINGULAR,
  CLIPC_ILL_CONDITIONED,
  CLIPC_NOT_REPRESENTABLE,
  CLIPC_WRONG_PROJECTION,
  CLIPC_EYE_NOT_CLIPPED,
  CLIPC_NO_DEPTH_LEFT
} clipc_error;

/* The HRESULT that IDirect3DDevice9 would have answered with: D3DERR_INVALIDCALL for what the caller did wrong. */
int32_t clipc_hresult(clipc_error error);

/* table.h */
typedef struct clipc_table clipc_table;
/* JSON, binary block, header text or DXBC container. On success *table must be freed, on failure it is NULL. */
clipc_error clipc_table_read(const void* bytes, size_t size, clipc_table** table, char* message);
void clipc_table_free(clipc_table* table); /* NULL is allowed */
uint32_t clipc_table_plane_count(const clipc_table* table);
uint32_t clipc_table_enable_mask(const clipc_table* table);

/* table.h: clipc::runtime::PlaneSpace, the space in which the planes must be given. */
typedef enum clipc_plane_space {
  CLIPC_SPACE_CLIP = 0,
  CLIPC_SPACE_XYW1,
  CLIPC_SPACE_OBJECT
} clipc_plane_space;
clipc_plane_space clipc_table_plane_space(const clipc_table* table);

/* clip_device.h. Both functions return 0 when the device refuses, and are given `context`. */
typedef struct clipc_device {
  void* context;
  int (*set_clip_plane)(void* context, uint32_t index, const float plane[4]);
  int (*set_clip_plane_enable)(void* context, uint32_t mask);
} clipc_device;

/* level9_binder.h */
typedef struct clipc_bound_buffer {
  uint32_t register_number; /* n of b<n> */
  uint32_t register_space;
  const void* bytes;
  size_t size;
} clipc_bound_buffer;

typedef struct clipc_binder clipc_binder;
clipc_error clipc_binder_create(const clipc_device* device, uint32_t max_planes,
                                clipc_binder** binder);
void clipc_binder_free(clipc_binder* binder); /* NULL is allowed; makes no call */
/* `needed`: bits of the planes to use, UINT32_MAX for all. At most CLIPC_MAX_BUFFERS buffers. */
#define CLIPC_MAX_BUFFERS 16
clipc_error clipc_binder_bind(clipc_binder* binder, const clipc_table* table,
                              const clipc_bound_buffer* buffers, size_t buffer_count,
                              uint32_t needed, char* message);
clipc_error clipc_binder_bind_none(clipc_binder* binder, char* message);
void clipc_binder_invalidate(clipc_binder* binder);

/* clip_plane.h: the constants for the plane spaces `clip`, `xyw1` and `object`. `view_or_null` NULL: the plane is in
 * view space. */
clipc_error clipc_clip_plane(const float plane[4], const float* view_or_null,
                             const float projection[16], float clip_plane[4], char* message);
clipc_error clipc_xyw1_plane(const float view_plane[4], const float projection[16],
                             float constant[4], char* message);
clipc_error clipc_object_plane(const float world_plane[4], const float world[16],
                               float object_plane[4], char* message);

/* plane_space.h: how many pixels of a picture of `rows` rows the cut is displaced by, at the 99th percentile. Negative:
 * no answer for this plane and projection. */
double clipc_edge_error(clipc_plane_space space, const float view_plane[4],
                        const float projection[16], double rows);

/* clip_status.h: D3DCLIPSTATUS9; begin with {0, 0xFFFFFFFF}. `planes` is 6 * 4 floats, or NULL with a mask of 0. */
typedef struct clipc_clip_status {
  uint32_t clip_union;
  uint32_t clip_intersection;
} clipc_clip_status;
void clipc_update_clip_status(clipc_clip_status* status, const float* positions, size_t count,
                              const float* planes, uint32_t enable_mask, int clipping);

/* box_planner.h: `bounds` is low x, y, z, high x, y, z of `count` boxes as six arrays; `planes` plane_count * 4 floats;
 * each plan the bits of the planes needed, or CLIPC_CULLED. */
#define CLIPC_CULLED 0x80
void clipc_plan_boxes(const float* const bounds[6], size_t count, const float* planes,
                      size_t plane_count, uint8_t* plans);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif /* CLIPC_RUNTIME_H */
