// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/options.h"

#include <fstream>
#include <iterator>

#include <getopt.h>

#include "tools/draw/inputs.h"

namespace clipc::draw {

std::vector<std::string> ParseOptions(int argc, char** argv,
                                      const std::map<std::string, Flag>& flags) {
  std::vector<option> table;
  std::vector<const std::function<void(const std::string&)>*> handlers;
  for (const auto& [name, flag] : flags) {
    table.push_back({name.c_str(), flag.takes_value ? required_argument : no_argument, nullptr,
                     static_cast<int>(handlers.size())});
    handlers.push_back(&flag.handle);
  }
  table.push_back({});
  optind = 1;
  for (int found; (found = getopt_long_only(argc, argv, "", table.data(), nullptr)) != -1;) {
    if (found == '?') throw DrawError("see clipc-draw without arguments");
    (*handlers[found])(optarg ? optarg : "");
  }
  return {argv + optind, argv + argc};
}

std::string OnlyPath(const std::vector<std::string>& paths) {
  if (paths.size() != 1) throw DrawError("one shader, please");
  return paths[0];
}

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw DrawError("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace clipc::draw
