// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "ir/program.h"
#include "tools/draw/random_inputs.h"
#include "tools/draw/vulkan/run.h"
#include "tools/reference-compiler/relocate.h"

// The reference compiler's shader in terms of clipc's program.
namespace clipc::draw::reference_compiler {

struct Module {
  std::string hlsl;
  Spirv declared;  // with all that the shader declares
  Spirv run;       // without what it does not use
  std::vector<ReferenceBlock> blocks;
  std::vector<ReferenceElements> elements;
  std::vector<Vector> inputs, outputs;
};

// The reference compiler's vector for each input or output; null where the reference compiler has
// none. Vectors are found by their semantic. Those without one (glslang does not pass the semantic
// of a struct on to its fields) are taken in the order of declaration if their number is that of
// the inputs or outputs left.
std::vector<const Vector*> Match(const ir::IoVars& list, const std::vector<Vector>& vectors);

// A draw call with the values of `random` in the places where the reference compiler's shader reads
// them.
DrawCall MakeDrawCall(const ir::Program& program, const Module& module, const RandomInputs& random,
                      const RandomOptions& draw);

// The captured values of the reference compiler's outputs, in the order of program.outputs. An
// output that the reference compiler does not write has no words.
std::vector<Captured> PickOutputs(const ir::Program& program, const Module& module,
                                  const std::vector<Output>& outputs,
                                  const std::vector<Captured>& captured);

}  // namespace clipc::draw::reference_compiler
