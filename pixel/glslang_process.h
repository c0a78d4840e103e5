// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <vector>

// What every use of glslang has in common.
namespace clipc::pixel {

// Makes glslang's tables of the process, once. They are never freed: a thread may use them until
// the end.
void InitializeGlslang();

struct GlslangError {
  std::string_view line;  // "12"; empty: of the whole shader
  std::string_view text;  // "'x' : undeclared identifier"
};
// The errors in glslang's log, whose last line is a summary. At least one.
std::vector<GlslangError> GlslangErrors(std::string_view log);

}  // namespace clipc::pixel
