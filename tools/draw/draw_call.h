// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/build.h"
#include "tools/draw/random_values.h"

namespace clipc::draw {

// Sets several instances if the shader can tell them apart.
void ChooseInstances(const Shader& shader, RandomOptions& draw);

// Sets the instances as ChooseInstances does, and lets the draw call start after vertex and
// instance 0 if the shader and its target allow that.
void ChooseDraw(const Shader& shader, RandomOptions& draw);

}  // namespace clipc::draw
