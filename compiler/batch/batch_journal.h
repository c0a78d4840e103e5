// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace clipc {

// What a batch has compiled so far, beside its index: a run that is interrupted or that ends at an
// error leaves it, and --resume goes on from there. A line of JSON for each permutation, written
// when its files are complete; the line that an interrupt cuts off is not read.
class BatchJournal {
 public:
  struct Done {
    std::vector<std::pair<std::string, std::string>> files;  // kind and name
    std::vector<std::string> digests;  // of their contents now; the journal has none
    std::vector<std::string> dependencies;
  };

  // `identity` stands for the request of the batch: the journal of another request is not read.
  BatchJournal(std::string path, std::string identity);
  ~BatchJournal();
  BatchJournal(const BatchJournal&) = delete;
  BatchJournal& operator=(const BatchJournal&) = delete;

  // Reads what an earlier run did, by the name of the permutation. A permutation is left out if a
  // file that it was made of has another size or time since then.
  std::map<std::string, Done> Read() const;
  // Begins to write, in place of what is there. This and Add return what went wrong; empty on
  // success.
  Result<> Begin();
  Result<> Add(const std::string& name, const Done& done);
  // The batch is complete: nothing is left to resume.
  void Remove();

  const std::string& path() const { return path_; }

 private:
  Result<> Write(const std::string& line);

  std::string path_, identity_;
  int file_ = -1;
  std::map<std::string, std::string> stamps_;  // of the files read, as they were first seen
};

}  // namespace clipc
