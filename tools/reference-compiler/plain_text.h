// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/lex/token.h"

namespace clipc::draw::reference_compiler {

// The parts of a shader that its entry function needs, as plain HLSL without preprocessor. Left out
// are techniques, states, annotations and shader objects, which glslang does not understand in an
// effect file, and functions that the entry does not call.
std::string PlainText(const Tokens& tokens, const std::string& entry);

}  // namespace clipc::draw::reference_compiler
