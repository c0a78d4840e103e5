// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/semantics.h"

#include <algorithm>
#include <vector>

#include "base/spelling.h"

namespace clipc::rules {
namespace {

using Use = SystemValue::Use;

struct Semantic {
  std::string_view name;
  SystemValue input, output;

  const SystemValue& Of(Direction direction) const {
    return direction == Direction::kInput ? input : output;
  }
};

constexpr SystemValue kPlain{};
constexpr SystemValue kRefused{Use::kRefused, Builtin::kNone, 0, 0};
constexpr SystemValue Is(Builtin builtin, int major = 4, int minor = 0) {
  return {Use::kBuiltin, builtin, major, minor};
}

// The system values, as an input and as an output. A position or clip distance that the input
// assembler reads is data like any other (DXC: "Arb" for the vertex input).
constexpr Semantic kSemantics[] = {
    {"SV_Position", kPlain, Is(Builtin::kPosition, 0)},
    {"SV_ClipDistance", kPlain, Is(Builtin::kClipDistance)},
    {"SV_CullDistance", kPlain, Is(Builtin::kCullDistance)},
    {"SV_VertexID", Is(Builtin::kVertexId), kPlain},
    {"SV_InstanceID", Is(Builtin::kInstanceId), kPlain},
    {"SV_StartVertexLocation", Is(Builtin::kBaseVertex, 6, 8), kRefused},
    {"SV_StartInstanceLocation", Is(Builtin::kBaseInstance, 6, 8), kRefused},
    {"SV_ViewID", Is(Builtin::kViewId, 6, 1), kPlain},
    {"SV_VulkanVertexID", Is(Builtin::kVertexIndex), kRefused},  // Slang's name
    {"SV_VulkanInstanceID", Is(Builtin::kInstanceIndex), kRefused},
    {"SV_ShadingRate", kPlain, Is(Builtin::kShadingRate, 6, 4)},
    {"SV_RenderTargetArrayIndex", kPlain, Is(Builtin::kLayer)},
    {"SV_ViewportArrayIndex", kPlain, Is(Builtin::kViewportIndex)},
    {"SV_PrimitiveID", kRefused, kPlain},
    // SV_PointSize is Slang's and SDL's name for Direct3D 9's PSIZE.
    {"SV_PointSize", kRefused, Is(Builtin::kPointSize, 0)},
    // vk::PointSize is written [[vk::builtin("PointSize")]].
    {"vk::PointSize", kRefused, Is(Builtin::kPointSize, 0)},
    {"vk::BaseVertex", Is(Builtin::kBaseVertex, 0), kRefused},
    {"vk::BaseInstance", Is(Builtin::kBaseInstance, 0), kRefused},
    {"vk::DrawIndex", Is(Builtin::kDrawIndex, 0), kRefused},
};

}  // namespace

SystemValue LookUpSemantic(std::string_view name, std::uint32_t index, Direction direction,
                           const Profile& profile, PositionName position) {
  const std::string lower = ToLower(name);
  if (profile.IsPixel()) {
    const bool is_made = lower.starts_with("sv_") || lower.starts_with("vk::") || lower == "vpos" ||
                         lower == "vface";
    const bool is_input = direction == Direction::kInput;
    return {is_input && is_made ? Use::kIgnored : Use::kPlain, Builtin::kNone, 0, 0};
  }
  for (const Semantic& row : kSemantics) {
    if (EqualIgnoringCase(row.name, name)) return row.Of(direction);
  }
  // POSITION and PSIZE are Direct3D 9's names of the position and of the point size.
  if (direction == Direction::kOutput && index == 0) {
    const bool is_old = profile.IsDirect3D9();
    if (lower == "position" && (is_old || position == PositionName::kBoth))
      return Is(Builtin::kPosition, 0);
    if (lower == "psize" && is_old) return Is(Builtin::kPointSize, 0);
  }
  return lower.starts_with("sv_") || lower.starts_with("vk::") ? kRefused : kPlain;
}

std::string_view NearSystemValue(std::string_view name, Direction direction) {
  std::vector<std::string_view> names;
  for (const Semantic& row : kSemantics) {
    if (row.Of(direction).use == Use::kBuiltin) names.push_back(row.name);
  }
  const std::vector<std::string_view> near = NearNames(name, names);
  return near.empty() ? std::string_view() : near.front();
}

SemanticName SplitSemantic(std::string_view written) {
  std::size_t end = written.size();
  while (end > 0 && written[end - 1] >= '0' && written[end - 1] <= '9' && written.size() - end < 9)
    --end;
  std::uint32_t index = 0;
  for (char c : written.substr(end)) index = index * 10 + static_cast<std::uint32_t>(c - '0');
  return {std::string(written.substr(0, end)), index, end < written.size()};
}

const IoVar* FindPlainPosition(const Program& program) {
  const auto found = std::ranges::find_if(program.outputs, [](const IoVar& output) {
    return output.builtin == Builtin::kNone && output.index == 0 &&
           EqualIgnoringCase(output.semantic, "POSITION");
  });
  return found == program.outputs.end() ? nullptr : &*found;
}

}  // namespace clipc::rules
