// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/image.h"

#include "tools/harness/offscreen.h"

namespace clipc::draw::vulkan {
namespace {

// How Vulkan takes what glTexImage takes.
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

}  // namespace

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
  switch (texture.kind) {
    case WordKind::kInt: return vk::Format::eR32G32B32A32Sint;
    case WordKind::kUint: return vk::Format::eR32G32B32A32Uint;
    case WordKind::kFloat: break;
  }
  return vk::Format::eR32G32B32A32Sfloat;
}

Image UploadImage(const Device& device, const Inputs::Texture& texture) {
  const Form form = FormOf(texture.target);
  const std::uint32_t levels = texture.levels.size();
  const std::uint32_t layers = LayersOf(form, texture.levels.at(0));
  const bool is_cube =
      form.view == vk::ImageViewType::eCube || form.view == vk::ImageViewType::eCubeArray;
  Image made;
  made.image = vk::raii::Image(
      device.get(), vk::ImageCreateInfo(
                        is_cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags(),
                        form.type, FormatOf(texture), ExtentOf(form, texture.levels[0]), levels,
                        layers, vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                        vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst));
  made.memory = device.Allocate(made.image.getMemoryRequirements());
  made.image.bindMemory(*made.memory, 0);

  Bytes bytes;
  std::vector<vk::BufferImageCopy> copies;
  for (std::uint32_t i = 0; i < levels; ++i) {
    const Inputs::Texture::Level& level = texture.levels[i];
    const vk::ImageSubresourceLayers place(vk::ImageAspectFlagBits::eColor, i, 0, layers);
    copies.emplace_back(bytes.size(), 0, 0, place, vk::Offset3D(), ExtentOf(form, level));
    const auto* begin = reinterpret_cast<const std::uint8_t*>(level.words.data());
    bytes.insert(bytes.end(), begin, begin + 4 * level.words.size());
  }
  const Buffer staging = device.NewBuffer(vk::BufferUsageFlagBits::eTransferSrc, bytes);
  const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, levels, 0, layers);
  device.Submit([&](const vk::raii::CommandBuffer& commands) {
    Transition(commands, made, all, vk::ImageLayout::eUndefined,
               vk::ImageLayout::eTransferDstOptimal);
    commands.copyBufferToImage(*staging.buffer, *made.image, vk::ImageLayout::eTransferDstOptimal,
                               copies);
    Transition(commands, made, all, vk::ImageLayout::eTransferDstOptimal,
               vk::ImageLayout::eShaderReadOnlyOptimal);
  });
  made.view = vk::raii::ImageView(
      device.get(),
      vk::ImageViewCreateInfo({}, *made.image, form.view, FormatOf(texture), {}, all));
  return made;
}

Image MakeTarget(const Device& device, std::uint32_t size) {
  constexpr auto kFormat = vk::Format::eR32G32B32A32Sfloat;
  const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  Image made;
  made.image = vk::raii::Image(
      device.get(), vk::ImageCreateInfo({}, vk::ImageType::e2D, kFormat, {size, size, 1}, 1, 1,
                                        vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                        vk::ImageUsageFlagBits::eColorAttachment |
                                            vk::ImageUsageFlagBits::eTransferSrc));
  made.memory = device.Allocate(made.image.getMemoryRequirements());
  made.image.bindMemory(*made.memory, 0);
  made.view = vk::raii::ImageView(
      device.get(),
      vk::ImageViewCreateInfo({}, *made.image, vk::ImageViewType::e2D, kFormat, {}, all));
  return made;
}

vk::raii::Sampler MakeSampler(const Device& device, bool compares) {
  constexpr auto kRepeat = vk::SamplerAddressMode::eRepeat;
  return {device.get(), vk::SamplerCreateInfo({}, vk::Filter::eNearest, vk::Filter::eNearest,
                                              vk::SamplerMipmapMode::eNearest, kRepeat, kRepeat,
                                              kRepeat, 0, false, 1, compares,
                                              vk::CompareOp::eLessOrEqual, 0, VK_LOD_CLAMP_NONE)};
}

}  // namespace clipc::draw::vulkan
