// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::draw::vulkan {

// Throws DrawError where the program uses something that lavapipe of Mesa 22.3 gets wrong:
// - in an array of arrays of textures or buffers it takes the last index for the element's number;
// - a gather with four offsets reads the first texture of the set, whichever it was asked for.
void RefuseDriverBugs(const ir::Program& program);

}  // namespace clipc::draw::vulkan
