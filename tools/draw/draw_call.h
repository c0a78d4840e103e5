// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/build.h"
#include "tools/draw/random_values.h"

namespace clipc::draw {

// More than one instance, for a shader that can tell them apart.
void ChooseInstances(const Shader& shader, RandomOptions& draw);

// A draw call in the middle of its vertices and instances, where the shader is said to stand that.
void ChooseDraw(const Shader& shader, RandomOptions& draw);

}  // namespace clipc::draw
