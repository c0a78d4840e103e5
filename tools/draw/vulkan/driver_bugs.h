// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "ir/program.h"

namespace clipc::draw::vulkan {

// Throws DrawError where the program has a gather with four offsets: lavapipe of Mesa 22.3 reads
// the first texture of the set, whichever it was asked for.
void RefuseDriverBugs(const ir::Program& program);

}  // namespace clipc::draw::vulkan
