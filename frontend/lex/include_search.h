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

// A file that is being read: the main file, or one that an #include entered.
struct EnteredFile {
  unsigned id = 0;                 // a different one each time that the file is entered
  const void* identity = nullptr;  // of the file itself; null for text that is not in a file
  std::string name;
  std::string folder;
  std::uint32_t included_at = 0;  // the location of the #include
};

// The folders in which an include is looked for: the folder of the file that includes it, the
// folder of the file that includes this one and so on, then `include_dirs`. "" is the current
// folder.
std::vector<std::string> IncludeFolders(std::span<const EnteredFile> stack,
                                        const std::vector<std::string>& include_dirs);

struct FoundInclude {
  std::string path;      // folder joined with `spelling`
  std::string spelling;  // the name as the file system has it
};

// Looks for an include file as Windows does: `\` separates folders and case does not matter. The
// first folder with a match wins; in each, an exact match wins over one in another case.
std::optional<FoundInclude> FindIncludeLikeWindows(const std::vector<std::string>& folders,
                                                   std::string_view name);

// Reports an include file that does not exist, unless the last error is one at the same place. With
// a `sandbox`, whether there is such a file outside of it is not said.
void ReportMissingInclude(Span where, const std::string& name,
                          const std::vector<std::string>& folders, const std::string& sandbox,
                          Diagnostics& diagnostics);

// Reports that includes are nested too deeply. If a file includes itself, the message names the
// cycle and points to the #include that closes it.
void ReportIncludeTooDeep(std::span<const EnteredFile> stack, Diagnostics& diagnostics);

}  // namespace clipc
