// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/glslang.h"

#include <glslang/Public/ShaderLang.h>
#include <spirv-tools/libspirv.hpp>

#include "tools/draw/vulkan/glslang.h"
#include "tools/harness/glslang_includer.h"

namespace clipc::draw::reference_compiler {
namespace {

using vulkan::Spirv;

std::string Preamble(const HlslSource& source) {
  // glslang defines VULKAN itself, and its row_major is HLSL's.
  return "#undef VULKAN\n" + harness::DefineLines(source.defines) +
         (source.row_major ? "#pragma pack_matrix(row_major)\n" : "");
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
    throw DrawError("glslang makes invalid SPIR-V: " + problem);
}

}  // namespace

Spirv SpirvOfHlsl(const HlslSource& source, bool legalize) {
  vulkan::InitializeGlslang();
  glslang::TShader shader(EShLangVertex);
  const char *text = source.text.c_str(), *name = source.path.c_str();
  const int length = static_cast<int>(source.text.size());
  shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
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
  Spirv spirv = vulkan::Translate(shader, includer, messages, legalize);
  if (legalize) Validate(spirv);
  return spirv;
}

}  // namespace clipc::draw::reference_compiler
