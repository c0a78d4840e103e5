// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clipc {

// Lists a SPIR-V module as text, in the form of spirv-dis, which spirv-as reads. Words that are not
// a module give a comment that says why. Empty where clipc was built without SPIR-V.
std::string ListSpirv(const std::vector<std::uint32_t>& words);

}  // namespace clipc
