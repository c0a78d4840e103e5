// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/run.h"

#include <algorithm>
#include <cstdlib>

#include "tools/draw/vulkan/descriptors.h"
#include "tools/draw/vulkan/device.h"
#include "tools/draw/vulkan/pipeline.h"

namespace clipc::draw::vulkan {
namespace {

// Outputs one after another in as many buffers as they take.
struct Layout {
  std::vector<FeedbackSlot> places;  // beside the outputs
  Words strides;                     // of each buffer
};

Layout LayOut(const Device& device, std::span<const Output> outputs) {
  Layout layout;
  const vk::PhysicalDeviceTransformFeedbackPropertiesEXT limits = device.FeedbackLimits();
  for (const Output& output : outputs) {
    const std::uint32_t bytes = 4 * output.Words();
    if (layout.strides.empty() ||
        layout.strides.back() + bytes > limits.maxTransformFeedbackBufferDataStride)
      layout.strides.push_back(0);
    layout.places.push_back(
        {static_cast<std::uint32_t>(layout.strides.size() - 1), layout.strides.back()});
    layout.strides.back() += bytes;
  }
  if (layout.strides.size() > limits.maxTransformFeedbackBuffers)
    throw DrawError("more outputs than transform feedback writes");
  return layout;
}

std::vector<Buffer> FeedbackBuffers(const Device& device, const Layout& layout, std::size_t runs) {
  std::vector<Buffer> buffers;
  for (const std::uint32_t stride : layout.strides) {
    // A value that is not written stays a NaN.
    const Bytes bytes(stride * runs, 0xff);
    buffers.push_back(
        device.NewBuffer(vk::BufferUsageFlagBits::eTransformFeedbackBufferEXT, bytes));
  }
  return buffers;
}

// `counter` gets the number of bytes that are written to the first buffer.
void Draw(const vk::raii::CommandBuffer& commands, const std::vector<Buffer>& feedback,
          const Buffer& counter, const Attributes& attributes, const DrawCall& call) {
  BindAttributes(commands, attributes);
  for (std::uint32_t i = 0; i < feedback.size(); ++i) {
    commands.bindTransformFeedbackBuffersEXT(i, *feedback[i].buffer, {0}, {VK_WHOLE_SIZE});
  }
  commands.beginRendering(vk::RenderingInfo({}, vk::Rect2D({0, 0}, {1, 1}), 1));
  commands.beginTransformFeedbackEXT(0, {}, {});
  commands.draw(call.vertices, call.instances, call.first_vertex, call.base_instance);
  commands.endTransformFeedbackEXT(0, *counter.buffer, vk::DeviceSize{0});
  commands.endRendering();
}

std::vector<Captured> Gather(const Device& device, const Layout& layout,
                             const std::vector<Buffer>& feedback, std::span<const Output> outputs,
                             int runs) {
  std::vector<Words> words;
  for (const Buffer& buffer : feedback) words.push_back(device.Read(buffer));
  std::vector<Captured> all;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    Captured& captured =
        all.emplace_back(Captured{outputs[i].name, outputs[i].layout, outputs[i].count, {}});
    const FeedbackSlot& place = layout.places[i];
    for (int run = 0; run < runs; ++run) {
      const auto first =
          words[place.buffer].begin() +
          (run * static_cast<std::ptrdiff_t>(layout.strides[place.buffer]) + place.offset) / 4;
      captured.words.insert(captured.words.end(), first, first + outputs[i].Words());
    }
  }
  return all;
}

}  // namespace

void CheckReads(const Spirv& spirv, const DrawCall& call) {
  const Reads reads = ReadsOf(spirv);
  for (const Reads::Binding& read : reads.bindings) {
    if (std::ranges::any_of(call.descriptors, [&](const auto& given) {
          return given.set == read.set && given.binding == read.binding;
        }))
      continue;
    throw DrawError("`" + read.name + "`, set " + std::to_string(read.set) + ", binding " +
                    std::to_string(read.binding) + ", has no value");
  }
  for (const Reads::Attribute& read : reads.attributes) {
    for (std::uint32_t at = read.location; at < read.location + read.locations; ++at) {
      if (std::ranges::any_of(call.attributes,
                              [&](const auto& given) { return given.location == at; }))
        continue;
      throw DrawError("attribute `" + read.name + "`, location " + std::to_string(at) +
                      ", has no value");
    }
  }
}

Runner::Runner() : device_(std::make_unique<Device>()) {}
Runner::~Runner() = default;

std::string Runner::WhyNone() {
  if (std::getenv("CI")) return "";
  try {
    const Device device;
    return "";
  } catch (const DrawError& error) {
    return error.what();
  }
}

std::string Runner::name() const { return device_->name(); }
std::uint32_t Runner::lanes() const { return device_->lanes(); }

// The shaders of a capture, of which the last one writes the outputs.
struct Runner::Feedback {
  PipelineShaders shaders;
  int most = 0;  // the vertices that it writes
};

std::vector<Captured> Runner::Capture(const Spirv& vertex, std::span<const Output> outputs,
                                      const DrawCall& call) const {
  CheckReads(vertex, call);
  return CaptureAll({{.vertex = vertex}, call.vertices * call.instances}, outputs, call);
}

std::vector<Captured> Runner::CaptureLast(const Stages& stages, std::span<const Output> outputs,
                                          const DrawCall& call) const {
  using enum vk::PrimitiveTopology;
  constexpr vk::PrimitiveTopology kTopologies[] = {
      ePointList, eLineList, eTriangleList, eLineListWithAdjacency, eTriangleListWithAdjacency};
  const bool has_patches = stages.patch_points > 0;
  return CaptureAll({{.vertex = stages.vertex,
                      .after = stages.after,
                      .topology = has_patches ? ePatchList : kTopologies[stages.primitive],
                      .patch_points = stages.patch_points},
                     stages.most},
                    outputs, call);
}

std::vector<Captured> Runner::CaptureAll(const Feedback& from, std::span<const Output> outputs,
                                         const DrawCall& call) const {
  const Layout layout = LayOut(*device_, outputs);
  try {
    const Attributes attributes = UploadAttributes(*device_, call);
    const Descriptors descriptors(*device_, call);
    const vk::raii::Device& device = device_->get();
    const std::vector<vk::DescriptorSetLayout> set_layouts = descriptors.Layouts();
    const auto pushed = static_cast<std::uint32_t>(call.push_constants.size());
    PipelineShaders shaders = from.shaders;
    const bool has_more = !shaders.after.empty();
    constexpr auto kStages = vk::ShaderStageFlagBits::eAllGraphics;
    const vk::PushConstantRange range(kStages, 0, pushed);
    vk::PipelineLayoutCreateInfo layout_info({}, set_layouts);
    if (pushed > 0) layout_info.setPushConstantRanges(range);
    const vk::raii::PipelineLayout pipeline_layout(device, layout_info);
    Spirv& writes = has_more ? shaders.after.back() : shaders.vertex;
    writes = WithTransformFeedback(writes, outputs, layout.places, layout.strides);
    const vk::raii::Pipeline pipeline = MakePipeline(device, shaders, attributes, pipeline_layout);
    const std::vector<Buffer> feedback =
        FeedbackBuffers(*device_, layout, static_cast<std::size_t>(from.most));
    const Buffer counter =
        device_->NewBuffer(vk::BufferUsageFlagBits::eTransformFeedbackCounterBufferEXT, Bytes(4));
    device_->Submit([&](const vk::raii::CommandBuffer& commands) {
      commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
      descriptors.Bind(commands, pipeline_layout);
      if (pushed > 0) {
        commands.pushConstants<std::uint8_t>(*pipeline_layout, kStages, 0, call.push_constants);
      }
      Draw(commands, feedback, counter, attributes, call);
    });
    const std::uint32_t written = device_->Read(counter).at(0) / layout.strides.at(0);
    return Gather(*device_, layout, feedback, outputs,
                  has_more ? static_cast<int>(written) : from.most);
  } catch (const vk::Error& error) {
    throw DrawError(std::string("Vulkan refuses the shader or its inputs: ") + error.what());
  }
}

}  // namespace clipc::draw::vulkan
