// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "tools/draw/vulkan/device.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

// The buffers of the attributes, with the descriptions that a pipeline takes of them.
struct Attributes {
  std::vector<vk::VertexInputBindingDescription> bindings;
  std::vector<vk::VertexInputAttributeDescription> places;
  std::vector<Buffer> buffers;
};
// The format of an attribute's values at one location.
vk::Format FormatOf(const Shape& shape);
Attributes UploadAttributes(const Device& device, const DrawCall& call);
void BindAttributes(const vk::raii::CommandBuffer& commands, const Attributes& attributes);

// The stage that a pipeline ends with.
enum class PipelineEnd : std::uint8_t {
  kCapture,     // points are captured and drawn nowhere
  kPicture,     // triangles are drawn into a target of MakeTarget, kPairSize wide
  kStatistics,  // as kPicture, and the driver tells of its code
};

struct PipelineShaders {
  Spirv vertex;
  Spirv fragment = {};  // for every end but kCapture
  PipelineEnd end = PipelineEnd::kCapture;
};
vk::raii::Pipeline MakePipeline(const vk::raii::Device& device, const PipelineShaders& shaders,
                                const Attributes& attributes,
                                const vk::raii::PipelineLayout& layout);

}  // namespace clipc::draw::vulkan
