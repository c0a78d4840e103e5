// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/bench/peers.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv_cross/spirv_glsl.hpp>

namespace clipc::bench {

void StartPeers() { glslang::InitializeProcess(); }
void StopPeers() { glslang::FinalizeProcess(); }

namespace {

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

std::optional<std::string> CompileText(const std::string& hlsl, const CompileRequest& request) {
  glslang::TShader shader(EShLangVertex);
  const char* text = hlsl.c_str();
  const char* name = request.path.c_str();
  const int length = static_cast<int>(hlsl.size());
  shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
  shader.setEntryPoint(request.entry.c_str());
  shader.setSourceEntryPoint(request.entry.c_str());
  shader.setEnvInput(glslang::EShSourceHlsl, EShLangVertex, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  std::string preamble;
  for (const std::string& define : request.defines) {
    const std::size_t equals = define.find('=');
    preamble += "#define " + define.substr(0, equals) +
                (equals == std::string::npos ? " 1" : " " + define.substr(equals + 1)) + "\n";
  }
  shader.setPreamble(preamble.c_str());
  Includer includer(request.include_dirs);
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
  glslang::GlslangToSpv(*program.getIntermediate(EShLangVertex), spirv, &spirv_options);
  try {
    spirv_cross::CompilerGLSL compiler(std::move(spirv));
    spirv_cross::CompilerGLSL::Options options;
    options.version = 450;
    compiler.set_common_options(options);
    return compiler.compile();
  } catch (const spirv_cross::CompilerError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::string> CompileWithPeers(const std::string& hlsl) {
  return CompileText(hlsl, {});
}

std::optional<std::string> CompileFileWithPeers(const CompileRequest& request) {
  std::ifstream file(request.path, std::ios::binary);
  return CompileText({std::istreambuf_iterator<char>(file), {}}, request);
}

}  // namespace clipc::bench
