// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/check/context.h"
#include "frontend/resolve/registers.h"

namespace clipc::check {

// The registers that are written on objects and buffers which nothing reached uses. fxc and dxc
// leave them alone when they choose registers: vkd3d's register-reservations-resources.shader_test,
// checked against both. Reports type arguments of theirs that no object has.
std::vector<ReservedRegisters> RegistersOfUnused(Context& context);

// Adds the objects and constant buffers that nothing reached to the program, as if it read them.
void ReachAllBindings(Context& context);

}  // namespace clipc::check
