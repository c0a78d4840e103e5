// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tools/draw/commands.h"

int main(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  try {
    if (command == "capture") return clipc::draw::RunCapture(argc - 1, argv + 1);
    if (command == "pixels") return clipc::draw::RunPixels(argc - 1, argv + 1);
    if (command == "compare") return clipc::draw::RunCompare(argc - 1, argv + 1);
    if (command == "devices") return clipc::draw::RunDevices();
    std::fputs(clipc::draw::kUsage, stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-draw: %s\n", error.what());
    return 2;
  }
}
