// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

// What is asked of SPIR-V.
namespace clipc {

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

  // The minor version of the SPIR-V: for OpenGL 0, for Vulkan that of its version.
  unsigned MinorVersion(bool is_for_vulkan) const {
    constexpr unsigned kMinor[] = {0, 3, 5, 6, 4};  // by VulkanVersion
    return is_for_vulkan ? version.value_or(kMinor[static_cast<std::size_t>(vulkan)]) : 0;
  }
};

}  // namespace clipc
