// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "pixel/meet.h"

namespace clipc::pixel {

// The first half of Meet: its outputs and zeros.
Meeting MeetInputs(const ir::Program& program, const Interface& pixel, const MeetOptions& options,
                   Diagnostics& diagnostics);

// The other half of Meet: its buffers.
std::vector<Meeting::Buffer> MeetBlocks(const ir::Program& program, const Interface& pixel,
                                        const MeetOptions& options, Diagnostics& diagnostics);

}  // namespace clipc::pixel
