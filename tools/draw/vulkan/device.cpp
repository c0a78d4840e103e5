// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/device.h"

#include <algorithm>
#include <cstring>

namespace clipc::draw::vulkan {
namespace {

// Never destroyed: that would unload the driver with memory that it does not free, and
// LeakSanitizer, which could have followed its pointers, reports that.
const vk::raii::Instance& TheInstance() {
  static const auto* context = new vk::raii::Context;
  static const auto* instance = [] {
    const vk::ApplicationInfo application("clipc-draw", 0, "", 0, VK_API_VERSION_1_3);
    return new vk::raii::Instance(*context, vk::InstanceCreateInfo({}, &application));
  }();
  return *instance;
}

vk::raii::PhysicalDevice Choose(const char* extension, bool is_processor) {
  for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(TheInstance())) {
    const auto extensions = device.enumerateDeviceExtensionProperties();
    const bool has_extension = std::ranges::any_of(extensions, [&](const auto& known) {
      return std::strcmp(known.extensionName, extension) == 0;
    });
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    if (has_extension && properties.apiVersion >= VK_API_VERSION_1_3 &&
        (properties.deviceType == vk::PhysicalDeviceType::eCpu) == is_processor)
      return std::move(device);
  }
  throw DrawError(std::string("no device has ") + extension);
}

std::uint32_t GraphicsFamily(const vk::raii::PhysicalDevice& device) {
  const auto families = device.getQueueFamilyProperties();
  const auto found = std::ranges::find_if(families, [](const vk::QueueFamilyProperties& family) {
    return static_cast<bool>(family.queueFlags & vk::QueueFlagBits::eGraphics);
  });
  return found - families.begin();
}

// With every feature that it has.
vk::raii::Device Create(const vk::raii::PhysicalDevice& physical, std::uint32_t family,
                        const char* extension) {
  const auto features =
      physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan11Features,
                            vk::PhysicalDeviceVulkan12Features, vk::PhysicalDeviceVulkan13Features,
                            vk::PhysicalDeviceTransformFeedbackFeaturesEXT,
                            vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>();
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
  return {physical, vk::DeviceCreateInfo({}, queue, {}, extension, nullptr,
                                         &features.get<vk::PhysicalDeviceFeatures2>())};
}

}  // namespace

Device::Device(const char* extension, bool is_processor) try {
  physical_ = Choose(extension, is_processor);
  family_ = GraphicsFamily(physical_);
  device_ = Create(physical_, family_, extension);
  queue_ = device_.getQueue(family_, 0);
} catch (const std::exception& error) {
  throw NoDevice(std::string("no Vulkan 1.3: ") + error.what() +
                 "; on Debian: apt-get install mesa-vulkan-drivers");
}

vk::PhysicalDeviceTransformFeedbackPropertiesEXT Device::FeedbackLimits() const {
  using Limits = vk::PhysicalDeviceTransformFeedbackPropertiesEXT;
  return physical_.getProperties2<vk::PhysicalDeviceProperties2, Limits>().get<Limits>();
}

vk::raii::DeviceMemory Device::Allocate(const vk::MemoryRequirements& requirements) const {
  constexpr vk::MemoryPropertyFlags kWanted =
      vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  const vk::PhysicalDeviceMemoryProperties memory = physical_.getMemoryProperties();
  for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    const bool fits = requirements.memoryTypeBits >> i & 1;
    if (fits && (memory.memoryTypes[i].propertyFlags & kWanted) == kWanted)
      return {device_, vk::MemoryAllocateInfo(requirements.size, i)};
  }
  throw DrawError("Vulkan has no memory that the host can write");
}

Buffer Device::NewBuffer(vk::BufferUsageFlags usage, std::span<const std::uint8_t> bytes) const {
  Buffer made;
  made.size = std::max<std::size_t>(bytes.size(), 16);
  made.buffer = vk::raii::Buffer(device_, vk::BufferCreateInfo({}, made.size, usage));
  made.memory = Allocate(made.buffer.getMemoryRequirements());
  made.buffer.bindMemory(*made.memory, 0);
  auto* mapped = static_cast<std::uint8_t*>(made.memory.mapMemory(0, VK_WHOLE_SIZE));
  std::memset(mapped, 0, made.size);
  std::ranges::copy(bytes, mapped);
  made.memory.unmapMemory();
  return made;
}

Words Device::Read(const Buffer& buffer) const {
  Words words(buffer.size / 4);
  std::memcpy(words.data(), buffer.memory.mapMemory(0, VK_WHOLE_SIZE), 4 * words.size());
  buffer.memory.unmapMemory();
  return words;
}

void Device::Submit(const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
  const vk::raii::CommandPool pool(device_, vk::CommandPoolCreateInfo({}, family_));
  const vk::raii::CommandBuffers buffers(
      device_, vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 1));
  const vk::raii::CommandBuffer& commands = buffers.front();
  commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  record(commands);
  commands.end();
  queue_.submit(vk::SubmitInfo({}, {}, *commands, {}));
  queue_.waitIdle();
}

}  // namespace clipc::draw::vulkan
