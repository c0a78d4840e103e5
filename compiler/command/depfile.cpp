// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/depfile.h"

namespace clipc {
namespace {

// Escapes a path for GNU make, as GCC does.
std::string Escaped(const std::string& path) {
  std::string out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const char c = path[i];
    if (c == ' ' || c == '\t') {
      // Backslashes before a space stand for themselves only when doubled.
      for (std::size_t j = i; j > 0 && path[j - 1] == '\\'; --j) out += '\\';
      out += '\\';
    } else if (c == '#' || c == '%' || c == ':') {
      out += '\\';
    } else if (c == '$') {
      out += '$';
    }
    out += c;
  }
  return out;
}

}  // namespace

std::string DependencyRule(const std::vector<std::string>& targets,
                           const std::vector<std::string>& dependencies) {
  std::string rule;
  for (const std::string& target : targets) rule += (rule.empty() ? "" : " ") + Escaped(target);
  rule += ':';
  for (const std::string& file : dependencies) rule += " \\\n  " + Escaped(file);
  rule += '\n';
  for (std::size_t i = 1; i < dependencies.size(); ++i)
    rule += '\n' + Escaped(dependencies[i]) + ":\n";
  return rule;
}

}  // namespace clipc
