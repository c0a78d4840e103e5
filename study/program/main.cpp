// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <exception>
#include <string>

#include "study/program/commands.h"

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string(argv[1]) == "scene")
      return clipc::study::RunScene({argv + 1, argv + argc});
    return clipc::study::RunStudy({argv, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-study: %s\n", error.what());
    return 2;
  }
}
