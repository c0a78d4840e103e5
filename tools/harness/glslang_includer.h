// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <glslang/Public/ShaderLang.h>

// The parts of compiling HLSL that glslang's library leaves to its callers. For tools that link it.
namespace clipc::harness {

// Looks for an included file beside the including one, then in the given folders.
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

// "A", "B=2" => the lines that define these macros.
inline std::string DefineLines(const std::vector<std::string>& defines) {
  std::string text;
  for (const std::string& define : defines) {
    const std::size_t equals = define.find('=');
    text += "#define " + define.substr(0, equals) + " " +
            (equals == std::string::npos ? "1" : define.substr(equals + 1)) + "\n";
  }
  return text;
}

}  // namespace clipc::harness
