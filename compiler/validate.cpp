// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/validate.h"

#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/build_info.h>

namespace clipc {
namespace {

// glslang's process-wide tables. Never freed: validation may run on any thread until the end.
void InitializeOnce() {
  static const bool initialized = glslang::InitializeProcess();
  (void)initialized;
}

// "ERROR: 0:12: 'x' : message" per line => "line 12: 'x' : message". glslang closes with a summary
// of its own.
std::vector<std::string> Problems(std::string_view log) {
  std::vector<std::string> problems;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    std::string_view line = log.substr(0, end);
    log.remove_prefix(std::min(end + 1, log.size()));
    constexpr std::string_view kError = "ERROR: ";
    if (!line.starts_with(kError) || line.find("compilation errors") != std::string_view::npos)
      continue;
    line.remove_prefix(kError.size());
    const std::size_t colon = line.find(':', 2);
    if (line.starts_with("0:") && colon != std::string_view::npos) {
      problems.push_back(fmt::format("line {}{}", line.substr(2, colon - 2), line.substr(colon)));
    } else {
      problems.emplace_back(line);
    }
  }
  if (problems.empty()) problems.emplace_back("no reason given");
  return problems;
}

}  // namespace

std::vector<std::string> Validate(const std::string& glsl, const glsl::Target& target,
                                  ShaderStage stage) {
  InitializeOnce();
  const EShLanguage language = stage == ShaderStage::kVertex ? EShLangVertex : EShLangFragment;
  auto messages = EShMsgDefault;
  glslang::TShader shader(language);
  if (target.IsVulkan()) {
    messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  }
  const char* text = glsl.data();
  const int length = static_cast<int>(glsl.size());
  shader.setStringsWithLengths(&text, &length, 1);
  if (!shader.parse(GetDefaultResources(), target.version(), false, messages)) {
    return Problems(shader.getInfoLog());
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages)) return Problems(program.getInfoLog());
  return {};
}

std::string ValidatorName() {
  return fmt::format("glslang {}.{}.{}", GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR,
                     GLSLANG_VERSION_PATCH);
}

}  // namespace clipc
