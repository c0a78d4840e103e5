// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/stage.h"

namespace clipc::ir {

// The feature level 9 of a profile such as vs_4_0_level_9_1.
// NOLINTNEXTLINE(readability-identifier-naming)
enum class Level9 : std::uint8_t { kNone, k9_0, k9_1, k9_3 };

// A compilation target of fxc or dxc.
struct Profile {
  std::string name = "vs_5_0";                  // as written, lower case
  std::optional<Stage> stage = Stage::kVertex;  // none: one that clipc does not read
  int major = 5;
  int minor = 0;
  Level9 level9 = Level9::kNone;

  // The word for the stage, also for one that clipc does not read: "vs", "ms", "lib".
  std::string_view Prefix() const { return std::string_view(name).substr(0, name.find('_')); }
  // Whether the profile is of the older dialect: vs_1_1, vs_2_0, vs_2_a or vs_3_0.
  bool IsDirect3D9() const { return major < 4; }
  bool IsAtLeast(int want_major, int want_minor) const {
    return major > want_major || (major == want_major && minor >= want_minor);
  }
  // Whether the profile has what came with shader model `first`, 41 for 4.1.
  bool HasModel(int first) const { return IsAtLeast(first / 10, first % 10); }
};

// Reads the name of a profile, "vs_4_0_level_9_1" or the like, in any case. Returns nullopt for a
// name that neither compiler accepts.
std::optional<Profile> ParseProfile(std::string_view name);
// The names of the stage's profiles that either compiler accepts, in the order of their versions.
std::vector<std::string> ProfilesOf(Stage stage);

}  // namespace clipc::ir
