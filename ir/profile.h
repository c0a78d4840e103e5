// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace clipc::ir {

// The feature level 9 of a profile such as vs_4_0_level_9_1.
// NOLINTNEXTLINE(readability-identifier-naming)
enum class Level9 : std::uint8_t { kNone, k9_0, k9_1, k9_3 };

// A compilation target of fxc or dxc. Only the profiles of vertex shaders compile; those of pixel
// shaders are read for what a vertex shader must fit, and a message names the others.
struct Profile {
  std::string name = "vs_5_0";  // as written, lower case
  std::string stage = "vs";
  int major = 5;
  int minor = 0;
  Level9 level9 = Level9::kNone;

  bool IsVertex() const { return stage == "vs"; }
  bool IsPixel() const { return stage == "ps"; }
  // Whether the profile is of the older dialect: vs_1_1, vs_2_0, vs_2_a or vs_3_0.
  bool IsDirect3D9() const { return major < 4; }
  bool IsAtLeast(int want_major, int want_minor) const {
    return major > want_major || (major == want_major && minor >= want_minor);
  }
};

// Reads the name of a profile, "vs_4_0_level_9_1" or the like, in any case. Returns nullopt for a
// name that neither compiler takes.
std::optional<Profile> ParseProfile(std::string_view name);

}  // namespace clipc::ir
