// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/image.h"

#include <algorithm>
#include <iterator>

#include "tools/draw/vulkan/samples.h"

namespace clipc::draw::vulkan {
namespace {

// The form of a texture in Vulkan, for a texture target of OpenGL.
struct Form {
  vk::ImageType type;
  vk::ImageViewType view;
  int axes;                 // of the size, without layers
  std::uint32_t faces = 1;  // of a cube that is not in an array
};

Form FormOf(GLenum target) {
  switch (target) {
    case GL_TEXTURE_1D: return {vk::ImageType::e1D, vk::ImageViewType::e1D, 1};
    case GL_TEXTURE_1D_ARRAY: return {vk::ImageType::e1D, vk::ImageViewType::e1DArray, 1};
    case GL_TEXTURE_2D: return {vk::ImageType::e2D, vk::ImageViewType::e2D, 2};
    case GL_TEXTURE_2D_ARRAY: return {vk::ImageType::e2D, vk::ImageViewType::e2DArray, 2};
    case GL_TEXTURE_3D: return {vk::ImageType::e3D, vk::ImageViewType::e3D, 3};
    case GL_TEXTURE_CUBE_MAP: return {vk::ImageType::e2D, vk::ImageViewType::eCube, 2, 6};
    case GL_TEXTURE_CUBE_MAP_ARRAY: return {vk::ImageType::e2D, vk::ImageViewType::eCubeArray, 2};
    default:
      throw DrawError("a texture of OpenGL target " + std::to_string(target) +
                      ", which no test draws with");
  }
}

vk::Extent3D ExtentOf(const Form& form, const Inputs::Texture::Level& level) {
  return {level.size[0], form.axes > 1 ? level.size[1] : 1, form.axes > 2 ? level.size[2] : 1};
}

std::uint32_t LayersOf(const Form& form, const Inputs::Texture::Level& level) {
  return form.axes < 3 ? form.faces * level.size[form.axes] : 1;
}

vk::ImageUsageFlags UsageOf(const Inputs::Texture& texture) {
  using enum vk::ImageUsageFlagBits;
  return texture.is_image ? eStorage | eTransferDst | eTransferSrc : eSampled | eTransferDst;
}

}  // namespace

Image NewImage(const Device& device, const vk::ImageCreateInfo& info, vk::ImageViewType view,
               vk::ImageAspectFlagBits aspect) {
  Image made;
  made.image = vk::raii::Image(device.get(), info);
  made.memory = device.Allocate(made.image.getMemoryRequirements());
  made.image.bindMemory(*made.memory, 0);
  const vk::ImageSubresourceRange all(aspect, 0, info.mipLevels, 0, info.arrayLayers);
  made.view = vk::raii::ImageView(
      device.get(), vk::ImageViewCreateInfo({}, *made.image, view, info.format, {}, all));
  return made;
}

void Transition(const vk::raii::CommandBuffer& commands, const Image& image,
                const vk::ImageSubresourceRange& all, vk::ImageLayout from, vk::ImageLayout to) {
  const vk::ImageMemoryBarrier barrier(
      vk::AccessFlagBits::eMemoryWrite,
      vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite, from, to,
      VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *image.image, all);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands,
                           vk::PipelineStageFlagBits::eAllCommands, {}, {}, {}, barrier);
}

vk::Format FormatOf(const Inputs::Texture& texture) {
  using enum vk::Format;
  constexpr vk::Format kFormats[][3] = {
      {eR32Sfloat, eR32Sint, eR32Uint},
      {eR32G32Sfloat, eR32G32Sint, eR32G32Uint},
      {eR32G32B32A32Sfloat, eR32G32B32A32Sint, eR32G32B32A32Uint}};
  const int components = texture.compares ? 1 : texture.components;
  return kFormats[components / 2][static_cast<int>(texture.kind)];
}

Image UploadImage(const Device& device, const Inputs::Texture& texture) {
  if (texture.target == GL_TEXTURE_2D_MULTISAMPLE ||
      texture.target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY)
    return UploadSamples(device, texture);
  const Form form = FormOf(texture.target);
  const std::uint32_t levels = texture.levels.size();
  const std::uint32_t layers = LayersOf(form, texture.levels.at(0));
  const bool is_cube =
      form.view == vk::ImageViewType::eCube || form.view == vk::ImageViewType::eCubeArray;
  Image made =
      NewImage(device,
               {is_cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags(),
                form.type, FormatOf(texture), ExtentOf(form, texture.levels[0]), levels, layers,
                vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, UsageOf(texture)},
               form.view);

  Bytes bytes;
  std::vector<vk::BufferImageCopy> copies;
  for (std::uint32_t i = 0; i < levels; ++i) {
    const Inputs::Texture::Level& level = texture.levels[i];
    const vk::ImageSubresourceLayers place(vk::ImageAspectFlagBits::eColor, i, 0, layers);
    copies.emplace_back(bytes.size(), 0, 0, place, vk::Offset3D(), ExtentOf(form, level));
    std::ranges::copy(BytesOf(level.words), std::back_inserter(bytes));
  }
  const Buffer staging = device.NewBuffer(vk::BufferUsageFlagBits::eTransferSrc, bytes);
  const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, levels, 0, layers);
  device.Submit([&](const vk::raii::CommandBuffer& commands) {
    Transition(commands, made, all, vk::ImageLayout::eUndefined,
               vk::ImageLayout::eTransferDstOptimal);
    commands.copyBufferToImage(*staging.buffer, *made.image, vk::ImageLayout::eTransferDstOptimal,
                               copies);
    Transition(
        commands, made, all, vk::ImageLayout::eTransferDstOptimal,
        texture.is_image ? vk::ImageLayout::eGeneral : vk::ImageLayout::eShaderReadOnlyOptimal);
  });
  return made;
}

Words ReadImage(const Device& device, const Image& image, const Inputs::Texture& texture) {
  const Inputs::Texture::Level& level = texture.levels.at(0);
  const Form form = FormOf(texture.target);
  const std::uint32_t layers = LayersOf(form, level);
  const vk::ImageSubresourceLayers place(vk::ImageAspectFlagBits::eColor, 0, 0, layers);
  const vk::BufferImageCopy copy(0, 0, 0, place, {}, ExtentOf(form, level));
  const Buffer read = device.NewBuffer(vk::BufferUsageFlagBits::eTransferDst, BytesOf(level.words));
  device.Submit([&](const vk::raii::CommandBuffer& commands) {
    Transition(commands, image, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, layers},
               vk::ImageLayout::eGeneral, vk::ImageLayout::eTransferSrcOptimal);
    commands.copyImageToBuffer(*image.image, vk::ImageLayout::eTransferSrcOptimal, *read.buffer,
                               copy);
  });
  Words words = device.Read(read);
  words.resize(level.words.size());
  return words;
}

Image MakeTarget(const Device& device, vk::Extent2D size, vk::Format format,
                 vk::SampleCountFlagBits samples) {
  const bool is_depth = format == vk::Format::eD32Sfloat;
  const vk::ImageUsageFlags usage = is_depth ? vk::ImageUsageFlagBits::eDepthStencilAttachment
                                             : vk::ImageUsageFlagBits::eColorAttachment;
  return NewImage(device,
                  {{},
                   vk::ImageType::e2D,
                   format,
                   {size.width, size.height, 1},
                   1,
                   1,
                   samples,
                   vk::ImageTiling::eOptimal,
                   usage | vk::ImageUsageFlagBits::eTransferSrc},
                  vk::ImageViewType::e2D,
                  is_depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor);
}

vk::raii::Sampler MakeSampler(const Device& device, bool compares) {
  constexpr auto kRepeat = vk::SamplerAddressMode::eRepeat;
  return {device.get(), vk::SamplerCreateInfo({}, vk::Filter::eNearest, vk::Filter::eNearest,
                                              vk::SamplerMipmapMode::eNearest, kRepeat, kRepeat,
                                              kRepeat, 0, false, 1, compares,
                                              vk::CompareOp::eLessOrEqual, 0, VK_LOD_CLAMP_NONE)};
}

}  // namespace clipc::draw::vulkan
