// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/explain.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostics.h"
#include "base/spelling.h"
#include "compiler/compile/suggest.h"

namespace clipc {
namespace {

struct Explanation {
  DiagId id;
  std::string_view rule;
  std::string_view options, example;
  std::string_view fixed_options, fixed;  // without a text: the example's
};  // without an example: what no short shader shows

constexpr Explanation kExplanations[] = {
#define EXPLANATION(Name, Rule, Options, Example, FixedOptions, Fixed) \
  {DiagId::k##Name, Rule, Options, Example, FixedOptions, Fixed},
#define RULE(Name, Rule) {DiagId::k##Name, Rule, "", "", "", ""},
#include "compiler/compile/explanations.def"
#undef RULE
#undef EXPLANATION
};

// The text in lines of up to 80 columns.
std::string Wrapped(std::string_view text) {
  constexpr std::size_t kColumns = 80;
  std::string lines;
  while (text.size() > kColumns) {
    const std::size_t end = text.rfind(' ', kColumns);
    if (end == std::string_view::npos) break;
    lines += fmt::format("{}\n", text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return fmt::format("{}{}\n", lines, text);
}

// The message with "..." for what was seen; empty if it says nothing else.
std::string MessageOf(std::string_view format) {
  if (format == "{}") return {};
  std::string message;
  for (std::size_t i = 0; i < format.size(); ++i) {
    const std::string_view two = format.substr(i, 2);
    message += two == "{}" ? "..." : std::string(1, format[i]);
    if (two == "{}" || two == "{{" || two == "}}") ++i;
  }
  return message;
}

// "Example: clipc x.hlsl -T vs_4_0" and the lines of the text, which are indented.
std::string Shown(std::string_view what, std::string_view options, std::string_view text) {
  std::string shown =
      fmt::format("\n{}: clipc x.hlsl{}{}\n", what, options.empty() ? "" : " ", options);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    shown += fmt::format("    {}\n", text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return shown;
}

std::string PageOf(DiagId id) {
  const DiagInfo& info = InfoOf(id);
  std::string text = fmt::format(
      "{}: {}{}\n", PrintedName(id), info.severity == Severity::kWarning ? "a warning" : "an error",
      info.fxc_code.empty() ? "" : fmt::format(", fxc's {}", info.fxc_code));
  if (const std::string message = MessageOf(info.format); !message.empty())
    text += "\n" + Wrapped(message);
  const auto* const explanation = std::ranges::find(kExplanations, id, &Explanation::id);
  if (explanation == std::ranges::end(kExplanations)) return text;
  text += "\n" + Wrapped(explanation->rule);
  if (explanation->example.empty()) return text;
  text += Shown("Example", explanation->options, explanation->example);
  const char* const fixed = explanation->fixed.empty() ? "Fixed, with the same file" : "Fixed";
  return text + Shown(fixed, explanation->fixed_options, explanation->fixed);
}

std::vector<DiagId> Explained() {
  std::vector<DiagId> ids;
  for (std::size_t i = 0; i < kDiagCount; ++i) {
    if (InfoOf(static_cast<DiagId>(i)).severity != Severity::kNote)
      ids.push_back(static_cast<DiagId>(i));
  }
  return ids;
}

}  // namespace

std::string Explain(std::string_view name) {
  std::string text;
  for (const DiagId id : Explained()) {
    const bool has_code = !name.empty() && EqualIgnoringCase(InfoOf(id).fxc_code, name);
    if (has_code || PrintedName(id) == name) text += (text.empty() ? "" : "\n") + PageOf(id);
  }
  return text;
}

std::string SuggestDiagnostic(std::string_view name) {
  std::vector<std::string> names;
  for (const DiagId id : Explained()) names.push_back(PrintedName(id));
  const std::vector<std::string_view> views(names.begin(), names.end());
  return Suggest(name, views);
}

}  // namespace clipc
