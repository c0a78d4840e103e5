// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/compile.h"

namespace clipc {

enum class MessageFormat : std::uint8_t { kText, kMsvc, kJson, kSarif };

// A command line, understood but for the names that Compile checks (profile, target, passes).
struct CommandLine {
  enum class Action : std::uint8_t { kCompile, kHelp, kVersion };

  Action action = Action::kCompile;
  std::vector<std::string> inputs;
  CompileRequest request;  // without path and text
  std::string output;      // empty: standard output
  std::string table, reflection;
  std::string fragment;  // a file that gets the discard of --lower=discard
  bool write_dependencies = false;
  std::string dependency_file, dependency_target;
  MessageFormat format = MessageFormat::kText;
  unsigned jobs = 1;  // inputs compiled at once
};

struct ParsedCommandLine {
  CommandLine command;
  std::string error;  // not empty: what is wrong with the arguments
};

// `arguments` without the program's name. fxc's spelling with a slash (/T vs_5_0) is taken where
// the argument is no file: an existing file, or a name in an existing folder, is an input however
// it starts.
ParsedCommandLine ParseCommandLine(std::span<const char* const> arguments);

std::string HelpText();

}  // namespace clipc
