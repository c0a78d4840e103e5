// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/build.h"
#include "tools/draw/compare.h"
#include "tools/draw/random_values.h"
#include "tools/harness/options.h"

namespace clipc::draw {

// The options of every comparison with the evaluator: how the shader is compiled, its random
// inputs, and by how much values may differ.
harness::options::Flags ComparisonFlags(BuildOptions& build, RandomOptions& random,
                                        Tolerance& tolerance);

}  // namespace clipc::draw
