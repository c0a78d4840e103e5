// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/image_format.h"

#include <algorithm>
#include <iterator>

namespace clipc::spirv {
namespace {

// In the order of SPIR-V's enumerators, section 3.11 of its specification.
constexpr std::string_view kNames[] = {"",          "rgba32f",      "rgba16f",
                                       "r32f",      "rgba8",        "rgba8_snorm",
                                       "rg32f",     "rg16f",        "r11f_g11f_b10f",
                                       "r16f",      "rgba16",       "rgb10_a2",
                                       "rg16",      "rg8",          "r16",
                                       "r8",        "rgba16_snorm", "rg16_snorm",
                                       "rg8_snorm", "r16_snorm",    "r8_snorm",
                                       "rgba32i",   "rgba16i",      "rgba8i",
                                       "r32i",      "rg32i",        "rg16i",
                                       "rg8i",      "r16i",         "r8i",
                                       "rgba32ui",  "rgba16ui",     "rgba8ui",
                                       "r32ui",     "rgb10_a2ui",   "rg32ui",
                                       "rg16ui",    "rg8ui",        "r16ui",
                                       "r8ui"};

}  // namespace

spv::ImageFormat FormatOf(std::string_view name) {
  const auto* found = std::ranges::find(kNames, name);
  if (found == std::end(kNames)) return spv::ImageFormat::Unknown;
  return static_cast<spv::ImageFormat>(found - std::begin(kNames));
}

bool IsBasic(spv::ImageFormat format) {
  using enum spv::ImageFormat;
  switch (format) {
    case Rgba32f:
    case Rgba16f:
    case R32f:
    case Rgba8:
    case Rgba8Snorm:
    case Rgba32i:
    case Rgba16i:
    case Rgba8i:
    case R32i:
    case Rgba32ui:
    case Rgba16ui:
    case Rgba8ui:
    case R32ui: return true;
    default: return false;
  }
}

}  // namespace clipc::spirv
