// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tools/draw/vulkan/image.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

vk::DescriptorType TypeOf(DescriptorKind kind);

// The bindings of each set, by the numbers of the set and of the binding.
using LayoutBindings =
    std::map<std::uint32_t, std::map<std::uint32_t, vk::DescriptorSetLayoutBinding>>;
// A layout for each set up to the last one, by its number. `sets` gets an empty set for each number
// that it lacks.
std::vector<vk::raii::DescriptorSetLayout> MakeLayouts(const Device& device, LayoutBindings& sets);
// Layouts for what the stages of a program read. An array without a size gets 16 elements.
std::vector<vk::raii::DescriptorSetLayout> LayoutsOf(const Device& device,
                                                     std::span<const Reads> stages);
std::vector<vk::DescriptorSetLayout> HandlesOf(
    const std::vector<vk::raii::DescriptorSetLayout>& layouts);

// The descriptor sets of a draw call and the objects that they point to.
class Descriptors {
 public:
  Descriptors(const Device& device, const DrawCall& call);

  std::vector<vk::DescriptorSetLayout> Layouts() const { return HandlesOf(layouts_); }
  void Bind(const vk::raii::CommandBuffer& commands, const vk::raii::PipelineLayout& layout,
            vk::PipelineBindPoint point = vk::PipelineBindPoint::eGraphics) const;
  // What shaders left in the memory that they may write, by its names.
  std::map<std::string, Bytes> ReadMemory(const DrawCall& call) const;

 private:
  void MakeLayouts(const DrawCall& call);
  void MakeSets(const DrawCall& call);
  void Write(const DrawCall::Descriptor& descriptor);

  const Device& device_;
  std::vector<vk::raii::DescriptorSetLayout> layouts_;  // by number of the set; empty ones between
  vk::raii::DescriptorPool pool_{nullptr};
  std::vector<vk::DescriptorSet> sets_;
  // The objects that the sets point to.
  std::vector<Buffer> buffers_;
  std::vector<Image> images_;
  std::vector<vk::raii::BufferView> texels_;
  std::vector<vk::raii::Sampler> samplers_;
  std::vector<std::size_t> places_;  // of each descriptor, in buffers_ or in images_
};

}  // namespace clipc::draw::vulkan
