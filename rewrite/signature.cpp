// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "rewrite/signature.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace clipc::rewrite {
namespace {

// The functions that a wrapper calls beside its entry function.
constexpr std::array<std::string_view, 2> kCalled = {"all", "dot"};

}  // namespace

Signature::Signature(const EntryPoint& entry)
    : entry_(entry), has_result_(entry.return_type != "void"), result_(entry.prefix + "result") {
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) names_.push_back(NameOf(i));
}

void Signature::ReturnByParameter() {
  by_parameter_ = true;
  Add(fmt::format("out {} {}{}", entry_.return_type, result_, entry_.return_semantic));
}

// The name of a parameter, another one where it would hide a name that the wrapper says.
std::string Signature::NameOf(std::size_t parameter) const {
  const std::string& name = entry_.parameters[parameter].name;
  if (name.empty()) return fmt::format("{}unused{}", entry_.prefix, parameter);
  const bool hides = std::ranges::find(entry_.not_hidden, name) != entry_.not_hidden.end() ||
                     std::ranges::find(kCalled, name) != kCalled.end();
  return hides ? fmt::format("{}parameter_{}", entry_.prefix, name) : name;
}

std::string Signature::ValueOf(const EntryAccess& access) const {
  return (access.parameter < names_.size() ? names_[access.parameter] : result_) + access.path;
}

std::string Signature::Call(const std::string& inner) const {
  const std::string call = fmt::format("{}({});\n", inner, fmt::join(names_, ", "));
  if (!has_result_) return "    " + call;
  return fmt::format("    {}{} = {}", by_parameter_ ? "" : entry_.result_type + " ", result_, call);
}

std::string Signature::Write(const std::string& name, const std::string& inner,
                             const std::string& before, const std::string& after) const {
  std::vector<std::string> parameters, with_default;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const EntryParameterText& text = entry_.parameters[i];
    (text.initial.empty() ? parameters : with_default)
        .push_back(text.before + names_[i] + text.after + text.initial);
  }
  parameters.insert(parameters.end(), added_.begin(), added_.end());
  parameters.insert(parameters.end(), with_default.begin(), with_default.end());
  return fmt::format("{}{} {}({}){}\n{{\n{}{}{}{}}}\n", entry_.attributes,
                     returns() ? entry_.return_type : "void", name, fmt::join(parameters, ", "),
                     returns() ? entry_.return_semantic : "", before, Call(inner), after,
                     returns() ? fmt::format("    return {};\n", result_) : "");
}

}  // namespace clipc::rewrite
