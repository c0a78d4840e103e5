// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/glslang.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace clipc::draw::vulkan {

void InitializeGlslang() {
  static const bool kInitialized = glslang::InitializeProcess();
  (void)kInitialized;
}

Spirv Translate(glslang::TShader& shader, glslang::TShader::Includer& includer,
                EShMessages messages, bool optimize) {
  if (!shader.parse(GetDefaultResources(), 110, false, messages, includer)) {
    throw DrawError(std::string("glslang refuses the shader:\n") + shader.getInfoLog());
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages) || !program.mapIO())
    throw DrawError(std::string("glslang cannot link the shader:\n") + program.getInfoLog());
  glslang::SpvOptions options;
  options.disableOptimizer = !optimize;
  Spirv spirv;
  spv::SpvBuildLogger logger;
  glslang::GlslangToSpv(*program.getIntermediate(shader.getStage()), spirv, &logger, &options);
  if (spirv.empty()) throw DrawError("glslang makes no SPIR-V:\n" + logger.getAllMessages());
  return spirv;
}

Spirv SpirvOfGlsl(const std::string& glsl, Stage stage) {
  InitializeGlslang();
  constexpr EShLanguage kLanguages[] = {EShLangVertex,   EShLangFragment,    EShLangCompute,
                                        EShLangGeometry, EShLangTessControl, EShLangTessEvaluation};
  static_assert(std::size(kLanguages) == kStageCount);
  const EShLanguage language = kLanguages[static_cast<std::size_t>(stage)];
  glslang::TShader shader(language);
  const char *text = glsl.c_str(), *name = "";
  const int length = static_cast<int>(glsl.size());
  shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  glslang::TShader::ForbidIncluder includer;
  return Translate(shader, includer, static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules),
                   false);
}

}  // namespace clipc::draw::vulkan
