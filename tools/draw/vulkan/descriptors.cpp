// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/descriptors.h"

#include <algorithm>
#include <utility>

#include "tools/draw/dispatch.h"

namespace clipc::draw::vulkan {
namespace {

constexpr auto kAllStages =
    vk::ShaderStageFlagBits::eAllGraphics | vk::ShaderStageFlagBits::eCompute;

bool IsBuffer(DescriptorKind kind) {
  using enum DescriptorKind;
  return kind == kUniforms || kind == kStorage || kind == kTexels || kind == kImageTexels;
}

}  // namespace

vk::DescriptorType TypeOf(DescriptorKind kind) {
  using enum vk::DescriptorType;
  constexpr vk::DescriptorType kTypes[] = {
      eUniformBuffer,        eStorageBuffer,      eSampledImage, eSampler,
      eCombinedImageSampler, eUniformTexelBuffer, eStorageImage, eStorageTexelBuffer};
  return kTypes[static_cast<int>(kind)];
}

std::vector<vk::raii::DescriptorSetLayout> MakeLayouts(const Device& device, LayoutBindings& sets) {
  std::vector<vk::raii::DescriptorSetLayout> layouts;
  for (std::uint32_t set = 0; !sets.empty() && set <= sets.rbegin()->first; ++set) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const auto& [number, binding] : sets[set]) bindings.push_back(binding);
    layouts.emplace_back(device.get(), vk::DescriptorSetLayoutCreateInfo({}, bindings));
  }
  return layouts;
}

std::vector<vk::raii::DescriptorSetLayout> LayoutsOf(const Device& device,
                                                     std::span<const Reads> stages) {
  constexpr std::uint32_t kManyElements = 16;
  LayoutBindings sets;
  for (const Reads& reads : stages) {
    for (const Reads::Binding& read : reads.bindings) {
      sets[read.set].try_emplace(read.binding, read.binding, TypeOf(read.kind),
                                 read.elements > 0 ? read.elements : kManyElements, kAllStages);
    }
  }
  return MakeLayouts(device, sets);
}

std::vector<vk::DescriptorSetLayout> HandlesOf(
    const std::vector<vk::raii::DescriptorSetLayout>& layouts) {
  std::vector<vk::DescriptorSetLayout> handles;
  for (const vk::raii::DescriptorSetLayout& layout : layouts) handles.push_back(*layout);
  return handles;
}

Descriptors::Descriptors(const Device& device, const DrawCall& call) : device_(device) {
  MakeLayouts(call);
  MakeSets(call);
  for (const DrawCall::Descriptor& descriptor : call.descriptors) Write(descriptor);
}

void Descriptors::MakeLayouts(const DrawCall& call) {
  LayoutBindings sets;
  for (const DrawCall::Descriptor& descriptor : call.descriptors) {
    vk::DescriptorSetLayoutBinding& binding = sets[descriptor.set][descriptor.binding];
    binding.binding = descriptor.binding;
    binding.descriptorType = TypeOf(descriptor.kind);
    binding.stageFlags = kAllStages;
    binding.descriptorCount = std::max(binding.descriptorCount, descriptor.element + 1);
  }
  layouts_ = vulkan::MakeLayouts(device_, sets);
}

void Descriptors::MakeSets(const DrawCall& call) {
  if (layouts_.empty()) return;
  std::map<vk::DescriptorType, std::uint32_t> counts;
  for (const DrawCall::Descriptor& descriptor : call.descriptors) ++counts[TypeOf(descriptor.kind)];
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const auto& [type, count] : counts) sizes.emplace_back(type, count);
  pool_ = vk::raii::DescriptorPool(device_.get(),
                                   vk::DescriptorPoolCreateInfo({}, layouts_.size(), sizes));
  const std::vector<vk::DescriptorSetLayout> layouts = Layouts();
  for (vk::raii::DescriptorSet& set :
       vk::raii::DescriptorSets(device_.get(), vk::DescriptorSetAllocateInfo(*pool_, layouts))) {
    sets_.push_back(set.release());  // freed with the pool
  }
}

void Descriptors::Write(const DrawCall::Descriptor& given) {
  const vk::DescriptorType type = TypeOf(given.kind);
  vk::WriteDescriptorSet write(sets_.at(given.set), given.binding, given.element, 1, type);
  vk::DescriptorBufferInfo buffer(nullptr, 0, VK_WHOLE_SIZE);
  vk::DescriptorImageInfo image({}, {}, vk::ImageLayout::eShaderReadOnlyOptimal);
  vk::BufferView texels;
  switch (given.kind) {
    case DescriptorKind::kUniforms:
    case DescriptorKind::kStorage: {
      const auto usage = given.kind == DescriptorKind::kUniforms
                             ? vk::BufferUsageFlagBits::eUniformBuffer
                             : vk::BufferUsageFlagBits::eStorageBuffer;
      buffer.buffer = *buffers_.emplace_back(device_.NewBuffer(usage, given.bytes)).buffer;
      break;
    }
    case DescriptorKind::kTexels:
    case DescriptorKind::kImageTexels: {
      const auto usage = given.kind == DescriptorKind::kTexels
                             ? vk::BufferUsageFlagBits::eUniformTexelBuffer
                             : vk::BufferUsageFlagBits::eStorageTexelBuffer;
      const Buffer& made = buffers_.emplace_back(
          device_.NewBuffer(usage, BytesOf(given.texture.levels.at(0).words)));
      texels_.emplace_back(
          device_.get(),
          vk::BufferViewCreateInfo({}, *made.buffer, FormatOf(given.texture), 0, VK_WHOLE_SIZE));
      texels = *texels_.back();
      break;
    }
    case DescriptorKind::kImage: image.imageLayout = vk::ImageLayout::eGeneral; [[fallthrough]];
    case DescriptorKind::kTexture:
    case DescriptorKind::kSampler:
    case DescriptorKind::kTextureWithSampler:
      if (given.kind != DescriptorKind::kSampler)
        image.imageView = *images_.emplace_back(UploadImage(device_, given.texture)).view;
      if (given.kind == DescriptorKind::kSampler ||
          given.kind == DescriptorKind::kTextureWithSampler)
        image.sampler = *samplers_.emplace_back(MakeSampler(device_, given.compares));
      break;
  }
  write.pBufferInfo = &buffer;
  write.pImageInfo = &image;
  write.pTexelBufferView = &texels;
  device_.get().updateDescriptorSets(write, {});
  const std::size_t count = IsBuffer(given.kind) ? buffers_.size() : images_.size();
  places_.push_back(count - 1);
}

void Descriptors::Bind(const vk::raii::CommandBuffer& commands,
                       const vk::raii::PipelineLayout& layout, vk::PipelineBindPoint point) const {
  if (!sets_.empty()) commands.bindDescriptorSets(point, *layout, 0, sets_, {});
}

std::map<std::string, Bytes> Descriptors::ReadMemory(const DrawCall& call) const {
  std::map<std::string, Bytes> memory;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const DrawCall::Descriptor& given = call.descriptors[i];
    if (given.kind == DescriptorKind::kStorage) {
      Bytes bytes = BytesOf(device_.Read(buffers_[places_[i]]));
      bytes.resize(given.bytes.size());
      memory.emplace(given.name, std::move(bytes));
    } else if (given.kind == DescriptorKind::kImageTexels) {
      Words words = device_.Read(buffers_[places_[i]]);
      words.resize(given.texture.levels.at(0).words.size());
      memory.emplace(given.name, MemoryOfTexels(given.texture, words));
    } else if (given.kind == DescriptorKind::kImage) {
      memory.emplace(
          given.name,
          MemoryOfTexels(given.texture, ReadImage(device_, images_[places_[i]], given.texture)));
    }
  }
  return memory;
}

}  // namespace clipc::draw::vulkan
