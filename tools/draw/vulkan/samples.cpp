// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/samples.h"

#include <array>
#include <string>
#include <utility>

#include "tools/draw/vulkan/descriptors.h"
#include "tools/draw/vulkan/glslang.h"
#include "tools/draw/vulkan/pipeline.h"

namespace clipc::draw::vulkan {
namespace {

constexpr char kCoverAll[] = R"(#version 450
void main() {
  gl_Position = vec4(vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

// Reads a texture in which the images of the layers lie one below the other, and below those of
// sample 0 those of sample 1. The number of the sample makes the shader run for each.
constexpr char kCopySamples[] = R"(#version 450
#extension GL_EXT_samplerless_texture_functions : require
layout(set = 0, binding = 0) uniform PREFIXtexture2D samples;
layout(push_constant) uniform Rows { int first, each; };
layout(location = 0) out PREFIXvec4 color;
void main() {
  color = texelFetch(samples, ivec2(gl_FragCoord.xy) + ivec2(0, first + gl_SampleID * each), 0);
}
)";

Spirv CopyOf(WordKind kind) {
  std::string fragment = kCopySamples;
  const char* const prefix = kind == WordKind::kInt ? "i" : kind == WordKind::kUint ? "u" : "";
  for (std::size_t at = fragment.find("PREFIX"); at != fragment.npos; at = fragment.find("PREFIX"))
    fragment.replace(at, 6, prefix);
  return SpirvOfGlsl(fragment, Stage::kPixel);
}

}  // namespace

Image UploadSamples(const Device& device, const Inputs::Texture& texture) {
  const Inputs::Texture::Level& level = texture.levels.at(0);
  const auto [width, height, images] = level.size;
  const std::uint32_t layers = images / kSamples;
  const bool is_array = texture.target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY;
  const PipelineTargets targets{
      {width, height}, {FormatOf(texture)}, vk::Format::eUndefined, vk::SampleCountFlagBits::e4};
  static_assert(kSamples == 4);
  Image made =
      NewImage(device,
               {{},
                vk::ImageType::e2D,
                FormatOf(texture),
                {width, height, 1},
                1,
                layers,
                targets.samples,
                vk::ImageTiling::eOptimal,
                vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eColorAttachment},
               is_array ? vk::ImageViewType::e2DArray : vk::ImageViewType::e2D);
  Inputs::Texture plain = texture;
  plain.target = GL_TEXTURE_2D;
  plain.levels[0].size = {width, height * images, 1};
  DrawCall call;
  call.descriptors.push_back({0, 0, 0, DescriptorKind::kTexture, {}, std::move(plain)});
  const Descriptors descriptors(device, call);
  const std::vector<vk::DescriptorSetLayout> sets = descriptors.Layouts();
  const vk::PushConstantRange rows(vk::ShaderStageFlagBits::eFragment, 0, 8);
  const vk::raii::PipelineLayout layout(device.get(), vk::PipelineLayoutCreateInfo({}, sets, rows));
  const vk::raii::Pipeline pipeline = MakePipeline(
      device.get(), {SpirvOfGlsl(kCoverAll), CopyOf(texture.kind), PipelineEnd::kImage}, {}, layout,
      targets);
  std::vector<vk::raii::ImageView> views;
  for (std::uint32_t layer = 0; layer < layers; ++layer)
    views.emplace_back(device.get(), vk::ImageViewCreateInfo(
                                         {}, *made.image, vk::ImageViewType::e2D, FormatOf(texture),
                                         {}, {vk::ImageAspectFlagBits::eColor, 0, 1, layer, 1}));
  const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, layers);
  device.Submit([&](const vk::raii::CommandBuffer& commands) {
    Transition(commands, made, all, vk::ImageLayout::eUndefined,
               vk::ImageLayout::eColorAttachmentOptimal);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
    descriptors.Bind(commands, layout);
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
      vk::RenderingAttachmentInfo attachment;
      attachment.imageView = *views[layer];
      attachment.imageLayout = vk::ImageLayout::eColorAttachmentOptimal;
      attachment.loadOp = vk::AttachmentLoadOp::eClear;
      attachment.storeOp = vk::AttachmentStoreOp::eStore;
      const std::array<std::uint32_t, 2> numbers{height * layer, height * layers};
      commands.pushConstants<std::uint32_t>(*layout, vk::ShaderStageFlagBits::eFragment, 0,
                                            numbers);
      commands.beginRendering(
          vk::RenderingInfo({}, vk::Rect2D({0, 0}, targets.size), 1, 0, attachment));
      commands.draw(3, 1, 0, 0);
      commands.endRendering();
    }
    Transition(commands, made, all, vk::ImageLayout::eColorAttachmentOptimal,
               vk::ImageLayout::eShaderReadOnlyOptimal);
  });
  return made;
}

}  // namespace clipc::draw::vulkan
