// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/offscreen.h"

#include <cstdio>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace clipc::harness {
namespace {

[[noreturn]] void ThrowNumbered(const std::string& what, unsigned error) {
  char number[16];
  std::snprintf(number, sizeof number, "0x%x", error);
  throw DrawError(what + " " + number);
}

void CheckEgl(bool ok, const char* what) {
  if (!ok)
    ThrowNumbered(std::string(what) + " failed with EGL error",
                  static_cast<unsigned>(eglGetError()));
}

void* MakeContext(EGLDisplay display, Api api) {
  const bool is_es = api == Api::kEs;
  const EGLint profile = api == Api::kCore ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                           : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
  // OpenGL ES has no profiles: its list ends before them.
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               is_es ? 3 : 4,
                               EGL_CONTEXT_MINOR_VERSION,
                               is_es ? 2 : 5,
                               is_es ? EGL_NONE : EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               profile,
                               EGL_NONE};
  void* context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  CheckEgl(context != EGL_NO_CONTEXT, "eglCreateContext");
  return context;
}

}  // namespace

OpenGl::OpenGl() {
  display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  CheckEgl(display_ != EGL_NO_DISPLAY, "opening Mesa's surfaceless display");
  CheckEgl(eglInitialize(display_, nullptr, nullptr), "eglInitialize");
}

OpenGl::~OpenGl() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  for (const auto& [api, context] : contexts_) eglDestroyContext(display_, context);
  // EGL itself stays: terminating it unloads the driver with memory that the driver never frees,
  // and LeakSanitizer, which could have followed its pointers, reports that.
}

void OpenGl::Use(Api api) {
  CheckEgl(eglBindAPI(api == Api::kEs ? EGL_OPENGL_ES_API : EGL_OPENGL_API), "eglBindAPI");
  void*& context = contexts_[api];
  if (context == nullptr) context = MakeContext(display_, api);
  CheckEgl(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context), "eglMakeCurrent");
}

runtime::gl::Procedure OpenGl::Load(const char* name) { return eglGetProcAddress(name); }

void CheckErrors(const std::string& where) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    ThrowNumbered(where + ": OpenGL error", error);
}

}  // namespace clipc::harness
