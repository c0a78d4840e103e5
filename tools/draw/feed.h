// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/write.h"
#include "ir/program.h"
#include "tools/draw/inputs.h"
#include "tools/draw/random_inputs.h"

namespace clipc::draw {

// The bits of the float that an int or uint converts to. GLSL 1.20 has no attributes and varyings
// of ints: they are passed as floats.
std::uint32_t AsFloat(std::uint32_t word, ir::Scalar kind);

// The inputs that `random` holds, under the names that the written shader gives them. The result
// refers to the arguments.
Inputs MakeInputs(const ir::Program& program, const GlslInfo& info, const RandomInputs& random,
                  const RandomOptions& draw);

}  // namespace clipc::draw
