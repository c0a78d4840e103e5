// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The lake on Vulkan 1.3, as docs/lake-vulkan.md explains it: a shadow map, the image in the water,
// and the screen.
//   lake_vulkan [FILE.png]
#include <cstdio>
#include <deque>
#include <exception>
#include <span>
#include <vector>

#include "depth.spv.h"
#include "examples/lake-vulkan/device.h"
#include "examples/lake/scene.h"
#include "land.spv.h"
#include "surface.spv.h"
#include "tools/harness/image.h"

namespace {

using namespace lake;
using Words = std::span<const std::uint32_t>;

// Where clipc binds the registers: b0 at 0, s0 at 16, t0 at 32, all in set 0.
constexpr std::uint32_t kBuffer = 0, kSampler = 16, kTexture = 32;

constexpr vk::ShaderStageFlags kBothStages =
    vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr vk::Format kColor = vk::Format::eR8G8B8A8Unorm, kDepth = vk::Format::eD32Sfloat;

struct MeshBuffers {
  Buffer vertices, indices;
  std::uint32_t count = 0;
};

// What the passes share: one set of bindings for all three programs, samplers, meshes.
struct Renderer {
  Device device;
  vk::raii::DescriptorSetLayout set{nullptr};
  vk::raii::PipelineLayout layout{nullptr};
  vk::raii::Sampler nearer{nullptr}, smooth{nullptr};  // of s0 and s1
  std::vector<MeshBuffers> meshes;
  std::deque<Buffer> constants;  // of the draws that run
};

Renderer MakeRenderer(const Scene& scene) {
  Renderer made;
  const vk::raii::Device& device = *made.device;
  using enum vk::DescriptorType;
  const vk::DescriptorSetLayoutBinding bindings[] = {
      {kBuffer + 0, eUniformBuffer, 1, kBothStages}, {kBuffer + 1, eUniformBuffer, 1, kBothStages},
      {kSampler + 0, eSampler, 1, kBothStages},      {kSampler + 1, eSampler, 1, kBothStages},
      {kTexture + 0, eSampledImage, 1, kBothStages}, {kTexture + 1, eSampledImage, 1, kBothStages}};
  made.set = {device, vk::DescriptorSetLayoutCreateInfo(
                          vk::DescriptorSetLayoutCreateFlagBits::ePushDescriptorKHR, bindings)};
  made.layout = {device, vk::PipelineLayoutCreateInfo({}, *made.set)};

  // SampleCmp compares: the sampler says so.
  vk::SamplerCreateInfo sampler({}, vk::Filter::eLinear, vk::Filter::eLinear);
  sampler.addressModeU = sampler.addressModeV = vk::SamplerAddressMode::eClampToEdge;
  made.smooth = {device, sampler};
  sampler.compareEnable = VK_TRUE;
  sampler.compareOp = vk::CompareOp::eLessOrEqual;
  made.nearer = {device, sampler};

  using Usage = vk::BufferUsageFlagBits;
  const auto upload = [&](Usage usage, const auto& list) {
    return made.device.NewBuffer(usage, list.data(), list.size() * sizeof list[0]);
  };
  for (const Mesh& mesh : scene.meshes)
    made.meshes.push_back({upload(Usage::eVertexBuffer, mesh.vertices),
                           upload(Usage::eIndexBuffer, mesh.indices),
                           static_cast<std::uint32_t>(mesh.indices.size())});
  return made;
}

// A program of a vertex shader and a pixel shader, which may be empty: then only depth is drawn.
vk::raii::Pipeline NewPipeline(const Renderer& renderer, Words vertex, Words pixel) {
  const vk::raii::Device& device = *renderer.device;
  std::vector<vk::raii::ShaderModule> modules;
  std::vector<vk::PipelineShaderStageCreateInfo> stages;
  const auto add = [&](vk::ShaderStageFlagBits stage, Words words) {
    modules.emplace_back(device, vk::ShaderModuleCreateInfo({}, words.size_bytes(), words.data()));
    stages.push_back({{}, stage, *modules.back(), "main"});
  };
  add(vk::ShaderStageFlagBits::eVertex, vertex);
  if (!pixel.empty()) add(vk::ShaderStageFlagBits::eFragment, pixel);

  // The inputs have the locations 0 and 1, in the order of the HLSL.
  constexpr auto kFloat3 = vk::Format::eR32G32B32Sfloat;
  const vk::VertexInputBindingDescription binding(0, sizeof(Vertex));
  const vk::VertexInputAttributeDescription attributes[] = {
      {0, 0, kFloat3, offsetof(Vertex, position)}, {1, 0, kFloat3, offsetof(Vertex, normal)}};
  const vk::PipelineVertexInputStateCreateInfo input({}, binding, attributes);
  const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  rasterization.lineWidth = 1;
  const vk::PipelineMultisampleStateCreateInfo multisample;
  const vk::PipelineDepthStencilStateCreateInfo depth({}, VK_TRUE, VK_TRUE, vk::CompareOp::eLess);
  vk::PipelineColorBlendAttachmentState target;
  target.colorWriteMask = vk::ColorComponentFlags(15);
  const std::uint32_t targets = pixel.empty() ? 0 : 1;
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, {}, targets, &target);
  const vk::DynamicState states[] = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, states);
  const vk::PipelineRenderingCreateInfo rendering(0, targets, &kColor, kDepth);
  return {device, nullptr,
          vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewport,
                                         &rasterization, &multisample, &depth, &blend, &dynamic,
                                         *renderer.layout, {}, {}, {}, {}, &rendering)};
}

// The textures of t0 and t1 that the pass reads.
struct Reads {
  const Texture *shadow = nullptr, *mirror = nullptr;
};

void Draw(Renderer& renderer, const vk::raii::CommandBuffer& commands,
          const vk::raii::Pipeline& pipeline, const ViewConstants& view,
          const std::vector<Object>& objects, const Reads& reads) {
  using enum vk::DescriptorType;
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
  const auto upload = [&](const auto& constants) {
    renderer.constants.push_back(renderer.device.NewBuffer(vk::BufferUsageFlagBits::eUniformBuffer,
                                                           &constants, sizeof constants));
    return vk::DescriptorBufferInfo(*renderer.constants.back().buffer, 0, VK_WHOLE_SIZE);
  };
  const vk::DescriptorBufferInfo of_view = upload(view);
  const vk::DescriptorImageInfo samplers[] = {{*renderer.nearer}, {*renderer.smooth}};
  for (const Object& object : objects) {
    const vk::DescriptorBufferInfo of_object = upload(object.constants);
    std::vector<vk::WriteDescriptorSet> writes = {
        {{}, kBuffer + 0, 0, eUniformBuffer, {}, of_view},
        {{}, kBuffer + 1, 0, eUniformBuffer, {}, of_object},
        {{}, kSampler + 0, 0, eSampler, samplers[0]},
        {{}, kSampler + 1, 0, eSampler, samplers[1]}};
    vk::DescriptorImageInfo images[2];
    const Texture* const textures[] = {reads.shadow, reads.mirror};
    for (std::uint32_t i = 0; i < 2; ++i) {
      if (textures[i] == nullptr) continue;
      images[i] = {{}, *textures[i]->view, vk::ImageLayout::eGeneral};
      writes.push_back({{}, kTexture + i, 0, eSampledImage, images[i]});
    }
    commands.pushDescriptorSetKHR(vk::PipelineBindPoint::eGraphics, *renderer.layout, 0, writes);
    const MeshBuffers& mesh = renderer.meshes[object.mesh];
    commands.bindVertexBuffers(0, *mesh.vertices.buffer, vk::DeviceSize{0});
    commands.bindIndexBuffer(*mesh.indices.buffer, 0, vk::IndexType::eUint32);
    commands.drawIndexed(mesh.count, 1, 0, 0, 0);
  }
}

// Begins a pass that clears what it draws to, after everything before.
void BeginPass(const vk::raii::CommandBuffer& commands, const Texture* color,
               const Texture& depth) {
  Wait(commands);
  const auto attachment = [](const Texture& texture, const vk::ClearValue& clear) {
    vk::RenderingAttachmentInfo info(*texture.view, vk::ImageLayout::eGeneral);
    info.loadOp = vk::AttachmentLoadOp::eClear;
    info.storeOp = vk::AttachmentStoreOp::eStore;
    info.clearValue = clear;
    return info;
  };
  const auto far = attachment(depth, vk::ClearDepthStencilValue(1, 0));
  const auto sky = color ? attachment(*color, vk::ClearColorValue(kSky)) : far;
  const vk::Rect2D all({}, depth.size);
  commands.beginRendering(vk::RenderingInfo({}, all, 1, 0, color ? 1 : 0, &sky, &far));
  const auto width = static_cast<float>(depth.size.width);
  const auto height = static_cast<float>(depth.size.height);
  commands.setViewport(0, vk::Viewport(0, 0, width, height, 0, 1));
  commands.setScissor(0, all);
}

Image DrawLake() {
  const Scene scene = MakeScene();
  Renderer renderer = MakeRenderer(scene);
  const Device& device = renderer.device;
  const auto depth = NewPipeline(renderer, depth_spv, {});
  const auto land = NewPipeline(renderer, land_spv, land_spv_pixel);
  const auto surface = NewPipeline(renderer, surface_spv, surface_spv_pixel);
  const Texture shadow = device.NewTexture(kDepth, kShadow, kShadow);
  const Texture mirror = device.NewTexture(kColor, kWidth, kHeight);
  const Texture screen = device.NewTexture(kColor, kWidth, kHeight);
  const Texture far = device.NewTexture(kDepth, kWidth, kHeight);

  device.Run([&](const vk::raii::CommandBuffer& commands) {
    BeginPass(commands, nullptr, shadow);
    Draw(renderer, commands, depth, scene.sunlight, scene.land, {});
    commands.endRendering();

    // The image in the water. The pipeline clips by every distance that the shader writes.
    BeginPass(commands, &mirror, far);
    Draw(renderer, commands, land, scene.mirrored, scene.land, {&shadow});
    commands.endRendering();

    BeginPass(commands, &screen, far);
    Draw(renderer, commands, land, scene.seen, scene.land, {&shadow});
    Draw(renderer, commands, surface, scene.seen, scene.surface, {&shadow, &mirror});
    commands.endRendering();
  });
  return device.Read(screen);
}

}  // namespace

int main(int argc, char** argv) try {
  WritePng(argc > 1 ? argv[1] : "lake-vulkan.png", Half(DrawLake()));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "lake_vulkan: %s\n", error.what());
  return 1;
}
