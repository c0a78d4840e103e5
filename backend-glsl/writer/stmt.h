// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/writer/code.h"

// Functions and their statements.
namespace clipc::glsl {

// Writes all functions that `main` reaches, and `main` last.
void WriteFunctions(Code& code);
// The GLSL name of a helper function of the program; writes the function when it is new.
std::string HelperFunction(Code& code, ir::FunctionId id);

}  // namespace clipc::glsl
