// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "ir/program.h"
#include "link/interface.h"
#include "link/matches.h"

namespace clipc::link {

// The first half of Match: its outputs and zeros.
Matches MatchInputs(const ir::Program& program, const Interface& pixel, const MatchOptions& options,
                    Diagnostics& diagnostics);

// The other half of Match: its buffers.
std::vector<Matches::Buffer> MatchBlocks(const ir::Program& program, const Interface& pixel,
                                         const MatchOptions& options, Diagnostics& diagnostics);

}  // namespace clipc::link
