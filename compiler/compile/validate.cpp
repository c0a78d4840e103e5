// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/validate.h"

#include <climits>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/build_info.h>

#include "link/glslang_process.h"

namespace clipc {
namespace {

// By stage.
constexpr EShLanguage kLanguages[] = {EShLangVertex,   EShLangFragment,    EShLangCompute,
                                      EShLangGeometry, EShLangTessControl, EShLangTessEvaluation};
static_assert(std::size(kLanguages) == kStageCount);

std::vector<std::string> Problems(std::string_view log) {
  std::vector<std::string> problems;
  for (const auto& [line, text] : link::GlslangErrors(log))
    problems.push_back(line.empty() ? std::string(text) : fmt::format("line {}: {}", line, text));
  return problems;
}

// The GLSL without `precise`, with all else in its place. glslang 12 ends the process where it
// follows `precise` to a field of an array's element (propagateNoContraction.cpp), and no GLSL that
// clipc writes is valid for the word alone. `precise name;` declares nothing new.
std::string WithoutPrecise(std::string glsl) {
  constexpr std::string_view kWord = "precise ";
  for (std::size_t at = 0; (at = glsl.find(kWord, at)) != glsl.npos; ++at) {
    const bool is_word =
        at == 0 || std::string_view("\n (").find(glsl[at - 1]) != std::string::npos;
    if (!is_word) continue;
    const std::size_t end = glsl.find_first_of(" ;\n", at + kWord.size());
    const bool is_statement = end != glsl.npos && glsl[end] == ';';
    const std::size_t count = is_statement ? end + 1 - at : kWord.size();
    glsl.replace(at, count, count, ' ');
  }
  return glsl;
}

}  // namespace

std::vector<std::string> Validate(const std::string& written, const glsl::Target& target,
                                  Stage stage) {
  using namespace glslang;
  const std::string glsl = WithoutPrecise(written);
  link::InitializeGlslang();
  const EShLanguage language = kLanguages[static_cast<std::size_t>(stage)];
  TShader shader(language);
  auto messages = EShMsgDefault;
  if (target.IsVulkan()) {
    shader.setEnvInput(EShSourceGlsl, language, EShClientVulkan, 100);
    shader.setEnvClient(EShClientVulkan, EShTargetVulkan_1_1);
    shader.setEnvTarget(EShTargetSpv, EShTargetSpv_1_3);
    messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  }
  const char* text = glsl.data();
  const int length = static_cast<int>(glsl.size());
  shader.setStringsWithLengths(&text, &length, 1);
  if (!shader.parse(GetDefaultResources(), target.version(), false, messages))
    return Problems(shader.getInfoLog());
  TProgram program;
  program.addShader(&shader);
  return program.link(messages) ? std::vector<std::string>() : Problems(program.getInfoLog());
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
      {"GL_OES_viewport_array", INT_MAX, "`GL_OES_viewport_array`"},
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
