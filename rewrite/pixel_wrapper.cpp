// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "rewrite/pixel_wrapper.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/spelling.h"
#include "rewrite/signature.h"

namespace clipc::rewrite {
namespace {

std::string_view InterpolationText(const ir::Program& program, const ir::IoVar& io) {
  if (program.types[program.vars[io.var].type].scalar != ir::Scalar::kFloat)
    return "nointerpolation ";
  switch (io.interpolation) {
    case ir::Interpolation::kDefault:
    case ir::Interpolation::kLinear: return "";
    case ir::Interpolation::kNoInterpolation: return "nointerpolation ";
    case ir::Interpolation::kNoPerspective: return "noperspective ";
  }
  return "";
}

}  // namespace

std::uint32_t LocationAfterOutputs(const ir::Program& vertex) {
  std::uint32_t next = 0;
  for (const ir::IoVar& output : vertex.outputs) {
    const ir::Type& type = vertex.types[vertex.vars[output.var].type];
    if (output.builtin == ir::Builtin::kNone)
      next = std::max(next, output.location + ir::LocationCount(type));
  }
  return next;
}

std::vector<std::string> UnreadOutputs(const EntryPoint& vertex, const EntryPoint& pixel,
                                       bool has_locations) {
  const ir::Program& program = vertex.program;
  std::vector<std::string> parameters;
  for (const ir::IoVar& output : program.outputs) {
    const bool is_read = std::ranges::any_of(pixel.program.inputs, [&](const ir::IoVar& input) {
      return input.index == output.index && EqualIgnoringCase(input.semantic, output.semantic);
    });
    if (output.builtin != ir::Builtin::kNone || is_read) continue;
    parameters.push_back(fmt::format(
        "{}{}{} {}unread{} : {}{}",
        has_locations ? fmt::format("[[vk::location({})]] ", output.location) : "",
        InterpolationText(program, output), program.types.Name(program.vars[output.var].type),
        pixel.prefix, parameters.size(), output.semantic, output.index));
  }
  return parameters;
}

std::string WritePixelWrapper(const EntryPoint& entry, const PixelForm& form,
                              const std::string& name, const std::string& inner,
                              std::size_t planes) {
  Signature signature(entry);
  std::string discards;
  if (planes > 0) {
    for (const std::string& unread : form.unread) signature.Add(unread);
  }
  for (const DistanceParameter& distances : DistanceParameters(form.planes, entry.prefix, planes)) {
    signature.Add(fmt::format("{}{} {}{}", distances.before, distances.type, distances.name,
                              distances.semantic));
    // Without /Gis fxc leaves isnan() out, and keeps what a comparison says of NaN; drivers of
    // Vulkan and OpenGL do the opposite.
    const char* discard = distances.width == 1
                              ? "    if (isnan({0}) || !({0} >= 0.0)) discard;\n"
                              : "    if (any(isnan({0})) || !all({0} >= 0.0)) discard;\n";
    discards += fmt::format(fmt::runtime(discard), distances.name);
  }
  return signature.Write(name, inner, form.discards_first ? discards : "",
                         form.discards_first ? "" : discards);
}

}  // namespace clipc::rewrite
