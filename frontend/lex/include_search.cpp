// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/include_search.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc {
namespace {

namespace fs = std::filesystem;

// Names are UTF-8 on every system: a path made of a plain string would not be, on Windows.
fs::path ToPath(const std::string& text) { return std::u8string(text.begin(), text.end()); }

std::string ToText(const fs::path& path) {
  const std::u8string text = path.generic_u8string();
  return {text.begin(), text.end()};
}

// The name of the entry of `folder` that is `name` in any case: `name` itself if such an entry
// exists, otherwise the first in alphabetical order; empty if there is none.
std::string MatchEntry(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (name == "." || name == ".." || fs::exists(folder / ToPath(name), error)) return name;
  std::string best;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error);
  for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
    std::string candidate = ToText(entry->path().filename());
    if (EqualIgnoringCase(candidate, name) && (best.empty() || candidate < best)) best = candidate;
  }
  return best;
}

// The path `relative` with each part spelled as the file system has it below `folder`, in any case;
// none if there is no such regular file.
std::optional<fs::path> MatchPath(const fs::path& folder, const fs::path& relative) {
  fs::path matched;
  for (const fs::path& part : relative) {
    if (part.has_root_directory()) {
      matched /= part;
      continue;
    }
    const std::string entry = MatchEntry(folder / matched, ToText(part));
    if (entry.empty()) return std::nullopt;
    matched /= ToPath(entry);
  }
  std::error_code error;
  if (!fs::is_regular_file(folder / matched, error)) return std::nullopt;
  return matched;
}

// " through `a`, `b`": the files between the two ends of a cycle.
std::string Through(std::span<const EnteredFile> files) {
  std::string text;
  for (const EnteredFile& file : files)
    text += fmt::format("{}`{}`", text.empty() ? " through " : ", ", file.name);
  return text;
}

}  // namespace

std::vector<std::string> IncludeFolders(std::span<const EnteredFile> stack,
                                        const std::vector<std::string>& include_dirs) {
  std::vector<std::string> folders;
  const auto add = [&](const std::string& folder) {
    const std::string plain = folder == "." ? "" : folder;
    if (std::ranges::find(folders, plain) == folders.end()) folders.push_back(plain);
  };
  for (auto file = stack.rbegin(); file != stack.rend(); ++file) {
    if (file->identity) add(file->folder);
  }
  for (const std::string& folder : include_dirs) add(folder);
  return folders;
}

std::optional<FoundInclude> FindIncludeLikeWindows(const std::vector<std::string>& folders,
                                                   std::string_view name) {
  std::string portable(name);
  std::ranges::replace(portable, '\\', '/');
  try {
    for (const std::string& folder : folders) {
      if (auto matched = MatchPath(ToPath(folder), ToPath(portable)))
        return FoundInclude{ToText(ToPath(folder) / *matched), ToText(*matched)};
    }
  } catch (const fs::filesystem_error&) {
    return std::nullopt;  // on Windows: the name, or one in that folder, is not Unicode
  }
  return std::nullopt;
}

void ReportMissingInclude(Span where, const std::string& name,
                          const std::vector<std::string>& folders, const std::string& sandbox,
                          Diagnostics& diagnostics) {
  const auto& all = diagnostics.all();
  if (!all.empty() && all.back().severity == Severity::kError && all.back().span == where) return;
  std::string list;
  for (const std::string& folder : folders) {
    list += fmt::format("{}`{}`", list.empty() ? "" : ", ", folder.empty() ? "." : folder);
  }
  if (sandbox.empty()) {
    diagnostics.Report(where, diag::MissingInclude, name, list);
  } else {
    diagnostics.Report(where, diag::IncludeNotInSandbox, name, sandbox, list);
  }
}

void ReportIncludeTooDeep(std::span<const EnteredFile> stack, Diagnostics& diagnostics) {
  // The first file that is entered again closes the cycle.
  for (std::size_t end = 1; end < stack.size(); ++end) {
    for (std::size_t begin = 0; stack[end].identity && begin < end; ++begin) {
      if (stack[begin].identity != stack[end].identity) continue;
      const Span where{stack[end].included_at, stack[end].included_at};
      diagnostics.Report(where, diag::IncludeCycle, stack[end].name,
                         Through(stack.subspan(begin + 1, end - begin - 1)));
      return;
    }
  }
  const Span where{stack.back().included_at, stack.back().included_at};
  diagnostics.Report(where, diag::IncludeTooDeep, static_cast<int>(stack.size()));
}

}  // namespace clipc
