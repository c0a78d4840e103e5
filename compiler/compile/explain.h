// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

namespace clipc {

// What --explain prints about the kind of diagnostic with the printed name `name`, or about all
// kinds with that code of fxc: the message, and for many kinds the rule, an example and the fix.
// Empty if nothing has the name.
std::string Explain(std::string_view name);

// "; did you mean `clip-plane-count`?", or empty.
std::string SuggestDiagnostic(std::string_view name);

}  // namespace clipc
