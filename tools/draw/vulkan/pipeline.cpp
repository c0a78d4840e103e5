// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/pipeline.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>

namespace clipc::draw::vulkan {
namespace {

vk::Format FormatOf(WordKind kind, std::size_t components) {
  using enum vk::Format;
  constexpr vk::Format kFormats[3][4] = {
      {eR32Sfloat, eR32G32Sfloat, eR32G32B32Sfloat, eR32G32B32A32Sfloat},
      {eR32Sint, eR32G32Sint, eR32G32B32Sint, eR32G32B32A32Sint},
      {eR32Uint, eR32G32Uint, eR32G32B32Uint, eR32G32B32A32Uint}};
  if (components < 1 || components > 4) throw DrawError("an attribute is a scalar or a vector");
  return kFormats[static_cast<int>(kind)][components - 1];
}

vk::ShaderStageFlagBits KindOf(Stage stage) {
  using enum vk::ShaderStageFlagBits;
  constexpr vk::ShaderStageFlagBits kKinds[] = {
      eVertex, eFragment, eCompute, eGeometry, eTessellationControl, eTessellationEvaluation};
  static_assert(std::size(kKinds) == kStageCount);
  return kKinds[static_cast<std::size_t>(stage)];
}

}  // namespace

vk::Format FormatOf(const WordLayout& layout) {
  return FormatOf(layout.kind, static_cast<std::size_t>(layout.rows));
}

Attributes UploadAttributes(const Device& device, const DrawCall& call) {
  Attributes made;
  for (const DrawCall::Attribute& attribute : call.attributes) {
    const std::size_t components = attribute.words.size() / call.vertices;
    Words words(components * call.first_vertex);
    words.insert(words.end(), attribute.words.begin(), attribute.words.end());
    const std::uint32_t binding = made.bindings.size();
    made.bindings.emplace_back(binding, 4 * components);
    made.places.emplace_back(attribute.location, binding, FormatOf(attribute.kind, components), 0);
    made.buffers.push_back(
        device.NewBuffer(vk::BufferUsageFlagBits::eVertexBuffer, BytesOf(words)));
  }
  return made;
}

Attributes AttributesOf(const Reads& vertex) {
  Attributes attributes;
  std::uint32_t offset = 0;
  for (const Reads::Attribute& read : vertex.attributes) {
    for (std::uint32_t at = read.location; at < read.location + read.locations; ++at) {
      attributes.places.emplace_back(at, 0, FormatOf(read.layout), offset);
      offset += 4 * static_cast<std::uint32_t>(read.layout.rows);
    }
  }
  if (offset > 0) attributes.bindings.emplace_back(0, offset);
  return attributes;
}

void BindAttributes(const vk::raii::CommandBuffer& commands, const Attributes& attributes) {
  for (std::uint32_t i = 0; i < attributes.buffers.size(); ++i)
    commands.bindVertexBuffers(i, *attributes.buffers[i].buffer, {0});
}

PipelineTargets TargetsOf(const Spirv& fragment) {
  PipelineTargets targets;
  targets.colors.clear();
  for (const Output& output : OutputsOf(fragment)) {
    if (!output.location) continue;
    const std::size_t end = *output.location + static_cast<std::size_t>(output.count);
    targets.colors.resize(std::max(targets.colors.size(), end), vk::Format::eUndefined);
    const vk::Format format = FormatOf({output.layout.kind, 4, 1});
    for (std::size_t i = *output.location; i < end; ++i) targets.colors[i] = format;
  }
  return targets;
}

vk::raii::Pipeline MakePipeline(const vk::raii::Device& device, const PipelineShaders& shaders,
                                const Attributes& attributes,
                                const vk::raii::PipelineLayout& layout,
                                const PipelineTargets& targets) {
  const bool draws = shaders.end != PipelineEnd::kCapture;
  std::vector<vk::raii::ShaderModule> modules;
  std::vector<std::string> entries;
  std::vector<vk::ShaderStageFlagBits> kinds;
  const auto add = [&](const Spirv& spirv) {
    modules.emplace_back(device, vk::ShaderModuleCreateInfo({}, spirv));
    entries.push_back(EntryPointOf(spirv));
    kinds.push_back(KindOf(StageOf(spirv)));
  };
  add(shaders.vertex);
  for (const Spirv& spirv : shaders.after) add(spirv);
  if (draws) add(shaders.fragment);
  std::vector<vk::PipelineShaderStageCreateInfo> stages;
  for (std::size_t i = 0; i < modules.size(); ++i)
    stages.emplace_back(vk::PipelineShaderStageCreateFlags(), kinds[i], *modules[i],
                        entries[i].c_str());
  const vk::PipelineVertexInputStateCreateInfo input({}, attributes.bindings, attributes.places);
  const vk::PipelineInputAssemblyStateCreateInfo assembly(
      {}, draws ? vk::PrimitiveTopology::eTriangleList : shaders.topology);
  const vk::PipelineTessellationStateCreateInfo patches({}, shaders.patch_points);
  const vk::Viewport size(0, 0, static_cast<float>(targets.size.width),
                          static_cast<float>(targets.size.height), 0, 1);
  const vk::Rect2D scissor({0, 0}, targets.size);
  const vk::PipelineViewportStateCreateInfo viewport({}, size, scissor);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  rasterization.rasterizerDiscardEnable = !draws;
  rasterization.lineWidth = 1;
  rasterization.frontFace = vk::FrontFace::eClockwise;  // as in Direct3D
  const vk::PipelineMultisampleStateCreateInfo samples({}, targets.samples);
  vk::PipelineColorBlendAttachmentState color;
  color.colorWriteMask = vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags;
  std::vector<vk::PipelineColorBlendAttachmentState> colors(targets.colors.size(), color);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (targets.colors[i] == vk::Format::eUndefined) colors[i].colorWriteMask = {};
  }
  const vk::PipelineColorBlendStateCreateInfo blending({}, false, {}, colors);
  const bool has_depth = targets.depth != vk::Format::eUndefined;
  const vk::PipelineDepthStencilStateCreateInfo depth({}, has_depth, has_depth,
                                                      vk::CompareOp::eAlways);
  vk::PipelineRenderingCreateInfo rendering;
  if (draws) rendering.setColorAttachmentFormats(targets.colors);
  rendering.depthAttachmentFormat = targets.depth;
  vk::GraphicsPipelineCreateInfo info;
  info.pNext = &rendering;
  info.setStages(stages);
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  if (shaders.patch_points > 0) info.pTessellationState = &patches;
  info.pViewportState = &viewport;
  info.pRasterizationState = &rasterization;
  info.pMultisampleState = &samples;
  if (draws) info.pColorBlendState = &blending;
  if (draws) info.pDepthStencilState = &depth;
  info.layout = *layout;
  if (shaders.end == PipelineEnd::kStatistics)
    info.flags = vk::PipelineCreateFlagBits::eCaptureStatisticsKHR;
  return {device, nullptr, info};
}

}  // namespace clipc::draw::vulkan
