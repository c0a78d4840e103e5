// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <vector>

#include "compiler/compile/job.h"
#include "ir/program.h"

namespace clipc {

// Gives the domain shaders of a program how their patches are cut and joined, which HLSL has in the
// hull shader: that of the program, else the request, else the hull shaders of the file, else what
// is assumed, with a warning. Reports a hull and a domain shader that do not fit together.
void FitTessellation(std::span<Job> jobs, std::vector<ir::Program>& programs);

}  // namespace clipc
