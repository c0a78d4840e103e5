/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_RUNTIME_H
#define CLIPC_RUNTIME_H 1

#include <stddef.h>
#include <stdint.h>

/* clipc::runtime for C99 and for other languages. The C++ header named above each group documents
 * its functions in full.
 *
 * Errors: every function that can fail returns a clipc_error. `message` is NULL or has room for
 * CLIPC_MESSAGE_SIZE chars; it receives one sentence about the error, empty on success. No function
 * throws or exits.
 * Threads: a function without an object may be called from any thread. Many threads may read one
 * clipc_table at once; a clipc_binder belongs to one thread at a time, that of its device.
 * Matrices: 16 floats with the translation in elements 12, 13, 14 (D3DMATRIX; OpenGL's
 * column-major).
 * Planes: {A, B, C, D} keeps the points with Ax + By + Cz + Dw >= 0. */

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and types as usual in C. */
#ifdef __cplusplus
extern "C" {
#endif

#define CLIPC_MESSAGE_SIZE 200

/* status.h: clipc::runtime::Error. The last member of each enumeration fixes its size, and makes
 * every number a value of it: that of a newer or older header is well defined. */
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
  CLIPC_NO_DEPTH_LEFT,
  CLIPC_LOOKS_TRANSPOSED,
  CLIPC_ERROR_MAX = 0x7fffffff
} clipc_error;

/* The HRESULT that an IDirect3DDevice9 returns in the same situation: D3DERR_INVALIDCALL for every
 * mistake of the caller. */
int32_t clipc_hresult(clipc_error error);

/* table.h */
typedef struct clipc_table clipc_table;
/* Reads JSON, a binary block, a header's text or a DXBC container. On success the caller frees
 * *table; on failure *table is NULL. */
clipc_error clipc_table_read(const void* bytes, size_t size, clipc_table** table, char* message);
void clipc_table_free(clipc_table* table); /* NULL is allowed */
uint32_t clipc_table_plane_count(const clipc_table* table);
uint32_t clipc_table_enable_mask(const clipc_table* table);

/* table.h: clipc::runtime::PlaneSpace, the space of the table's planes. */
typedef enum clipc_plane_space {
  CLIPC_SPACE_CLIP = 0,
  CLIPC_SPACE_XYW1,
  CLIPC_SPACE_OBJECT,
  CLIPC_SPACE_MAX = 0x7fffffff
} clipc_plane_space;
clipc_plane_space clipc_table_plane_space(const clipc_table* table);

/* clip_device.h. Both functions receive `context` and return 0 if the device refuses the call. */
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
void clipc_binder_free(clipc_binder* binder); /* NULL is allowed; does not call the device */
/* `needed`: bit i for each plane i to use, UINT32_MAX for all. Takes at most CLIPC_MAX_BUFFERS. */
#define CLIPC_MAX_BUFFERS 16
clipc_error clipc_binder_bind(clipc_binder* binder, const clipc_table* table,
                              const clipc_bound_buffer* buffers, size_t buffer_count,
                              uint32_t needed, char* message);
clipc_error clipc_binder_bind_none(clipc_binder* binder, char* message);
void clipc_binder_invalidate(clipc_binder* binder);

/* clip_plane.h: the constants for the plane spaces `clip`, `xyw1` and `object`. If `view_or_null`
 * is NULL, `plane` is in view space, else in world space. */
clipc_error clipc_clip_plane(const float plane[4], const float* view_or_null,
                             const float projection[16], float clip_plane[4], char* message);
clipc_error clipc_xyw1_plane(const float view_plane[4], const float projection[16],
                             float constant[4], char* message);
clipc_error clipc_object_plane(const float world_plane[4], const float world[16],
                               float object_plane[4], char* message);

/* plane_space.h: PredictEdgeError, the displacement of the cut in pixels of a picture of `rows`
 * rows, at the 99th percentile. Negative if there is no prediction for plane and projection. */
double clipc_edge_error(clipc_plane_space space, const float view_plane[4],
                        const float projection[16], double rows);

/* clip_status.h: D3DCLIPSTATUS9; its initial value is {0, 0xFFFFFFFF}. `positions` is count * 4
 * floats; `planes` is 6 * 4 floats, or NULL with a mask of 0. */
typedef struct clipc_clip_status {
  uint32_t clip_union;
  uint32_t clip_intersection;
} clipc_clip_status;
void clipc_update_clip_status(clipc_clip_status* status, const float* positions, size_t count,
                              const float* planes, uint32_t enable_mask, int clipping);

/* box_planner.h: `bounds` is six arrays of `count` floats, low x, y, z and high x, y, z; `planes`
 * is plane_count * 4 floats. Each of `count` plans is the bits of the planes needed, or
 * CLIPC_CULLED. */
#define CLIPC_CULLED 0x80
void clipc_plan_boxes(const float* const bounds[6], size_t count, const float* planes,
                      size_t plane_count, uint8_t* plans);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif /* CLIPC_RUNTIME_H */
