// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/validate.h"

#include <climits>
#include <string_view>

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#if CLIPC_HAS_SPIRV
#include <glslang/SPIRV/GlslangToSpv.h>
#endif
#include <glslang/build_info.h>

#include "link/glslang_process.h"

namespace clipc {
namespace {

std::vector<std::string> Problems(std::string_view log) {
  std::vector<std::string> problems;
  for (const auto& [line, text] : link::GlslangErrors(log))
    problems.push_back(line.empty() ? std::string(text) : fmt::format("line {}: {}", line, text));
  return problems;
}

// A shader that glslang compiles and links.
class Linked {
 public:
  Linked(const std::string& glsl, const glsl::Target& target, Stage stage,
         const SpirvRequest* spirv)
      : language_(stage == Stage::kVertex ? EShLangVertex : EShLangFragment), shader_(language_) {
    auto messages = EShMsgDefault;
    if (target.IsVulkan() || spirv) messages = SetEnvironment(target.IsVulkan(), spirv);
    const char* text = glsl.data();
    const int length = static_cast<int>(glsl.size());
    shader_.setStringsWithLengths(&text, &length, 1);
    if (!shader_.parse(GetDefaultResources(), target.version(), false, messages)) {
      problems_ = Problems(shader_.getInfoLog());
      return;
    }
    program_.addShader(&shader_);
    if (!program_.link(messages) || (spirv && !program_.mapIO()))
      problems_ = Problems(program_.getInfoLog());
  }

  const std::vector<std::string>& problems() const { return problems_; }
  glslang::TIntermediate& program() { return *program_.getIntermediate(language_); }

 private:
  EShMessages SetEnvironment(bool is_vulkan, const SpirvRequest* spirv) {
    using namespace glslang;
    constexpr EShTargetClientVersion kVulkan[] = {EShTargetVulkan_1_0, EShTargetVulkan_1_1,
                                                  EShTargetVulkan_1_2, EShTargetVulkan_1_3,
                                                  EShTargetVulkan_1_1};
    constexpr EShTargetLanguageVersion kSpirv[] = {
        EShTargetSpv_1_0, EShTargetSpv_1_3, EShTargetSpv_1_5, EShTargetSpv_1_6, EShTargetSpv_1_4};
    const SpirvRequest request = spirv ? *spirv : SpirvRequest{};
    const auto version = static_cast<std::size_t>(request.vulkan);
    const auto language =
        request.version ? static_cast<EShTargetLanguageVersion>(1 << 16 | *request.version << 8)
                        : kSpirv[version];
    const EShClient client = is_vulkan ? EShClientVulkan : EShClientOpenGL;
    shader_.setEnvInput(EShSourceGlsl, language_, client, 100);
    shader_.setEnvClient(client, is_vulkan ? kVulkan[version] : EShTargetOpenGL_450);
    shader_.setEnvTarget(EShTargetSpv, is_vulkan ? language : EShTargetSpv_1_0);
    return static_cast<EShMessages>(is_vulkan ? EShMsgSpvRules | EShMsgVulkanRules
                                              : EShMsgSpvRules);
  }

  EShLanguage language_;
  glslang::TShader shader_;
  glslang::TProgram program_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> Validate(const std::string& glsl, const glsl::Target& target,
                                  Stage stage) {
  link::InitializeGlslang();
  return Linked(glsl, target, stage, nullptr).problems();
}

Spirv MakeSpirv(const std::string& glsl, const glsl::Target& target, Stage stage,
                const SpirvRequest& request, [[maybe_unused]] const std::string& name) {
  link::InitializeGlslang();
  Linked linked(glsl, target, stage, &request);
  Spirv made;
  made.problems = linked.problems();
  if (!made.problems.empty()) return made;
#if CLIPC_HAS_SPIRV
  glslang::SpvOptions options;
  options.generateDebugInfo = request.debug_info;
  if (request.debug_info) {
    linked.program().setSourceFile(name.c_str());
    linked.program().addSourceText(glsl.data(), glsl.size());
  }
  if (!request.entry.empty()) linked.program().setEntryPointName(request.entry.c_str());
  linked.program().setNanMinMaxClamp(request.nan_clamp);
  spv::SpvBuildLogger logger;
  glslang::GlslangToSpv(linked.program(), made.words, &logger, &options);
  if (made.words.empty()) made.problems.push_back(logger.getAllMessages());
#else
  made.problems.emplace_back("this clipc was built without glslang's SPIR-V");
#endif
  return made;
}

std::string_view UnknownToValidator(std::string_view glsl, const glsl::Target& target) {
  struct Unknown {
    std::string_view word;      // that only GLSL with the part has in it
    int first_known = INT_MAX;  // the first version in which glslang 12 supports the part
    std::string_view part;
  };
  constexpr Unknown kUnknown[] = {
      {"GL_EXT_draw_buffers", INT_MAX, "`GL_EXT_draw_buffers`"},
      {"gl_InstanceIDARB", INT_MAX, "`gl_InstanceIDARB` of GL_ARB_draw_instanced"},
      {"GL_ARB_conservative_depth", INT_MAX, "`GL_ARB_conservative_depth`"},
      {"GL_OES_sample_variables", 310, "`GL_OES_sample_variables` in OpenGL ES 3.0"},
      {"GL_OES_shader_multisample_interpolation", 310,
       "`GL_OES_shader_multisample_interpolation` in OpenGL ES 3.0"},
      {"_clip_cull_distance", INT_MAX, "clip distances in OpenGL ES"},
  };
  for (const Unknown& unknown : kUnknown) {
    if (target.version() < unknown.first_known && glsl.find(unknown.word) != glsl.npos)
      return unknown.part;
  }
  return "";
}

std::string ValidatorName() {
  return fmt::format("glslang {}.{}.{}", GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR,
                     GLSLANG_VERSION_PATCH);
}

}  // namespace clipc
