// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "backend-glsl/writer/context.h"

// Functions that GLSL or the target lacks, written where they are first needed.
namespace clipc::glsl {

// A name for a parameter or local of a function that is being defined, unlike every name that the
// function may mention.
std::string Fresh(WriterContext& context, std::string_view wanted);

// The GLSL name of helper `name`; defines it by define(GLSL name) when `key` is new for that name.
using DefineHelper = std::function<std::string(const std::string& function)>;
std::string Helper(WriterContext& context, std::string_view name, const std::string& key,
                   const DefineHelper& define);

// Whether a helper of that name and key is defined.
bool HasHelper(const WriterContext& context, std::string_view name, std::string_view key);

}  // namespace clipc::glsl
