// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "ir/program.h"
#include "pixel/interface.h"

// Where a vertex shader and a pixel shader meet.
namespace clipc::pixel {

struct MeetOptions {
  bool keep_outputs = false;  // also those that the pixel shader does not read
  // Vulkan matches every input that is declared, also one that is never read, and lets blocks of
  // one name differ (chapter "Shader Interfaces").
  bool is_vulkan = false;
  bool zero_unwritten = false;  // what the pixel shader reads and nothing writes is 0
  bool is_es = false;           // precisions are a part of declarations
};

// Which input each output meets, and what each constant buffer is there.
struct Meeting {
  struct Output {
    std::optional<std::size_t> input;  // in Interface::inputs
    std::uint32_t element = 0;         // the column or element of it
  };
  std::vector<Output> outputs;  // beside program.outputs
  // Inputs that nothing writes and that are 0 therefore; of Vulkan also those that nothing reads.
  std::vector<std::size_t> zeros;
  struct Buffer {
    std::optional<std::size_t> block;  // in Interface::blocks
    bool is_loose = false;             // its members are in Interface::uniforms
    // Beside the members, or the fields of a ConstantBuffer<T>.
    std::vector<ir::Precision> precisions = {};
  };
  std::vector<Buffer> buffers;  // by CbufferId
};

// Inputs with a semantic meet the output of that semantic. Others meet, in this order of belief, an
// output whose semantic or member of a struct their name was made of by DXC, glslang, SPIRV-Cross
// or HLSLcc, the output of their location, or the only one that is left of their type. Reports an
// input that nothing writes (as a warning with MeetOptions::zero_unwritten), types that cannot
// fit, and a constant buffer that both declare with different members. Requires Form::kTyped.
Meeting Meet(const ir::Program& program, const Interface& pixel, const MeetOptions& options,
             Diagnostics& diagnostics);

// Gives the outputs and constant buffers the names, places and shapes of what they meet, and
// removes the outputs that meet nothing. Requires a meeting without errors. Requires and ensures
// Form::kTyped.
void Apply(ir::Program& program, const Interface& pixel, const Meeting& meeting,
           const MeetOptions& options);

}  // namespace clipc::pixel
