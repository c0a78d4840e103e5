// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/batch/permutations.h"

namespace clipc {

struct Manifest {
  std::vector<ShaderGroup> groups;
  std::string error;  // not empty: what is wrong, and where
};

// Reads the manifest that --batch names: docs/permutations.md. `arguments` are those of the command
// line, which hold for every shader of it, --batch among them.
Manifest ReadManifest(const std::string& path, std::span<const char* const> arguments);
// Reads the text of a manifest; `path` is for messages.
Manifest ParseManifest(const std::string& path, const std::string& text,
                       std::span<const char* const> arguments);

}  // namespace clipc
