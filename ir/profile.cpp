// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/profile.h"

namespace clipc::ir {
namespace {

struct Entry {
  std::string_view name;
  int major;
  int minor;
  Level9 level9 = Level9::kNone;
};

// fxc's and dxc's documented targets; dxc adds the 6.x rows for each stage.
constexpr Entry kVertex[] = {
    {"vs_1_1", 1, 1},
    {"vs_2_0", 2, 0},
    {"vs_2_a", 2, 0},
    {"vs_2_sw", 2, 0},
    {"vs_3_0", 3, 0},
    {"vs_3_sw", 3, 0},
    {"vs_4_0", 4, 0},
    {"vs_4_0_level_9_0", 4, 0, Level9::k9_0},
    {"vs_4_0_level_9_1", 4, 0, Level9::k9_1},
    {"vs_4_0_level_9_3", 4, 0, Level9::k9_3},
    {"vs_4_1", 4, 1},
    {"vs_5_0", 5, 0},
    {"vs_5_1", 5, 1},
};
constexpr Entry kOther[] = {
    {"ps_1_1", 1, 1},
    {"ps_1_2", 1, 2},
    {"ps_1_3", 1, 3},
    {"ps_1_4", 1, 4},
    {"ps_2_0", 2, 0},
    {"ps_2_a", 2, 0},
    {"ps_2_b", 2, 0},
    {"ps_2_sw", 2, 0},
    {"ps_3_0", 3, 0},
    {"ps_3_sw", 3, 0},
    {"ps_4_0", 4, 0},
    {"ps_4_0_level_9_0", 4, 0, Level9::k9_0},
    {"ps_4_0_level_9_1", 4, 0, Level9::k9_1},
    {"ps_4_0_level_9_3", 4, 0, Level9::k9_3},
    {"ps_4_1", 4, 1},
    {"ps_5_0", 5, 0},
    {"ps_5_1", 5, 1},
    {"gs_4_0", 4, 0},
    {"gs_4_1", 4, 1},
    {"gs_5_0", 5, 0},
    {"gs_5_1", 5, 1},
    {"hs_5_0", 5, 0},
    {"hs_5_1", 5, 1},
    {"ds_5_0", 5, 0},
    {"ds_5_1", 5, 1},
    {"cs_4_0", 4, 0},
    {"cs_4_1", 4, 1},
    {"cs_5_0", 5, 0},
    {"cs_5_1", 5, 1},
    {"lib_4_0", 4, 0},
    {"lib_4_1", 4, 1},
    {"lib_4_0_level_9_1", 4, 0, Level9::k9_1},
    {"lib_4_0_level_9_3", 4, 0, Level9::k9_3},
    {"lib_5_0", 5, 0},
    {"lib_6_x", 6, 15},
    {"fx_2_0", 2, 0},
    {"fx_4_0", 4, 0},
    {"fx_4_1", 4, 1},
    {"fx_5_0", 5, 0},
    {"tx_1_0", 1, 0},
    {"rootsig_1_0", 1, 0},
    {"rootsig_1_1", 1, 1},
    {"rootsig_1_2", 1, 2},
};
// Shader model 6.minor: the first minor of each stage, and the last that a dxc release knows.
struct Stage {
  std::string_view stage;
  int first_minor;
};
constexpr Stage kStages6[] = {{"vs", 0}, {"ps", 0}, {"gs", 0}, {"hs", 0}, {"ds", 0},
                              {"cs", 0}, {"ms", 5}, {"as", 5}, {"lib", 1}};
constexpr int kLastMinor6 = 9;

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

Profile Make(std::string_view name, int major, int minor, Level9 level9) {
  return {.name = std::string(name),
          .stage = std::string(name.substr(0, name.find('_'))),
          .major = major,
          .minor = minor,
          .level9 = level9};
}

}  // namespace

std::optional<Profile> ParseProfile(std::string_view name) {
  const std::string lower = LowerCase(name);
  for (const Entry& entry : kVertex) {
    if (entry.name == lower) return Make(lower, entry.major, entry.minor, entry.level9);
  }
  for (const Entry& entry : kOther) {
    if (entry.name == lower) return Make(lower, entry.major, entry.minor, entry.level9);
  }
  for (const Stage& stage : kStages6) {
    for (int minor = stage.first_minor; minor <= kLastMinor6; ++minor) {
      if (lower == std::string(stage.stage) + "_6_" + std::to_string(minor)) {
        return Make(lower, 6, minor, Level9::kNone);
      }
    }
  }
  return std::nullopt;
}

}  // namespace clipc::ir
