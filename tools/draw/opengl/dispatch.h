// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <string>

#include "tools/draw/inputs.h"

namespace clipc::draw {

// Runs the compute shader for kGroups (tools/draw/dispatch.h), and returns what the storage buffers
// and images hold then, by their names; an image has four words for each texel, of which the last
// ones are 0 where it has fewer. OpenGL ES reads no textures back: then only buffers are there. A
// context that VersionOf(compute) names must be current.
std::map<std::string, Bytes> Dispatch(const std::string& compute, const Inputs& inputs);

}  // namespace clipc::draw
