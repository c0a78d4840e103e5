// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// clipc-isa FILE.spv...: compiles each vertex shader with the first Vulkan device and prints "FILE
// INSTRUCTIONS CYCLES": of the machine code, and what a multiprocessor needs for one wave (the
// inverse throughput). With RADV_FORCE_FAMILY set, Mesa plays an AMD processor. The shaders read
// two vertex attributes (vec4, vec3) and the uniform buffer 0. Exit: 77 where no device tells such
// numbers.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>

namespace {

[[noreturn]] void Skip(const char* why) {
  std::fprintf(stderr, "clipc-isa: %s\n", why);
  std::exit(77);
}

void Require(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  std::fprintf(stderr, "clipc-isa: %s failed with %d\n", what, static_cast<int>(result));
  std::exit(2);
}

// A Vulkan structure, zero but for its type.
template <typename T>
T Make(VkStructureType type) {
  T made{};
  made.sType = type;
  return made;
}

// Device and what all pipelines share; the process's end frees them.
struct Gpu {
  VkDevice device = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkRenderPass pass = VK_NULL_HANDLE;
  PFN_vkGetPipelineExecutablePropertiesKHR properties = nullptr;
  PFN_vkGetPipelineExecutableStatisticsKHR statistics = nullptr;
};

VkPhysicalDevice FirstDevice() {
  auto application = Make<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.apiVersion = VK_API_VERSION_1_2;
  auto create = Make<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  create.pApplicationInfo = &application;
  VkInstance instance;
  if (vkCreateInstance(&create, nullptr, &instance) != VK_SUCCESS) Skip("no Vulkan");
  std::uint32_t count = 1;
  VkPhysicalDevice device = VK_NULL_HANDLE;
  vkEnumeratePhysicalDevices(instance, &count, &device);
  if (count == 0) Skip("no Vulkan device");
  return device;
}

VkDevice OpenDevice(VkPhysicalDevice physical) {
  const float priority = 1;
  auto queue = Make<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueCount = 1, queue.pQueuePriorities = &priority;
  auto told = Make<VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR);
  told.pipelineExecutableInfo = VK_TRUE;
  VkPhysicalDeviceFeatures features{};
  features.shaderClipDistance = VK_TRUE;
  const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
  auto create = Make<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  create.pNext = &told;
  create.queueCreateInfoCount = 1, create.pQueueCreateInfos = &queue;
  create.enabledExtensionCount = 1, create.ppEnabledExtensionNames = &extension;
  create.pEnabledFeatures = &features;
  VkDevice device;
  if (vkCreateDevice(physical, &create, nullptr, &device) != VK_SUCCESS)
    Skip("the Vulkan device tells nothing of its code");
  return device;
}

VkRenderPass MakePass(VkDevice device) {
  VkAttachmentDescription color{};
  color.format = VK_FORMAT_R8G8B8A8_UNORM, color.samples = VK_SAMPLE_COUNT_1_BIT;
  color.finalLayout = VK_IMAGE_LAYOUT_GENERAL;
  const VkAttachmentReference reference = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.colorAttachmentCount = 1, subpass.pColorAttachments = &reference;
  auto create = Make<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
  create.attachmentCount = 1, create.pAttachments = &color;
  create.subpassCount = 1, create.pSubpasses = &subpass;
  VkRenderPass pass;
  Require(vkCreateRenderPass(device, &create, nullptr, &pass), "vkCreateRenderPass");
  return pass;
}

VkPipelineLayout MakeLayout(VkDevice device) {
  const VkDescriptorSetLayoutBinding binding = {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1,
                                                VK_SHADER_STAGE_VERTEX_BIT, nullptr};
  auto set =
      Make<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  set.bindingCount = 1, set.pBindings = &binding;
  VkDescriptorSetLayout set_layout;
  Require(vkCreateDescriptorSetLayout(device, &set, nullptr, &set_layout),
          "vkCreateDescriptorSetLayout");
  auto create = Make<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  create.setLayoutCount = 1, create.pSetLayouts = &set_layout;
  VkPipelineLayout layout;
  Require(vkCreatePipelineLayout(device, &create, nullptr, &layout), "vkCreatePipelineLayout");
  return layout;
}

Gpu OpenGpu() {
  Gpu gpu;
  gpu.device = OpenDevice(FirstDevice());
  gpu.layout = MakeLayout(gpu.device);
  gpu.pass = MakePass(gpu.device);
  gpu.properties = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
      vkGetDeviceProcAddr(gpu.device, "vkGetPipelineExecutablePropertiesKHR"));
  gpu.statistics = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
      vkGetDeviceProcAddr(gpu.device, "vkGetPipelineExecutableStatisticsKHR"));
  return gpu;
}

// A pipeline of that vertex shader alone: nothing behind it is rasterised away, because what it
// outputs is kept by the driver only for the built-in outputs; position and clip distances.
VkPipeline MakePipeline(const Gpu& gpu, const std::vector<char>& spirv) {
  auto module_create = Make<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  module_create.codeSize = spirv.size(),
  module_create.pCode = reinterpret_cast<const std::uint32_t*>(spirv.data());
  auto stage =
      Make<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
  stage.stage = VK_SHADER_STAGE_VERTEX_BIT, stage.pName = "main";
  Require(vkCreateShaderModule(gpu.device, &module_create, nullptr, &stage.module),
          "vkCreateShaderModule");
  const VkVertexInputBindingDescription binding = {0, 28, VK_VERTEX_INPUT_RATE_VERTEX};
  const VkVertexInputAttributeDescription attributes[] = {{0, 0, VK_FORMAT_R32G32B32A32_SFLOAT, 0},
                                                          {1, 0, VK_FORMAT_R32G32B32_SFLOAT, 16}};
  auto input = Make<VkPipelineVertexInputStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
  input.vertexBindingDescriptionCount = 1, input.pVertexBindingDescriptions = &binding;
  input.vertexAttributeDescriptionCount = 2, input.pVertexAttributeDescriptions = attributes;
  auto assembly = Make<VkPipelineInputAssemblyStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  const VkViewport viewport = {0, 0, 64, 64, 0, 1};
  const VkRect2D scissor = {{0, 0}, {64, 64}};
  auto view = Make<VkPipelineViewportStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
  view.viewportCount = 1, view.pViewports = &viewport, view.scissorCount = 1,
  view.pScissors = &scissor;
  auto raster = Make<VkPipelineRasterizationStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
  raster.lineWidth = 1;
  auto samples = Make<VkPipelineMultisampleStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  const VkPipelineColorBlendAttachmentState color{};
  auto blend = Make<VkPipelineColorBlendStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
  blend.attachmentCount = 1, blend.pAttachments = &color;
  auto create = Make<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
  create.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
  create.stageCount = 1, create.pStages = &stage;
  create.pVertexInputState = &input, create.pInputAssemblyState = &assembly,
  create.pViewportState = &view;
  create.pRasterizationState = &raster, create.pMultisampleState = &samples,
  create.pColorBlendState = &blend;
  create.layout = gpu.layout, create.renderPass = gpu.pass;
  VkPipeline pipeline;
  Require(vkCreateGraphicsPipelines(gpu.device, VK_NULL_HANDLE, 1, &create, nullptr, &pipeline),
          "vkCreateGraphicsPipelines");
  return pipeline;
}

// Of the first executable, which is the vertex shader.
std::uint64_t StatisticOf(const Gpu& gpu, VkPipeline pipeline, const char* name) {
  auto executable =
      Make<VkPipelineExecutableInfoKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR);
  executable.pipeline = pipeline;
  std::uint32_t count = 0;
  Require(gpu.statistics(gpu.device, &executable, &count, nullptr),
          "vkGetPipelineExecutableStatisticsKHR");
  std::vector<VkPipelineExecutableStatisticKHR> all(
      count,
      Make<VkPipelineExecutableStatisticKHR>(VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR));
  Require(gpu.statistics(gpu.device, &executable, &count, all.data()),
          "vkGetPipelineExecutableStatisticsKHR");
  for (const VkPipelineExecutableStatisticKHR& statistic : all) {
    if (std::strcmp(statistic.name, name) == 0) return statistic.value.u64;
  }
  Skip("the Vulkan device counts no instructions");
}

}  // namespace

int main(int argc, char** argv) {
  const Gpu gpu = OpenGpu();
  for (int i = 1; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::vector<char> spirv{std::istreambuf_iterator<char>(file), {}};
    if (spirv.empty() || spirv.size() % 4 != 0) {
      std::fprintf(stderr, "clipc-isa: `%s` is no SPIR-V\n", argv[i]);
      return 2;
    }
    const VkPipeline pipeline = MakePipeline(gpu, spirv);
    std::printf("%s %llu %llu\n", argv[i],
                static_cast<unsigned long long>(StatisticOf(gpu, pipeline, "Instructions")),
                static_cast<unsigned long long>(StatisticOf(gpu, pipeline, "Inverse Throughput")));
  }
  return 0;
}
