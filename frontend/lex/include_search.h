// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/span.h"

namespace clipc {

// One file on the way from the main file to the one being read.
struct EnteredFile {
  unsigned id = 0;                 // of this time it is read
  const void* identity = nullptr;  // of the file itself; null for text that is in no file
  std::string name;
  std::string folder;
  std::uint32_t included_at = 0;  // location of the directive
};

// Where an include is looked for: beside the file that includes it, beside that one's includer and
// so on, then `-I`.
std::vector<std::string> IncludeFolders(std::span<const EnteredFile> stack,
                                        const std::vector<std::string>& include_dirs);

struct FoundInclude {
  std::string path;      // folder joined with `spelling`
  std::string spelling;  // the name in the form that the file system has it
};

// Looks for an include file as Windows would where the exact name was not found: `\` parts folders
// and case does not matter. Folders are tried in order; in each, an exact match wins over one in
// another case. "" is the current folder.
std::optional<FoundInclude> FindIncludeLikeWindows(const std::vector<std::string>& folders,
                                                   std::string_view name);

// A missing include, unless an error at the same place has just said why.
void ReportMissingInclude(Span where, const std::string& name,
                          const std::vector<std::string>& folders, Diagnostics& diagnostics);

// The stack is as deep as it may be: names the cycle, placed where it closes, or says that there is
// none.
void ReportIncludeTooDeep(std::span<const EnteredFile> stack, Diagnostics& diagnostics);

}  // namespace clipc
