// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/pair.h"

#include <algorithm>
#include <bit>

#include "tools/draw/opengl/image.h"
#include "tools/draw/vulkan/descriptors.h"
#include "tools/draw/vulkan/device.h"
#include "tools/draw/vulkan/pipeline.h"

namespace clipc::draw::vulkan {
namespace {

void AddBinding(const Reads::Binding& read, DrawCall& call) {
  const auto given = std::ranges::find_if(call.descriptors, [&](const auto& known) {
    return known.set == read.set && known.binding == read.binding;
  });
  DrawCall::Descriptor& descriptor = given != call.descriptors.end()
                                         ? *given
                                         : call.descriptors.emplace_back(DrawCall::Descriptor{
                                               read.set, read.binding, 0, read.kind});
  const std::uint64_t seed = SeedOf(std::to_string(read.set) + "." + std::to_string(read.binding));
  if (descriptor.kind != read.kind || read.is_array)
    throw DrawError("`" + read.name + "` is an array, or its place is taken by another kind");
  switch (read.kind) {
    case DescriptorKind::kUniforms:
      descriptor.bytes = PairBlock(seed, std::max(read.bytes, descriptor.bytes.size()));
      return;
    case DescriptorKind::kTexture:
    case DescriptorKind::kTextureWithSampler: descriptor.texture = PairTexture(seed); return;
    case DescriptorKind::kSampler: return;
    case DescriptorKind::kStorage:
    case DescriptorKind::kTexels:
    case DescriptorKind::kImage:
    case DescriptorKind::kImageTexels: break;
  }
  throw DrawError("`" + read.name + "` is a buffer, which no pair is drawn with");
}

DrawCall CallOf(const SpirvPair& pair) {
  DrawCall call;
  call.vertices = static_cast<int>(FullTarget().size());
  const Reads vertex = ReadsOf(pair.vertex);
  for (const Reads::Attribute& read : vertex.attributes) {
    for (std::uint32_t at = read.location; at < read.location + read.locations; ++at)
      call.attributes.push_back({at, read.layout.kind, PairAttribute(at, read.layout)});
  }
  for (const Reads::Binding& read : vertex.bindings) AddBinding(read, call);
  for (const Reads::Binding& read : ReadsOf(pair.fragment).bindings) AddBinding(read, call);
  return call;
}

// Records the drawing of the call's triangles into a cleared target.
void Record(const vk::raii::CommandBuffer& commands, const Image& target,
            const Attributes& attributes, int vertices) {
  const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  Transition(commands, target, all, vk::ImageLayout::eUndefined,
             vk::ImageLayout::eColorAttachmentOptimal);
  vk::RenderingAttachmentInfo attachment;
  attachment.imageView = *target.view;
  attachment.imageLayout = vk::ImageLayout::eColorAttachmentOptimal;
  attachment.loadOp = vk::AttachmentLoadOp::eClear;
  attachment.storeOp = vk::AttachmentStoreOp::eStore;
  const vk::Rect2D area({0, 0}, {kPairSize, kPairSize});
  BindAttributes(commands, attributes);
  commands.beginRendering(vk::RenderingInfo({}, area, 1, 0, attachment));
  commands.draw(static_cast<std::uint32_t>(vertices), 1, 0, 0);
  commands.endRendering();
  Transition(commands, target, all, vk::ImageLayout::eColorAttachmentOptimal,
             vk::ImageLayout::eTransferSrcOptimal);
}

// Draws the pair. Returns four floats for each pixel.
std::vector<float> Draw(const Device& device, const SpirvPair& pair) try {
  const DrawCall call = CallOf(pair);
  const Attributes attributes = UploadAttributes(device, call);
  const Descriptors descriptors(device, call);
  const std::vector<vk::DescriptorSetLayout> set_layouts = descriptors.Layouts();
  const vk::raii::PipelineLayout layout(device.get(),
                                        vk::PipelineLayoutCreateInfo({}, set_layouts));
  const vk::raii::Pipeline pipeline = MakePipeline(
      device.get(), {pair.vertex, pair.fragment, PipelineEnd::kImage}, attributes, layout);
  const Image target = MakeTarget(device, {kPairSize, kPairSize});
  const Buffer pixels = device.NewBuffer(vk::BufferUsageFlagBits::eTransferDst,
                                         Bytes(std::size_t{16} * kPairSize * kPairSize));
  device.Submit([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
    descriptors.Bind(commands, layout);
    Record(commands, target, attributes, call.vertices);
    const vk::ImageSubresourceLayers place(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
    const vk::BufferImageCopy copy(0, 0, 0, place, {}, {kPairSize, kPairSize, 1});
    commands.copyImageToBuffer(*target.image, vk::ImageLayout::eTransferSrcOptimal, *pixels.buffer,
                               copy);
  });
  std::vector<float> rgba;
  for (const std::uint32_t word : device.Read(pixels)) rgba.push_back(std::bit_cast<float>(word));
  return rgba;
} catch (const vk::Error& error) {
  throw DrawError(std::string("Vulkan refuses the program: ") + error.what());
}

void Link(const Device& device, const SpirvPair& pair) {
  constexpr std::uint32_t kPushedBytes = 128;  // that every Vulkan has
  const Reads reads[] = {ReadsOf(pair.vertex), ReadsOf(pair.fragment)};
  const std::vector<vk::raii::DescriptorSetLayout> sets = LayoutsOf(device, reads);
  const std::vector<vk::DescriptorSetLayout> layouts = HandlesOf(sets);
  const vk::PushConstantRange pushed(
      vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment, 0, kPushedBytes);
  const vk::raii::PipelineLayout layout(device.get(),
                                        vk::PipelineLayoutCreateInfo({}, layouts, pushed));
  MakePipeline(device.get(), {pair.vertex, pair.fragment, PipelineEnd::kImage},
               AttributesOf(reads[0]), layout, TargetsOf(pair.fragment));
}

}  // namespace

std::vector<std::string> LinkPrograms(std::span<const SpirvPair> pairs) {
  const Device device(Validation::kOn);
  TakeMessages();
  std::vector<std::string> said;
  for (const SpirvPair& pair : pairs) {
    std::string& text = said.emplace_back();
    try {
      Link(device, pair);
    } catch (const vk::Error& error) {
      text = std::string("Vulkan refuses the program: ") + error.what();
    }
    for (const std::string& message : TakeMessages()) text += (text.empty() ? "" : "\n") + message;
  }
  return said;
}

PairResult CompareImages(const SpirvPair& first, const SpirvPair& second) {
  const Device device(Validation::kOn);
  TakeMessages();
  const std::vector<float> mine = Draw(device, first);
  std::vector<std::string> messages = TakeMessages();
  return {CompareColors(mine, Draw(device, second)), std::move(messages)};
}

std::string PairDeviceName() { return Device(Validation::kOn).name(); }

}  // namespace clipc::draw::vulkan
