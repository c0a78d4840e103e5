// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>

#include "backend-glsl/writer/code.h"

// Functions and their statements.
namespace clipc::glsl {

// A global variable that gets its value in `main`.
struct LateGlobal {
  std::string name, value;
};
// The text of all functions that `main` reaches, and of `main` last, which begins with `late`.
std::string WriteFunctions(Code& code, std::span<const LateGlobal> late);
// Writes the function that reads a member of a block, with that name, among the helper functions.
// It is a macro where the target accepts only constants and the indices of loops as indices, which
// a parameter is not.
void WriteReader(Code& code, ir::FunctionId reader, const std::string& name);
// The GLSL name of a helper function of the program; writes the function when it is new.
const std::string& HelperFunction(Code& code, ir::FunctionId id);

}  // namespace clipc::glsl
