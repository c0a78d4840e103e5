// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "clip-table/clip_table.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace clipc::clip_table {
namespace {

constexpr std::string_view kLoweringNames[] = {"clip-distance", "level9", "none", "near-plane",
                                               "discard"};
constexpr std::string_view kSpaceNames[] = {"direct3d-clip", "xyw1", "object"};
constexpr std::string_view kScaleNames[] = {"any", "depth"};

template <typename Enum, std::size_t N>
std::optional<Enum> Parse(std::string_view name, const std::string_view (&names)[N]) {
  const auto found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names)) return std::nullopt;
  return static_cast<Enum>(found - std::begin(names));
}

bool HoldsNul(std::initializer_list<std::string_view> texts) {
  return std::any_of(texts.begin(), texts.end(),
                     [](std::string_view text) { return text.find('\0') != text.npos; });
}

std::string ProblemOf(const Plane& plane, std::size_t index, Lowering lowering) {
  const std::string where = "plane " + std::to_string(index);
  if (plane.index != index)
    return where + " says that it is operand " + std::to_string(plane.index);
  if (HoldsNul({plane.text})) return where + " holds a NUL character";
  if (!plane.constant) {
    return lowering == Lowering::kLevel9
               ? where + " is no whole register, which Direct3D 9 cannot be told"
               : "";
  }
  const Constant& constant = *plane.constant;
  if (HoldsNul({constant.cbuffer, constant.glsl_block, constant.glsl_member})) {
    return where + " holds a NUL character";
  }
  if (constant.byte_offset != std::uint64_t{16} * constant.float4_register) {
    return where + " is register " + std::to_string(constant.float4_register) + " at byte offset " +
           std::to_string(constant.byte_offset) + "; a register is 16 bytes";
  }
  return "";
}

}  // namespace

std::string_view NameOf(Lowering lowering) {
  return kLoweringNames[static_cast<std::size_t>(lowering)];
}

std::string_view NameOf(PositionSpace space) {
  return kSpaceNames[static_cast<std::size_t>(space)];
}

std::string_view NameOf(PlaneScale scale) { return kScaleNames[static_cast<std::size_t>(scale)]; }

std::optional<Lowering> ParseLowering(std::string_view name) {
  return Parse<Lowering>(name, kLoweringNames);
}

std::optional<PositionSpace> ParsePositionSpace(std::string_view name) {
  return Parse<PositionSpace>(name, kSpaceNames);
}

std::string ProblemOf(const ClipTable& table) {
  if (table.planes.size() > kMaxPlanes) {
    return std::to_string(table.planes.size()) + " planes; at most " + std::to_string(kMaxPlanes);
  }
  if (table.lowering == Lowering::kNearPlane && table.planes.size() > 1) {
    return std::to_string(table.planes.size()) + " planes in the place of one near plane";
  }
  const std::uint32_t mask = EnableMask(table.lowering, table.planes.size());
  if (table.enable_mask != mask) {
    return "enable mask " + std::to_string(table.enable_mask) + " for " +
           std::to_string(table.planes.size()) + " planes; it must be " + std::to_string(mask);
  }
  if (!KnowsSpace(table.lowering, table.position_space)) {
    return "planes in space " + std::string(NameOf(table.position_space)) + " with lowering " +
           std::string(NameOf(table.lowering)) + ", which knows clip space only";
  }
  if (HoldsNul({table.entry, table.profile})) return "a name holds a NUL character";
  for (std::size_t i = 0; i < table.planes.size(); ++i) {
    if (std::string problem = ProblemOf(table.planes[i], i, table.lowering); !problem.empty()) {
      return problem;
    }
  }
  return "";
}

std::optional<Format> FormatOf(std::string_view path) {
  const auto ends = [&](std::string_view extension) { return path.ends_with(extension); };
  if (ends(".json")) return Format::kJson;
  if (ends(".bin")) return Format::kBinary;
  if (ends(".h") || ends(".hpp") || ends(".inc")) return Format::kHeader;
  return std::nullopt;
}

}  // namespace clipc::clip_table
