// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <functional>

#include <vulkan/vulkan_raii.hpp>

#include "tools/harness/image.h"

// What every program on Vulkan has: a device, buffers, images, commands. None of it is about
// shaders.
namespace lake {

struct Buffer {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Buffer buffer{nullptr};
};

// An image in the layout eGeneral, in which it is drawn, read and copied.
struct Texture {
  vk::Extent2D size;
  vk::Format format = vk::Format::eUndefined;
  vk::ImageAspectFlags aspect;
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Image image{nullptr};
  vk::raii::ImageView view{nullptr};
};

// A Vulkan 1.3 device with clip distances and push descriptors. Throws std::exception where the
// machine does not have one, and where Vulkan reports an error.
class Device {
 public:
  Device();

  const vk::raii::Device& operator*() const { return device_; }

  // A buffer with those bytes, in memory that the host writes.
  Buffer NewBuffer(vk::BufferUsageFlags usage, const void* bytes, std::size_t size) const;
  Texture NewTexture(vk::Format format, int width, int height) const;
  // Records commands, runs them and waits.
  void Run(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;
  // The texels of an image of the format eR8G8B8A8Unorm.
  clipc::harness::Image Read(const Texture& texture) const;

 private:
  vk::raii::DeviceMemory Allocate(const vk::MemoryRequirements& needs,
                                  vk::MemoryPropertyFlags properties) const;

  vk::raii::PhysicalDevice physical_{nullptr};
  vk::raii::Device device_{nullptr};
  vk::raii::Queue queue_{nullptr};
  std::uint32_t family_ = 0;
};

// Records that all commands before have written what all commands after read.
void Wait(const vk::raii::CommandBuffer& commands);

}  // namespace lake
