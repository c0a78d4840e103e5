// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

namespace clipc {

// The make rule `target: dependencies`, and an empty rule for each included file, so that one that
// is deleted does not stop the build. Understood by make and ninja.
std::string DependencyRule(const std::string& target, const std::vector<std::string>& dependencies);

}  // namespace clipc
