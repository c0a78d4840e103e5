// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "clip-table/clip_table.h"

#include <algorithm>
#include <initializer_list>

namespace clipc::clip_table {
namespace {

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
               ? where + " is not one whole register; Direct3D 9 accepts only whole registers"
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

std::string ProblemOf(const ClipTable& table) {
  if (table.planes.size() > kMaxClipPlanes) {
    return std::to_string(table.planes.size()) + " planes; at most " +
           std::to_string(kMaxClipPlanes);
  }
  if (table.lowering == Lowering::kNearPlane && table.planes.size() > 1) {
    return std::to_string(table.planes.size()) + " planes in the place of one near plane";
  }
  const std::uint32_t mask = EnableMask(table.lowering, table.planes.size());
  if (table.enable_mask != mask) {
    return "enable mask " + std::to_string(table.enable_mask) + " for " +
           std::to_string(table.planes.size()) + " planes; it must be " + std::to_string(mask);
  }
  if (!Supports(table.lowering, table.plane_space)) {
    return std::string("planes in space ") + NameOf(table.plane_space) + " with lowering " +
           NameOf(table.lowering) + ", which supports planes in clip space only";
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
