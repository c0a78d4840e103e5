// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/spirv.h"

#include <algorithm>
#include <cstring>
#include <set>

#include "tools/draw/vulkan/reflect.h"

namespace clipc::draw::vulkan {
namespace {

using spirv_cross::Compiler;
using spirv_cross::Resource;
using spirv_cross::SPIRType;

constexpr std::size_t kHeaderWords = 5;

WordLayout LayoutOf(const SPIRType& type, const std::string& name) {
  using enum WordKind;
  const auto columns = static_cast<int>(type.columns), rows = static_cast<int>(type.vecsize);
  switch (type.basetype) {
    case SPIRType::Float: return {kFloat, columns, rows};
    case SPIRType::Int: return {kInt, columns, rows};
    case SPIRType::Boolean:
    case SPIRType::UInt: return {kUint, columns, rows};
    default: throw DrawError("`" + name + "` has a type that no test draws with");
  }
}

int CountOf(const SPIRType& type) {
  int count = 1;
  for (const std::uint32_t size : type.array) count *= static_cast<int>(size);
  return count;
}

const char* NameOf(spv::BuiltIn builtin) {
  switch (builtin) {
    case spv::BuiltInPosition: return "gl_Position";
    case spv::BuiltInPointSize: return "gl_PointSize";
    case spv::BuiltInClipDistance: return "gl_ClipDistance";
    case spv::BuiltInCullDistance: return "gl_CullDistance";
    case spv::BuiltInLayer: return "gl_Layer";
    case spv::BuiltInViewportIndex: return "gl_ViewportIndex";
    default: return "";
  }
}

Output Make(const Compiler& compiler, const Resource& resource, spirv_cross::TypeID type_id,
            std::string name) {
  const SPIRType& type = compiler.get_type(type_id);
  Output output;
  output.layout = LayoutOf(type, name);
  output.count = CountOf(type);
  output.name = std::move(name);
  output.variable = resource.id;
  output.type = resource.base_type_id;
  return output;
}

// The member of gl_PerVertex with that built-in; none where it is a variable of its own.
std::optional<std::uint32_t> MemberOf(const Compiler& compiler,
                                      const spirv_cross::BuiltInResource& found) {
  const SPIRType& type = compiler.get_type(found.resource.base_type_id);
  if (type.basetype != SPIRType::Struct) return std::nullopt;
  for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
    if (compiler.has_member_decoration(type.self, i, spv::DecorationBuiltIn) &&
        compiler.get_member_decoration(type.self, i, spv::DecorationBuiltIn) ==
            static_cast<std::uint32_t>(found.builtin)) {
      return i;
    }
  }
  return std::nullopt;
}

std::vector<Output> ReflectOutputs(const Compiler& compiler) {
  const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
  std::vector<Output> outputs;
  for (const Resource& resource : resources.stage_outputs) {
    Output& output =
        outputs.emplace_back(Make(compiler, resource, resource.type_id, resource.name));
    output.location = compiler.get_decoration(resource.id, spv::DecorationLocation);
    output.semantic =
        compiler.get_decoration_string(resource.id, spv::DecorationHlslSemanticGOOGLE);
  }
  for (const spirv_cross::BuiltInResource& found : resources.builtin_outputs) {
    Output& output = outputs.emplace_back(
        Make(compiler, found.resource, found.value_type_id, NameOf(found.builtin)));
    output.member = MemberOf(compiler, found);
    output.semantic =
        compiler.get_decoration_string(found.resource.id, spv::DecorationHlslSemanticGOOGLE);
  }
  return outputs;
}

Reads ReflectReads(const Compiler& compiler) {
  const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
  Reads reads;
  const auto add = [&](const auto& list, DescriptorKind kind) {
    for (const Resource& resource : list) {
      const std::string& variable = compiler.get_name(resource.id);
      const SPIRType& type = compiler.get_type(resource.type_id);
      Reads::Binding& binding = reads.bindings.emplace_back(
          Reads::Binding{variable.empty() ? compiler.get_name(resource.base_type_id) : variable,
                         compiler.get_decoration(resource.id, spv::DecorationDescriptorSet),
                         compiler.get_decoration(resource.id, spv::DecorationBinding), kind,
                         !type.array.empty(), static_cast<std::uint32_t>(CountOf(type))});
      if (kind == DescriptorKind::kUniforms)
        binding.bytes = compiler.get_declared_struct_size(compiler.get_type(resource.base_type_id));
      if (type.basetype != SPIRType::Struct && type.image.dim == spv::DimBuffer)
        binding.kind =
            kind == DescriptorKind::kImage ? DescriptorKind::kImageTexels : DescriptorKind::kTexels;
    }
  };
  add(resources.uniform_buffers, DescriptorKind::kUniforms);
  add(resources.storage_buffers, DescriptorKind::kStorage);
  add(resources.sampled_images, DescriptorKind::kTextureWithSampler);
  add(resources.separate_images, DescriptorKind::kTexture);
  add(resources.separate_samplers, DescriptorKind::kSampler);
  add(resources.storage_images, DescriptorKind::kImage);
  for (const Resource& resource : resources.stage_inputs) {
    const SPIRType& type = compiler.get_type(resource.type_id);
    reads.attributes.push_back(
        {resource.name,
         compiler.get_decoration_string(resource.id, spv::DecorationHlslSemanticGOOGLE),
         compiler.get_decoration(resource.id, spv::DecorationLocation),
         static_cast<std::uint32_t>(CountOf(type)) * type.columns,
         type.basetype == SPIRType::Struct ? WordLayout{} : LayoutOf(type, resource.name)});
  }
  return reads;
}

// Calls visit(opcode) until that returns false, and returns where it stopped.
template <typename Visit>
std::size_t Walk(const Spirv& spirv, Visit&& visit) {
  std::size_t at = kHeaderWords;
  while (at < spirv.size() && visit(static_cast<spv::Op>(spirv[at] & 0xffff)))
    at += std::max(spirv[at] >> 16, 1u);
  return at;
}

void Append(Spirv& spirv, spv::Op op, std::initializer_list<std::uint32_t> operands) {
  spirv.push_back((operands.size() + 1) << 16 | op);
  spirv.insert(spirv.end(), operands);
}

// Whether the instruction must come before the first decoration or type.
bool IsPreamble(spv::Op op) {
  switch (op) {
    case spv::OpCapability:
    case spv::OpExtension:
    case spv::OpExtInstImport:
    case spv::OpMemoryModel:
    case spv::OpEntryPoint:
    case spv::OpExecutionMode:
    case spv::OpString:
    case spv::OpSource:
    case spv::OpSourceContinued:
    case spv::OpSourceExtension:
    case spv::OpName:
    case spv::OpMemberName:
    case spv::OpModuleProcessed:
    case spv::OpNop: return true;
    default: return false;
  }
}

}  // namespace

bool IsSpirv(std::string_view bytes) {
  std::uint32_t word = 0;
  if (bytes.size() >= 4) std::memcpy(&word, bytes.data(), 4);
  return word == spv::MagicNumber;
}

Spirv SpirvOfBytes(std::string_view bytes) {
  return WordsOf({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

std::vector<Output> OutputsOf(const Spirv& spirv) { return Reflected(spirv, ReflectOutputs); }
Reads ReadsOf(const Spirv& spirv) { return Reflected(spirv, ReflectReads); }

Stage StageOf(const Spirv& spirv) {
  const std::size_t entry = Walk(spirv, [](spv::Op op) { return op != spv::OpEntryPoint; });
  return spirv.at(entry + 1) == spv::ExecutionModelFragment ? Stage::kPixel : Stage::kVertex;
}

std::string EntryPointOf(const Spirv& spirv) {
  const std::size_t entry = Walk(spirv, [](spv::Op op) { return op != spv::OpEntryPoint; });
  return reinterpret_cast<const char*>(&spirv.at(entry + 3));
}

Spirv WithPoints(Spirv spirv) {
  for (std::size_t at = kHeaderWords; at < spirv.size(); at += std::max(spirv[at] >> 16, 1u)) {
    const bool is_mode = (spirv[at] & 0xffff) == spv::OpExecutionMode;
    if (is_mode && (spirv[at + 2] == spv::ExecutionModeOutputLineStrip ||
                    spirv[at + 2] == spv::ExecutionModeOutputTriangleStrip))
      spirv[at + 2] = spv::ExecutionModeOutputPoints;
  }
  return spirv;
}

Spirv WithTransformFeedback(const Spirv& spirv, std::span<const Output> outputs,
                            std::span<const FeedbackSlot> places,
                            std::span<const std::uint32_t> strides) {
  Spirv decorations;
  std::set<std::uint32_t> blocks;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    const FeedbackSlot& place = places[i];
    if (output.member) {
      Append(decorations, spv::OpMemberDecorate,
             {output.type, *output.member, spv::DecorationOffset, place.offset});
      if (!blocks.insert(output.variable).second) continue;
    } else {
      Append(decorations, spv::OpDecorate, {output.variable, spv::DecorationOffset, place.offset});
    }
    Append(decorations, spv::OpDecorate, {output.variable, spv::DecorationXfbBuffer, place.buffer});
    Append(decorations, spv::OpDecorate,
           {output.variable, spv::DecorationXfbStride, strides[place.buffer]});
  }

  const std::size_t entry = Walk(spirv, [](spv::Op op) { return op != spv::OpEntryPoint; });
  const std::size_t modes = entry + (spirv.at(entry) >> 16);
  const std::size_t body = Walk(spirv, IsPreamble);
  Spirv result;
  const auto copy = [&](std::size_t from, std::size_t to) {
    for (const std::uint32_t word : std::span(spirv).subspan(from, to - from))
      result.push_back(word);
  };
  copy(0, kHeaderWords);
  Append(result, spv::OpCapability, {spv::CapabilityTransformFeedback});
  copy(kHeaderWords, modes);
  Append(result, spv::OpExecutionMode, {spirv[entry + 2], spv::ExecutionModeXfb});
  copy(modes, body);
  result.insert(result.end(), decorations.begin(), decorations.end());
  copy(body, spirv.size());
  return result;
}

}  // namespace clipc::draw::vulkan
