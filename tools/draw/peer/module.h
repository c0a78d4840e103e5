// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tools/draw/vulkan/spirv.h"

// What another compiler made of a shader, in terms of the HLSL: semantics, names of buffers and
// members.
namespace clipc::draw::peer {

// A cbuffer, tbuffer or ConstantBuffer.
struct Block {
  std::string name;
  std::uint32_t size = 0;
  bool is_storage = false;  // a tbuffer
  // By the member's name, the byte of each of its components, in the order of the value: elements,
  // fields, and of a matrix row after row of the HLSL matrix.
  std::map<std::string, std::vector<std::uint32_t>> members;
};
std::vector<Block> BlocksOf(const vulkan::Spirv& spirv);

// A StructuredBuffer.
struct Elements {
  std::string name;
  std::uint32_t stride = 0;
  std::vector<std::uint32_t> bytes;  // of an element's components, in the order of the value
};
std::vector<Elements> ElementsOf(const vulkan::Spirv& spirv);

// A vector that the shader reads or writes: an array is as many as it has elements, a matrix as it
// has rows.
struct Vector {
  std::string key;  // KeyOf its semantic; empty without one
  std::uint32_t location;
};
// "TEXCOORD3": how a semantic and its index are compared.
std::string KeyOf(const std::string& semantic, std::uint32_t index);
// Of a module with all that the shader declares: where no variable was left out, elements of arrays
// can be counted.
std::vector<Vector> InputsOf(const vulkan::Spirv& declared);
std::vector<Vector> OutputsOf(const vulkan::Spirv& declared);

}  // namespace clipc::draw::peer
