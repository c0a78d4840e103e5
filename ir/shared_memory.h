// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "ir/program.h"

namespace clipc::ir {

// The bytes of the memory that a group shares, as Direct3D counts them: those of the components of
// all variables of Storage::kShared, without padding.
std::uint64_t SharedBytes(const Program& program);

}  // namespace clipc::ir
