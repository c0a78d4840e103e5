// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/glslang_process.h"

#include <algorithm>

#include <glslang/Public/ShaderLang.h>

// Of compiler/library/late_streams.cpp, in programs that are linked with it.
extern "C" [[gnu::weak]] void clipc_prepare_glslang();

namespace clipc::link {

void InitializeGlslang() {
  static const bool kIsInitialized = [] {
    if (clipc_prepare_glslang) clipc_prepare_glslang();
    return glslang::InitializeProcess();
  }();
  (void)kIsInitialized;
}

std::vector<GlslangError> GlslangErrors(std::string_view log) {
  constexpr std::string_view kError = "ERROR: ", kFile = "0:", kAfterLine = ": ";
  std::vector<GlslangError> errors;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    std::string_view text = log.substr(0, end);
    log.remove_prefix(std::min(end + 1, log.size()));
    if (!text.starts_with(kError) || text.find("compilation errors") != text.npos) continue;
    text.remove_prefix(kError.size());
    const std::size_t after = text.find(kAfterLine);
    if (!text.starts_with(kFile) || after == text.npos) {
      errors.push_back({"", text});
    } else {
      errors.push_back({text.substr(kFile.size(), after - kFile.size()),
                        text.substr(after + kAfterLine.size())});
    }
  }
  if (errors.empty()) errors.push_back({"", "glslang gives no reason"});
  return errors;
}

}  // namespace clipc::link
