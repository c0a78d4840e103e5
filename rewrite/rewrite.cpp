// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "rewrite/rewrite.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc::rewrite {
namespace {

// A change of the text: `text` takes the place of the range.
struct Edit {
  TextRange range;
  std::string text;
};

bool IsOfWord(char c) {
  return (c >= '0' && c <= '9') || (ToLower(c) >= 'a' && ToLower(c) <= 'z') || c == '_';
}

// The code with other words for some of its words; the text of strings stays.
std::string WithWords(std::string_view code,
                      std::initializer_list<std::pair<std::string_view, std::string_view>> words) {
  std::string result;
  while (!code.empty()) {
    const bool is_word = IsOfWord(code[0]);
    std::size_t size = 1;
    if (is_word)
      size = static_cast<std::size_t>(std::ranges::find_if_not(code, IsOfWord) - code.begin());
    else if (code[0] == '"')
      size = std::min(code.find('"', 1), code.size() - 1) + 1;
    const std::string_view part = code.substr(0, size);
    const auto* found = std::ranges::find(words, part, [](const auto& word) { return word.first; });
    result += is_word && found != words.end() ? found->second : part;
    code.remove_prefix(size);
  }
  return result;
}

// The names that directives in the text define or undefine as macros.
std::vector<std::string> MacrosIn(std::string_view text) {
  const auto skip = [](std::string_view& line, std::size_t count) {
    line.remove_prefix(count);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  };
  std::vector<std::string> names;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    skip(line, 0);
    if (!line.starts_with('#')) continue;
    skip(line, 1);
    const std::size_t word = line.starts_with("define") ? 6 : line.starts_with("undef") ? 5 : 0;
    if (word == 0) continue;
    skip(line, word);
    names.emplace_back(line.begin(), std::ranges::find_if_not(line, IsOfWord));
  }
  return names;
}

class Rewriter {
 public:
  Rewriter(const std::string& text, const Options& options) : text_(text), options_(options) {}

  void Add(const Entry& entry) {
    const EntryPoint& point = entry.point;
    source_ = entry.source;
    diagnostics_ = entry.diagnostics;
    const auto end = source_->AfterInMainText(point.definition);
    if (!CanWrap(point, end)) return;
    std::vector<std::string> undefined;
    RemoveAttributes(point, undefined);
    if (entry.form.lowering == Lowering::kNone) return;
    for (const Span shader_kind : point.shader_kinds) Remove(shader_kind);
    const bool renames = Renames(entry);
    const std::string inner = renames ? point.prefix + point.name : point.name;
    if (renames) Rename(entry, *end, inner, undefined);
    // glslang finds no function by its name alone in a namespace.
    AddWrappers(entry, *end, point.scope + inner, undefined);
  }

  std::string Finish() {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    const std::size_t start = text_.starts_with(kMark) ? kMark.size() : 0;
    if (options_.source_lines) head_ += LineDirective(start);
    if (!head_.empty()) edits_.push_back({{start, start}, head_});
    std::ranges::stable_sort(edits_, {}, [](const Edit& edit) { return edit.range.begin; });
    std::string result;
    std::size_t done = 0;
    for (const Edit& edit : edits_) {
      result.append(text_, done, edit.range.begin - done);
      result += WithLineEnds(edit.text);
      done = edit.range.end;
    }
    return result.append(text_, done);
  }

 private:
  // Whether the wrapper takes the name of the entry function.
  bool Renames(const Entry& entry) const { return entry.pixel || options_.wrapper_entry.empty(); }

  bool CanWrap(const EntryPoint& point, std::optional<std::size_t> end) {
    if (!point.unnamed_type.empty()) {
      diagnostics_->Report(point.definition, diag::RewriteUnnamedType, point.unnamed_type,
                           point.name);
      return false;
    }
    const bool is_here = end && (point.scope.empty() || source_->InMainText(point.definition));
    if (!is_here) diagnostics_->Report(point.definition, diag::RewriteElsewhere, point.name);
    return is_here;
  }

  // Removes the attributes that the text spells. The others get a name without effect.
  void RemoveAttributes(const EntryPoint& point, std::vector<std::string>& undefined) {
    for (std::size_t i = 0; i < point.clip_planes.size(); ++i) {
      if (Remove(point.clip_planes[i])) continue;
      const std::string& word = point.clip_plane_words[i];
      if (std::ranges::find(undefined, word) != undefined.end()) continue;
      const std::string name = point.prefix + word;
      diagnostics_->Report(point.definition, diag::RewriteAttributeStays, point.name, name);
      head_ += fmt::format(
          "// The clip planes of {} are not spelled out in this file: they stay, without effect.\n"
          "#define {} {}\n",
          point.name, word, name);
      undefined.push_back(word);
    }
  }

  // Removes a phrase that the main file spells, and the blanks after it. Its line ends stay.
  bool Remove(Span span) {
    const auto range = source_->InMainText(span);
    if (!range) return false;
    const std::string_view removed =
        std::string_view(text_).substr(range->begin, range->end - range->begin);
    std::string lines;
    for (const char c : removed) {
      if (c == '\n') lines += c;
    }
    std::size_t end = range->end;
    while (end < text_.size() && (text_[end] == ' ' || text_[end] == '\t')) ++end;
    edits_.push_back({{range->begin, end}, lines});
    return true;
  }

  // Gives the entry function another name. Up to the wrapper: in its definition and its prototypes
  // if the text spells them and says the name nowhere else, and in its calls too if a field or a
  // variable has the name; or else by a macro. After the wrapper: where it is called or declared.
  void Rename(const Entry& entry, std::size_t end, const std::string& inner,
              std::vector<std::string>& undefined) {
    const EntryPoint& point = entry.point;
    bool is_used = false, is_spelled = true, has_others = false;
    std::vector<TextRange> before, after;
    for (const Use& use : entry.uses) {
      const bool is_own =
          std::ranges::any_of(point.names, [&](Span name) { return name.end == use.span.end; });
      const bool is_call = use.kind == Use::Kind::kCall, is_other = use.kind == Use::Kind::kOther;
      has_others |= is_other;
      const auto range = source_->InMainText(use.span);
      const bool is_after = source_->AfterInMainText(use.span).value_or(0) > end;
      if (range && (is_own || is_call)) (is_after ? after : before).push_back(*range);
      if (is_after) continue;
      is_used |= !is_own;
      is_spelled &= is_other || (range && (is_own || is_call));
    }
    if (!is_spelled || (is_used && !has_others)) {
      head_ += fmt::format("#define {} {}\n", point.name, inner);
      undefined.push_back(point.name);
      before.clear();
    }
    for (const auto& ranges : {before, after}) {
      for (const TextRange& range : ranges) edits_.push_back({range, inner});
    }
  }

  static std::string Wrapper(const Entry& entry, const std::string& name, const std::string& inner,
                             std::size_t planes) {
    return entry.pixel ? WritePixelWrapper(entry.point, *entry.pixel, name, inner, planes)
                       : WriteWrapper(entry.point, entry.form, name, inner, planes);
  }
  // The wrapper after a macro that gave another name to the entry function, and to the fields and
  // variables that are called like it.
  static std::string WrapperAfterMacro(const Entry& entry, const std::string& name,
                                       const std::string& inner, std::size_t planes) {
    const std::string own = entry.point.prefix + "wrapper";
    return WithWords(Wrapper(entry, own, inner, planes),
                     {{own, name}, {entry.point.name, entry.point.prefix + entry.point.name}});
  }

  void AddWrappers(const Entry& entry, std::size_t end, const std::string& inner,
                   const std::vector<std::string>& undefined) {
    const std::string name = Renames(entry) ? entry.point.name : options_.wrapper_entry;
    std::string added =
        fmt::format("\n\n// Written by clipc: `{}` {}.\n", name,
                    entry.pixel ? "discards outside of the clip planes" : "with its clip planes");
    for (const std::string& word : undefined) added += fmt::format("#undef {}\n", word);
    const bool by_macro = std::ranges::find(undefined, entry.point.name) != undefined.end();
    const auto wrapper = by_macro ? WrapperAfterMacro : Wrapper;
    added += wrapper(entry, name, inner, entry.planes);
    const std::size_t most = std::min<std::size_t>(entry.planes, options_.variants.value_or(0));
    for (std::size_t count = 0; options_.variants && count <= most; ++count)
      added += "\n" + wrapper(entry, fmt::format("{}_{}", name, count), inner, count);
    CheckMacros(entry.point, end, added);
    const bool ends_line = end < text_.size() && (text_[end] == '\n' || text_[end] == '\r');
    if (options_.source_lines) {
      added += LineDirective(end);
    } else if (ends_line) {
      added.pop_back();
    }
    edits_.push_back({{end, end}, std::move(added)});
  }

  // Reports a macro of the function's own body that is a word of the wrapper after it.
  void CheckMacros(const EntryPoint& point, std::size_t end, const std::string& wrapper) {
    const auto definition = source_->InMainText(point.definition);
    if (!definition) return;
    const std::string_view body =
        std::string_view(text_).substr(definition->begin, end - definition->begin);
    for (const std::string& name : MacrosIn(body)) {
      if (WithWords(wrapper, {{name, ""}}) == wrapper) continue;
      diagnostics_->Report(point.definition, diag::RewriteMacro, point.name, name);
      return;
    }
  }

  // The line that says which line of the user's file follows.
  std::string LineDirective(std::size_t offset) const {
    const auto line =
        std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n') + 1;
    std::string path;
    for (const char c : options_.path) {
      if (c == '"' || c == '\\') path += '\\';
      path += c;
    }
    return fmt::format("#line {} \"{}\"\n", line, path);
  }

  // The text with the line ends of the user's file.
  std::string WithLineEnds(const std::string& text) const {
    const std::size_t first = text_.find('\n');
    if (first == std::string::npos || first == 0 || text_[first - 1] != '\r') return text;
    std::string result;
    for (const char c : text) {
      if (c == '\n') result += '\r';
      result += c;
    }
    return result;
  }

  const std::string& text_;
  const Options& options_;
  const Source* source_ = nullptr;  // of the entry that is added
  Diagnostics* diagnostics_ = nullptr;
  std::string head_;  // what comes before the first line
  std::vector<Edit> edits_;
};

}  // namespace

std::string Rewrite(const std::string& text, std::span<const Entry> entries,
                    const Options& options) {
  Rewriter rewriter(text, options);
  for (const Entry& entry : entries) rewriter.Add(entry);
  return rewriter.Finish();
}

}  // namespace clipc::rewrite
