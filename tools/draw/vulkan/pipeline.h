// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "tools/draw/pair.h"
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
vk::Format FormatOf(const WordLayout& layout);
// Descriptions without buffers, of all that the vertex shader reads.
Attributes AttributesOf(const Reads& vertex);
Attributes UploadAttributes(const Device& device, const DrawCall& call);
void BindAttributes(const vk::raii::CommandBuffer& commands, const Attributes& attributes);

// The stage that a pipeline ends with.
enum class PipelineEnd : std::uint8_t {
  kCapture,     // points are captured and drawn nowhere
  kImage,       // triangles are drawn into targets
  kStatistics,  // as kImage, and the driver tells of its code
};

struct PipelineShaders {
  Spirv vertex;
  Spirv fragment = {};  // for every end but kCapture
  PipelineEnd end = PipelineEnd::kCapture;
  std::vector<Spirv> after = {};                                       // the stages between the two
  vk::PrimitiveTopology topology = vk::PrimitiveTopology::ePointList;  // of kCapture
  std::uint32_t patch_points = 0;                                      // of ePatchList
};
// The targets that a pipeline draws to.
struct PipelineTargets {
  vk::Extent2D size{kPairSize, kPairSize};
  std::vector<vk::Format> colors{vk::Format::eR32G32B32A32Sfloat};  // eUndefined: none
  vk::Format depth = vk::Format::eUndefined;  // every pixel passes, and its depth is kept
  vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1;
};
// Targets for all that the fragment shader writes.
PipelineTargets TargetsOf(const Spirv& fragment);
vk::raii::Pipeline MakePipeline(const vk::raii::Device& device, const PipelineShaders& shaders,
                                const Attributes& attributes,
                                const vk::raii::PipelineLayout& layout,
                                const PipelineTargets& targets = {});

}  // namespace clipc::draw::vulkan
