// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "rewrite/wrapper.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/invariant.h"

namespace clipc::rewrite {
namespace {

class Wrapper {
 public:
  Wrapper(const EntryPoint& entry, const PlaneForm& form, std::size_t planes)
      : entry_(entry),
        form_(form),
        planes_(planes),
        distances_(form.lowering == Lowering::kClipDistance ? std::max(planes, form.distances) : 0),
        has_result_(entry.return_type != "void"),
        result_(entry.prefix + "result") {
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) names_.push_back(NameOf(i));
    const auto position =
        std::ranges::find(entry.program.outputs, ir::Builtin::kPosition, &ir::IoVar::builtin);
    CLIPC_CHECK(position != entry.program.outputs.end());
    position_ = AccessOf(entry, *position);
    const bool has_outs = std::ranges::any_of(entry.parameters, &EntryParameterText::is_out);
    returns_ = has_result_ && !(has_outs && IsWholeResult(position_));
  }

  std::string Write(const std::string& name, const std::string& inner) const {
    std::vector<std::string> parameters, with_default;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const EntryParameterText& text = entry_.parameters[i];
      (text.initial.empty() ? parameters : with_default)
          .push_back(text.before + names_[i] + text.after + text.initial);
    }
    if (has_result_ && !returns_) {
      parameters.push_back(
          fmt::format("out {} {}{}", entry_.return_type, result_, entry_.return_semantic));
    }
    for (std::size_t i = 0; i < distances_; i += 4) {
      parameters.push_back(
          fmt::format("out {} {} : SV_ClipDistance{}", TypeFrom(i), DistancesFrom(i), i / 4));
    }
    parameters.insert(parameters.end(), with_default.begin(), with_default.end());
    return fmt::format("{}{} {}({}){}\n{{\n{}}}\n", entry_.attributes,
                       returns_ ? entry_.return_type : "void", name, fmt::join(parameters, ", "),
                       returns_ ? entry_.return_semantic : "", Body(inner));
  }

 private:
  bool IsWholeResult(const EntryAccess& access) const {
    return access.parameter == entry_.parameters.size() && access.path.empty();
  }

  // The name of a parameter, another one where it would hide a name that the wrapper says.
  std::string NameOf(std::size_t parameter) const {
    const std::string& name = entry_.parameters[parameter].name;
    if (name.empty()) return fmt::format("{}unused{}", entry_.prefix, parameter);
    const bool hides = std::ranges::find(entry_.not_hidden, name) != entry_.not_hidden.end();
    return hides ? entry_.prefix + name : name;
  }

  std::string ValueOf(const EntryAccess& access) const {
    return (access.parameter < names_.size() ? names_[access.parameter] : result_) + access.path;
  }

  std::string DistancesFrom(std::size_t first) const {
    return fmt::format("{}distances{}", entry_.prefix, first / 4);
  }
  std::string TypeFrom(std::size_t first) const {
    const std::size_t width = std::min<std::size_t>(distances_ - first, 4);
    return width == 1 ? "float" : fmt::format("float{}", width);
  }

  // The value as a float4: min16float4 and the like are converted.
  std::string AsFloat4(const EntryAccess& access) const {
    const ir::Type& type = entry_.program.types[access.type];
    const std::string value = ValueOf(access);
    if (type.Components() == 3) return fmt::format("float4({}, 1.0)", value);
    return type.scalar == ir::Scalar::kFloat ? value : fmt::format("float4({})", value);
  }

  std::string Dot(const std::string& vertex, std::size_t plane) const {
    return fmt::format("dot({}, {})", vertex, entry_.planes[plane]);
  }

  std::string Body(const std::string& inner) const {
    const std::string vertex_name = entry_.prefix + "vertex";
    const std::string position = AsFloat4(position_);
    std::string vertex = form_.space == PlaneSpace::kClip ? position : vertex_name;
    std::string body;
    // The entry function may change an inout parameter, so the vertex is kept before the call.
    if (form_.space == PlaneSpace::kObject && planes_ > 0)
      body += fmt::format("    float4 {} = {};\n", vertex_name, AsFloat4(InputOf()));
    const char* equals = has_result_ ? " = " : "";
    const std::string declared = has_result_ && returns_ ? entry_.return_type + " " : "";
    body += fmt::format("    {}{}{}{}({});\n", declared, has_result_ ? result_ : "", equals, inner,
                        fmt::join(names_, ", "));
    if (form_.space == PlaneSpace::kXyw1 && planes_ > 0)
      body += fmt::format("    float4 {} = float4({}.xyw, 1.0);\n", vertex_name, position);
    body += form_.lowering == Lowering::kNearPlane ? Depth(vertex) : Distances(vertex);
    if (returns_) body += fmt::format("    return {};\n", result_);
    return body;
  }

  std::string Depth(const std::string& vertex) const {
    return planes_ > 0 ? fmt::format("    {}.z = {};\n", ValueOf(position_), Dot(vertex, 0)) : "";
  }

  std::string Distances(const std::string& vertex) const {
    std::string body;
    for (std::size_t first = 0; first < distances_; first += 4) {
      std::vector<std::string> values;
      for (std::size_t i = first; i < std::min(first + 4, distances_); ++i)
        values.push_back(i < planes_ ? Dot(vertex, i) : "0.0");
      const std::string value =
          values.size() == 1 ? values.front()
                             : fmt::format("{}({})", TypeFrom(first), fmt::join(values, ", "));
      body += fmt::format("    {} = {};\n", DistancesFrom(first), value);
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
  std::size_t distances_;  // at least as many, or none where none are written
  bool has_result_;
  bool returns_ = false;  // whether the wrapper returns the result; else it is an out parameter
  std::string result_;
  std::vector<std::string> names_;  // of the parameters
  EntryAccess position_;
};

}  // namespace

std::string WriteWrapper(const EntryPoint& entry, const PlaneForm& form, const std::string& name,
                         const std::string& inner, std::size_t planes) {
  return Wrapper(entry, form, planes).Write(name, inner);
}

}  // namespace clipc::rewrite
