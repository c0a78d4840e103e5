// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
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

// The outputs of a result, in the order in which they are written. The texts are moved out of the
// result. A failed compile has no files, but perhaps a dump of a stage before the failure.
Result<std::vector<OutputPiece>> CollectOutputs(const CommandLine& command,
                                                const OutputPaths& paths, CompileResult& result);

}  // namespace clipc
