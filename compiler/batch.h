// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compiler/batch_index.h"
#include "compiler/compile.h"
#include "compiler/options.h"
#include "compiler/permutations.h"
#include "compiler/run_result.h"

// The compilation of many permutations of a few shaders in one run: docs/permutations.md.
namespace clipc {

// Whether the command line asks for a batch, by a manifest or a macro with several values.
bool WantsBatch(const CommandLine& command);

// Runs a batch. `arguments` are those that `command` was read from.
RunResult RunBatch(std::span<const char* const> arguments, CommandLine command);

// A batch whose shaders are known.
struct BatchOfGroups {
  std::vector<ShaderGroup> groups;
  CompileResult first;  // what was read to know them: its messages and dependencies
  // What stands for the request, so that --resume goes on with the same one; empty: nothing does.
  std::string identity;
  // Returns the text of the index; `entries` are those of the groups, in their order.
  std::function<std::string(const std::vector<BatchEntry>& entries)> render;
};
RunResult RunBatch(CommandLine command, BatchOfGroups batch);

}  // namespace clipc
