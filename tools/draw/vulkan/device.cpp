// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/device.h"

#include <algorithm>
#include <cstring>

#include "tools/harness/offscreen.h"

namespace clipc::draw::vulkan {
namespace {

constexpr char kFeedback[] = VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME;

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

bool HasFeedback(const vk::raii::PhysicalDevice& device) {
  const auto extensions = device.enumerateDeviceExtensionProperties();
  return std::any_of(extensions.begin(), extensions.end(),
                     [](const vk::ExtensionProperties& extension) {
                       return std::strcmp(extension.extensionName, kFeedback) == 0;
                     });
}

vk::raii::PhysicalDevice Choose() {
  for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(TheInstance())) {
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    const bool is_processor = properties.deviceType == vk::PhysicalDeviceType::eCpu;
    if (is_processor && properties.apiVersion >= VK_API_VERSION_1_3 && HasFeedback(device))
      return std::move(device);
  }
  throw harness::DrawError(
      "no Vulkan 1.3 on the processor; on Debian: apt-get install mesa-vulkan-drivers");
}

std::uint32_t GraphicsFamily(const vk::raii::PhysicalDevice& device) {
  const auto families = device.getQueueFamilyProperties();
  const auto found =
      std::find_if(families.begin(), families.end(), [](const vk::QueueFamilyProperties& family) {
        return static_cast<bool>(family.queueFlags & vk::QueueFlagBits::eGraphics);
      });
  return static_cast<std::uint32_t>(found - families.begin());
}

// With every feature that it has.
vk::raii::Device Create(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
  const auto features =
      physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan11Features,
                            vk::PhysicalDeviceVulkan12Features, vk::PhysicalDeviceVulkan13Features,
                            vk::PhysicalDeviceTransformFeedbackFeaturesEXT>();
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
  const char* extensions[] = {kFeedback};
  return {physical, vk::DeviceCreateInfo({}, queue, {}, extensions, nullptr,
                                         &features.get<vk::PhysicalDeviceFeatures2>())};
}

template <typename Make>
auto Guarded(Make&& make) {
  try {
    return make();
  } catch (const harness::DrawError&) {
    throw;
  } catch (const std::exception& error) {
    throw harness::DrawError(std::string("no Vulkan: ") + error.what() +
                             "; on Debian: apt-get install mesa-vulkan-drivers");
  }
}

}  // namespace

Device::Device() {
  Guarded([&] {
    physical_ = Choose();
    family_ = GraphicsFamily(physical_);
    device_ = Create(physical_, family_);
    queue_ = device_.getQueue(family_, 0);
  });
}

std::uint32_t Device::MostFeedbackStride() const {
  const auto properties =
      physical_.getProperties2<vk::PhysicalDeviceProperties2,
                               vk::PhysicalDeviceTransformFeedbackPropertiesEXT>();
  return properties.get<vk::PhysicalDeviceTransformFeedbackPropertiesEXT>()
      .maxTransformFeedbackBufferDataStride;
}

std::uint32_t Device::MostFeedbackBuffers() const {
  const auto properties =
      physical_.getProperties2<vk::PhysicalDeviceProperties2,
                               vk::PhysicalDeviceTransformFeedbackPropertiesEXT>();
  return properties.get<vk::PhysicalDeviceTransformFeedbackPropertiesEXT>()
      .maxTransformFeedbackBuffers;
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
  throw harness::DrawError("Vulkan has no memory that the host can write");
}

Buffer Device::NewBuffer(vk::BufferUsageFlags usage, std::span<const std::uint8_t> bytes) const {
  Buffer made;
  made.size = std::max<std::size_t>(bytes.size(), 16);
  made.buffer = vk::raii::Buffer(device_, vk::BufferCreateInfo({}, made.size, usage));
  made.memory = Allocate(made.buffer.getMemoryRequirements());
  made.buffer.bindMemory(*made.memory, 0);
  auto* mapped = static_cast<std::uint8_t*>(made.memory.mapMemory(0, VK_WHOLE_SIZE));
  std::memset(mapped, 0, made.size);
  std::copy(bytes.begin(), bytes.end(), mapped);
  made.memory.unmapMemory();
  return made;
}

std::vector<std::uint32_t> Device::Read(const Buffer& buffer) const {
  std::vector<std::uint32_t> words(buffer.size / 4);
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
