// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/permutations.h"

namespace clipc {

enum class BatchStatus : std::uint8_t { kNotCompiled, kCompiled, kFailed };

// A setting, and the files that hold its outputs. Settings may share files.
struct BatchEntry {
  std::string name;  // of the files that it would have alone
  std::string source, entry, profile, target;
  std::vector<std::pair<std::string, std::optional<std::string>>> defines;
  BatchStatus status = BatchStatus::kNotCompiled;
  int exit_code = 0;
  std::vector<std::pair<std::string, std::string>> files;  // kind and name
  std::map<std::string, std::string> initial_values;       // CompileResult::initial_values
};

// Fills in the source, entry, profile, target and defines of the group's setting `number`.
void Describe(const ShaderGroup& group, std::size_t number, BatchEntry& entry);

// The index as JSON: docs/permutations.md.
std::string RenderIndex(const std::vector<BatchEntry>& entries);

}  // namespace clipc
