// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/program.h"
#include "tools/draw/vulkan/device.h"

namespace clipc::draw::vulkan {

// A texture that shaders can read.
struct Image {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Image image{nullptr};
  vk::raii::ImageView view{nullptr};
};
Image UploadImage(const Device& device, const Inputs::Texture& texture);

vk::Format FormatOf(const Inputs::Texture& texture);

// The nearest texel of the nearest level of a texture that repeats; if it compares, what is less or
// equal passes.
vk::raii::Sampler MakeSampler(const Device& device, bool compares);

}  // namespace clipc::draw::vulkan
