// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "examples/lake-vulkan/device.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace lake {
namespace {

using Memory = vk::MemoryPropertyFlagBits;

// An instance is never destroyed: that would unload the driver with memory that it does not free,
// and LeakSanitizer, which could have followed its pointers, reports that.
const vk::raii::Instance& TheInstance() {
  static const auto* context = new vk::raii::Context;
  static const vk::ApplicationInfo application("lake", 0, "", 0, VK_API_VERSION_1_3);
  static const auto* instance =
      new vk::raii::Instance(*context, vk::InstanceCreateInfo({}, &application));
  return *instance;
}

vk::raii::PhysicalDevice ChooseDevice() {
  for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(TheInstance())) {
    const auto extensions = device.enumerateDeviceExtensionProperties();
    const bool pushes = std::ranges::any_of(extensions, [](const auto& extension) {
      return std::strcmp(extension.extensionName, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME) == 0;
    });
    if (pushes && device.getProperties().apiVersion >= VK_API_VERSION_1_3 &&
        device.getFeatures().shaderClipDistance)
      return std::move(device);
  }
  throw std::runtime_error(
      "no Vulkan 1.3 with clip distances; on Debian: apt-get install mesa-vulkan-drivers");
}

std::uint32_t GraphicsFamily(const vk::raii::PhysicalDevice& device) {
  const auto families = device.getQueueFamilyProperties();
  std::uint32_t i = 0;
  while (i + 1 < families.size() && !(families[i].queueFlags & vk::QueueFlagBits::eGraphics)) ++i;
  return i;
}

}  // namespace

Device::Device() : physical_(ChooseDevice()), family_(GraphicsFamily(physical_)) {
  vk::PhysicalDeviceVulkan13Features late;
  late.dynamicRendering = VK_TRUE;
  vk::PhysicalDeviceFeatures2 features({}, &late);
  features.features.shaderClipDistance = VK_TRUE;  // all that a clip plane needs
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, family_, 1, &priority);
  constexpr const char* kExtension = VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME;
  device_ = vk::raii::Device(physical_,
                             vk::DeviceCreateInfo({}, queue, {}, kExtension, nullptr, &features));
  queue_ = device_.getQueue(family_, 0);
}

vk::raii::DeviceMemory Device::Allocate(const vk::MemoryRequirements& needs,
                                        vk::MemoryPropertyFlags properties) const {
  const vk::PhysicalDeviceMemoryProperties memory = physical_.getMemoryProperties();
  for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    const bool fits = (needs.memoryTypeBits >> i & 1) != 0;
    if (fits && (memory.memoryTypes[i].propertyFlags & properties) == properties)
      return {device_, vk::MemoryAllocateInfo(needs.size, i)};
  }
  throw std::runtime_error("Vulkan has no such memory");
}

Buffer Device::NewBuffer(vk::BufferUsageFlags usage, const void* bytes, std::size_t size) const {
  Buffer made;
  made.buffer = vk::raii::Buffer(device_, vk::BufferCreateInfo({}, size, usage));
  made.memory =
      Allocate(made.buffer.getMemoryRequirements(), Memory::eHostVisible | Memory::eHostCoherent);
  made.buffer.bindMemory(*made.memory, 0);
  if (bytes != nullptr) {
    std::memcpy(made.memory.mapMemory(0, VK_WHOLE_SIZE), bytes, size);
    made.memory.unmapMemory();
  }
  return made;
}

Texture Device::NewTexture(vk::Format format, int width, int height) const {
  using Usage = vk::ImageUsageFlagBits;
  Texture made;
  made.size = vk::Extent2D(width, height);
  made.format = format;
  const bool is_depth = format == vk::Format::eD32Sfloat;
  made.aspect = is_depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
  vk::ImageCreateInfo info({}, vk::ImageType::e2D, format, vk::Extent3D(made.size, 1), 1, 1);
  info.usage = Usage::eSampled | Usage::eTransferSrc |
               (is_depth ? Usage::eDepthStencilAttachment : Usage::eColorAttachment);
  made.image = vk::raii::Image(device_, info);
  made.memory = Allocate(made.image.getMemoryRequirements(), Memory::eDeviceLocal);
  made.image.bindMemory(*made.memory, 0);
  const vk::ImageSubresourceRange all(made.aspect, 0, 1, 0, 1);
  made.view = vk::raii::ImageView(
      device_, vk::ImageViewCreateInfo({}, *made.image, vk::ImageViewType::e2D, format, {}, all));
  Run([&](const vk::raii::CommandBuffer& commands) {
    using Stage = vk::PipelineStageFlagBits;
    const vk::ImageMemoryBarrier barrier(
        {}, vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite,
        vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral, VK_QUEUE_FAMILY_IGNORED,
        VK_QUEUE_FAMILY_IGNORED, *made.image, all);
    commands.pipelineBarrier(Stage::eTopOfPipe, Stage::eAllCommands, {}, {}, {}, barrier);
  });
  return made;
}

void Device::Run(const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
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

clipc::harness::Image Device::Read(const Texture& texture) const {
  clipc::harness::Image image{
      static_cast<int>(texture.size.width), static_cast<int>(texture.size.height), {}};
  image.rgba.resize(std::size_t{4} * texture.size.width * texture.size.height);
  const Buffer copy = NewBuffer(vk::BufferUsageFlagBits::eTransferDst, nullptr, image.rgba.size());
  Run([&](const vk::raii::CommandBuffer& commands) {
    Wait(commands);
    const vk::BufferImageCopy all({}, 0, 0, vk::ImageSubresourceLayers(texture.aspect, 0, 0, 1), {},
                                  vk::Extent3D(texture.size, 1));
    commands.copyImageToBuffer(*texture.image, vk::ImageLayout::eGeneral, *copy.buffer, all);
  });
  std::memcpy(image.rgba.data(), copy.memory.mapMemory(0, VK_WHOLE_SIZE), image.rgba.size());
  copy.memory.unmapMemory();
  return image;
}

void Wait(const vk::raii::CommandBuffer& commands) {
  using Stage = vk::PipelineStageFlagBits;
  constexpr auto kAll = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;
  commands.pipelineBarrier(Stage::eAllCommands, Stage::eAllCommands, {},
                           vk::MemoryBarrier(kAll, kAll), {}, {});
}

}  // namespace lake
