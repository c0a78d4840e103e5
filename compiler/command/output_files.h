// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace clipc {

// Output files that appear all at once or not at all. Each is written to a temporary file beside
// it; the temporary files are renamed when every one is complete. A path that is not a regular file
// (a device, a pipe) is written in place, just before the renaming.
class OutputFiles {
 public:
  // What becomes of a file that has the contents already. A make rule needs a new time of the file
  // that it names; of many outputs, those that do not change keep theirs, and so what is made of
  // them.
  enum class Unchanged : std::uint8_t { kReplaced, kKept };

  explicit OutputFiles(Unchanged unchanged = Unchanged::kReplaced) : unchanged_(unchanged) {}
  ~OutputFiles();  // removes the temporary files that were not renamed
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  // Adds a file to write; the path "-" is standard output.
  void Add(std::string path, std::string contents);

  // Writes the files. Where there is a problem, every regular file is as it was. Call it once.
  Result<> Commit();

 private:
  struct File {
    std::string path;
    std::string contents;
    std::string temporary;  // empty: written in place
    bool is_kept = false;
  };
  Result<> Prepare(File& file);

  Unchanged unchanged_;

  std::vector<File> files_;
};

}  // namespace clipc
