// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/build.h"
#include "tools/draw/random_inputs.h"
#include "tools/draw/reference.h"

// The dispatch of a compute shader, whose outputs are the buffers and images that it may write.
namespace clipc::draw {

// The groups in x, y and z.
inline constexpr std::array<std::uint32_t, 3> kGroups = {3, 2, 1};

// One component of each element of a buffer, or of each texel of an image.
struct MemoryPart {
  std::string name;    // "items.2": of component 2
  std::string object;  // in the GLSL: "items", "items[1]"
  ir::VarId var;
  std::size_t element = 0;  // of an array of objects
  bool is_image = false;
  ir::Scalar kind = ir::Scalar::kUint;
  std::uint32_t first = 0, stride = 4;  // bytes
};
// The parts of the memory that the shader may write.
std::vector<MemoryPart> WrittenParts(const Shader& shader, const RandomInputs& inputs);
// The words of the part, of the buffer's bytes.
Words WordsIn(const Bytes& buffer, const MemoryPart& part);

// The texels of an image as WordsIn takes them: four words each, of which the last ones are 0 where
// it has fewer.
Bytes MemoryOfTexels(const Inputs::Texture& image, std::span<const std::uint32_t> words);
// The parts of what a driver left in the memory, which is known by its objects' names.
std::vector<Captured> CapturedMemory(const Shader& shader, const RandomInputs& inputs,
                                     const std::map<std::string, Bytes>& memory);

// What each part must hold after the dispatch. What depends on which thread or which group was
// first is open. Throws DrawError where threads race for the memory that a group shares: then the
// program means nothing.
std::vector<Expected> ExpectedOfDispatch(const Shader& shader, const RandomInputs& inputs);

}  // namespace clipc::draw
