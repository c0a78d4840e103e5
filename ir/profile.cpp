// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/profile.h"

#include <algorithm>

#include "base/spelling.h"

namespace clipc::ir {
namespace {

// fxc's and dxc's documented targets before shader model 6.
constexpr std::string_view kNames[] = {
    "vs_1_1",
    "vs_2_0",
    "vs_2_a",
    "vs_2_sw",
    "vs_3_0",
    "vs_3_sw",
    "vs_4_0",
    "vs_4_0_level_9_0",
    "vs_4_0_level_9_1",
    "vs_4_0_level_9_3",
    "vs_4_1",
    "vs_5_0",
    "vs_5_1",
    "ps_1_1",
    "ps_1_2",
    "ps_1_3",
    "ps_1_4",
    "ps_2_0",
    "ps_2_a",
    "ps_2_b",
    "ps_2_sw",
    "ps_3_0",
    "ps_3_sw",
    "ps_4_0",
    "ps_4_0_level_9_0",
    "ps_4_0_level_9_1",
    "ps_4_0_level_9_3",
    "ps_4_1",
    "ps_5_0",
    "ps_5_1",
    "gs_4_0",
    "gs_4_1",
    "gs_5_0",
    "gs_5_1",
    "hs_5_0",
    "hs_5_1",
    "ds_5_0",
    "ds_5_1",
    "cs_4_0",
    "cs_4_1",
    "cs_5_0",
    "cs_5_1",
    "lib_4_0",
    "lib_4_1",
    "lib_4_0_level_9_1",
    "lib_4_0_level_9_3",
    "lib_5_0",
    "lib_6_x",
    "fx_2_0",
    "fx_4_0",
    "fx_4_1",
    "fx_5_0",
    "tx_1_0",
    "rootsig_1_0",
    "rootsig_1_1",
    "rootsig_1_2",
};
// Shader model 6.minor: the first minor of each stage, and the last that a dxc release takes.
struct Stage {
  std::string_view stage;
  int first_minor;
};
constexpr Stage kStages6[] = {{"vs", 0}, {"ps", 0}, {"gs", 0}, {"hs", 0}, {"ds", 0},
                              {"cs", 0}, {"ms", 5}, {"as", 5}, {"lib", 1}};
constexpr int kLastMinor6 = 9;

bool IsKnown(const std::string& lower) {
  if (std::ranges::find(kNames, lower) != std::end(kNames)) return true;
  for (const Stage& stage : kStages6) {
    for (int minor = stage.first_minor; minor <= kLastMinor6; ++minor) {
      if (lower == std::string(stage.stage) + "_6_" + std::to_string(minor)) return true;
    }
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
  if (!IsKnown(lower)) return std::nullopt;
  const std::size_t stage = lower.find('_');
  return Profile{.name = lower,
                 .stage = lower.substr(0, stage),
                 .major = lower[stage + 1] - '0',
                 .minor = MinorOf(lower[stage + 3]),
                 .level9 = Level9Of(lower)};
}

}  // namespace clipc::ir
