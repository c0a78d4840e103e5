// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "backend-glsl/writer/context.h"

namespace clipc::glsl {

// Names everything but functions and locals, which are named when they are declared. The names that
// the host sees come first and so keep their spelling.
Names NameEverything(WriterContext& context);
// The names of the functions, by FunctionId. Overloads are told apart by their parameters' types,
// so the types must have names.
std::vector<std::string> NameFunctions(WriterContext& context);

}  // namespace clipc::glsl
