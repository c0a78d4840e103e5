// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/gl.h"

#include <cstdio>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace clipc::draw {
namespace {

[[noreturn]] void ThrowEgl(const char* what) {
  char text[128];
  std::snprintf(text, sizeof text, "%s failed with EGL error 0x%x", what,
                static_cast<unsigned>(eglGetError()));
  throw DrawError(text);
}

template <typename Function>
void Load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(eglGetProcAddress(name));
}

Gl LoadFunctions() {
  Gl gl{};
#define CLIPC_GL_LOAD(Type, Name) \
  Load(gl.Name, "gl" #Name);      \
  if (!gl.Name) throw DrawError("OpenGL has no gl" #Name);
  CLIPC_GL_FUNCTIONS(CLIPC_GL_LOAD)
#undef CLIPC_GL_LOAD
  Load(gl.ClipControl, "glClipControl");
  Load(gl.DrawElementsInstancedBaseVertexBaseInstance,
       "glDrawElementsInstancedBaseVertexBaseInstance");
  Load(gl.ClipPlane, "glClipPlane");
  return gl;
}

std::vector<EGLint> ContextAttributes(Api api) {
  if (api == Api::kEs) {
    return {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  }
  const EGLint profile = api == Api::kCore ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                           : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
  return {EGL_CONTEXT_MAJOR_VERSION,
          4,
          EGL_CONTEXT_MINOR_VERSION,
          5,
          EGL_CONTEXT_OPENGL_PROFILE_MASK,
          profile,
          EGL_NONE};
}

}  // namespace

std::string Version::Line() const {
  return "#version " + std::to_string(number) + (es && number >= 300 ? " es\n" : "\n");
}

Version VersionOf(const std::string& glsl) {
  Version version;
  const std::size_t at = glsl.find("#version");
  if (at == glsl.npos) return version;
  const std::string line = glsl.substr(at, glsl.find('\n', at) - at);
  std::sscanf(line.c_str(), "#version %d", &version.number);
  version.es = version.number == 100 || line.find(" es") != line.npos;
  const bool is_old = version.number < 140 || line.find("compatibility") != line.npos;
  version.api = version.es ? Api::kEs : is_old ? Api::kCompatibility : Api::kCore;
  return version;
}

Device::Device() {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!get_display) ThrowEgl("finding eglGetPlatformDisplayEXT");
  display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display_ == EGL_NO_DISPLAY) ThrowEgl("opening Mesa's surfaceless display");
  if (!eglInitialize(display_, nullptr, nullptr)) ThrowEgl("eglInitialize");
}

Device::~Device() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  for (auto& [api, context] : contexts_) eglDestroyContext(display_, context.handle);
  // EGL itself stays: terminating it unloads the driver with memory that the driver never frees,
  // and LeakSanitizer, which could have followed its pointers, reports that.
}

Device::Context Device::Create(Api api) const {
  if (!eglBindAPI(api == Api::kEs ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) ThrowEgl("eglBindAPI");
  Context context;
  context.handle =
      eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, ContextAttributes(api).data());
  if (context.handle == EGL_NO_CONTEXT) ThrowEgl("eglCreateContext");
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.handle))
    ThrowEgl("eglMakeCurrent");
  context.gl = LoadFunctions();
  return context;
}

const Gl& Device::Use(Api api) {
  auto found = contexts_.find(api);
  if (found == contexts_.end()) found = contexts_.emplace(api, Create(api)).first;
  eglBindAPI(api == Api::kEs ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, found->second.handle))
    ThrowEgl("eglMakeCurrent");
  return found->second.gl;
}

void CheckErrors(const Gl& gl, const std::string& where) {
  if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
    char text[32];
    std::snprintf(text, sizeof text, "OpenGL error 0x%x", error);
    throw DrawError(where + ": " + text);
  }
}

}  // namespace clipc::draw
