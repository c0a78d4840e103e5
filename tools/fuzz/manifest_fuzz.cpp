// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Reads any text as a manifest: either there is an error with a message, or groups whose
// permutations have names of files in one folder.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "compiler/batch/manifest.h"
#include "compiler/batch/permutations.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // An `@` may name a response file, which would be read.
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.find('@') != std::string_view::npos) return 0;
  const char* const arguments[] = {"--batch=fuzz.json", "-o", "out", "-DA={0,1}"};
  const auto groups = clipc::ParseManifest("fuzz.json", std::string(text), arguments);
  if (!groups && groups.problem().empty()) std::abort();
  if (!groups) return 0;
  if (groups->empty()) std::abort();
  for (const clipc::ShaderGroup& group : *groups) {
    const std::size_t count = std::min<std::size_t>(group.Count(), 20);
    for (std::size_t number = 0; number < count; ++number) {
      const std::string name = clipc::FileNameOf(group, number);
      if (name.empty() || name.find('/') != std::string::npos) std::abort();
      if (clipc::TitleOf(group, number).empty()) std::abort();
    }
  }
  return 0;
}
