// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Compiles any text: no crash, no hang, and GLSL exactly when there is no error. The first line of
// an input may be `//PROFILE TARGET LOWERING SPACE`, up to four digits, `a` after `9`, that choose
// a profile and a target from the lists below, a lowering and a plane space; a digit that is
// missing chooses the first.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "compiler/compile/compile.h"

namespace {

constexpr std::array kProfiles = {
    "vs_5_0", "vs_4_0_level_9_1", "vs_4_0_level_9_3", "vs_5_1", "vs_6_6", "vs_3_0", "vs_4_0",
    "ps_5_0", "ps_3_0",           "cs_5_0",           "gs_5_0", "hs_5_0", "ds_5_0"};
constexpr std::array kTargets = {"glsl450", "vulkan",  "glsl330", "glsl120",
                                 "glsl130", "essl310", "glsl420", "essl300"};

// The digit at `position` as an index into a list of `size`.
std::size_t Choose(std::string_view text, std::size_t position, std::size_t size) {
  const bool chooses = text.size() > position && text.starts_with("//");
  constexpr std::string_view kDigits = "0123456789abcdef";
  const std::size_t digit = chooses ? kDigits.find(text[position]) : 0;
  return digit < kDigits.size() ? digit % size : 0;
}

void ChoosePlanes(std::string_view text, clipc::PlaneOptions& planes) {
  const std::size_t lowering = Choose(text, 4, std::size(clipc::kLoweringNames) + 1);
  if (lowering < std::size(clipc::kLoweringNames))
    planes.lowering = static_cast<clipc::Lowering>(lowering);
  planes.space =
      static_cast<clipc::PlaneSpace>(Choose(text, 5, std::size(clipc::kPlaneSpaceNames)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static clipc::Compiler compiler;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  clipc::ProgramRequest request;
  request.first().path = "fuzz.hlsl";
  request.first().text = std::string(text);
  request.planes.given_to_device = true;
  request.first().profile = kProfiles[Choose(text, 2, kProfiles.size())];
  request.target = *clipc::glsl::Target::Parse(kTargets[Choose(text, 3, kTargets.size())]);
  // Shaders without a stage after them take no options about planes.
  const auto stage = clipc::StageOf(request.first().profile.substr(0, 2));
  if (clipc::InfoOf(*stage).has_stage_after) ChoosePlanes(text, request.planes);
  request.style.clip_space = {.negative_one_to_one = true, .flip_y = true};
  request.outputs.facts = true;
  if (request.target.IsVulkan()) request.outputs.spirv.emplace();
  request.debug.verify = true;
  const clipc::CompileResult result = compiler.Compile(request);
  if (result.ok() != result.outputs.has_value()) std::abort();
  if (!result.ok() && result.messages.empty()) std::abort();
  return 0;
}
