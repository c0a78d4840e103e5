// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <span>

#include <fcntl.h>
#include <unistd.h>

#include "compiler/driver.h"

namespace {

// A closed standard stream's number would go to the next file that is opened, and messages or GLSL
// into it. A null device open for the wrong direction keeps the number, and using it is an error.
void KeepStandardNumbers() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) < 0) open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace

int main(int argc, char** argv) {
  KeepStandardNumbers();
  return clipc::RunCommandLine(std::span<const char* const>(argv + 1, argv + argc));
}
