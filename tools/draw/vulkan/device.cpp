// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/device.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace clipc::draw::vulkan {
namespace {

const vk::raii::Context& TheContext() {
  static const auto* context = new vk::raii::Context;
  return *context;
}

// An instance is never destroyed: that would unload the driver with memory that it does not free,
// and LeakSanitizer, which could have followed its pointers, reports that.
const vk::ApplicationInfo kApplication("clipc-draw", 0, "", 0, VK_API_VERSION_1_3);

const vk::raii::Instance& TheInstance() {
  static const auto* instance =
      new vk::raii::Instance(TheContext(), vk::InstanceCreateInfo({}, &kApplication));
  return *instance;
}

std::vector<std::string>& Messages() {
  static std::vector<std::string> messages;
  return messages;
}

VKAPI_ATTR VkBool32 VKAPI_CALL Note(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                    VkDebugUtilsMessageTypeFlagsEXT,
                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
  Messages().emplace_back(data->pMessage);
  return VK_FALSE;
}

// An instance whose devices the validation layers watch.
const vk::raii::Instance& TheWatchedInstance() {
  static const vk::raii::Instance* instance = nullptr;
  if (instance) return *instance;
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  const vk::DebugUtilsMessengerCreateInfoEXT messenger(
      {}, Severity::eError | Severity::eWarning,
      Type::eGeneral | Type::eValidation | Type::ePerformance, Note);
  constexpr const char* kLayer = "VK_LAYER_KHRONOS_validation";
  constexpr const char* kExtension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  instance = new vk::raii::Instance(TheContext(),
                                    vk::InstanceCreateInfo({}, &kApplication, kLayer, kExtension));
  static const auto* listener = new vk::raii::DebugUtilsMessengerEXT(*instance, messenger);
  (void)listener;
  return *instance;
}

vk::raii::PhysicalDevice Choose(const vk::raii::Instance& instance, const char* extension,
                                bool is_processor) {
  for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance)) {
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

// Creates a device with every feature that it has.
vk::raii::Device Create(const vk::raii::PhysicalDevice& physical, std::uint32_t family,
                        const char* extension) {
  auto features =
      physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan11Features,
                            vk::PhysicalDeviceVulkan12Features, vk::PhysicalDeviceVulkan13Features,
                            vk::PhysicalDeviceTransformFeedbackFeaturesEXT,
                            vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>();
  if (std::strcmp(extension, VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME) != 0)
    features.unlink<vk::PhysicalDeviceTransformFeedbackFeaturesEXT>();
  if (std::strcmp(extension, VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME) != 0)
    features.unlink<vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>();
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
  return {physical, vk::DeviceCreateInfo({}, queue, {}, extension, nullptr,
                                         &features.get<vk::PhysicalDeviceFeatures2>())};
}

}  // namespace

std::vector<std::string> TakeMessages() { return std::exchange(Messages(), {}); }

Device::Device(const char* extension, bool is_processor, Validation validation) try {
  physical_ = Choose(validation == Validation::kOn ? TheWatchedInstance() : TheInstance(),
                     extension, is_processor);
  family_ = GraphicsFamily(physical_);
  device_ = Create(physical_, family_, extension);
  queue_ = device_.getQueue(family_, 0);
} catch (const std::exception& error) {
  throw NoDevice(std::string("no Vulkan 1.3: ") + error.what() +
                 "; on Debian: apt-get install mesa-vulkan-drivers vulkan-validationlayers");
}

vk::PhysicalDeviceTransformFeedbackPropertiesEXT Device::FeedbackLimits() const {
  using Limits = vk::PhysicalDeviceTransformFeedbackPropertiesEXT;
  return physical_.getProperties2<vk::PhysicalDeviceProperties2, Limits>().get<Limits>();
}

std::uint32_t Device::lanes() const {
  using Limits = vk::PhysicalDeviceVulkan11Properties;
  return physical_.getProperties2<vk::PhysicalDeviceProperties2, Limits>()
      .get<Limits>()
      .subgroupSize;
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
