// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Generated shaders to measure with, of any size. Equal arguments give equal text.
namespace clipc::bench {

// The text with the number in the place of each `@`.
std::string Numbered(std::string_view text, int number);

// A vertex shader of about 60 lines: transform, light, fog, texture coordinates, two clip planes.
// Different seeds give different constants and names.
std::string SixtyLineShader(unsigned seed);

// A SixtyLineShader and a pixel shader, `pixel`, that reads its outputs.
std::string SixtyLinePair(unsigned seed);

// A compute shader of about 60 lines, `sum`: a tile of texels in groupshared memory, a weighted sum
// over it, a histogram by atomic operations, and a store.
std::string SixtyLineGroup(unsigned seed);

// An effect of Direct3D 9 with 50 passes: each of kEffectVertexShaders, `VS0` and so on, with each
// of kEffectPixelShaders, `PS0` and so on.
inline constexpr int kEffectVertexShaders = 10, kEffectPixelShaders = 5;
std::string FiftyPasses();

// A shader of at least `bytes` bytes of functions and statements, all reached from main.
std::string LargeShader(std::size_t bytes);

}  // namespace clipc::bench
