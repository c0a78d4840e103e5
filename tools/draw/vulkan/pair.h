// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/draw/pair.h"
#include "tools/draw/vulkan/spirv.h"

namespace clipc::draw::vulkan {

struct SpirvPair {
  Spirv vertex, fragment;
};

struct PairResult {
  PairDifference difference;
  std::vector<std::string> messages;  // of the validation layers, about the first program
};

// Draws a mesh over the whole target with both programs and compares the images, while Vulkan's
// validation layers watch. Both get the same vertices by location, and the same bytes and texels by
// set and binding. Throws DrawError where a program reads what it cannot be given: arrays of
// blocks or textures, storage.
PairResult CompareImages(const SpirvPair& first, const SpirvPair& second);

// Makes a pipeline of each pair, while the validation layers watch. Returns for each what they and
// the driver say of it: nothing where locations, types and bindings of the two shaders fit.
std::vector<std::string> LinkPrograms(std::span<const SpirvPair> pairs);

// The name of the device that draws pairs. Throws NoDevice where there is none, or no validation
// layers.
std::string PairDeviceName();

}  // namespace clipc::draw::vulkan
