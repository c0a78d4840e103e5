// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "rewrite/wrapper.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/invariant.h"
#include "rewrite/signature.h"

namespace clipc::rewrite {
namespace {

// The number of distances that are written for so many planes.
std::size_t DistanceCount(const PlaneForm& form, std::size_t planes) {
  if (form.lowering == Lowering::kNearPlane) return 0;
  return form.lowering == Lowering::kClipDistance ? std::max(planes, form.distances) : planes;
}

class Wrapper {
 public:
  Wrapper(const EntryPoint& entry, const PlaneForm& form, std::size_t planes)
      : entry_(entry),
        form_(form),
        planes_(planes),
        distances_(DistanceParameters(form, entry.prefix, DistanceCount(form, planes))),
        signature_(entry) {
    const auto position =
        std::ranges::find(entry.program.outputs, ir::Builtin::kPosition, &ir::IoVar::builtin);
    CLIPC_CHECK(position != entry.program.outputs.end());
    position_ = AccessOf(entry, *position);
    const bool has_outs = std::ranges::any_of(entry.parameters, &EntryParameterText::is_out);
    const bool is_result = position_.parameter == entry.parameters.size() && position_.path.empty();
    if (has_outs && is_result) signature_.ReturnByParameter();
    for (const DistanceParameter& distances : distances_)
      signature_.Add(fmt::format("{}out {} {}{}", distances.before, distances.type, distances.name,
                                 distances.semantic));
  }

  std::string Write(const std::string& name, const std::string& inner) const {
    const std::string vertex_name = entry_.prefix + "vertex";
    const std::string position = AsFloat4(position_);
    const std::string vertex = form_.space == PlaneSpace::kClip ? position : vertex_name;
    std::string before, after;
    // The entry function may change an inout parameter, so the vertex is kept before the call.
    if (form_.space == PlaneSpace::kObject && planes_ > 0)
      before = fmt::format("    float4 {} = {};\n", vertex_name, AsFloat4(InputOf()));
    if (form_.space == PlaneSpace::kXyw1 && planes_ > 0)
      after = fmt::format("    float4 {} = float4({}.xyw, 1.0);\n", vertex_name, position);
    after += form_.lowering == Lowering::kNearPlane ? Depth(vertex) : Distances(vertex);
    return signature_.Write(name, inner, before, after);
  }

 private:
  // The value as a float4: min16float4 and the like are converted.
  std::string AsFloat4(const EntryAccess& access) const {
    const ir::Type& type = entry_.program.types[access.type];
    const std::string value = signature_.ValueOf(access);
    if (type.Components() == 3) return fmt::format("float4({}, 1.0)", value);
    return type.scalar == ir::Scalar::kFloat ? value : fmt::format("float4({})", value);
  }

  std::string Dot(const std::string& vertex, std::size_t plane) const {
    return fmt::format("dot({}, {})", vertex, entry_.planes[plane]);
  }

  std::string Depth(const std::string& vertex) const {
    return planes_ > 0
               ? fmt::format("    {}.z = {};\n", signature_.ValueOf(position_), Dot(vertex, 0))
               : "";
  }

  std::string Distances(const std::string& vertex) const {
    std::string body;
    for (const DistanceParameter& distances : distances_) {
      std::vector<std::string> values;
      for (std::size_t i = distances.first; i < distances.first + distances.width; ++i)
        values.push_back(i < planes_ ? Dot(vertex, i) : "0.0");
      const std::string value =
          values.size() == 1 ? values.front()
                             : fmt::format("{}({})", distances.type, fmt::join(values, ", "));
      body += fmt::format("    {} = {};\n", distances.name, value);
    }
    return body;
  }

  EntryAccess InputOf() const {
    const auto& inputs = entry_.program.inputs;
    const auto input = std::ranges::find(inputs, form_.position_input, &ir::IoVar::var);
    CLIPC_CHECK(input != inputs.end());
    return AccessOf(entry_, *input);
  }

  const EntryPoint& entry_;
  const PlaneForm& form_;
  std::size_t planes_;
  std::vector<DistanceParameter> distances_;  // for at least as many, or none
  Signature signature_;
  EntryAccess position_;
};

}  // namespace

std::string WriteWrapper(const EntryPoint& entry, const PlaneForm& form, const std::string& name,
                         const std::string& inner, std::size_t planes) {
  return Wrapper(entry, form, planes).Write(name, inner);
}

}  // namespace clipc::rewrite
