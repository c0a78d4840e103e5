// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The program, which `npx clipc` runs.
#include <cstddef>
#include <cstdio>
#include <span>
#include <vector>

#include <unistd.h>

#include "compiler/driver.h"
#include "web/module/strings.h"

namespace clipc {
extern const char kCommit[];  // made by cmake/write_commit.cmake
}  // namespace clipc

#define CLIPC_EXPORT(name) __attribute__((export_name(#name)))

extern "C" {

// Runs the program, with its files. `strings` are the working directory and the arguments. Returns
// the exit status.
CLIPC_EXPORT(clipc_module_run) int clipc_module_run(const char* strings, std::size_t size) {
  const std::vector<const char*> words = clipc::StringsIn({strings, size});
  if (chdir(words[0]) != 0) std::perror(words[0]);
  const int status = clipc::RunCommandLine(std::span(words).subspan(1), clipc::kCommit);
  std::fflush(nullptr);
  return status;
}

}  // extern "C"
