// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"
#include "tools/draw/random_inputs.h"
#include "tools/draw/vulkan/run.h"
#include "tools/peer/relocate.h"

// The peer's shader in terms of clipc's program.
namespace clipc::draw::peer {

struct Module {
  std::string hlsl;
  Spirv declared;  // with all that the shader declares
  Spirv run;       // without what it does not use
  std::vector<PeerBlock> blocks;
  std::vector<PeerElements> elements;
  std::vector<Vector> inputs, outputs;
};

// The peer's vector for each input or output; null where the peer has none. Vectors are found by
// their semantic. Those without one (glslang does not pass the semantic of a struct on to its
// fields) are taken in the order of declaration if their number is that of the inputs or outputs
// left.
std::vector<const Vector*> Match(const std::vector<ir::IoVar>& list,
                                 const std::vector<Vector>& vectors);

// A draw call with the values of `random` in the places where the peer's shader reads them.
DrawCall MakeDrawCall(const ir::Program& program, const Module& module, const RandomInputs& random,
                      const RandomOptions& draw);

// The captured values of the peer's outputs, in the order of program.outputs. An output that the
// peer does not write has no words.
std::vector<Captured> PickOutputs(const ir::Program& program, const Module& module,
                                  const std::vector<Output>& outputs,
                                  const std::vector<Captured>& captured);

}  // namespace clipc::draw::peer
