// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <set>

#include "ir/program.h"

namespace clipc::ir {

// The bytes of the memory that a group shares, as Direct3D counts them: those of the components of
// all variables of Storage::kShared, without padding.
std::uint64_t SharedBytes(const Program& program);

// The variables of Storage::kShared with floats that atomic operations change.
std::set<VarId> ExchangedFloats(const Program& program);

}  // namespace clipc::ir
