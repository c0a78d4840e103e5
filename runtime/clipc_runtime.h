/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_RUNTIME_H
#define CLIPC_RUNTIME_H 1

#include <stddef.h>
#include <stdint.h>

/** clipc::runtime for C99 and for other languages. The C++ header named above each group documents
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

/** status.h: clipc::runtime::Error. The last member of each enumeration fixes its size, and makes
 * every number a value of it: the number of a newer or older header is well defined. */
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

/** The HRESULT that an IDirect3DDevice9 returns in the same situation: D3DERR_INVALIDCALL for every
 * mistake of the caller. */
int32_t clipc_hresult(clipc_error error);

/** table.h */
typedef struct clipc_table clipc_table;
/** Reads JSON, a binary block, a header's text or a DXBC container. On success the caller frees
 * *table; on failure *table is NULL. */
clipc_error clipc_table_read(const void* bytes, size_t size, clipc_table** table, char* message);
void clipc_table_free(clipc_table* table); /**< NULL is allowed */
uint32_t clipc_table_plane_count(const clipc_table* table);
uint32_t clipc_table_enable_mask(const clipc_table* table);

/** table.h: clipc::runtime::PlaneSpace, the space of the table's planes. */
typedef enum clipc_plane_space {
  CLIPC_SPACE_CLIP = 0,
  CLIPC_SPACE_XYW1,
  CLIPC_SPACE_OBJECT,
  CLIPC_SPACE_MAX = 0x7fffffff
} clipc_plane_space;
clipc_plane_space clipc_table_plane_space(const clipc_table* table);

/** table.h: clipc::runtime::Lowering, what the shader does with its planes. */
typedef enum clipc_lowering {
  CLIPC_LOWERING_CLIP_DISTANCE = 0,
  CLIPC_LOWERING_LEVEL9,
  CLIPC_LOWERING_NONE,
  CLIPC_LOWERING_NEAR_PLANE,
  CLIPC_LOWERING_DISCARD,
  CLIPC_LOWERING_MAX = 0x7fffffff
} clipc_lowering;
clipc_lowering clipc_table_lowering(const clipc_table* table);

/** table.h: TablePlane, the place of one plane among the constants. Texts live as long as the
 * table, and are empty, not NULL, where there is nothing. `index` is below
 * clipc_table_plane_count. */
typedef struct clipc_plane_place {
  int in_register;          /**< 0: composed of several constants; the members below are empty */
  uint32_t register_number; /**< n of b<n> */
  uint32_t register_space;
  uint32_t byte_offset; /**< of the four floats in that buffer */
  const char* text;     /**< the operand of [clipplanes] */
  const char* cbuffer;
  const char* glsl_block;  /**< empty for a plain uniform */
  const char* glsl_member; /**< the member or uniform; empty if the shader does not read it */
} clipc_plane_place;
clipc_error clipc_table_get_plane(const clipc_table* table, uint32_t index,
                                  clipc_plane_place* place, char* message);

/** clip_device.h. Both functions receive `context` and return 0 if the device refuses the call. */
typedef struct clipc_device {
  void* context;
  int (*set_clip_plane)(void* context, uint32_t index, const float plane[4]);
  int (*set_clip_plane_enable)(void* context, uint32_t mask);
} clipc_device;

/** level9_binder.h */
typedef struct clipc_bound_buffer {
  uint32_t register_number; /**< n of b<n> */
  uint32_t register_space;
  const void* bytes;
  size_t size;
} clipc_bound_buffer;

typedef struct clipc_binder clipc_binder;
clipc_error clipc_binder_create(const clipc_device* device, uint32_t max_planes,
                                clipc_binder** binder);
void clipc_binder_free(clipc_binder* binder); /**< NULL is allowed; does not call the device */
/** `needed`: bit i for each plane i to use, UINT32_MAX for all. Takes at most CLIPC_MAX_BUFFERS. */
#define CLIPC_MAX_BUFFERS 16
clipc_error clipc_binder_bind(clipc_binder* binder, const clipc_table* table,
                              const clipc_bound_buffer* buffers, size_t buffer_count,
                              uint32_t needed, char* message);
clipc_error clipc_binder_bind_none(clipc_binder* binder, char* message);
void clipc_binder_invalidate(clipc_binder* binder);

/** clip_plane.h: the constants for the plane spaces `clip`, `xyw1` and `object`. If `view_or_null`
 * is NULL, `plane` is in view space, else in world space. */
clipc_error clipc_clip_plane(const float plane[4], const float* view_or_null,
                             const float projection[16], float clip_plane[4], char* message);
clipc_error clipc_xyw1_plane(const float view_plane[4], const float projection[16],
                             float constant[4], char* message);
clipc_error clipc_object_plane(const float world_plane[4], const float world[16],
                               float object_plane[4], char* message);

/** plane_space.h: PlaneConstantFor, the constant of a plane for the table's plane space. A matrix
 * that is NULL is the identity. Warning: none, or CLIPC_ILL_CONDITIONED with a sentence where the
 * edge, with the object's own vertices, moves by more than `most_pixels` in an image of `rows`
 * rows. */
typedef enum clipc_known_in {
  CLIPC_KNOWN_IN_OBJECT = 0,
  CLIPC_KNOWN_IN_WORLD,
  CLIPC_KNOWN_IN_VIEW,
  CLIPC_KNOWN_IN_MAX = 0x7fffffff
} clipc_known_in;
/** MatrixOrder; CLIPC_ONE_MATRIX counts for what is none of these. */
typedef enum clipc_matrix_order {
  CLIPC_ONE_MATRIX = 0,
  CLIPC_WORLD_FIRST,
  CLIPC_WORLD_VIEW_FIRST,
  CLIPC_THREE_MATRICES,
  CLIPC_FLOAT_WORLD_VIEW,
  CLIPC_FLOAT_VIEW_PROJECTION,
  CLIPC_MATRIX_ORDER_MAX = 0x7fffffff
} clipc_matrix_order;
typedef struct clipc_draw_matrices {
  const float *world, *view, *projection;
  clipc_matrix_order order;
} clipc_draw_matrices;
typedef struct clipc_space_constant {
  float constant[4];
  double edge_error; /**< in pixels along the surface; 0 if there is no prediction */
  clipc_error warning;
  char warning_message[CLIPC_MESSAGE_SIZE];
} clipc_space_constant;
clipc_error clipc_plane_constant(clipc_plane_space space, const float plane[4],
                                 clipc_known_in known_in, const clipc_draw_matrices* draw,
                                 double rows, double most_pixels, clipc_space_constant* constant,
                                 char* message);

/** mirror.h: MirrorMatrix, for planar reflections. The draw swaps its cull mode. */
clipc_error clipc_mirror_matrix(const float plane[4], float matrix[16], char* message);

/** near_plane.h: one plane without hardware. The flags of a depth range: OpenGL's -w <= z <= w, and
 * reverse-Z. */
enum { CLIPC_DEPTH_NEGATIVE_ONE_TO_ONE = 1, CLIPC_DEPTH_REVERSED = 2 };
typedef struct clipc_sheared_projection {
  float projection[16];
  double scale;
  double effective_near;
  double depth_ratio;
  int keeps_far;
} clipc_sheared_projection;
/** `keep_far`: NearPlaneScale::kKeepFar, else kAsGiven. */
clipc_error clipc_shear_near_plane(const float view_plane[4], const float projection[16],
                                   uint32_t depth_range, int keep_far,
                                   clipc_sheared_projection* sheared, char* message);
void clipc_set_depth_column(float to_clip[16], const float plane[4], double scale,
                            uint32_t depth_range);

/** plane_space.h: PredictEdgeError, the displacement of the cut in pixels of an image of `rows`
 * rows, at the 99th percentile. Negative if there is no prediction for plane and projection. */
double clipc_edge_error(clipc_plane_space space, const float view_plane[4],
                        const float projection[16], double rows);
/** The edge error of a draw whose cut is known: `places` is x, y and z of `count` places of it, in
 * the object's own space; `edge` is the length of the triangles' edges in half images. */
double clipc_cut_error(clipc_plane_space space, const float plane[4], clipc_known_in known_in,
                       const clipc_draw_matrices* draw, const double* places, size_t count,
                       double edge, double rows);

/** clip_status.h: D3DCLIPSTATUS9; its initial value is {0, 0xFFFFFFFF}. `positions` is count * 4
 * floats; `planes` is 6 * 4 floats, or NULL with a mask of 0. */
typedef struct clipc_clip_status {
  uint32_t clip_union;
  uint32_t clip_intersection;
} clipc_clip_status;
void clipc_update_clip_status(clipc_clip_status* status, const float* positions, size_t count,
                              const float* planes, uint32_t enable_mask, int clipping);

/** box_planner.h: `bounds` is six arrays of `count` floats, low x, y, z and high x, y, z; `planes`
 * is plane_count * 4 floats. Each of `count` plans is the bits of the planes needed, or
 * CLIPC_CULLED. */
#define CLIPC_CULLED 0x80
void clipc_plan_boxes(const float* const bounds[6], size_t count, const float* planes,
                      size_t plane_count, uint8_t* plans);

/** hidden_planes.h: the plan of a box, from `low` to `high`, without the planes whose cut others
 * hide. */
uint8_t clipc_without_hidden_planes(const float low[3], const float high[3], const float* planes,
                                    size_t plane_count, uint8_t plan);

/** shader_variant.h: the shader of `clipc --variants` that has just the planes of a plan, and the
 * object's plane for each of its planes. */
typedef struct clipc_shader_variant {
  uint8_t plane_count;
  uint8_t planes[6];
} clipc_shader_variant;
clipc_shader_variant clipc_variant_of(uint8_t plan);
/** Copies the planes that the variant uses. `from` and `to` are arrays of 4 floats for each plane;
 * `to` has room for variant->plane_count planes. */
void clipc_compact_planes(const clipc_shader_variant* variant, const float* from, float* to);
/** The drawing order by number of planes. `order` has room for `count` indices; objects with k
 * planes are order[first[k]] up to order[first[k + 1] - 1]. */
void clipc_order_by_plane_count(const uint8_t* plans, size_t count, uint32_t* order,
                                size_t first[8]);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif /**< CLIPC_RUNTIME_H */
