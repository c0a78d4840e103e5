// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/gl.h"
#include "study/program/commands.h"

namespace clipc::study {

int RunScene(const std::vector<std::string>&) { throw draw::DrawError(kUsage); }

}  // namespace clipc::study
