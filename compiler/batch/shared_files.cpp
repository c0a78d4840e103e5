// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/shared_files.h"

#include <functional>
#include <string_view>

#include "base/result.h"
#include "compiler/batch/batch_index.h"
#include "frontend/lex/source_text.h"

namespace clipc {

std::string SharedFiles::Share(const std::string& file, const std::string& contents) {
  const std::string_view extension = ExtensionIn(file);
  const std::hash<std::string_view> hash;
  const std::size_t key = hash(contents) ^ hash(extension) << 1;
  const auto has = [&](const Written& written) {
    if (written.contents) return *written.contents == contents;
    const Result<std::string> text = ReadText(folder_ + written.file);
    return text && *text == contents;
  };
  const auto [begin, end] = files_.equal_range(key);
  for (auto known = begin; known != end; ++known) {
    const Written& written = known->second;
    if (ExtensionIn(written.file) == extension && has(written)) return written.file;
  }
  const bool is_kept = contents.size() <= room_;
  if (is_kept) room_ -= contents.size();
  files_.emplace(key, Written{file, is_kept ? std::optional(contents) : std::nullopt});
  return file;
}

}  // namespace clipc
