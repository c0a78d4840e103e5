// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/target.h"
#include "base/stage.h"

namespace clipc {

// Compiles and links `glsl` as a shader of one stage with glslang, in this process. Returns
// glslang's messages, "line 12: ...": none for a valid shader, at least one for another. The first
// call for a GLSL version builds glslang's tables for it, which takes tens of milliseconds; they
// stay for the life of the process. Thread-safe.
std::vector<std::string> Validate(const std::string& glsl, const glsl::Target& target, Stage stage);

// What valid GLSL for the target has in it that the validator does not support; empty if there is
// nothing, so that a message of Validate is about a mistake. docs/language.md, "GLSL that glslang
// refuses", is the list.
std::string_view UnknownToValidator(std::string_view glsl, const glsl::Target& target);

// The version of Vulkan that SPIR-V is for, which decides the version of the SPIR-V: 1.0, 1.3, 1.5,
// 1.6, or 1.4 for Vulkan 1.1 with the extension for it.
enum class VulkanVersion : std::uint8_t { k1_0, k1_1, k1_2, k1_3, k1_1WithSpirv1_4 };
// What debug information has: the values of dxc's -fspv-debug, each with what those before it have,
// but kSet without the text of the source.
enum class SpirvDebug : std::uint8_t {
  kFile,         // the name of the file
  kSource,       // its text
  kLine,         // the line of each instruction
  kTool,         // the compiler
  kSet,          // the same as kLine in instructions of NonSemantic.Shader.DebugInfo.100
  kSetAndSource  // with the text
};
struct SpirvRequest {
  VulkanVersion vulkan = VulkanVersion::k1_1;
  bool debug_info = false;
  SpirvDebug debug = SpirvDebug::kLine;
  std::optional<unsigned> version = {};  // 5 for SPIR-V 1.5; none: that of the Vulkan version
  std::string entry = {};                // the name of the entry point; empty: `main`
  bool has_reflection = false;  // variables have their semantics and the names of their types
  bool nan_clamp = false;       // min, max and clamp give the operand that is a number
};
struct Spirv {
  std::vector<std::uint32_t> words;
  std::vector<std::string> problems;  // as of Validate; empty exactly when there are words
};

// Translates the GLSL of a shader by glslang: for Vulkan, or for OpenGL 4.5 when `target` is
// one of OpenGL's. Debug information has the GLSL in it, which a debugger shows as the file `name`.
Spirv MakeSpirv(const std::string& glsl, const glsl::Target& target, Stage stage,
                const SpirvRequest& request, const std::string& name);

// The name and version of the validator, "glslang 12.0.0".
std::string ValidatorName();

}  // namespace clipc
