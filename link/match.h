// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "ir/program.h"
#include "link/interface.h"

// The matching of a vertex shader with a pixel shader: of outputs with inputs, and of constant
// buffers.
namespace clipc::link {

struct MatchOptions {
  bool keep_outputs = false;  // outputs that the pixel shader does not read are kept
  // Vulkan matches every input that is declared, also one that is never read, and lets blocks of
  // one name differ (chapter "Shader Interfaces").
  bool is_vulkan = false;
  bool zero_unwritten = false;  // inputs that the pixel shader reads and nothing writes are 0
  bool is_es = false;           // precisions are a part of declarations
};

// The input that each output matches, and the block that each constant buffer is in the pixel
// shader.
struct Matches {
  struct Output {
    std::optional<std::size_t> input;  // in Interface::inputs
    std::uint32_t element = 0;         // the column or element of the input
  };
  std::vector<Output> outputs;  // beside program.outputs
  // Inputs that nothing writes and that become 0, by their numbers in Interface::inputs; for Vulkan
  // also those outside groups that nothing reads.
  std::vector<std::size_t> zeros;
  struct Buffer {
    std::optional<std::size_t> block;  // in Interface::blocks
    bool is_loose = false;             // its members are in Interface::uniforms
    // The precisions of the members, or of the fields of a ConstantBuffer<T>, in their order.
    std::vector<ir::Precision> precisions = {};
  };
  std::vector<Buffer> buffers;  // by CbufferId
};

// Finds the outputs and the constant buffers that the pixel shader's inputs and blocks match.
// Inputs with a semantic match the output of that semantic, or of their [[vk::location]]. Others
// match, in this order of belief, an output whose semantic or member of a struct their name was
// made of by DXC, glslang, SPIRV-Cross or HLSLcc, the output of their location, or the outputs that
// are left, in their order, if those are as many and of the same types. Reports an input that
// nothing writes (as a warning with MatchOptions::zero_unwritten), types that cannot fit, and a
// constant buffer that both declare with different members. Requires Form::kResolved.
Matches Match(const ir::Program& program, const Interface& pixel, const MatchOptions& options,
              Diagnostics& diagnostics);

// Gives the outputs and constant buffers the names, places and shapes of the inputs and blocks that
// they match. Removes the outputs that match nothing, unless they are built in or
// MatchOptions::keep_outputs is set. Requires matches without errors. Requires and ensures
// Form::kResolved.
void Apply(ir::Program& program, const Interface& pixel, const Matches& matches,
           const MatchOptions& options);

}  // namespace clipc::link
