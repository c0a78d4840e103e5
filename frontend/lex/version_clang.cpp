// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <clang/Basic/Version.inc>

#include "frontend/lex/source.h"

namespace clipc {

std::string LlvmName() { return "LLVM " CLANG_VERSION_STRING; }

}  // namespace clipc
