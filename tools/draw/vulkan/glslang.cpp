// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/glslang.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>

#include "tools/harness/glslang_includer.h"

namespace clipc::draw::vulkan {
namespace {

// Initializes glslang once and never frees it, as compiler/validate.cpp does.
void InitializeOnce() {
  static const bool kInitialized = glslang::InitializeProcess();
  (void)kInitialized;
}

std::string Preamble(const HlslSource& source) {
  // glslang defines VULKAN itself, and its row_major is HLSL's.
  return "#undef VULKAN\n" + harness::DefineLines(source.defines) +
         (source.row_major ? "#pragma pack_matrix(row_major)\n" : "");
}

template <typename Error>
Spirv Translate(glslang::TShader& shader, glslang::TShader::Includer& includer,
                EShMessages messages, bool optimize) {
  if (!shader.parse(GetDefaultResources(), 110, false, messages, includer)) {
    throw Error(std::string("glslang refuses the shader:\n") + shader.getInfoLog());
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages) || !program.mapIO())
    throw Error(std::string("glslang cannot link the shader:\n") + program.getInfoLog());
  glslang::SpvOptions options;
  options.disableOptimizer = !optimize;
  Spirv spirv;
  spv::SpvBuildLogger logger;
  glslang::GlslangToSpv(*program.getIntermediate(shader.getStage()), spirv, &logger, &options);
  if (spirv.empty()) throw Error("glslang makes no SPIR-V:\n" + logger.getAllMessages());
  return spirv;
}

void SetText(glslang::TShader& shader, const char* const* text, const int* length,
             const char* const* name) {
  shader.setStringsWithLengthsAndNames(text, length, name, 1);
}

void Validate(const Spirv& spirv) {
  std::string problem;
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_0);
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
        if (problem.empty()) problem = message;
      });
  spvtools::ValidatorOptions options;
  options.SetSkipBlockLayout(true);  // HLSL's is not Vulkan 1.0's
  if (!tools.Validate(spirv.data(), spirv.size(), options))
    throw PeerRefuses("glslang makes invalid SPIR-V: " + problem);
}

}  // namespace

Spirv SpirvOfGlsl(const std::string& glsl, ShaderStage stage) {
  InitializeOnce();
  const EShLanguage language = stage == ShaderStage::kVertex ? EShLangVertex : EShLangFragment;
  glslang::TShader shader(language);
  const char *text = glsl.c_str(), *name = "";
  const int length = static_cast<int>(glsl.size());
  SetText(shader, &text, &length, &name);
  shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  glslang::TShader::ForbidIncluder includer;
  return Translate<DrawError>(shader, includer,
                              static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules), false);
}

Spirv SpirvOfHlsl(const HlslSource& source, bool legalize) {
  InitializeOnce();
  glslang::TShader shader(EShLangVertex);
  const char *text = source.text.c_str(), *name = source.path.c_str();
  const int length = static_cast<int>(source.text.size());
  SetText(shader, &text, &length, &name);
  shader.setEntryPoint(
      source.entry.c_str());  // not `main`: the shader may have another function of that name
  shader.setSourceEntryPoint(source.entry.c_str());
  shader.setEnvInput(glslang::EShSourceHlsl, EShLangVertex, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  shader.setEnvTargetHlslFunctionality1();
  // Direct3D numbers each kind of object apart.
  shader.setShiftBinding(glslang::EResSampler, 100);
  shader.setShiftBinding(glslang::EResTexture, 200);
  shader.setShiftBinding(glslang::EResSsbo, 400);
  shader.setShiftBinding(glslang::EResImage, 600);
  shader.setShiftBinding(glslang::EResUav, 800);
  shader.setAutoMapBindings(true);
  shader.setAutoMapLocations(true);
  const std::string preamble = Preamble(source);
  shader.setPreamble(preamble.c_str());
  harness::Includer includer(source.include_dirs);
  const auto messages =
      static_cast<EShMessages>(EShMsgReadHlsl | EShMsgVulkanRules | EShMsgSpvRules |
                               EShMsgHlslOffsets | EShMsgHlslLegalization);
  Spirv spirv = Translate<PeerRefuses>(shader, includer, messages, legalize);
  if (legalize) Validate(spirv);
  return spirv;
}

}  // namespace clipc::draw::vulkan
