// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tools/study/program/commands.h"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (!arguments.empty() && arguments[0] == "scene") return clipc::study::RunScene(arguments);
    return clipc::study::RunStudy(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-study: %s\n", error.what());
    return 2;
  }
}
