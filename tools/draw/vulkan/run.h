// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <memory>
#include <string>

#include "tools/draw/inputs.h"
#include "tools/draw/surface.h"
#include "tools/draw/vulkan/spirv.h"

namespace clipc::draw::vulkan {

// The data that an application gives a shader.
struct DrawCall {
  struct Attribute {
    std::uint32_t location;
    WordKind kind;
    Words words;  // of vertex 0, then of vertex 1, ...
  };
  struct Descriptor {
    std::uint32_t set, binding, element;  // the element of an array
    DescriptorKind kind;
    Bytes bytes = {};              // of kUniforms and kStorage
    Inputs::Texture texture = {};  // of kTexture, kTextureWithSampler and kTexels
    bool compares = false;         // of kSampler
    std::string name = {};         // "items[1]" for an element of an array
  };
  int vertices = 0, instances = 1;
  int first_vertex = 0, base_instance = 0;
  std::vector<Attribute> attributes;
  std::vector<Descriptor> descriptors;
  Bytes push_constants;
};

// Throws DrawError where the shader reads something without a value, of which Vulkan says nothing.
void CheckReads(const Spirv& spirv, const DrawCall& call);

class Device;

// The error of a machine without a Vulkan that can do what is asked for.
class NoDevice : public DrawError {
 public:
  using DrawError::DrawError;
};

// Vulkan without a display: Mesa's software driver, which the loader finds without an environment
// variable. All functions throw DrawError.
class Runner {
 public:
  Runner();
  ~Runner();

  std::string name() const;
  std::uint32_t lanes() const;  // of a subgroup

  // The reason why there is no device; empty if there is one, and always in CI (the environment has
  // `CI`), so that tests without a device fail there.
  static std::string WhyNone();

  // Runs the vertex shader without any other stage, on points, and returns `outputs` in their
  // order. Throws DrawError where the shader reads something that the draw call does not give.
  std::vector<Captured> Capture(const Spirv& vertex, std::span<const Output> outputs,
                                const DrawCall& call) const;

  // Runs the stages in their order, of which the last gives points, and returns `outputs` of all
  // that it gives, at most `most`.
  struct Stages {
    Spirv vertex;
    std::vector<Spirv> after;
    int primitive = 0;               // an ir::Primitive
    std::uint32_t patch_points = 0;  // above 0: patches in place of primitives
    int most = 0;
  };
  std::vector<Captured> CaptureLast(const Stages& stages, std::span<const Output> outputs,
                                    const DrawCall& call) const;

  // Draws the surface with both shaders and returns the values of each target, in their order. A
  // pixel has `samples`, which are resolved.
  std::vector<Captured> DrawSurface(const Spirv& vertex, const Spirv& fragment,
                                    const std::vector<SurfaceTarget>& targets, const DrawCall& call,
                                    int samples) const;

  // Runs the compute shader for kGroups (tools/draw/dispatch.h), and returns what the storage
  // buffers and images hold then, by their names, the latter as MemoryOfTexels has them. Throws
  // DrawError where the shader reads something that the call does not give.
  std::map<std::string, Bytes> Dispatch(const Spirv& compute, const DrawCall& call) const;

 private:
  struct Feedback;
  std::vector<Captured> CaptureAll(const Feedback& feedback, std::span<const Output> outputs,
                                   const DrawCall& call) const;

  std::unique_ptr<Device> device_;
};

}  // namespace clipc::draw::vulkan
