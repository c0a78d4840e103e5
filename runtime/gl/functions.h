// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../status.h"

/// The OpenGL functions that clip planes need, declared without an OpenGL header and called without
/// linking an OpenGL library.
namespace clipc::runtime::gl {

#if defined(_WIN32)
#define CLIPC_GL_API __stdcall
#else
#define CLIPC_GL_API
#endif

/// OpenGL's values. GL_CLIP_PLANEi of the compatibility profile has the value of GL_CLIP_DISTANCEi.
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
  /// Functions of the compatibility profile; null in other contexts.
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

/// Finds the address of a function such as "glEnable": eglGetProcAddress, glXGetProcAddressARB, or
/// a function that calls SDL_GL_GetProcAddress, glfwGetProcAddress or wglGetProcAddress. Called
/// with the context current.
using Procedure = void (*)();
using Loader = Procedure (*)(const char* name);

/// Loads every function. Errors: kDeviceFailed if the loader does not find a function that every
/// profile has; kInvalidArgument for a null loader.
Result<Functions> LoadFunctions(Loader loader) noexcept;

}  // namespace clipc::runtime::gl
