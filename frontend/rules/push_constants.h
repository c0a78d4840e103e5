// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/names.h"

namespace clipc::rules {

// Checks the buffers that are [[vk::push_constant]]: at most one, a struct or a cbuffer, whose
// members Direct3D's packing, which clipc keeps, puts where Vulkan expects them. Vulkan's packing
// is DXC's default for push constants, std430 in which a vector is aligned as its component unless
// it would cross 16 bytes ("Memory layout rules" in DXC's docs/SPIR-V.rst). [[vk::offset]] holds
// for both packings.
void CheckPushConstants(const Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
