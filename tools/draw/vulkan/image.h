// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/inputs.h"
#include "tools/draw/vulkan/device.h"

namespace clipc::draw::vulkan {

// A texture that shaders can read, or an image that they draw.
struct Image {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Image image{nullptr};
  vk::raii::ImageView view{nullptr};
};
Image UploadImage(const Device& device, const Inputs::Texture& texture);
// The texels of an image that UploadImage made of `texture`, after shaders wrote to it.
Words ReadImage(const Device& device, const Image& image, const Inputs::Texture& texture);
// An image in memory of its own, and the view of all of it.
Image NewImage(const Device& device, const vk::ImageCreateInfo& info, vk::ImageViewType view,
               vk::ImageAspectFlagBits aspect = vk::ImageAspectFlagBits::eColor);

// An image that can be drawn to.
Image MakeTarget(const Device& device, vk::Extent2D size,
                 vk::Format format = vk::Format::eR32G32B32A32Sfloat,
                 vk::SampleCountFlagBits samples = vk::SampleCountFlagBits::e1);

// Records a change of layout that everything before it and after it waits for.
void Transition(const vk::raii::CommandBuffer& commands, const Image& image,
                const vk::ImageSubresourceRange& all, vk::ImageLayout from, vk::ImageLayout to);

vk::Format FormatOf(const Inputs::Texture& texture);

// A sampler that takes the nearest texel of the nearest level of a texture that repeats. If it
// compares, a reference passes that is less or equal.
vk::raii::Sampler MakeSampler(const Device& device, bool compares);

}  // namespace clipc::draw::vulkan
