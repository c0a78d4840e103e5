// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "bench/peers.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <spirv_cross/spirv_glsl.hpp>
#include <vector>

namespace clipc::bench {

void StartPeers() { glslang::InitializeProcess(); }
void StopPeers() { glslang::FinalizeProcess(); }

std::optional<std::string> CompileWithPeers(const std::string& hlsl) {
  glslang::TShader shader(EShLangVertex);
  const char* text = hlsl.c_str();
  shader.setStrings(&text, 1);
  shader.setEntryPoint("main");
  shader.setSourceEntryPoint("main");
  shader.setEnvInput(glslang::EShSourceHlsl, EShLangVertex, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  const auto messages = static_cast<EShMessages>(EShMsgReadHlsl | EShMsgVulkanRules | EShMsgSpvRules);
  if (!shader.parse(GetDefaultResources(), 450, false, messages)) return std::nullopt;
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages)) return std::nullopt;
  std::vector<unsigned> spirv;
  glslang::SpvOptions spirv_options;
  spirv_options.disableOptimizer = false;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangVertex), spirv, &spirv_options);
  spirv_cross::CompilerGLSL compiler(std::move(spirv));
  spirv_cross::CompilerGLSL::Options options;
  options.version = 450;
  compiler.set_common_options(options);
  return compiler.compile();
}

}  // namespace clipc::bench
