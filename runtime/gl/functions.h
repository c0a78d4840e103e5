// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/status.h"

// The few OpenGL functions that clip planes need, with no OpenGL header and no link to an OpenGL
// library.
namespace clipc::runtime::gl {

#if defined(_WIN32)
#define CLIPC_GL_API __stdcall
#else
#define CLIPC_GL_API
#endif

// OpenGL's values. GL_CLIP_PLANEi of the compatibility profile is the same number as
// GL_CLIP_DISTANCEi.
inline constexpr unsigned kClipDistance0 = 0x3000;
inline constexpr unsigned kMaxClipDistances = 0x0D32;
inline constexpr unsigned kMatrixMode = 0x0BA0;
inline constexpr unsigned kModelView = 0x1700;

// NOLINTBEGIN(readability-identifier-naming): named as OpenGL names them.
struct Functions {
  void(CLIPC_GL_API* Enable)(unsigned capability) = nullptr;
  void(CLIPC_GL_API* Disable)(unsigned capability) = nullptr;
  unsigned char(CLIPC_GL_API* IsEnabled)(unsigned capability) = nullptr;
  void(CLIPC_GL_API* GetIntegerv)(unsigned name, int* value) = nullptr;
  // Of the compatibility profile: null elsewhere.
  void(CLIPC_GL_API* ClipPlane)(unsigned plane, const double* equation) = nullptr;
  void(CLIPC_GL_API* GetClipPlane)(unsigned plane, double* equation) = nullptr;
  void(CLIPC_GL_API* MatrixMode)(unsigned mode) = nullptr;
  void(CLIPC_GL_API* PushMatrix)() = nullptr;
  void(CLIPC_GL_API* PopMatrix)() = nullptr;
  void(CLIPC_GL_API* LoadIdentity)() = nullptr;

  bool has_clip_planes() const noexcept {
    return ClipPlane && GetClipPlane && MatrixMode && PushMatrix && PopMatrix && LoadIdentity;
  }
};

// NOLINTEND(readability-identifier-naming)

// "glEnable" => its address: eglGetProcAddress, glXGetProcAddressARB, or a function around
// SDL_GL_GetProcAddress, glfwGetProcAddress or wglGetProcAddress. Called with the context current.
using Procedure = void (*)();
using Loader = Procedure (*)(const char* name);

// Errors: kDeviceFailed where the loader does not find a function that every profile has;
// kInvalidArgument for a null loader.
Result<Functions> LoadFunctions(Loader loader) noexcept;

}  // namespace clipc::runtime::gl
