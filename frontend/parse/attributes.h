// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>

// The attributes of HLSL by name. The case of the letters does not matter.
namespace clipc {

inline constexpr std::string_view kClipPlanesAttribute = "clipplanes";

enum class AttributeMeaning : std::uint8_t {
  kUnknown,
  kClipPlanes,
  kLikeClipPlanes,  // unknown, and spelled nearly like `clipplanes`
  // A hint to an optimiser, or a property that only other stages have: clipc does what it asks for
  // by compiling the shader.
  kKnown,
  // What it asks for, a place in a pipeline layout for example, is lost in GLSL.
  kWithoutEffect,
};
AttributeMeaning MeaningOfAttribute(std::string_view name);

}  // namespace clipc
