// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <exception>
#include <string>

#include "tools/draw/commands.h"

using namespace clipc::draw;

int main(int argc, char** argv) {
  const Arguments arguments(argv + 1, argv + argc);
  const std::string command = arguments.empty() ? "" : arguments[0];
  try {
    if (command == "capture") return RunCapture(arguments);
    if (command == "pixels") return RunPixels(arguments);
    if (command == "pair") return RunPair(arguments);
    if (command == "link") return RunLink(arguments);
    if (command == "passes") return RunPasses(arguments);
    if (command == "image") return RunImage(arguments);
    if (command == "compare") return RunCompare(arguments);
    if (command == "machine-code") return RunMachineCode(arguments);
    if (command == "devices") return RunDevices();
    std::fputs(kUsage, stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-draw: %s\n", error.what());
    return 2;
  }
}
