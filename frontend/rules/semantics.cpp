// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/semantics.h"

#include <algorithm>

#include "base/spelling.h"

namespace clipc::rules {
namespace {

using Use = SystemValue::Use;

struct Row {
  std::string_view name;  // lower case
  SystemValue input, output;
};

constexpr SystemValue kPlain{};
constexpr SystemValue kRefused{Use::kRefused, Builtin::kNone, 0, 0};
constexpr SystemValue Is(Builtin builtin, int major = 4, int minor = 0) {
  return {Use::kBuiltin, builtin, major, minor};
}

// A position or clip distance that the input assembler reads is data like any other (DXC: "Arb" for
// the vertex input).
constexpr Row kRows[] = {
    {"sv_position", kPlain, Is(Builtin::kPosition, 0)},
    {"sv_clipdistance", kPlain, Is(Builtin::kClipDistance)},
    {"sv_culldistance", kPlain, Is(Builtin::kCullDistance)},
    {"sv_vertexid", Is(Builtin::kVertexId), kPlain},
    {"sv_instanceid", Is(Builtin::kInstanceId), kPlain},
    {"sv_startvertexlocation", Is(Builtin::kBaseVertex, 6, 8), kRefused},
    {"sv_startinstancelocation", Is(Builtin::kBaseInstance, 6, 8), kRefused},
    {"sv_viewid", Is(Builtin::kViewId, 6, 1), kPlain},
    {"sv_vulkanvertexid", Is(Builtin::kVertexIndex), kRefused},  // Slang's
    {"sv_vulkaninstanceid", Is(Builtin::kInstanceIndex), kRefused},
    {"sv_shadingrate", kPlain, Is(Builtin::kShadingRate, 6, 4)},
    {"sv_rendertargetarrayindex", kPlain, Is(Builtin::kLayer)},
    {"sv_viewportarrayindex", kPlain, Is(Builtin::kViewportIndex)},
    {"sv_primitiveid", kRefused, kPlain},
    // Slang's and SDL's name for Direct3D 9's PSIZE.
    {"sv_pointsize", kRefused, Is(Builtin::kPointSize, 0)},
    // [[vk::builtin("PointSize")]]
    {"vk::pointsize", kRefused, Is(Builtin::kPointSize, 0)},
    {"vk::basevertex", Is(Builtin::kBaseVertex, 0), kRefused},
    {"vk::baseinstance", Is(Builtin::kBaseInstance, 0), kRefused},
    {"vk::drawindex", Is(Builtin::kDrawIndex, 0), kRefused},
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
  for (const Row& row : kRows) {
    if (row.name == lower) return direction == Direction::kInput ? row.input : row.output;
  }
  // Direct3D 9's names of the position and of the point size.
  if (direction == Direction::kOutput && index == 0) {
    const bool is_old = profile.IsDirect3D9();
    if (lower == "position" && (is_old || position == PositionName::kBoth))
      return Is(Builtin::kPosition, 0);
    if (lower == "psize" && is_old) return Is(Builtin::kPointSize, 0);
  }
  return lower.starts_with("sv_") || lower.starts_with("vk::") ? kRefused : kPlain;
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
