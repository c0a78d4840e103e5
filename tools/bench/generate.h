// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>

// Shaders to measure with: made, so that any size can be had, and the same text for the same
// arguments.
namespace clipc::bench {

// About 60 lines of what vertex shaders do: transform, light, fog, texture coordinates, two clip
// planes. `seed` changes constants and names, so that no two are equal.
std::string SixtyLineShader(unsigned seed);

// At least `bytes` of functions and statements, all reached from main.
std::string LargeShader(std::size_t bytes);

}  // namespace clipc::bench
