// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "compiler/command/command_line.h"
#include "compiler/command/place_outputs.h"
#include "compiler/compile/result.h"

namespace clipc {

// A file that a compile makes.
struct OutputPiece {
  std::string kind;  // "glsl", "fragment", "table" and so on: see collect_outputs.cpp
  std::string path;  // "-": standard output
  std::string contents;
};

// Adds the outputs of a result to `pieces`, in the order in which they are written. The texts are
// moved out of the result. A failed compile has no files, but perhaps a dump of a stage before the
// failure. Returns the problem in words; empty if there is none.
std::string CollectOutputs(const CommandLine& command, const OutputPaths& paths,
                           CompileResult& result, std::vector<OutputPiece>& pieces);

}  // namespace clipc
