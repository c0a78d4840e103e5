// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compiler/batch/batch_index.h"
#include "compiler/batch/permutations.h"
#include "compiler/command/collect_outputs.h"
#include "compiler/command/command_line.h"
#include "compiler/command/run_result.h"
#include "compiler/compile/result.h"

// The compilation of many permutations of a few shaders in one run: docs/permutations.md.
namespace clipc {

// Whether the command line asks for a batch, by a manifest or a macro with several values.
bool WantsBatch(const CommandLine& command);

// Runs a batch. `arguments` are those that `command` was read from.
RunResult RunBatch(std::span<const char* const> arguments, CommandLine command);

// What a batch writes when all is compiled.
struct BatchEnd {
  std::string index;                    // its text
  std::vector<OutputPiece> files = {};  // others, of all programs together
  CompileResult messages = {};
};

// A batch whose shaders are known.
struct BatchOfGroups {
  std::vector<ShaderGroup> groups;
  CompileResult first;  // what was read to know them: its messages and dependencies
  // What stands for the request, so that --resume goes on with the same one; empty: nothing does.
  std::string identity;
  // Makes the end; `entries` are those of the groups, in their order.
  std::function<BatchEnd(const std::vector<BatchEntry>& entries)> end;
  // Sees the result of each job before its files are written. May be null.
  std::function<void(std::size_t job, const CompileResult& result)> keep = {};
};
RunResult RunBatch(CommandLine command, BatchOfGroups batch);

}  // namespace clipc
