// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/program.h"

// Vertex shaders in SPIR-V. What SPIRV-Cross cannot read is a DrawError.
namespace clipc::draw::vulkan {

using Spirv = std::vector<std::uint32_t>;

// A variable that a vertex shader writes, or a member of its gl_PerVertex.
struct Output {
  std::string name;  // in the text that it was compiled from; "gl_Position" and its like for what
                     // is built in
  std::string semantic;  // as HLSL has it, if the compiler wrote that down: "TEXCOORD3"
  std::optional<std::uint32_t> location;  // none: built in
  Shape shape;
  int count = 1;                         // elements of an array
  std::uint32_t variable = 0, type = 0;  // ids
  std::optional<std::uint32_t> member;   // of gl_PerVertex

  int Words() const { return shape.Words() * count; }
};
std::vector<Output> OutputsOf(const Spirv& spirv);

// The name of its entry point.
std::string EntryPointOf(const Spirv& spirv);

// What the shader reads.
struct Reads {
  struct Binding {
    std::string name;  // of the variable, or of a block without an instance
    std::uint32_t set, binding;
  };
  struct Attribute {
    std::string name, semantic;  // as those of an output
    std::uint32_t location;
    std::uint32_t locations;  // how many it takes: elements of arrays and columns of matrices
  };
  std::vector<Binding> bindings;
  std::vector<Attribute> attributes;
};
Reads ReadsOf(const Spirv& spirv);

// Where transform feedback is to write an output.
struct Place {
  std::uint32_t buffer = 0, offset = 0;  // in bytes
};

// The shader that writes outputs[i] to places[i] of every vertex's part of the buffer,
// `strides[buffer]` bytes long.
Spirv WithTransformFeedback(const Spirv& spirv, std::span<const Output> outputs,
                            std::span<const Place> places, std::span<const std::uint32_t> strides);

}  // namespace clipc::draw::vulkan
