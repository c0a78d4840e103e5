// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/profile.h"

#include <algorithm>
#include <ranges>

#include "base/spelling.h"

namespace clipc::ir {
namespace {

// fxc's and dxc's documented targets: a stage's versions before shader model 6, and its first minor
// version of that model, if dxc has it there.
struct Versions {
  std::string_view prefix;
  std::string_view before6;
  int first_minor6 = kLastMinor6 + 1;

  static constexpr int kLastMinor6 = 9;  // the last that a dxc release takes
};
constexpr Versions kVersions[] = {
    {"vs", "1_1 2_0 2_a 2_sw 3_0 3_sw 4_0 4_0_level_9_0 4_0_level_9_1 4_0_level_9_3 4_1 5_0 5_1",
     0},
    {"ps",
     "1_1 1_2 1_3 1_4 2_0 2_a 2_b 2_sw 3_0 3_sw 4_0 4_0_level_9_0 4_0_level_9_1 4_0_level_9_3 4_1 "
     "5_0 5_1",
     0},
    {"gs", "4_0 4_1 5_0 5_1", 0},
    {"hs", "5_0 5_1", 0},
    {"ds", "5_0 5_1", 0},
    {"cs", "4_0 4_1 5_0 5_1", 0},
    {"ms", "", 5},
    {"as", "", 5},
    {"lib", "4_0 4_1 4_0_level_9_1 4_0_level_9_3 5_0 6_x", 1},
    {"fx", "2_0 4_0 4_1 5_0"},
    {"tx", "1_0"},
    {"rootsig", "1_0 1_1 1_2"},
};

bool IsKnown(std::string_view name, std::string_view version) {
  const auto stage = std::ranges::find(kVersions, name, &Versions::prefix);
  if (stage == std::end(kVersions)) return false;
  if (version.size() == 3 && version.starts_with("6_")) {
    const int minor = version[2] - '0';
    if (minor >= stage->first_minor6 && minor <= Versions::kLastMinor6) return true;
  }
  // Whether it is one of the words, whole.
  const std::string_view words = stage->before6;
  const auto ends = [&](std::size_t at) { return at == words.size() || words[at] == ' '; };
  for (std::size_t at = words.find(version); at != words.npos; at = words.find(version, at + 1)) {
    if ((at == 0 || words[at - 1] == ' ') && ends(at + version.size())) return !version.empty();
  }
  return false;
}

// vs_2_a and vs_2_sw are versions of 2.0; lib_6_x is a library of any shader model 6.
int MinorOf(char letter) {
  if (letter == 'x') return 15;
  return letter >= '0' && letter <= '9' ? letter - '0' : 0;
}

Level9 Level9Of(const std::string& lower) {
  if (lower.ends_with("level_9_0")) return Level9::k9_0;
  if (lower.ends_with("level_9_1")) return Level9::k9_1;
  return lower.ends_with("level_9_3") ? Level9::k9_3 : Level9::kNone;
}

}  // namespace

std::optional<Profile> ParseProfile(std::string_view name) {
  const std::string lower = ToLower(name);
  const std::size_t stage = std::min(lower.find('_'), lower.size() - 1);
  if (lower.empty() || !IsKnown(lower.substr(0, stage), lower.substr(stage + 1)))
    return std::nullopt;
  return Profile{.name = lower,
                 .stage = StageOf(lower.substr(0, stage)),
                 .major = lower[stage + 1] - '0',
                 .minor = MinorOf(lower[stage + 3]),
                 .level9 = Level9Of(lower)};
}

std::vector<std::string> ProfilesOf(Stage stage) {
  const std::string prefix(InfoOf(stage).prefix);
  const auto& versions = *std::ranges::find(kVersions, prefix, &Versions::prefix);
  std::vector<std::string> names;
  for (const auto version : std::views::split(versions.before6, ' '))
    names.push_back(prefix + "_" + std::string(version.begin(), version.end()));
  for (int minor = versions.first_minor6; minor <= Versions::kLastMinor6; ++minor)
    names.push_back(prefix + "_6_" + std::to_string(minor));
  return names;
}

}  // namespace clipc::ir
