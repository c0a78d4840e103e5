// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/draw/vulkan/run.h"
#include "tools/draw/vulkan/spirv.h"

// The interface of a shader that another compiler made, in terms of the HLSL: semantics, names of
// buffers, names of members.
namespace clipc::draw::reference_compiler {

using vulkan::DescriptorKind;
using vulkan::DrawCall;
using vulkan::Output;
using vulkan::Reads;
using vulkan::Runner;
using vulkan::Spirv;

using Offsets = std::vector<std::uint32_t>;  // in bytes, of the components of a value

// A cbuffer, tbuffer or ConstantBuffer.
struct ReferenceBlock {
  std::string name;
  std::uint32_t size = 0;
  bool is_storage = false;  // a tbuffer
  // By the member's name, the byte of each of its components, in the order of the value: elements,
  // fields, and of a matrix row after row of the HLSL matrix.
  std::map<std::string, Offsets> members;
};
std::vector<ReferenceBlock> BlocksOf(const Spirv& spirv);

// A StructuredBuffer.
struct ReferenceElements {
  std::string name;
  std::uint32_t stride = 0;
  Offsets bytes;  // of an element's components, in the order of the value
};
std::vector<ReferenceElements> ElementsOf(const Spirv& spirv);

// A vector that the shader reads or writes. An array counts as one vector for each element, a
// matrix as one for each row.
struct Vector {
  std::string key;  // KeyOf(its semantic, its index); empty without a semantic
  std::uint32_t location;
};
// "TEXCOORD3": a semantic with its index, in the spelling that they are compared by.
std::string KeyOf(const std::string& semantic, std::uint32_t index);
// The inputs and outputs of a module with all that the shader declares: where no variable was left
// out, elements of arrays can be counted.
std::vector<Vector> InputsOf(const Spirv& declared);
std::vector<Vector> OutputsOf(const Spirv& declared);

}  // namespace clipc::draw::reference_compiler
