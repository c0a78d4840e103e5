// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

namespace clipc {

// The make rule `targets: dependencies`, and an empty rule for each included file, so that the
// build does not stop when such a file is deleted. make and ninja understand both.
std::string DependencyRule(const std::vector<std::string>& targets,
                           const std::vector<std::string>& dependencies);

}  // namespace clipc
