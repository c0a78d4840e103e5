// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/dispatch.h"

#include "tools/draw/vulkan/descriptors.h"
#include "tools/draw/vulkan/device.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

std::map<std::string, Bytes> Runner::Dispatch(const Spirv& compute, const DrawCall& call) const
    try {
  constexpr auto kStage = vk::ShaderStageFlagBits::eCompute;
  constexpr auto kPoint = vk::PipelineBindPoint::eCompute;
  CheckReads(compute, call);
  const vk::raii::Device& device = device_->get();
  const Descriptors descriptors(*device_, call);
  const std::vector<vk::DescriptorSetLayout> set_layouts = descriptors.Layouts();
  const auto pushed = static_cast<std::uint32_t>(call.push_constants.size());
  const vk::PushConstantRange range(kStage, 0, pushed);
  vk::PipelineLayoutCreateInfo layout_info({}, set_layouts);
  if (pushed > 0) layout_info.setPushConstantRanges(range);
  const vk::raii::PipelineLayout layout(device, layout_info);
  const vk::raii::ShaderModule module(device, vk::ShaderModuleCreateInfo({}, compute));
  const std::string entry = EntryPointOf(compute);
  const vk::PipelineShaderStageCreateInfo stage({}, kStage, *module, entry.c_str());
  const vk::raii::Pipeline pipeline(device, nullptr,
                                    vk::ComputePipelineCreateInfo({}, stage, *layout));
  device_->Submit([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(kPoint, *pipeline);
    descriptors.Bind(commands, layout, kPoint);
    if (pushed > 0) commands.pushConstants<std::uint8_t>(*layout, kStage, 0, call.push_constants);
    commands.dispatch(kGroups[0], kGroups[1], kGroups[2]);
    const vk::MemoryBarrier written(vk::AccessFlagBits::eShaderWrite,
                                    vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader,
                             vk::PipelineStageFlagBits::eHost, {}, written, {}, {});
  });
  return descriptors.ReadMemory(call);
} catch (const vk::Error& error) {
  throw DrawError(std::string("Vulkan refuses the shader or its inputs: ") + error.what());
}

}  // namespace clipc::draw::vulkan
