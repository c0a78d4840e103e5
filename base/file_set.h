// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace clipc {

// A set of files. Paths that name the same existing file, or that are the same text, are one file.
class FileSet {
 public:
  void Add(const std::string& path);
  bool Has(const std::string& path) const;

 private:
  static std::string Normal(const std::string& path);

  std::set<std::string> paths_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  // as system::FileStatus has them
};

// Whether the path names an existing folder.
bool IsDirectory(const std::string& path);

}  // namespace clipc
