// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

namespace clipc {

// The files that a batch has written, by what is in them: outputs with the same extension and the
// same contents are one file.
class SharedFiles {
 public:
  // `folder` is put before the names of files.
  explicit SharedFiles(std::string folder) : folder_(std::move(folder)) {}

  // Returns the written file that has the extension and the contents of `file`; `file` itself,
  // which is remembered, if there is none.
  std::string Share(const std::string& file, const std::string& contents);

 private:
  struct Written {
    std::string file;
    std::optional<std::string> contents;  // none: they are read from the file
  };

  std::string folder_;
  std::size_t room_ = std::size_t{1} << 20;  // the bytes of contents that may still be kept
  std::unordered_multimap<std::size_t, Written> files_;  // by the hash of extension and contents
};

}  // namespace clipc
