// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "frontend/lex/token.h"

namespace clipc::draw::peer {

// A shader as plain HLSL without preprocessor: what its entry function needs of it. Techniques,
// states, annotations, shader objects and functions that the entry does not call are left out,
// which glslang does not understand in an effect file.
std::string PlainText(const Tokens& tokens, const std::string& entry);

}  // namespace clipc::draw::peer
