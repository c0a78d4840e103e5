// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace clipc {

// "; did you mean `vs_5_0` or `vs_5_1`?" for a `name` that is not one of `names`. Lists all `names`
// when there are not many and none is near; empty when there is nothing to offer.
std::string Suggest(std::string_view name, std::span<const std::string_view> names);

}  // namespace clipc
