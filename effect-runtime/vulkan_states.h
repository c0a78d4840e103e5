/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_EFFECT_RUNTIME_VULKAN_STATES_H
#define CLIPC_EFFECT_RUNTIME_VULKAN_STATES_H 1

#include <stdint.h>

/** The states of an effect's passes for Vulkan, for C99 and C++17: a part of the table of effect.h,
 * which clipc_vk_effect_states reads. Nothing of Vulkan is included. */

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and types as usual in C. */
#ifdef __cplusplus
extern "C" {
#endif

/** The states of a pass as members of the structs of a Vulkan pipeline, FRONT_COMPARE_OP for
 * `front.compareOp`. Values are Vulkan's enumerators, masks and flags; those called float are the
 * bits of one. */
typedef enum clipc_vk_state {
  CLIPC_VK_DEPTH_TEST_ENABLE,
  CLIPC_VK_DEPTH_WRITE_ENABLE,
  CLIPC_VK_DEPTH_COMPARE_OP,
  CLIPC_VK_CULL_MODE,
  CLIPC_VK_FRONT_FACE, /**< of the image as Direct3D has it, whose first row is the upper one */
  CLIPC_VK_POLYGON_MODE,
  CLIPC_VK_DEPTH_BIAS_CONSTANT_FACTOR, /**< a float, as the next one; in Vulkan's units */
  CLIPC_VK_DEPTH_BIAS_SLOPE_FACTOR,
  CLIPC_VK_DEPTH_CLAMP_ENABLE,
  CLIPC_VK_SCISSOR_ENABLE, /**< Vulkan has no switch: 0 is a scissor of the whole image */
  CLIPC_VK_ALPHA_TO_COVERAGE_ENABLE,
  CLIPC_VK_SAMPLE_MASK,
  CLIPC_VK_BLEND_ENABLE,
  CLIPC_VK_SRC_COLOR_BLEND_FACTOR,
  CLIPC_VK_DST_COLOR_BLEND_FACTOR,
  CLIPC_VK_COLOR_BLEND_OP,
  CLIPC_VK_SRC_ALPHA_BLEND_FACTOR,
  CLIPC_VK_DST_ALPHA_BLEND_FACTOR,
  CLIPC_VK_ALPHA_BLEND_OP,
  CLIPC_VK_BLEND_CONSTANTS_0, /**< a float, as the three after it */
  CLIPC_VK_BLEND_CONSTANTS_1,
  CLIPC_VK_BLEND_CONSTANTS_2,
  CLIPC_VK_BLEND_CONSTANTS_3,
  CLIPC_VK_COLOR_WRITE_MASK_0,
  CLIPC_VK_COLOR_WRITE_MASK_1,
  CLIPC_VK_COLOR_WRITE_MASK_2,
  CLIPC_VK_COLOR_WRITE_MASK_3,
  CLIPC_VK_STENCIL_TEST_ENABLE,
  CLIPC_VK_REFERENCE,
  CLIPC_VK_COMPARE_MASK,
  CLIPC_VK_WRITE_MASK,
  CLIPC_VK_FRONT_COMPARE_OP,
  CLIPC_VK_FRONT_FAIL_OP,
  CLIPC_VK_FRONT_DEPTH_FAIL_OP,
  CLIPC_VK_FRONT_PASS_OP,
  CLIPC_VK_BACK_COMPARE_OP,
  CLIPC_VK_BACK_FAIL_OP,
  CLIPC_VK_BACK_DEPTH_FAIL_OP,
  CLIPC_VK_BACK_PASS_OP,
  CLIPC_VK_STATE_COUNT
} clipc_vk_state;
typedef struct clipc_vk_effect_state {
  uint32_t state, value; /**< a clipc_vk_state */
} clipc_vk_effect_state;
typedef struct clipc_vk_effect_pass {
  uint32_t first_state, state_count;
} clipc_vk_effect_pass;

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif /**< CLIPC_EFFECT_RUNTIME_VULKAN_STATES_H */
