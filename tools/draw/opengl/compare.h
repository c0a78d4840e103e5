// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/compare.h"

namespace clipc::draw {

// Runs the shader on OpenGL and compares its outputs with the expected ones.
Comparison CompareWithOpenGl(harness::OpenGl& opengl, const Trial& trial);

}  // namespace clipc::draw
