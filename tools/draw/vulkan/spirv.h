// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/draw/inputs.h"

// Shaders in SPIR-V. All functions throw DrawError where SPIRV-Cross cannot read the shader.
namespace clipc::draw::vulkan {

using Spirv = Words;

// Whether a file begins as SPIR-V does, in this machine's order of bytes.
bool IsSpirv(std::string_view bytes);
Spirv SpirvOfBytes(std::string_view bytes);

// A variable that a shader writes, or a member of its gl_PerVertex.
struct Output {
  // The name in the text that the shader was compiled from; "gl_Position" and the like for built-in
  // outputs.
  std::string name;
  std::string semantic;                   // of the HLSL, if the compiler wrote it down: "TEXCOORD3"
  std::optional<std::uint32_t> location;  // none: built in
  WordLayout layout;
  int count = 1;                         // elements of an array
  std::uint32_t variable = 0, type = 0;  // ids
  std::optional<std::uint32_t> member;   // of gl_PerVertex

  int Words() const { return layout.Words() * count; }
};
std::vector<Output> OutputsOf(const Spirv& spirv);

Stage StageOf(const Spirv& spirv);
// The name of the shader's entry point.
std::string EntryPointOf(const Spirv& spirv);

enum class DescriptorKind {
  kUniforms,
  kStorage,
  kTexture,
  kSampler,
  kTextureWithSampler,
  kTexels,
  kImage,
  kImageTexels,
};

// The variables that the shader reads.
struct Reads {
  struct Binding {
    std::string name;  // of the variable, or of a block without an instance
    std::uint32_t set, binding;
    DescriptorKind kind;
    bool is_array = false;
    std::uint32_t elements = 1;  // of all dimensions; 0: an array without a size
    std::size_t bytes = 0;       // of kUniforms
  };
  struct Attribute {
    std::string name, semantic;  // as those of an output
    std::uint32_t location;
    std::uint32_t locations;  // their number: elements of arrays and columns of matrices
    WordLayout layout;        // of one element; of a block or a struct, nothing
  };
  std::vector<Binding> bindings;
  std::vector<Attribute> attributes;
};
Reads ReadsOf(const Spirv& spirv);

// The geometry or domain shader, changed to give points in place of strips or triangles.
Spirv WithPoints(Spirv spirv);

// The hull shader, changed to give its factors as data, and so many segments to a tessellator of
// lines (tools/draw/pass_patch.h).
Spirv WithFactorsAsData(const Spirv& spirv, std::uint32_t segments);

// The place where transform feedback writes an output.
struct FeedbackSlot {
  std::uint32_t buffer = 0, offset = 0;  // in bytes
};

// The shader, changed to write outputs[i] to places[i] of every vertex's part of the buffer. A part
// has strides[buffer] bytes.
Spirv WithTransformFeedback(const Spirv& spirv, std::span<const Output> outputs,
                            std::span<const FeedbackSlot> places,
                            std::span<const std::uint32_t> strides);

}  // namespace clipc::draw::vulkan
