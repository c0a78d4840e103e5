// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/bench/reference_compilers.h"

#include <fstream>
#include <iterator>
#include <vector>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv_cross/spirv_glsl.hpp>

#include "tools/harness/glslang_includer.h"

namespace clipc::bench {

void StartReferenceCompilers() { glslang::InitializeProcess(); }
void StopReferenceCompilers() { glslang::FinalizeProcess(); }

namespace {

std::optional<std::string> CompileText(const std::string& hlsl, const ProgramRequest& request) {
  // By stage.
  constexpr EShLanguage kLanguages[] = {EShLangVertex,   EShLangFragment,    EShLangCompute,
                                        EShLangGeometry, EShLangTessControl, EShLangTessEvaluation};
  static_assert(std::size(kLanguages) == kStageCount);
  const auto prefix = StageOf(request.first().profile.substr(0, 2));
  const EShLanguage stage = kLanguages[static_cast<std::size_t>(prefix.value_or(Stage::kVertex))];
  glslang::TShader shader(stage);
  const char* text = hlsl.c_str();
  const char* name = request.first().path.c_str();
  const int length = static_cast<int>(hlsl.size());
  shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
  shader.setEntryPoint(request.first().entry.c_str());
  shader.setSourceEntryPoint(request.first().entry.c_str());
  shader.setEnvInput(glslang::EShSourceHlsl, stage, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  const std::string preamble = harness::DefineLines(request.defines);
  shader.setPreamble(preamble.c_str());
  harness::Includer includer(request.includes.dirs);
  const auto messages =
      static_cast<EShMessages>(EShMsgReadHlsl | EShMsgVulkanRules | EShMsgSpvRules);
  if (!shader.parse(GetDefaultResources(), 450, false, messages, includer)) return std::nullopt;
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages)) return std::nullopt;
  // glslang's own programs legalise HLSL unless told not to: without, its SPIR-V may break Vulkan's
  // rules.
  std::vector<unsigned> spirv;
  glslang::SpvOptions spirv_options;
  spirv_options.disableOptimizer = false;
  glslang::GlslangToSpv(*program.getIntermediate(stage), spirv, &spirv_options);
  try {
    spirv_cross::CompilerGLSL compiler(std::move(spirv));
    spirv_cross::CompilerGLSL::Options options;
    options.version = 450;
    compiler.set_common_options(options);
    // As its program does; OpenGL has no other textures.
    compiler.build_dummy_sampler_for_combined_images();
    compiler.build_combined_image_samplers();
    return compiler.compile();
  } catch (const spirv_cross::CompilerError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::string> CompileWithReferenceCompilers(const ProgramRequest& request) {
  return CompileText(request.first().text.value_or(""), request);
}

std::optional<std::string> CompileFileWithReferenceCompilers(const ProgramRequest& request) {
  std::ifstream file(request.first().path, std::ios::binary);
  return CompileText({std::istreambuf_iterator<char>(file), {}}, request);
}

}  // namespace clipc::bench
