// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "base/not_copied.h"
#include "runtime/gl/functions.h"

// OpenGL without a display, for tests and examples.
namespace clipc::harness {

// The error of a machine or an input that does not allow what a tool does. The tool ends with its
// message; it never skips.
class DrawError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// kCore and kCompatibility: OpenGL 4.5 of that profile. kEs: OpenGL ES 3.2.
enum class Api { kCore, kCompatibility, kEs };

// Mesa's software OpenGL through EGL's surfaceless platform, which needs neither an environment
// variable nor a device file. There is one context for each Api, made at the first Use. Throws
// DrawError where the machine does not have one.
class OpenGl : NotCopied {
 public:
  OpenGl();
  explicit OpenGl(Api api) : OpenGl() { Use(api); }
  ~OpenGl();

  // Makes that context current: the functions of <epoxy/gl.h> work on it from then on.
  void Use(Api api);

  // The address of an OpenGL function, for clipc::runtime::gl::LoadFunctions.
  static runtime::gl::Procedure Load(const char* name);

 private:
  void* display_ = nullptr;
  std::map<Api, void*> contexts_;
};

// Throws DrawError with `where` when OpenGL has noted an error.
void CheckErrors(const std::string& where);

}  // namespace clipc::harness
