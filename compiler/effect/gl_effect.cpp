// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/gl_effect.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/spelling.h"
#include "compiler/command/command_line.h"

namespace clipc {
namespace {

// Returns the number of the item in the list, to which it is added if it is new.
template <typename Item>
std::size_t NumberOf(const Item& item, std::vector<Item>& list) {
  const auto found = std::ranges::find(list, item);
  const auto number = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(item);
  return number;
}

// GL_TEXTURE_2D and the like; none for what is not a texture with a sampler.
std::optional<std::uint32_t> TargetOf(ir::ObjectKind kind) {
  const ir::ObjectInfo& info = ir::InfoOf(kind);
  if (!ir::IsTexture(kind) && !ir::IsSampler(kind)) return std::nullopt;
  if (info.is_cube) return info.is_array ? 0x9009 : 0x8513;
  if (info.is_multisampled) return info.is_array ? 0x9102 : 0x9100;
  if (info.axes == 1) return info.is_array ? 0x8C18 : 0x0DE0;
  if (info.axes == 3) return 0x806F;
  return info.is_array ? 0x8C1A : 0x0DE1;  // `sampler` of Direct3D 9 is one of 2D textures
}

std::vector<std::uint32_t> WordsOf(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint32_t> words((bytes.size() + 3) / 4);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    words[i / 4] |= std::uint32_t{bytes[i]} << 8 * (i % 4);
  return words;
}

class GlEffectMaker {
 public:
  GlEffectMaker(const EffectFacts& effect, bool flips, Diagnostics& diagnostics)
      : effect_(effect), flips_(flips), diagnostics_(diagnostics), states_({}, diagnostics) {}

  GlEffect Make() && {
    for (const EffectTechniqueFact& technique : effect_.techniques) {
      const std::size_t first = made_.passes.size();
      is_of_direct3d_9_ = technique.kind == "technique";
      for (const EffectPassFact& pass : technique.passes) AddPass(pass);
      made_.techniques.push_back({NameOf(technique),
                                  {first, made_.passes.size() - first},
                                  AddAnnotations(technique.annotations)});
    }
    for (GlEffect::Parameter& parameter : made_.parameters)
      parameter.annotations = AnnotationsOf(parameter.name);
    for (GlEffect::Texture& texture : made_.textures)
      texture.annotations = AnnotationsOf(texture.name.substr(0, texture.name.find('[')));
    return std::move(made_);
  }

 private:
  // The name of a technique, after that of its group where another one has it too: "G2|T", as
  // ID3DX11Effect::GetTechniqueByName has it.
  std::string NameOf(const EffectTechniqueFact& technique) const {
    const auto same =
        std::ranges::count(effect_.techniques, technique.name, &EffectTechniqueFact::name);
    return same > 1 && !technique.group.empty() ? technique.group + "|" + technique.name
                                                : technique.name;
  }

  GlRange AddAnnotations(const std::vector<ast::Annotation>& annotations) {
    const std::size_t first = made_.annotations.size();
    made_.annotations.insert(made_.annotations.end(), annotations.begin(), annotations.end());
    return {first, annotations.size()};
  }
  GlRange AnnotationsOf(std::string_view variable) {
    const EffectParameterFact* const fact = effect_.FindParameter(variable);
    return fact ? AddAnnotations(fact->text.annotations) : GlRange();
  }

  // A constant buffer; programs that have equal ones share it.
  struct Block {
    const BufferFact* buffer;
    friend bool operator==(const Block& a, const Block& b) {
      const auto is_same = [](const MemberFact& x, const MemberFact& y) {
        return x.name == y.name && x.type == y.type && x.offset == y.offset && x.size == y.size &&
               x.IsRowMajor() == y.IsRowMajor();
      };
      return a.buffer->name == b.buffer->name && a.buffer->size == b.buffer->size &&
             std::ranges::equal(a.buffer->members, b.buffer->members, is_same);
    }
  };

  void AddPass(const EffectPassFact& fact) {
    const ast::EffectPass& pass = fact.text;
    const auto leave_out = [&](std::string_view lacks) {
      diagnostics_.Report(pass.span, diag::EffectPassNotInHeader, pass.name, lacks);
    };
    if (fact.programs.empty() && !fact.is_left_out) leave_out("shader");
    const std::vector<const EffectProgramFact*> programs = ProgramsOf(fact);
    const auto has = [](const EffectProgramFact& program, Stage stage) {
      const auto& shaders = program.shaders;
      return std::ranges::find(shaders, stage, &EffectShaderFact::stage) != shaders.end();
    };
    const auto draws = [&](const EffectProgramFact& program) {
      return has(program, Stage::kVertex) &&
             std::ranges::none_of(kMiddleStages, [&](Stage stage) { return has(program, stage); });
    };
    for (const EffectProgramFact& program : fact.programs) {
      if (!program.is_compiled || draws(program)) continue;
      leave_out(has(program, Stage::kVertex) ? "program of a vertex and a pixel shader alone"
                                             : "vertex shader");
    }
    std::optional<GlRange> states, annotations, vulkan;  // the same for all programs
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const EffectProgramFact* const program = programs[i];
      if (!program || !program->is_compiled || !program->code || !draws(*program)) continue;
      const std::size_t made = ProgramOf(program->code, pass);
      if (!states) {
        states = AddStates(pass);
        annotations = AddAnnotations(pass.annotations);
        vulkan = AddVulkanStates(pass);
      }
      const std::string suffix = programs.size() == 1 ? "" : fmt::format(".{}", i);
      made_.passes.push_back({pass.name + suffix, made, *states, *annotations, *vulkan});
    }
  }

  // The programs of a pass by the value that chooses them; null for a value without a program.
  // Without a value, those that are compiled.
  static std::vector<const EffectProgramFact*> ProgramsOf(const EffectPassFact& fact) {
    std::vector<const EffectProgramFact*> programs;
    if (!fact.choices.empty()) {
      for (const std::optional<std::size_t>& program : fact.choices.front().programs)
        programs.push_back(program ? &fact.programs[*program] : nullptr);
      return programs;
    }
    for (const EffectProgramFact& program : fact.programs) {
      if (program.is_compiled) programs.push_back(&program);
    }
    return programs;
  }

  GlRange AddStates(const ast::EffectPass& pass) {
    std::vector<GlState> states = ReadGlStates(effect_, pass, flips_, states_);
    // In Direct3D 10 the format of the render target says alone whether colors are converted.
    constexpr GlState kByFormat = {GlStateKind::kSrgbWrite, 1};
    if (!is_of_direct3d_9_) {
      const auto place = std::ranges::lower_bound(states, kByFormat.kind, {}, &GlState::kind);
      if (place == states.end() || place->kind != kByFormat.kind) states.insert(place, kByFormat);
    }
    const std::size_t first = made_.states.size();
    made_.states.insert(made_.states.end(), states.begin(), states.end());
    return {first, states.size()};
  }

  GlRange AddVulkanStates(const ast::EffectPass& pass) {
    const std::vector<VulkanState> states = ReadVulkanStates(effect_, pass);
    const std::size_t first = made_.vulkan_states.size();
    made_.vulkan_states.insert(made_.vulkan_states.end(), states.begin(), states.end());
    return {first, states.size()};
  }

  // What a pass of Direct3D 9 gives to the pixel shader's sampler of a register.
  struct PassStage {
    std::string sampler = {}, texture = {};
    friend bool operator==(const PassStage&, const PassStage&) = default;
  };
  using PassStages = std::vector<PassStage>;  // by the number of the register

  // The program's number. Passes whose shaders become the same share one, unless
  // they give it other samplers.
  std::size_t ProgramOf(const std::shared_ptr<const EffectCode>& code,
                        const ast::EffectPass& pass) {
    const PassStages stages = StagesOf(pass, *code);
    for (std::size_t i = 0; i < made_.programs.size(); ++i) {
      const auto& known = made_.programs[i].code;
      if (stages_[i] == stages && (known == code || *known == *code)) return i;
    }
    GlEffect::Program program;
    program.code = code;
    program.uses.first = made_.uses.size();
    program.samplers.first = made_.samplers.size();
    program.planes.first = made_.planes.size();
    for (const StageFacts& stage : code->facts.stages) {
      for (const BufferFact& buffer : stage.buffers) AddBlock(buffer, program.uses, pass);
      for (const ResourceFact& resource : stage.resources)
        AddSampler(resource, stage.stage == "pixel" ? stages : PassStages(), program.samplers,
                   pass);
    }
    if (code->facts.planes) {
      for (const clip_table::Plane& plane : code->facts.planes->planes)
        made_.planes.push_back({plane.index, plane.text});
    }
    program.uses.count = made_.uses.size() - program.uses.first;
    program.samplers.count = made_.samplers.size() - program.samplers.first;
    program.planes.count = made_.planes.size() - program.planes.first;
    made_.programs.push_back(std::move(program));
    stages_.push_back(stages);
    return made_.programs.size() - 1;
  }

  void AddBlock(const BufferFact& buffer, const GlRange& uses, const ast::EffectPass& pass) {
    if (!buffer.block || buffer.size == 0) return;
    if (buffer.block->layout != "std140" || buffer.count != 1) {
      diagnostics_.Report(pass.span, diag::EffectBufferNotInHeader, buffer.name);
      return;
    }
    const std::size_t number = NumberOf(Block{&buffer}, blocks_);
    if (number == made_.block_sizes.size()) {
      made_.block_sizes.push_back(buffer.size);
      for (const MemberFact& member : buffer.members)
        ParameterOf(member).places.push_back({number, member.offset, member.IsRowMajor()});
    }
    // Both shaders may have the block.
    const auto first = made_.uses.begin() + static_cast<std::ptrdiff_t>(uses.first);
    const auto known = std::find_if(first, made_.uses.end(), [&](const GlEffect::Use& use) {
      return use.name == buffer.block->name;
    });
    if (known == made_.uses.end()) {
      made_.uses.push_back({buffer.block->name, number});
    } else {
      known->block = number;
    }
  }

  GlEffect::Parameter& ParameterOf(const MemberFact& member) {
    const auto known = std::ranges::find(made_.parameters, member.name, &GlEffect::Parameter::name);
    if (known != made_.parameters.end()) return *known;
    GlEffect::Parameter& parameter = made_.parameters.emplace_back();
    parameter.name = member.name;
    SetShape(member, parameter);
    if (const EffectParameterFact* fact = effect_.FindParameter(member.name)) {
      parameter.semantic = fact->text.semantic;
      parameter.value = WordsOf(fact->initial);
    }
    return parameter;
  }

  static void SetShape(const MemberFact& member, GlEffect::Parameter& parameter) {
    const ShapeFact& shape = member.shape;
    const bool is_plain =
        (shape.kind == ir::TypeKind::kScalar || shape.kind == ir::TypeKind::kVector ||
         shape.kind == ir::TypeKind::kMatrix) &&
        !ir::IsWide(shape.scalar);
    parameter.columns = is_plain ? shape.columns : member.size;
    if (!is_plain) return;
    parameter.rows = shape.rows;
    parameter.elements = shape.dimensions.empty() ? 0 : 1;
    for (const ShapeFact::Dimension& dimension : shape.dimensions)
      parameter.elements *= dimension.count;
    // A column of a float1x4 is a vector of one component, as an element of a float[4] is.
    if (shape.kind == ir::TypeKind::kMatrix && shape.rows == 1 && !member.IsRowMajor()) {
      parameter.elements = std::max(1U, parameter.elements) * shape.columns;
      parameter.columns = 1;
    }
  }

  // Sampler[0] = <S>; Texture[1] = (T); of those that the pixel shader has and that say something
  // else than the sampler itself.
  PassStages StagesOf(const ast::EffectPass& pass, const EffectCode& code) {
    PassStages stages;
    for (const ast::EffectState& state : pass.states) {
      const bool is_sampler = EqualIgnoringCase(state.word, "Sampler");
      if (!state.has_index || state.is_wrong) continue;
      if (!is_sampler && !EqualIgnoringCase(state.word, "Texture")) continue;
      const std::optional<std::string> own = OwnName(code, state.index, is_sampler);
      const std::string name = NameIn(state);
      if (own && name.empty()) states_.NotConstant(state);
      if (!own || *own == name) continue;
      if (stages.size() <= state.index) stages.resize(state.index + 1);
      PassStage& stage = stages[state.index];
      (is_sampler ? stage.sampler : stage.texture) = name;
    }
    return stages;
  }

  // The name of the pixel shader's sampler of a register, or of that one's texture; none for a
  // register without a sampler.
  std::optional<std::string> OwnName(const EffectCode& code, std::uint32_t number,
                                     bool of_sampler) const {
    for (const StageFacts& stage : code.facts.stages) {
      for (const ResourceFact& resource : stage.resources) {
        const auto& part = resource.texture;
        if (stage.stage != "pixel" || !ir::IsSampler(resource.kind) || !part || !part->reg)
          continue;
        const std::uint32_t element = number - part->reg->number;
        if (element >= CountOf(*part)) continue;
        if (of_sampler) return part->dimensions.empty() ? part->name : "";
        const ast::EffectParameter said = Said(part->name);
        return TextureOf(element < said.elements.size() ? said.elements[element] : said.states);
      }
    }
    return std::nullopt;
  }

  void AddSampler(const ResourceFact& resource, const PassStages& stages, const GlRange& samplers,
                  const ast::EffectPass& pass) {
    const auto& [glsl, kind, set, binding, texture, sampler, access] = resource;
    if (!texture) return;
    const auto first = made_.samplers.begin() + static_cast<std::ptrdiff_t>(samplers.first);
    if (std::any_of(first, made_.samplers.end(), [&](const GlEffect::Sampler& it) {
          return it.name.substr(0, it.name.find('[')) == resource.glsl;
        }))
      return;
    const std::optional<std::uint32_t> target = TargetOf(kind);
    if (!target) {
      diagnostics_.Report(pass.span, diag::EffectTextureNotInHeader, texture->name, texture->type);
      return;
    }
    const bool is_old = ir::IsSampler(kind);  // of Direct3D 9, which has its texture
    const ResourceFact::Part& stated = is_old || !sampler ? *texture : *sampler;
    const ast::EffectParameter said =
        Said(stated.element_of.empty() ? stated.name : stated.element_of);
    for (std::uint32_t i = 0; i < CountOf(*texture); ++i) {
      const std::string element = texture->dimensions.empty() ? "" : fmt::format("[{}]", i);
      const std::uint32_t block = stated.element_of.empty() ? i : stated.element;
      std::vector<ast::EffectState> states =
          block < said.elements.size() ? said.elements[block] : said.states;
      std::string named = texture->name + element;
      if (is_old) {
        const std::size_t index = texture->reg ? texture->reg->number + i : stages.size();
        const PassStage by_pass = index < stages.size() ? stages[index] : PassStage();
        if (!by_pass.sampler.empty()) states = StatesOf(by_pass.sampler);
        const std::string own = by_pass.texture.empty() ? TextureOf(states) : by_pass.texture;
        if (!own.empty()) named = own;
      }
      GlSampling read = ReadGlSampling(states, is_old, states_);
      if (!FiltersTexels(resource)) read.min_filter = read.mag_filter = kGlNearest;
      const std::size_t sampling = NumberOf(read, made_.samplings);
      const std::size_t number = NumberOf(GlEffect::Texture{named, *target}, made_.textures);
      made_.samplers.push_back({glsl + IndicesOf(i, texture->dimensions), number, sampling});
    }
  }

  // Whether the texture is read through a sampler that filters. OpenGL reads black where a sampler
  // object asks for more of a texture than it has: for levels, or to filter integers ("Texture
  // Completeness" of its specification).
  static bool FiltersTexels(const ResourceFact& resource) {
    const std::string& type = resource.texture->type;  // Texture2D<uint4>
    const std::string_view texel = std::string_view(type).substr(type.find('<') + 1);
    constexpr const char* kIntegers[] = {"int", "uint", "min16int", "min16uint", "min12int"};
    const bool is_integer =
        std::ranges::any_of(kIntegers, [&](const char* word) { return texel.starts_with(word); });
    return !is_integer && (resource.sampler || ir::IsSampler(resource.kind));
  }

  // The number of objects of an array, in all dimensions; 1 of another one.
  static std::uint32_t CountOf(const ResourceFact::Part& part) {
    std::uint32_t count = 1;
    for (const std::uint32_t size : part.dimensions) count *= size;
    return count;
  }
  // "[1][0]": the indices of an element that is counted through all dimensions.
  static std::string IndicesOf(std::uint32_t element, std::span<const std::uint32_t> dimensions) {
    std::string indices;
    for (std::size_t i = dimensions.size(); i-- > 0; element /= dimensions[i])
      indices.insert(0, fmt::format("[{}]", element % dimensions[i]));
    return indices;
  }

  // The states of a sampler, or of an element of an array of samplers: S[1][0].
  std::vector<ast::EffectState> StatesOf(const std::string& name) const {
    const ast::EffectParameter said = Said(name.substr(0, name.find('[')));
    const std::vector<std::uint32_t> indices = NumbersIn(name), sizes = NumbersIn(said.type);
    std::size_t element = indices.empty() ? said.elements.size() : 0;
    for (std::size_t i = 0; i < indices.size(); ++i)
      element = element * (i < sizes.size() ? sizes[i] : 0) + indices[i];
    return element < said.elements.size() ? said.elements[element] : said.states;
  }
  // The numbers in the square brackets of a text.
  static std::vector<std::uint32_t> NumbersIn(std::string_view text) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t at = 0; (at = text.find('[', at)) != text.npos; ++at) {
      std::uint32_t& number = numbers.emplace_back();
      std::from_chars(text.data() + at + 1, text.data() + text.size(), number);
    }
    return numbers;
  }

  ast::EffectParameter Said(std::string_view name) const {
    const EffectParameterFact* const fact = effect_.FindParameter(name);
    return fact ? fact->text : ast::EffectParameter();
  }

  const EffectFacts& effect_;
  const bool flips_;
  bool is_of_direct3d_9_ = false;  // the technique whose passes are added
  Diagnostics& diagnostics_;
  StateReport states_;
  GlEffect made_;
  std::vector<Block> blocks_;       // beside block_sizes
  std::vector<PassStages> stages_;  // beside programs
};

}  // namespace

GlEffect MakeGlEffect(const EffectFacts& effect, bool flips, Diagnostics& diagnostics) {
  return GlEffectMaker(effect, flips, diagnostics).Make();
}

}  // namespace clipc
