// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "compiler/batch/permutations.h"
#include "compiler/command/collect_outputs.h"
#include "compiler/command/command_line.h"
#include "compiler/compile/message.h"

namespace clipc {

enum class BatchStatus : std::uint8_t { kNotCompiled, kCompiled, kFailed };

// A permutation, and the files that hold its outputs. Permutations may share files.
struct BatchEntry {
  std::string name;  // of the files that it would have alone
  std::string source, entry, profile, target;
  std::vector<std::pair<std::string, std::optional<std::string>>> defines;
  BatchStatus status = BatchStatus::kNotCompiled;
  int exit_code = 0;
  std::vector<std::pair<std::string, std::string>> files;  // kind and name
  std::vector<std::string> digests;  // of the contents of each file, Sha256; of a part
  std::shared_ptr<const std::vector<Message>> errors;  // null: none
};

// Fills in the source, entry, profile, target and defines of the group's permutation `number`.
void Describe(const ShaderGroup& group, std::size_t number, BatchEntry& entry);

// Which part of a batch an index is of: part 2 of 4 has the second of each four permutations.
struct ShardOfIndex {
  unsigned part = 1, parts = 1;
};

// The extension of a file's name, with its dot. Outputs with the same extension and the same
// contents are one file.
std::string_view ExtensionIn(std::string_view file);

// What stands beside an index, after its name, while its batch is not complete.
inline constexpr const char* kJournalSuffix = ".part";

// The index as JSON: docs/permutations.md. That of a part also has the digests.
std::string RenderIndex(const std::vector<BatchEntry>& entries, ShardOfIndex shard);

// The index of a batch, of the indexes at `paths` of all its parts: what one run that compiles all
// of them writes.
Result<std::string> MergeIndexes(const std::vector<std::string>& paths);

// The targets of the make rule: that of -MT, the index of a manifest, or all files of an effect, of
// which `ends` are those that are written last.
std::vector<std::string> RuleTargets(const CommandLine& command, std::span<const OutputPiece> ends,
                                     const std::vector<BatchEntry>& entries);

}  // namespace clipc
