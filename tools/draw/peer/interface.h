// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"
#include "tools/draw/peer/layout.h"
#include "tools/draw/random_inputs.h"
#include "tools/draw/vulkan/run.h"

// The peer's shader in terms of clipc's program.
namespace clipc::draw::peer {

struct Module {
  std::string hlsl;
  vulkan::Spirv declared, run;  // with all that the shader declares; what is to be run
  std::vector<Block> blocks;
  std::vector<Elements> elements;
  std::vector<Vector> inputs, outputs;
};

// The peer's vector for each input or output; null where it has none. By the semantic; those that
// have none, as glslang does not pass the semantic of a struct on to its fields, in the order of
// declaration if as many are left.
std::vector<const Vector*> Match(const std::vector<ir::IoVar>& list,
                                 const std::vector<Vector>& vectors);

// `random` where the peer's shader reads it.
vulkan::DrawCall MakeDrawCall(const ir::Program& program, const Module& module,
                              const RandomInputs& random, const RandomOptions& draw);

// What was captured of the peer's outputs, beside program.outputs; without words what it does not
// write.
std::vector<Captured> PickOutputs(const ir::Program& program, const Module& module,
                                  const std::vector<vulkan::Output>& outputs,
                                  const std::vector<Captured>& captured);

}  // namespace clipc::draw::peer
