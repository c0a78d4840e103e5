// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/batch/permutations.h"

namespace clipc {

// Reads the manifest that --batch names: docs/permutations.md. `arguments` are those of the command
// line, which hold for every shader of it, --batch among them.
Result<std::vector<ShaderGroup>> ReadManifest(const std::string& path,
                                              std::span<const char* const> arguments);
// Reads the text of a manifest; `path` is for messages.
Result<std::vector<ShaderGroup>> ParseManifest(const std::string& path, const std::string& text,
                                               std::span<const char* const> arguments);

}  // namespace clipc
