// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/gl/functions.h"

namespace clipc::runtime::gl {
namespace {

template <typename Function>
void Load(Loader loader, const char* name, Function& function) {
  function = reinterpret_cast<Function>(loader(name));
}

}  // namespace

Result<Functions> LoadFunctions(Loader loader) noexcept {
  if (loader == nullptr)
    return Status::Failure(Error::kInvalidArgument, "no loader of OpenGL functions");
  Functions gl;
  Load(loader, "glEnable", gl.Enable);
  Load(loader, "glDisable", gl.Disable);
  Load(loader, "glIsEnabled", gl.IsEnabled);
  Load(loader, "glGetIntegerv", gl.GetIntegerv);
  if (!gl.Enable || !gl.Disable || !gl.IsEnabled || !gl.GetIntegerv) {
    return Status::Failure(
        Error::kDeviceFailed,
        "the loader does not find glEnable, glDisable, glIsEnabled or glGetIntegerv");
  }
  Load(loader, "glClipPlane", gl.ClipPlane);
  Load(loader, "glGetClipPlane", gl.GetClipPlane);
  Load(loader, "glMatrixMode", gl.MatrixMode);
  Load(loader, "glPushMatrix", gl.PushMatrix);
  Load(loader, "glPopMatrix", gl.PopMatrix);
  Load(loader, "glLoadIdentity", gl.LoadIdentity);
  return gl;
}

}  // namespace clipc::runtime::gl
