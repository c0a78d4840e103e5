// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/machine_code.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "tools/draw/vulkan/descriptors.h"
#include "tools/draw/vulkan/device.h"
#include "tools/draw/vulkan/glslang.h"
#include "tools/draw/vulkan/pipeline.h"

namespace clipc::draw::vulkan {
namespace {

// The number of bytes of push constants that every Vulkan has at least.
constexpr std::uint32_t kPushedBytes = 128;

constexpr vk::ShaderStageFlags kBoth =
    vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

// The GLSL type of one element, `vec3` or `mat4x3`.
std::string GlslTypeOf(const WordLayout& layout) {
  constexpr const char* kScalars[] = {"float", "int", "uint"};
  constexpr const char* kVectors[] = {"vec", "ivec", "uvec"};
  const auto kind = static_cast<int>(layout.kind);
  if (layout.columns > 1)
    return "mat" + std::to_string(layout.columns) + "x" + std::to_string(layout.rows);
  return layout.rows == 1 ? kScalars[kind] : kVectors[kind] + std::to_string(layout.rows);
}

// A fragment shader that adds up all that the vertex shader gives to it.
Spirv ReaderOf(const std::vector<Output>& outputs) {
  std::string inputs, sum;
  for (const Output& output : outputs) {
    if (!output.location) continue;
    const std::string name = "i" + std::to_string(inputs.size());
    inputs += "layout(location = " + std::to_string(*output.location) + ") ";
    if (output.layout.kind != WordKind::kFloat) inputs += "flat ";
    inputs += "in " + GlslTypeOf(output.layout) + " " + name;
    if (output.count > 1) inputs += "[" + std::to_string(output.count) + "]";
    inputs += ";\n";
    for (int i = 0; i < output.count; ++i) {
      const std::string element = output.count > 1 ? name + "[" + std::to_string(i) + "]" : name;
      for (int column = 0; column < output.layout.columns; ++column) {
        const std::string vector =
            output.layout.columns > 1 ? element + "[" + std::to_string(column) + "]" : element;
        for (int row = 0; row < output.layout.rows; ++row) {
          const std::string component =
              output.layout.rows > 1 ? vector + "[" + std::to_string(row) + "]" : vector;
          sum += "  color += float(" + component + ");\n";
        }
      }
    }
  }
  return SpirvOfGlsl("#version 450\n" + inputs +
                         "layout(location = 0) out vec4 color;\nvoid main() {\n"
                         "  color = vec4(0.0);\n" +
                         sum + "}\n",
                     Stage::kPixel);
}

// A vertex shader that gives values of its own to all that the fragment shader reads.
Spirv WriterOf(const Reads& fragment) {
  std::string outputs, values;
  for (const Reads::Attribute& read : fragment.attributes) {
    WordLayout part = read.layout;
    part.columns = 1;
    if (part.rows < 1) throw DrawError("an input is a scalar, a vector or a matrix");
    for (std::uint32_t at = read.location; at < read.location + read.locations; ++at) {
      const std::string type = GlslTypeOf(part), number = std::to_string(at);
      outputs += "layout(location = " + number + ") out " + type + " o" + number + ";\n";
      const std::string seed = "gl_VertexIndex * " + std::to_string(at + 2);
      values += "  o" + number + " = " + type + "(sin(vec4(1, 2, 3, 4) * float(" + seed + "))" +
                std::string(".xyzw").substr(0, 1 + static_cast<std::size_t>(part.rows)) + ");\n";
    }
  }
  return SpirvOfGlsl("#version 450\n" + outputs +
                         "void main() {\n  gl_Position = vec4(gl_VertexIndex);\n" + values + "}\n",
                     Stage::kVertex);
}

}  // namespace

CodeCounter::CodeCounter()
    : device_(
          std::make_unique<Device>(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME, false)) {}
CodeCounter::~CodeCounter() = default;

MachineCode CodeCounter::Count(const Spirv& shader) const try {
  const vk::raii::Device& device = device_->get();
  const bool is_pixel = StageOf(shader) == Stage::kPixel;
  const Reads reads = ReadsOf(shader);
  const std::vector<vk::raii::DescriptorSetLayout> sets = LayoutsOf(*device_, {&reads, 1});
  const std::vector<vk::DescriptorSetLayout> layouts = HandlesOf(sets);
  const vk::PushConstantRange pushed(kBoth, 0, kPushedBytes);
  const vk::raii::PipelineLayout layout(device, vk::PipelineLayoutCreateInfo({}, layouts, pushed));
  const vk::raii::Pipeline pipeline =
      is_pixel
          ? MakePipeline(device, {WriterOf(reads), shader, PipelineEnd::kStatistics}, {}, layout,
                         TargetsOf(shader))
          : MakePipeline(device, {shader, ReaderOf(OutputsOf(shader)), PipelineEnd::kStatistics},
                         AttributesOf(reads), layout);
  const auto executables =
      device.getPipelineExecutablePropertiesKHR(vk::PipelineInfoKHR(*pipeline));
  const auto stage =
      is_pixel ? vk::ShaderStageFlagBits::eFragment : vk::ShaderStageFlagBits::eVertex;
  std::uint32_t index = 0;
  while (index < executables.size() && !(executables[index].stages & stage)) ++index;
  if (index == executables.size()) throw DrawError("the driver tells of no code of the stage");
  const auto all =
      device.getPipelineExecutableStatisticsKHR(vk::PipelineExecutableInfoKHR(*pipeline, index));
  const auto number = [&](std::string_view name) {
    const auto found = std::ranges::find_if(all, [&](const auto& statistic) {
      return name == static_cast<const char*>(statistic.name);
    });
    if (found == all.end()) throw DrawError("the Vulkan device counts no instructions");
    return found->value.u64;
  };
  return {number("Instructions"), number("Inverse Throughput")};
} catch (const vk::Error& error) {
  throw DrawError(std::string("Vulkan refuses the shader: ") + error.what());
}

}  // namespace clipc::draw::vulkan
