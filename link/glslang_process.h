// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <vector>

// The common parts of all uses of glslang.
namespace clipc::link {

// Makes glslang's tables of the process, once. They are never freed: a thread may use them until
// the process ends.
void InitializeGlslang();

struct GlslangError {
  std::string_view line;  // "12"; empty: of the whole shader
  std::string_view text;  // "'x' : undeclared identifier"
};
// Returns the errors in glslang's log, without the summary in its last line. There is at least one.
std::vector<GlslangError> GlslangErrors(std::string_view log);

}  // namespace clipc::link
