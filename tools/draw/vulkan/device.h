// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <vulkan/vulkan_raii.hpp>

#include "tools/draw/vulkan/run.h"

// Only files of this folder include this header: compiling vulkan_raii.hpp takes seconds.
namespace clipc::draw::vulkan {

// A buffer in memory that the host can write and read.
struct Buffer {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Buffer buffer{nullptr};
  std::size_t size = 0;
};

// Whether Vulkan's validation layers watch a device.
enum class Validation : std::uint8_t { kOff, kOn };

// Returns the messages that the validation layers have reported of all devices since the last call.
std::vector<std::string> TakeMessages();

// A Vulkan 1.3 device.
class Device {
 public:
  // Opens the first device that has that extension. Throws NoDevice when there is none, or no
  // validation layers where they are asked for.
  Device(const char* extension, bool is_processor, Validation validation = Validation::kOff);
  // Opens a processor with transform feedback: Mesa's lavapipe.
  Device() : Device(VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME, true) {}
  explicit Device(Validation validation)
      : Device(VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME, true, validation) {}

  const vk::raii::Device& get() const { return device_; }
  std::string name() const { return physical_.getProperties().deviceName; }
  std::uint32_t lanes() const;  // of a subgroup
  vk::PhysicalDeviceTransformFeedbackPropertiesEXT FeedbackLimits() const;

  // Makes a buffer of these bytes, and of 16 at least, so that an empty one can be bound.
  Buffer NewBuffer(vk::BufferUsageFlags usage, std::span<const std::uint8_t> bytes) const;
  Words Read(const Buffer& buffer) const;
  vk::raii::DeviceMemory Allocate(const vk::MemoryRequirements& requirements) const;

  // Records commands, runs them and waits.
  void Submit(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;

 private:
  vk::raii::PhysicalDevice physical_{nullptr};
  vk::raii::Device device_{nullptr};
  vk::raii::Queue queue_{nullptr};
  std::uint32_t family_ = 0;
};

}  // namespace clipc::draw::vulkan
