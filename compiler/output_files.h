// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace clipc {

// Output files that appear all at once or not at all: each is written to a temporary file beside
// it, and they are renamed only when every one is complete. What is no regular file (a device, a
// pipe) is written to last-minute, in place.
class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();  // removes the temporaries of what was not committed
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  // "-" is standard output.
  void Add(std::string path, std::string contents);

  // Empty on success; else what went wrong, and every regular file is as it was. Call it once.
  std::string Commit();

 private:
  struct File {
    std::string path;
    std::string contents;
    std::string temporary;  // empty: written in place
  };
  std::string Prepare(File& file);

  std::vector<File> files_;
};

// Files by identity: paths that name the same existing file, or are the same text, are one.
class FileSet {
 public:
  void Add(const std::string& path);
  bool Has(const std::string& path) const;

 private:
  std::set<std::string> paths_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  // device and number
};
bool IsDirectory(const std::string& path);

}  // namespace clipc
