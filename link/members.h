// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"
#include "link/interface.h"

namespace clipc::link {

// The members of a constant buffer as GLSL has them: a ConstantBuffer<T> has those of T, and HLSL's
// row_major is column_major.
std::vector<UniformMember> MembersOf(const ir::Program& program, const ir::Cbuffer& cbuffer);

}  // namespace clipc::link
