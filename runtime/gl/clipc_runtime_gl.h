/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_RUNTIME_GL_H
#define CLIPC_RUNTIME_GL_H 1

#include "../clipc_runtime.h"

/** clipc::runtime_gl for C99: clip planes on OpenGL. The rules of clipc_runtime.h hold. The context
 * must be current in every call, those that free included. */

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and types as usual in C. */
#ifdef __cplusplus
extern "C" {
#endif

/** gl/functions.h: finds an OpenGL function by its name, as eglGetProcAddress does. */
typedef void (*clipc_gl_procedure)(void);
typedef clipc_gl_procedure (*clipc_gl_loader)(const char* name);

/** gl/clip_switches.h: enables just the GL_CLIP_DISTANCEi that a shader writes. Freeing restores
 * what was enabled before. */
typedef struct clipc_gl_switches clipc_gl_switches;
clipc_error clipc_gl_switches_create(clipc_gl_loader loader, clipc_gl_switches** switches,
                                     char* message);
void clipc_gl_switches_free(clipc_gl_switches* switches); /**< NULL is allowed */
uint32_t clipc_gl_switches_max_planes(const clipc_gl_switches* switches);
clipc_error clipc_gl_switches_bind(clipc_gl_switches* switches, const clipc_table* table,
                                   char* message);
clipc_error clipc_gl_switches_bind_variant(clipc_gl_switches* switches,
                                           const clipc_shader_variant* variant, char* message);
clipc_error clipc_gl_switches_enable(clipc_gl_switches* switches, uint32_t mask, char* message);
void clipc_gl_switches_restore(clipc_gl_switches* switches);

/** gl/clip_plane_device.h: glClipPlane as the device of a clipc_binder, for shaders of lowering
 * level9. Free the binder first. Errors: CLIPC_DEVICE_FAILED where the context has no
 * glClipPlane. */
typedef struct clipc_gl_device clipc_gl_device;
clipc_error clipc_gl_device_create(clipc_gl_loader loader, clipc_gl_device** device, char* message);
void clipc_gl_device_free(clipc_gl_device* device); /**< NULL is allowed */
uint32_t clipc_gl_device_max_planes(const clipc_gl_device* device);
/** The device as clipc_binder_create takes it. */
clipc_device clipc_gl_device_callbacks(clipc_gl_device* device);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif /**< CLIPC_RUNTIME_GL_H */
