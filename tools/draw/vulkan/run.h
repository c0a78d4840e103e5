// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>

#include "tools/draw/program.h"
#include "tools/draw/vulkan/spirv.h"

namespace clipc::draw::vulkan {

// What a vertex shader reads, as an application gives it.
struct DrawCall {
  struct Attribute {
    std::uint32_t location;
    Shape::Kind kind;
    std::vector<std::uint32_t> words;  // of vertex 0, then of vertex 1, ...
  };
  enum class Kind { kUniforms, kStorage, kTexture, kSampler, kTextureWithSampler, kTexels };
  struct Descriptor {
    std::uint32_t set, binding, element;  // element of an array
    Kind kind;
    std::vector<std::uint8_t> bytes = {};  // kUniforms, kStorage
    Inputs::Texture texture = {};          // the others but kSampler
    bool compares = false;                 // kSampler
  };
  int vertices = 0, instances = 1;
  int first_vertex = 0, base_instance = 0;
  std::vector<Attribute> attributes;
  std::vector<Descriptor> descriptors;
};

// Vulkan without a display: Mesa's software driver. The loader finds it without an environment
// variable. All throw DrawError.
class Device;
class Runner {
 public:
  Runner();
  ~Runner();

  std::string name() const;

  // Empty if there is a device; else why there is none. In CI (the environment has `CI`) always
  // empty: there, what needs one fails.
  static std::string WhyNone();

  // Runs the vertex shader alone, on points, and returns `outputs` in their order. What the shader
  // reads and the draw call does not give is a DrawError.
  std::vector<Captured> Capture(const Spirv& vertex, std::span<const Output> outputs,
                                const DrawCall& call) const;

 private:
  std::unique_ptr<Device> device_;
};

}  // namespace clipc::draw::vulkan
