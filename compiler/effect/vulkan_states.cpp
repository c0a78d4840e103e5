// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/vulkan_states.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>

#include "compiler/effect/gl_states.h"

namespace clipc {
namespace {

using Value = std::variant<std::uint32_t, float>;

// OpenGL's values in the order of Vulkan's enumerators.
constexpr std::uint32_t kCompares[] = {0x200, 0x201, 0x202, 0x203, 0x204, 0x205, 0x206, 0x207};
constexpr std::uint32_t kCulls[] = {0, 0x404, 0x405};
constexpr std::uint32_t kFronts[] = {0x901, 0x900};
constexpr std::uint32_t kFills[] = {0x1B02, 0x1B01, 0x1B00};
// 12 and 13 are the factors of the constant's alpha, which Direct3D does not have.
constexpr std::uint32_t kNoFactor = 0xFFFFFFFF;
constexpr std::uint32_t kFactors[] = {0,     1,      0x300,  0x301,  0x306,  0x307,     0x302,
                                      0x303, 0x304,  0x305,  0x8001, 0x8002, kNoFactor, kNoFactor,
                                      0x308, 0x88F9, 0x88FA, 0x8589, 0x88FB};
constexpr std::uint32_t kEquations[] = {0x8006, 0x800A, 0x800B, 0x8007, 0x8008};
constexpr std::uint32_t kStencils[] = {0x1E00, 0, 0x1E01, 0x1E02, 0x1E03, 0x150A, 0x8507, 0x8508};

Value PlaceIn(std::span<const std::uint32_t> list, std::uint32_t value) {
  return static_cast<std::uint32_t>(std::ranges::find(list, value) - list.begin());
}

Value Itself(std::uint32_t value) { return value; }
Value Float(std::uint32_t value) { return std::bit_cast<float>(value); }
Value Compare(std::uint32_t value) { return PlaceIn(kCompares, value); }
Value Cull(std::uint32_t value) { return PlaceIn(kCulls, value); }
Value Front(std::uint32_t value) { return PlaceIn(kFronts, value); }
Value Fill(std::uint32_t value) { return PlaceIn(kFills, value); }
Value Factor(std::uint32_t value) { return PlaceIn(kFactors, value); }
Value Equation(std::uint32_t value) { return PlaceIn(kEquations, value); }
Value Stencil(std::uint32_t value) { return PlaceIn(kStencils, value); }

struct Row {
  std::string_view member;
  GlStateKind state;
  Value (*read)(std::uint32_t value);
  GlStateKind decides, otherwise;  // both are `state` where nothing decides
};
constexpr Row kRows[] = {
#define VK_STATE(Member, State, Reading) \
  {Member, GlStateKind::k##State, Reading, GlStateKind::k##State, GlStateKind::k##State},
#define VK_STATE_OF(Member, State, Reading, If, Else) \
  {Member, GlStateKind::k##State, Reading, GlStateKind::k##If, GlStateKind::k##Else},
#include "compiler/effect/vulkan_states.def"
};

constexpr StateHost kVulkan = {.name = "`vulkan` in the JSON",
                               .api = "a pipeline of Vulkan",
                               .reader = "it",
                               .member = "member",
                               .cure = "where you make the pipeline",
                               .has = [](GlStateKind state) {
                                 return std::ranges::any_of(kRows, [=](const Row& row) {
                                   return row.state == state || row.decides == state ||
                                          row.otherwise == state;
                                 });
                               }};

}  // namespace

std::vector<VulkanState> ReadVulkanStates(const EffectFacts& effect, const ast::EffectPass& pass) {
  Diagnostics unused;  // CheckVulkanStates reports
  StateReport report(kVulkan, unused);
  std::array<std::optional<std::uint32_t>, static_cast<std::size_t>(GlStateKind::kCount)> found;
  const auto at = [&](GlStateKind kind) -> std::optional<std::uint32_t>& {
    return found[static_cast<std::size_t>(kind)];
  };
  for (const auto& [kind, value] : ReadGlStates(effect, pass, false, report)) at(kind) = value;
  std::vector<VulkanState> states;
  for (const Row& row : kRows) {
    const bool is_itself = row.decides == row.state || at(row.decides).value_or(0) != 0;
    if (const auto& value = at(is_itself ? row.state : row.otherwise))
      states.push_back({row.member, row.read(*value)});
  }
  return states;
}

void CheckVulkanStates(const EffectFacts& effect, Diagnostics& diagnostics) {
  StateReport report(kVulkan, diagnostics);
  for (const EffectTechniqueFact& technique : effect.techniques) {
    for (const EffectPassFact& pass : technique.passes)
      (void)ReadGlStates(effect, pass.text, false, report);
  }
}

}  // namespace clipc
