// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "compiler/compile/request.h"
#include "link/read.h"

namespace clipc {

// Reads the interface of the request's neighbour, and what keeps the program from fitting it.
// Appends the files that were read to `dependencies`.
link::ReadResult ReadNeighbour(const ProgramRequest& request,
                               std::vector<std::string>& dependencies);

}  // namespace clipc
