// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/kept_blocks.h"
#include "base/system.h"
#include "compiler/driver.h"

namespace clipc {
extern const char kCommit[];  // made by cmake/write_commit.cmake
}  // namespace clipc

int main(int argc, char** argv) {
  clipc::KeepBlocksToTheEnd();
  clipc::system::PrepareStandardStreams();
  return clipc::RunCommandLine(clipc::system::Arguments(argc, argv), clipc::kCommit);
}
