// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>

#include "tools/draw/vulkan/spirv.h"

namespace clipc::draw::vulkan {

class Device;

// The size and the speed of the code that a Vulkan driver compiles a shader to.
struct MachineCode {
  std::uintmax_t instructions;
  std::uintmax_t cycles;  // that a multiprocessor needs for one wave: the inverse throughput
};

// Counts the machine code of vertex and fragment shaders, by the first Vulkan device that tells of
// it. The attributes of a vertex shader lie one after another in one buffer, each with the
// components that the shader declares; a fragment shader reads every output, so that none is left
// out. To a fragment shader a vertex shader gives values that the driver does not know, and it
// draws to a target for each output. Nothing is drawn.
class CodeCounter {
 public:
  // Throws NoDevice if no device tells of its machine code.
  CodeCounter();
  ~CodeCounter();

  // Throws DrawError where SPIRV-Cross or the driver cannot read the shader.
  MachineCode Count(const Spirv& shader) const;

 private:
  std::unique_ptr<Device> device_;
};

}  // namespace clipc::draw::vulkan
