// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

namespace clipc {

// The end of a run.
struct RunResult {
  int code = 0;  // the exit code
  // The files that were read for each input; one list for a batch. Empty: nothing was compiled, as
  // the options or the manifest are wrong.
  std::vector<std::vector<std::string>> files = {};
};

}  // namespace clipc
