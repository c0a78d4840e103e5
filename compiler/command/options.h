// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "compiler/command/command_line.h"

namespace clipc {

struct ParsedCommandLine {
  CommandLine command;
  Result<> result;  // what is wrong with the arguments
};

// Reads a command line. `arguments` do not include the name of the program. fxc's spelling with a
// slash (/T vs_5_0) is an option when the argument is not a file; an existing file, or a name in an
// existing folder, is an input. @FILE stands for the words of that file.
ParsedCommandLine ParseCommandLine(std::span<const char* const> arguments);

// The text of --help: all topics, or one.
std::string HelpText(std::string_view topic = {});

}  // namespace clipc
