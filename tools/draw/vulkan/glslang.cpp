// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/glslang.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>

namespace clipc::draw::vulkan {
namespace {

// Never freed, as compiler/validate.cpp has it.
void InitializeOnce() {
  static const bool initialized = glslang::InitializeProcess();
  (void)initialized;
}

// Looks beside the including file, then in the folders given.
class Includer : public glslang::TShader::Includer {
 public:
  explicit Includer(const std::vector<std::string>& folders) : folders_(folders) {}

  IncludeResult* includeLocal(const char* header, const char* includer, size_t) override {
    const std::string from = includer;
    const std::size_t slash = from.rfind('/');
    if (IncludeResult* found =
            Open((slash == std::string::npos ? "" : from.substr(0, slash + 1)) + header))
      return found;
    return includeSystem(header, includer, 0);
  }
  IncludeResult* includeSystem(const char* header, const char*, size_t) override {
    for (const std::string& folder : folders_) {
      if (IncludeResult* found = Open(folder + "/" + header)) return found;
    }
    return nullptr;
  }
  void releaseInclude(IncludeResult* result) override {
    if (result) delete static_cast<std::string*>(result->userData);
    delete result;
  }

 private:
  static IncludeResult* Open(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    std::ifstream file(path, std::ios::binary);
    if (!file) return nullptr;
    auto* text = new std::string(std::istreambuf_iterator<char>(file), {});
    return new IncludeResult(path, text->data(), text->size(), text);
  }

  const std::vector<std::string>& folders_;
};

std::string Preamble(const HlslSource& source) {
  std::string text = "#undef VULKAN\n";  // glslang's own
  for (const std::string& define : source.defines) {
    const std::size_t equals = define.find('=');
    const bool has_value = equals != std::string::npos;
    text += "#define " + define.substr(0, equals) + " " +
            (has_value ? define.substr(equals + 1) : "1") + "\n";
  }
  // HLSL's row_major is glslang's.
  if (source.row_major) text += "#pragma pack_matrix(row_major)\n";
  return text;
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
  glslang::GlslangToSpv(*program.getIntermediate(EShLangVertex), spirv, &logger, &options);
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

Spirv SpirvOfGlsl(const std::string& glsl) {
  InitializeOnce();
  glslang::TShader shader(EShLangVertex);
  const char *text = glsl.c_str(), *name = "";
  const int length = static_cast<int>(glsl.size());
  SetText(shader, &text, &length, &name);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangVertex, glslang::EShClientVulkan, 100);
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
  Includer includer(source.include_dirs);
  const auto messages =
      static_cast<EShMessages>(EShMsgReadHlsl | EShMsgVulkanRules | EShMsgSpvRules |
                               EShMsgHlslOffsets | EShMsgHlslLegalization);
  Spirv spirv = Translate<PeerRefuses>(shader, includer, messages, legalize);
  if (legalize) Validate(spirv);
  return spirv;
}

}  // namespace clipc::draw::vulkan
