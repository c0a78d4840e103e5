// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/spirv.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <map>
#include <set>

#include "tools/draw/pass_patch.h"
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

std::size_t EntryPointAt(const Spirv& spirv) {
  return Walk(spirv, [](spv::Op op) { return op != spv::OpEntryPoint; });
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
  const std::size_t entry = EntryPointAt(spirv);
  constexpr Stage kStagesByModel[] = {Stage::kVertex,   Stage::kHull,  Stage::kDomain,
                                      Stage::kGeometry, Stage::kPixel, Stage::kCompute};
  static_assert(std::size(kStagesByModel) == kStageCount);
  return kStagesByModel[std::min<std::size_t>(spirv.at(entry + 1), kStageCount - 1)];
}

std::string EntryPointOf(const Spirv& spirv) {
  const std::size_t entry = EntryPointAt(spirv);
  return reinterpret_cast<const char*>(&spirv.at(entry + 3));
}

Spirv WithPoints(Spirv spirv) {
  if (StageOf(spirv) == Stage::kDomain) {
    const std::size_t entry = EntryPointAt(spirv);
    Spirv mode;
    Append(mode, spv::OpExecutionMode, {spirv[entry + 2], spv::ExecutionModePointMode});
    const auto after = static_cast<std::ptrdiff_t>(entry + (spirv[entry] >> 16));
    spirv.insert(spirv.begin() + after, mode.begin(), mode.end());
    return spirv;
  }
  for (std::size_t at = kHeaderWords; at < spirv.size(); at += std::max(spirv[at] >> 16, 1u)) {
    const bool is_mode = (spirv[at] & 0xffff) == spv::OpExecutionMode;
    if (is_mode && (spirv[at + 2] == spv::ExecutionModeOutputLineStrip ||
                    spirv[at + 2] == spv::ExecutionModeOutputTriangleStrip))
      spirv[at + 2] = spv::ExecutionModeOutputPoints;
  }
  return spirv;
}

namespace {

// Copies a hull shader, with changes. Its outputs of factors get locations; another one, which no
// statement of the shader names, gets the factors that the tessellator sees.
class FactorChanger {
 public:
  FactorChanger(const Spirv& spirv, std::uint32_t segments)
      : spirv_(spirv), segments_(static_cast<float>(segments)), next_(spirv.at(kBoundAt)) {}

  Spirv Change() && {
    Learn();
    made_.assign(spirv_.begin(), spirv_.begin() + kHeaderWords);
    for (std::size_t at = kHeaderWords; at < spirv_.size(); at += SizeAt(at)) Copy(at);
    made_[kBoundAt] = next_;
    return std::move(made_);
  }

 private:
  static constexpr std::size_t kBoundAt = 3;

  spv::Op OpAt(std::size_t at) const { return static_cast<spv::Op>(spirv_[at] & 0xffff); }
  std::size_t SizeAt(std::size_t at) const { return std::max(spirv_[at] >> 16, 1u); }

  // The factors that an instruction decorates; none for others.
  const FactorsAsData* DecoratedAt(std::size_t at) const {
    if (OpAt(at) != spv::OpDecorate || spirv_[at + 2] != spv::DecorationBuiltIn) return nullptr;
    if (spirv_[at + 3] == spv::BuiltInTessLevelOuter) return &kFactors[0];
    return spirv_[at + 3] == spv::BuiltInTessLevelInner ? &kFactors[1] : nullptr;
  }

  // Finds the output of the outer factors and its types.
  void Learn() {
    std::map<std::uint32_t, std::uint32_t> inner;  // by the id of a pointer or of an array
    for (std::size_t at = kHeaderWords; at < spirv_.size(); at += SizeAt(at)) {
      const spv::Op op = OpAt(at);
      if (DecoratedAt(at) == &kFactors[0]) outer_ = spirv_[at + 1];
      if (op == spv::OpTypePointer) inner[spirv_[at + 1]] = spirv_[at + 3];
      if (op == spv::OpTypeArray) inner[spirv_[at + 1]] = spirv_[at + 2];
      if (op == spv::OpVariable && spirv_[at + 2] == outer_) pointer_ = spirv_[at + 1];
      if (op == spv::OpEntryPoint) entry_ = spirv_[at + 2];
    }
    if (pointer_ == 0) throw DrawError("a hull shader without factors");
    array_ = inner[pointer_];
    float_ = inner[array_];
    constant_ = next_;
    new_ = constant_ + 3;
    next_ = new_ + 1;
  }

  void Copy(std::size_t at) {
    const spv::Op op = OpAt(at);
    const auto begin = spirv_.begin() + static_cast<std::ptrdiff_t>(at);
    if (const FactorsAsData* data = DecoratedAt(at)) {
      Append(made_, spv::OpDecorate, {spirv_[at + 1], spv::DecorationLocation, data->location});
      if (data != kFactors) return;
      Append(made_, spv::OpDecorate, {new_, spv::DecorationBuiltIn, spv::BuiltInTessLevelOuter});
      Append(made_, spv::OpDecorate, {new_, spv::DecorationPatch});
      return;
    }
    // The domain shader says how the tessellator works.
    if (op == spv::OpExecutionMode && spirv_[at + 2] != spv::ExecutionModeOutputVertices) return;
    if (op == spv::OpFunction && !std::exchange(has_function_, true)) Declare();
    if (op == spv::OpFunction) is_in_entry_ = spirv_[at + 2] == entry_;
    const bool begins = op == spv::OpLabel || op == spv::OpVariable || op == spv::OpFunction;
    if (is_in_entry_ && !begins) {
      Append(made_, spv::OpStore, {new_, constant_ + 2});
      is_in_entry_ = false;
    }
    made_.insert(made_.end(), begin, begin + static_cast<std::ptrdiff_t>(SizeAt(at)));
    if (op != spv::OpEntryPoint) return;
    made_.push_back(new_);
    made_[made_.size() - SizeAt(at) - 1] += 1 << 16;
  }

  // The factors of a line: one line, and its segments.
  void Declare() {
    Append(made_, spv::OpConstant, {float_, constant_, std::bit_cast<std::uint32_t>(1.0f)});
    Append(made_, spv::OpConstant,
           {float_, constant_ + 1, std::bit_cast<std::uint32_t>(segments_)});
    Append(made_, spv::OpConstantComposite,
           {array_, constant_ + 2, constant_, constant_ + 1, constant_, constant_});
    Append(made_, spv::OpVariable, {pointer_, new_, spv::StorageClassOutput});
  }

  const Spirv& spirv_;
  const float segments_;
  std::uint32_t next_;
  std::uint32_t outer_ = 0, pointer_ = 0, array_ = 0, float_ = 0, entry_ = 0;
  std::uint32_t constant_ = 0, new_ = 0;  // the first of three constants, and the variable
  bool has_function_ = false, is_in_entry_ = false;
  Spirv made_;
};

}  // namespace

Spirv WithFactorsAsData(const Spirv& spirv, std::uint32_t segments) {
  return FactorChanger(spirv, segments).Change();
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

  const std::size_t entry = EntryPointAt(spirv);
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
