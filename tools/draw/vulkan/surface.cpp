// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <bit>

#include "tools/draw/vulkan/descriptors.h"
#include "tools/draw/vulkan/device.h"
#include "tools/draw/vulkan/image.h"
#include "tools/draw/vulkan/pipeline.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {
namespace {

constexpr vk::Extent2D kSurfaceExtent(kSurfaceWidth, kSurfaceHeight);

vk::Format FormatOf(const SurfaceTarget& target) {
  using enum vk::Format;
  constexpr vk::Format kFormats[] = {eR32G32B32A32Sfloat, eR32G32B32A32Sint, eR32G32B32A32Uint};
  return target.is_depth ? eD32Sfloat : kFormats[static_cast<int>(target.kind)];
}

vk::ImageAspectFlagBits AspectOf(const SurfaceTarget& target) {
  return target.is_depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

// The images of the targets, as attachments of a draw call. Where a pixel has several samples,
// these have images of their own, which are resolved into the others.
class SurfaceImages {
 public:
  SurfaceImages(const Device& device, const std::vector<SurfaceTarget>& targets, int samples)
      : targets_(targets) {
    formats_.size = kSurfaceExtent;
    formats_.colors.clear();
    formats_.samples = static_cast<vk::SampleCountFlagBits>(samples);
    for (const SurfaceTarget& target : targets) {
      const Image& image =
          images_.emplace_back(MakeTarget(device, kSurfaceExtent, FormatOf(target)));
      pixels_.push_back(device.NewBuffer(
          vk::BufferUsageFlagBits::eTransferDst,
          Bytes(std::size_t{4} * kSurfaceWidth * kSurfaceHeight * (target.is_depth ? 1 : 4))));
      if (samples > 1)
        sampled_.push_back(MakeTarget(device, kSurfaceExtent, FormatOf(target), formats_.samples));
      Add(target, image);
    }
  }

  const PipelineTargets& Formats() const { return formats_; }

  void Begin(const vk::raii::CommandBuffer& commands) const {
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      Change(commands, i, images_[i], vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral);
      if (!sampled_.empty())
        Change(commands, i, sampled_[i], vk::ImageLayout::eUndefined, vk::ImageLayout::eGeneral);
    }
    const bool has_depth = formats_.depth != vk::Format::eUndefined;
    commands.beginRendering(vk::RenderingInfo({}, vk::Rect2D({0, 0}, kSurfaceExtent), 1, 0, colors_,
                                              has_depth ? &depth_ : nullptr));
  }

  // Ends the drawing and copies the images to where Read finds them.
  void End(const vk::raii::CommandBuffer& commands) const {
    commands.endRendering();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      Change(commands, i, images_[i], vk::ImageLayout::eGeneral,
             vk::ImageLayout::eTransferSrcOptimal);
      const vk::ImageSubresourceLayers place(AspectOf(targets_[i]), 0, 0, 1);
      const vk::BufferImageCopy copy(0, 0, 0, place, {}, {kSurfaceWidth, kSurfaceHeight, 1});
      commands.copyImageToBuffer(*images_[i].image, vk::ImageLayout::eTransferSrcOptimal,
                                 *pixels_[i].buffer, copy);
    }
  }

  std::vector<Captured> Read(const Device& device) const {
    std::vector<Captured> captured;
    for (std::size_t i = 0; i < targets_.size(); ++i)
      captured.push_back(PixelsOf(device.Read(pixels_[i]), targets_[i], false));
    return captured;
  }

 private:
  void Add(const SurfaceTarget& target, const Image& image) {
    vk::RenderingAttachmentInfo attachment;
    attachment.imageView = *image.view;
    attachment.imageLayout = vk::ImageLayout::eGeneral;
    attachment.loadOp = vk::AttachmentLoadOp::eClear;
    attachment.storeOp = vk::AttachmentStoreOp::eStore;
    if (!sampled_.empty()) {
      const bool has_mean = !target.is_depth && target.kind == WordKind::kFloat;
      attachment.resolveMode =
          has_mean ? vk::ResolveModeFlagBits::eAverage : vk::ResolveModeFlagBits::eSampleZero;
      attachment.resolveImageView = attachment.imageView;
      attachment.resolveImageLayout = attachment.imageLayout;
      attachment.imageView = *sampled_.back().view;
    }
    if (target.is_depth) {
      attachment.clearValue.depthStencil = vk::ClearDepthStencilValue(kClearDepth);
      depth_ = attachment;
      formats_.depth = FormatOf(target);
      return;
    }
    const std::uint32_t word =
        target.kind == WordKind::kFloat ? std::bit_cast<std::uint32_t>(kClearColor) : kClearInteger;
    attachment.clearValue.color = vk::ClearColorValue(std::array{word, word, word, word});
    const std::size_t count = std::max<std::size_t>(colors_.size(), target.number + 1);
    colors_.resize(count);
    formats_.colors.resize(count, vk::Format::eUndefined);
    colors_[target.number] = attachment;
    formats_.colors[target.number] = FormatOf(target);
  }

  void Change(const vk::raii::CommandBuffer& commands, std::size_t i, const Image& image,
              vk::ImageLayout from, vk::ImageLayout to) const {
    Transition(commands, image, {AspectOf(targets_[i]), 0, 1, 0, 1}, from, to);
  }

  const std::vector<SurfaceTarget>& targets_;
  std::vector<Image> images_, sampled_;
  std::vector<Buffer> pixels_;
  std::vector<vk::RenderingAttachmentInfo> colors_;
  vk::RenderingAttachmentInfo depth_;
  PipelineTargets formats_;
};

}  // namespace

std::vector<Captured> Runner::DrawSurface(const Spirv& vertex, const Spirv& fragment,
                                          const std::vector<SurfaceTarget>& targets,
                                          const DrawCall& call, int samples) const try {
  constexpr auto kBoth = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
  const SurfaceImages images(*device_, targets, samples);
  const Attributes attributes = UploadAttributes(*device_, call);
  const Descriptors descriptors(*device_, call);
  const std::vector<vk::DescriptorSetLayout> set_layouts = descriptors.Layouts();
  const vk::PushConstantRange range(kBoth, 0,
                                    static_cast<std::uint32_t>(call.push_constants.size()));
  vk::PipelineLayoutCreateInfo layout_info({}, set_layouts);
  if (range.size > 0) layout_info.setPushConstantRanges(range);
  const vk::raii::PipelineLayout layout(device_->get(), layout_info);
  const vk::raii::Pipeline pipeline =
      MakePipeline(device_->get(), {vertex, fragment, PipelineEnd::kImage}, attributes, layout,
                   images.Formats());
  device_->Submit([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
    descriptors.Bind(commands, layout);
    if (range.size > 0)
      commands.pushConstants<std::uint8_t>(*layout, kBoth, 0, call.push_constants);
    BindAttributes(commands, attributes);
    images.Begin(commands);
    commands.draw(static_cast<std::uint32_t>(call.vertices), 1, 0, 0);
    images.End(commands);
  });
  return images.Read(*device_);
} catch (const vk::Error& error) {
  throw DrawError(std::string("Vulkan refuses the shader or its inputs: ") + error.what());
}

}  // namespace clipc::draw::vulkan
