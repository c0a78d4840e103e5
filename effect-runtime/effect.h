/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_EFFECT_RUNTIME_EFFECT_H
#define CLIPC_EFFECT_RUNTIME_EFFECT_H 1

#include "../runtime/gl/clipc_runtime_gl.h"
#include "vulkan_states.h"

/** Effects on OpenGL 3.3 and OpenGL ES 3.0, for C99 and C++17: the programs, states, samplers and
 * parameters of an effect. It is a table of constants in the header that `clipc --effect -Fh FILE`
 * writes when the application is built, so nothing is parsed when it runs. docs/effects.md shows a
 * whole program, and says which OpenGL calls a state becomes.
 *
 * The rules of clipc_runtime.h hold. The context must be current in every call, the one that frees
 * included. */

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and types as usual in C. */
#ifdef __cplusplus
extern "C" {
#endif

/** The states of a pass. Values are OpenGL's, booleans 0 or 1; those called float are the bits of
 * one. Each apply begins with Direct3D's defaults. */
typedef enum clipc_gl_state {
  CLIPC_GL_DEPTH_TEST,
  CLIPC_GL_DEPTH_WRITE,
  CLIPC_GL_DEPTH_FUNC,
  CLIPC_GL_CULL_FACE,  /**< GL_FRONT, GL_BACK, or 0: nothing is culled */
  CLIPC_GL_FRONT_FACE, /**< GL_CW or GL_CCW */
  CLIPC_GL_POLYGON_MODE,
  CLIPC_GL_DEPTH_BIAS,       /**< a float in OpenGL's units */
  CLIPC_GL_SLOPE_DEPTH_BIAS, /**< a float */
  CLIPC_GL_DEPTH_CLAMP,
  CLIPC_GL_SCISSOR_TEST,
  CLIPC_GL_MULTISAMPLE,
  CLIPC_GL_ALPHA_TO_COVERAGE,
  CLIPC_GL_SAMPLE_MASK,
  CLIPC_GL_SRGB_WRITE,
  CLIPC_GL_CLIP_PLANES, /**< a mask of distances besides those that the shader writes always */
  CLIPC_GL_BLEND,
  CLIPC_GL_BLEND_SEPARATE_ALPHA,
  CLIPC_GL_BLEND_SOURCE,
  CLIPC_GL_BLEND_TARGET,
  CLIPC_GL_BLEND_EQUATION,
  CLIPC_GL_BLEND_SOURCE_ALPHA,
  CLIPC_GL_BLEND_TARGET_ALPHA,
  CLIPC_GL_BLEND_EQUATION_ALPHA,
  CLIPC_GL_BLEND_RED, /**< a float, as those after it */
  CLIPC_GL_BLEND_GREEN,
  CLIPC_GL_BLEND_BLUE,
  CLIPC_GL_BLEND_ALPHA,
  CLIPC_GL_COLOR_MASK_0, /**< bit 0: red, bit 3: alpha; of the first render target */
  CLIPC_GL_COLOR_MASK_1,
  CLIPC_GL_COLOR_MASK_2,
  CLIPC_GL_COLOR_MASK_3,
  CLIPC_GL_STENCIL_TEST,
  CLIPC_GL_STENCIL_TWO_SIDED, /**< the back states count; else those of the front do for both */
  CLIPC_GL_STENCIL_REFERENCE,
  CLIPC_GL_STENCIL_READ_MASK,
  CLIPC_GL_STENCIL_WRITE_MASK,
  CLIPC_GL_STENCIL_FUNC,
  CLIPC_GL_STENCIL_FAIL,
  CLIPC_GL_STENCIL_DEPTH_FAIL,
  CLIPC_GL_STENCIL_PASS,
  CLIPC_GL_STENCIL_BACK_FUNC,
  CLIPC_GL_STENCIL_BACK_FAIL,
  CLIPC_GL_STENCIL_BACK_DEPTH_FAIL,
  CLIPC_GL_STENCIL_BACK_PASS,
  CLIPC_GL_STATE_COUNT
} clipc_gl_state;

/** The table: what -Fh writes. Numbers count in the arrays of clipc_gl_effect_table. */
typedef struct clipc_gl_effect_state {
  uint32_t state, value; /**< a clipc_gl_state */
} clipc_gl_effect_state;
typedef struct clipc_gl_effect_pass {
  const char* name;
  uint32_t program, first_state, state_count;
  uint32_t first_annotation, annotation_count;
} clipc_gl_effect_pass;
typedef struct clipc_gl_effect_technique {
  const char* name;
  uint32_t first_pass, pass_count;
  uint32_t first_annotation, annotation_count;
} clipc_gl_effect_technique;
typedef struct clipc_gl_effect_plane {
  uint32_t index; /**< of the clip distance */
  const char*
      text; /**< the plane as [clipplanes(..)] has it: a parameter's name, or a part of one */
} clipc_gl_effect_plane;
typedef struct clipc_gl_effect_program {
  const char *vertex, *fragment; /**< GLSL; fragment is NULL where the pass has no pixel shader */
  uint32_t first_use, use_count; /**< of blocks */
  uint32_t first_sampler, sampler_count;
  uint32_t first_plane, plane_count;
  uint32_t clip_distances; /**< a mask of those that the shader writes */
} clipc_gl_effect_program;
typedef struct clipc_gl_effect_use {
  const char* name; /**< of the block in the GLSL */
  uint32_t block;
} clipc_gl_effect_use;
typedef struct clipc_gl_effect_sampler {
  const char* name; /**< of the uniform in the GLSL */
  uint32_t texture, sampling;
} clipc_gl_effect_sampler;
typedef struct clipc_gl_effect_texture {
  const char* name; /**< of the texture in the effect; of the sampler where that names none */
  uint32_t target;  /**< GL_TEXTURE_2D and the like */
  uint32_t first_annotation, annotation_count;
} clipc_gl_effect_texture;
typedef struct clipc_gl_effect_sampling {
  uint32_t min_filter, mag_filter, wrap_s, wrap_t, wrap_r;
  uint32_t compare_func; /**< 0: does not compare */
  float max_anisotropy, min_lod, max_lod, lod_bias, border[4];
} clipc_gl_effect_sampling;
typedef struct clipc_gl_effect_place {
  uint32_t block, offset;
  uint32_t row_major; /**< of a matrix: whether a row, not a column, is a vector of the buffer */
} clipc_gl_effect_place;
typedef struct clipc_gl_effect_parameter {
  const char *name, *semantic; /**< semantic is "" without one */
  /** The shape of each element; rows is 0 for a struct, whose bytes are given as they lie in the
   * buffer, columns of them. */
  uint32_t rows, columns, elements;
  uint32_t first_place, place_count;
  const uint32_t* value; /**< the default, as it lies in the buffer; NULL: zeros */
  uint32_t value_count;
  uint32_t first_annotation, annotation_count;
} clipc_gl_effect_parameter;
/** <string UIName = "Height";>, as the effect has it. */
typedef struct clipc_gl_effect_annotation {
  const char *type, *name, *value;
} clipc_gl_effect_annotation;
typedef struct clipc_gl_effect_table {
  const clipc_gl_effect_technique* techniques;
  const clipc_gl_effect_pass* passes;
  const clipc_gl_effect_state* states;
  const clipc_gl_effect_program* programs;
  const clipc_gl_effect_use* uses;
  const clipc_gl_effect_sampler* samplers;
  const clipc_gl_effect_plane* planes;
  const clipc_gl_effect_texture* textures;
  const clipc_gl_effect_sampling* samplings;
  const clipc_gl_effect_parameter* parameters;
  const clipc_gl_effect_place* places;
  const uint32_t* block_sizes; /**< in bytes */
  uint32_t technique_count, program_count, texture_count, sampling_count, parameter_count,
      block_count;
  const clipc_gl_effect_annotation* annotations;
  uint32_t annotation_count;
  const clipc_vk_effect_state* vulkan_states;
  const clipc_vk_effect_pass* vulkan_passes; /**< by the number of the pass */
  uint32_t vulkan_pass_count;
} clipc_gl_effect_table;

/** The states of a pass for a Vulkan pipeline, `count` of them: those that the pass sets. Others
 * have Direct3D's defaults. It needs no OpenGL and no effect. NULL where the pass sets none, and
 * where the table has no such pass. */
const clipc_vk_effect_state* clipc_vk_effect_states(const clipc_gl_effect_table* table,
                                                    uint32_t pass, uint32_t* count);

/** An effect in a context. The table must outlive it. */
typedef struct clipc_gl_effect clipc_gl_effect;
/** Makes programs, uniform buffers with the default values, and sampler objects. Errors:
 * CLIPC_DEVICE_FAILED with the beginning of OpenGL's message where a program is refused, or where
 * the context lacks a function. */
clipc_error clipc_gl_effect_create(clipc_gl_loader loader, const clipc_gl_effect_table* table,
                                   clipc_gl_effect** effect, char* message);
void clipc_gl_effect_free(clipc_gl_effect* effect); /**< NULL is allowed */

/** Finds a pass by its names; `pass` may be NULL for the first of the technique. Errors:
 * CLIPC_INVALID_ARGUMENT where the effect has none of the name. */
clipc_error clipc_gl_effect_find(const clipc_gl_effect* effect, const char* technique,
                                 const char* pass, uint32_t* number, char* message);
/** The name of the parameter with a semantic, in any case of letters, as ID3DXEffect has them; NULL
 * without one. */
const char* clipc_gl_effect_by_semantic(const clipc_gl_effect* effect, const char* semantic);

/** The walk over an effect: its technique, pass, parameter, texture or annotation i; NULL past the
 * last. The passes of a technique are those from `first_pass` on, `pass_count` of them, and so are
 * the annotations of what has any. */
const clipc_gl_effect_technique* clipc_gl_effect_technique_of(const clipc_gl_effect* effect,
                                                              uint32_t i);
const clipc_gl_effect_pass* clipc_gl_effect_pass_of(const clipc_gl_effect* effect, uint32_t i);
const clipc_gl_effect_parameter* clipc_gl_effect_parameter_of(const clipc_gl_effect* effect,
                                                              uint32_t i);
const clipc_gl_effect_texture* clipc_gl_effect_texture_of(const clipc_gl_effect* effect,
                                                          uint32_t i);
const clipc_gl_effect_annotation* clipc_gl_effect_annotation_of(const clipc_gl_effect* effect,
                                                                uint32_t i);

/** Sets a parameter for all programs. `values` are floats, ints or uints, and ints for bools, one
 * after another without gaps, matrices in the order of HLSL's rows (as D3DMATRIX has them, for
 * mul(vector, matrix)); `size` is in bytes. Errors: CLIPC_INVALID_ARGUMENT where no program reads a
 * parameter of that name, or `size` is not that of the parameter; a smaller size sets the first
 * elements of an array. */
clipc_error clipc_gl_effect_set(clipc_gl_effect* effect, const char* name, const void* values,
                                size_t size, char* message);
/** Sets a texture object for the texture or the Direct3D 9 sampler of that name. */
clipc_error clipc_gl_effect_set_texture(clipc_gl_effect* effect, const char* name, unsigned texture,
                                        char* message);

/** Makes the next draw one of the pass: its program, uniform buffers, textures, samplers, and its
 * states over Direct3D's defaults. Just the clip distances are enabled that its shader writes. */
clipc_error clipc_gl_effect_apply(clipc_gl_effect* effect, uint32_t pass, char* message);
/** The OpenGL program of a pass, for glGetAttribLocation("in_POSITION0"). */
unsigned clipc_gl_effect_program_of(const clipc_gl_effect* effect, uint32_t pass);
/** The planes that the vertex shader of a pass clips with: their number, and the plane i, or NULL.
 */
uint32_t clipc_gl_effect_plane_count(const clipc_gl_effect* effect, uint32_t pass);
const clipc_gl_effect_plane* clipc_gl_effect_plane_of(const clipc_gl_effect* effect, uint32_t pass,
                                                      uint32_t i);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif /**< CLIPC_EFFECT_RUNTIME_EFFECT_H */
