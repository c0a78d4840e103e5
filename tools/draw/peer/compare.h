// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <set>
#include <string>

#include "tools/draw/compare.h"
#include "tools/draw/peer/layout.h"
#include "tools/draw/vulkan/run.h"

// The same HLSL through another compiler.
namespace clipc::draw::peer {

struct PeerComparison {
  Comparison values;
  LayoutComparison layout;
  std::set<std::string> known_bugs;  // that `values` was compared with, and that `layout` shows
};

// Compiles the shader with glslang's HLSL front end, runs it on Vulkan with the same vertices and
// constants, and holds every output against what must come out; and where the constants lie against
// where clipc has them. The shader must have been built without clip distances and in Direct3D's
// clip space, which is what the peer writes. The draw call must start at 0.
PeerComparison CompareWithGlslang(const vulkan::Runner& runner, const Shader& shader,
                                  const BuildOptions& options, const RandomOptions& draw,
                                  const Tolerance& tolerance);

}  // namespace clipc::draw::peer
