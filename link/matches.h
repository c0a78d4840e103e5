// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program.h"

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

}  // namespace clipc::link
