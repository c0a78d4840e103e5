// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <set>
#include <string>

#include "tools/draw/compare.h"
#include "tools/draw/vulkan/run.h"

// Comparing with what another compiler makes of the same HLSL.
namespace clipc::draw::reference_compiler {

struct ReferenceComparison {
  Comparison values;
  std::set<std::string> known_bugs;  // that explain differences, or leave nothing to compare
};

// Compiles the shader with glslang's HLSL front end, runs it on Vulkan with the same vertices and
// constants, and compares every output with the expected one. The shader must have been built
// without clip distances and in Direct3D's clip space, which is what the reference compiler writes.
// The draw call must start at 0.
ReferenceComparison CompareWithGlslang(const vulkan::Runner& runner, const Shader& shader,
                                       const BuildOptions& options, const RandomOptions& draw,
                                       const Tolerance& tolerance);

}  // namespace clipc::draw::reference_compiler
