// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>

// Generated shaders to measure with, of any size. Equal arguments give equal text.
namespace clipc::bench {

// A vertex shader of about 60 lines: transform, light, fog, texture coordinates, two clip planes.
// Different seeds give different constants and names.
std::string SixtyLineShader(unsigned seed);

// A SixtyLineShader and a pixel shader, `pixel`, that reads its outputs.
std::string SixtyLinePair(unsigned seed);

// A shader of at least `bytes` bytes of functions and statements, all reached from main.
std::string LargeShader(std::size_t bytes);

}  // namespace clipc::bench
