// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/effect_passes.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <ranges>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "compiler/compile/suggest.h"
#include "ir/profile.h"

namespace clipc {
namespace {

using ast::EffectShader;

// The shader variables of the effect, by name.
using Variables = std::unordered_map<std::string_view, const std::vector<EffectShader>*>;

// The profile that a shader is compiled for. fxc compiles ps_1_1 to ps_1_4 as ps_2_0 (X3539).
std::string ProfileFor(const EffectShader& shader) {
  const auto profile = ir::ParseProfile(shader.profile);
  const bool is_old = profile && profile->stage == Stage::kPixel && !profile->IsAtLeast(2, 0);
  return is_old ? "ps_2_0" : shader.profile;
}

// The name of the state that gives a pass its shader, by stage.
constexpr std::string_view kShaderStates[] = {"VertexShader",   "PixelShader", "ComputeShader",
                                              "GeometryShader", "HullShader",  "DomainShader"};
static_assert(std::size(kShaderStates) == kStageCount);
std::string_view StateOf(Stage stage) { return kShaderStates[static_cast<std::size_t>(stage)]; }

class ProgramFinder {
 public:
  ProgramFinder(const ast::File& file, const ast::Effect& effect, const CommandLine& command,
                Diagnostics& diagnostics)
      : effect_(effect), command_(command), diagnostics_(diagnostics) {
    for (const ast::DeclId decl : file.top_level) {
      if (const auto* function = std::get_if<ast::FunctionDecl>(&file.decls[decl].node))
        functions_.push_back(file.names[function->name]);
    }
    for (const ast::EffectParameter& parameter : effect.parameters) {
      if (!parameter.shaders.empty()) variables_.emplace(parameter.name, &parameter.shaders);
    }
    for (const ast::EffectConstant& constant : effect.constants)
      constants_.emplace(constant.name, constant.value);
    for (const ast::EffectTable& table : effect.tables) tables_.emplace(table.name, &table.values);
  }

  EffectPrograms Find() {
    for (std::size_t i = 0; i < effect_.techniques.size(); ++i) {
      const ast::EffectTechnique& technique = effect_.techniques[i];
      if (!command_.technique.empty() && technique.name != command_.technique) continue;
      for (const std::string& text : technique.not_read)
        diagnostics_.Report({}, diag::EffectNotRead, text, technique.name);
      for (std::size_t k = 0; k < technique.passes.size(); ++k) {
        if (command_.pass.empty() || technique.passes[k].name == command_.pass) AddPass(i, k);
      }
    }
    return std::move(found_);
  }

 private:
  void AddPass(std::size_t technique, std::size_t number) {
    const ast::EffectPass& pass = effect_.techniques[technique].passes[number];
    PassPrograms& added = found_.passes.emplace_back();
    added.technique = technique;
    added.pass = number;
    for (const std::string& text : pass.not_read)
      diagnostics_.Report(pass.span, diag::EffectNotRead, text, pass.name);
    const std::vector<StageShaders> drawing = {
        ShadersOf(added, pass, Stage::kVertex, pass.vertex),
        ShadersOf(added, pass, Stage::kHull, pass.hull),
        ShadersOf(added, pass, Stage::kDomain, pass.domain),
        ShadersOf(added, pass, Stage::kGeometry, pass.geometry),
        ShadersOf(added, pass, Stage::kPixel, pass.pixel)};
    const std::span<const StageShaders> between = std::span(drawing).subspan(1, 3);
    const bool has_between =
        std::ranges::any_of(between, [](const StageShaders& shaders) { return !shaders.IsNull(); });
    if (has_between && drawing[0].IsNull() && !added.is_left_out)
      LeaveOut(added, pass, StateOf(Stage::kVertex), "NULL");
    const std::vector<StageShaders> computing = {
        ShadersOf(added, pass, Stage::kCompute, pass.compute)};
    AddPrograms(added, drawing, Resolved(pass.geometry)->captures);  // its choice is the first
    AddPrograms(added, computing, {});
  }

  // The shader that a variable, or a number's element of an array, stands for.
  const EffectShader* Resolved(const EffectShader& shader) const {
    if (shader.kind != EffectShader::Kind::kVariable) return &shader;
    const auto variable = variables_.find(shader.variable);
    std::size_t number = 0;
    if (variable == variables_.end() || !IsNumber(IndexOf(shader).text, number)) return &shader;
    return number < variable->second->size() ? &(*variable->second)[number] : &shader;
  }

  // Whether ConstructGSWithSO is given the pass's own vertex or domain shader, whose results are
  // captured where there is no geometry shader.
  bool IsOfStageBefore(const ast::EffectPass& pass, const EffectShader& captured) const {
    const auto profile = ir::ParseProfile(captured.profile);
    if (captured.captures.empty() || !profile || !profile->stage) return false;
    const EffectShader* before =
        Resolved(*profile->stage == Stage::kDomain ? pass.domain : pass.vertex);
    return *profile->stage != Stage::kGeometry && before->function == captured.function &&
           before->call == captured.call;
  }

  // The shaders that a pass may use in a stage.
  struct StageShaders {
    const EffectShader* said;
    std::vector<std::optional<EffectStage>> shaders;  // none: NULL
    StageIndex index;

    bool IsNull() const {
      return std::ranges::none_of(shaders, [](const auto& shader) { return shader.has_value(); });
    }
  };

  // Adds the programs of a shader of each of those stages that have any.
  void AddPrograms(PassPrograms& added, std::vector<StageShaders> stages,
                   const std::vector<std::string>& captures) {
    const ast::EffectPass& pass = effect_.techniques[added.technique].passes[added.pass];
    std::erase_if(stages, [](const StageShaders& stage) { return stage.IsNull(); });
    if (added.is_left_out || stages.empty()) return;
    std::vector<StageIndex> indices;
    for (const StageShaders& stage : stages) {
      StageIndex& index = indices.emplace_back(stage.index);
      for (const auto& shader : stage.shaders) index.elements.push_back(shader.has_value());
    }
    const std::optional<ChosenPrograms> chosen = ChoosePrograms(indices, kMaxPermutations - count_);
    if (!chosen) return LeaveOut(added, pass, StateOf(FirstOf(stages.front())), "too many");
    if (const auto& outside = chosen->outside) {
      const EffectShader& said = *stages[outside->stage].said;
      diagnostics_.Report(said.span, diag::EffectIndexOutside, said.text, outside->text,
                          outside->value);
    }
    const std::size_t first = added.programs.size();
    for (const std::vector<std::size_t>& elements : chosen->programs) {
      EffectProgram& program = added.programs.emplace_back();
      for (std::size_t i = 0; i < stages.size(); ++i) {
        if (const auto& shader = stages[i].shaders[elements[i]]) program.shaders.push_back(*shader);
      }
      program.captures = captures;
      program.group = GroupOf(program, added.technique, added.pass);
    }
    count_ += std::max(chosen->choice.programs.size(), chosen->programs.size());
    if (chosen->choice.values.empty()) return;
    EffectChoice& choice = added.choices.emplace_back(chosen->choice);
    for (std::optional<std::size_t>& program : choice.programs) {
      if (program) *program += first;
    }
  }

  static Stage FirstOf(const StageShaders& stage) {
    return (*std::ranges::find_if(stage.shaders, [](const auto& one) { return one.has_value(); }))
        ->stage;
  }

  void LeaveOut(PassPrograms& added, const ast::EffectPass& pass, std::string_view stage,
                std::string_view text) {
    constexpr std::size_t kMost = 60;
    added.is_left_out = true;
    diagnostics_.Report(pass.span, diag::EffectPassLeftOut, pass.name, stage,
                        text.size() > kMost ? fmt::format("{}..", text.substr(0, kMost)) : text);
  }

  // Reports a shader that is of another stage, or of a function that the effect does not have.
  bool IsFor(Stage stage, const EffectShader& shader) {
    const auto profile = ir::ParseProfile(shader.profile);
    if (!profile) {
      const std::vector<std::string> known = ir::ProfilesOf(stage);
      diagnostics_.Report(
          shader.span, diag::UnknownProfile, shader.profile,
          Suggest(shader.profile, std::vector<std::string_view>(known.begin(), known.end())));
      return false;
    }
    if (profile->stage && *profile->stage != stage) {
      diagnostics_.Report(shader.span, diag::EffectShaderStage, shader.profile,
                          InfoOf(*profile->stage).name, StateOf(stage), InfoOf(stage).prefix);
      return false;
    }
    // A name with `::` is looked up where the function is compiled.
    const bool is_plain = shader.function.find(':') == std::string::npos;
    if (!is_plain || std::ranges::find(functions_, shader.function) != functions_.end())
      return true;
    diagnostics_.Report(shader.span, diag::EntryNotFound, shader.function,
                        Suggest(shader.function, functions_));
    return false;
  }

  // The shaders that the pass may use in a stage; leaves the pass out if one of them is not to be
  // compiled.
  StageShaders ShadersOf(PassPrograms& added, const ast::EffectPass& pass, Stage stage,
                         const EffectShader& shader) {
    StageShaders found{&shader, {}, {}};
    const auto add = [&](const EffectShader& one, std::optional<std::size_t> element) {
      std::optional<EffectStage>& added_shader = found.shaders.emplace_back();
      if (one.kind == EffectShader::Kind::kNone) return;
      if (stage == Stage::kGeometry && IsOfStageBefore(pass, one)) return;
      if (one.kind == EffectShader::Kind::kCompiled && !IsFor(stage, one)) {
        added.is_left_out = true;
      } else if (one.kind == EffectShader::Kind::kCompiled) {
        added_shader = {stage, &one, element, ProfileFor(one)};
      } else if (!added.is_left_out) {
        LeaveOut(added, pass, StateOf(stage), one.text);
      }
    };
    const auto variable = shader.kind == EffectShader::Kind::kVariable
                              ? variables_.find(shader.variable)
                              : variables_.end();
    if (variable == variables_.end()) {
      add(shader, std::nullopt);
      return found;
    }
    const std::vector<EffectShader>& elements = *variable->second;
    found.index = IndexOf(shader);
    std::size_t value = 0;
    if (IsNumber(found.index.text, value)) {
      found.index.elements.assign(elements.size(), true);
      const std::optional<std::size_t> element = ElementOf(found.index, value);
      found.index = {};
      add(element ? elements[*element] : shader, std::nullopt);
      return found;
    }
    for (std::size_t i = 0; i < elements.size() && i < kMaxPermutations; ++i) add(elements[i], i);
    return found;
  }

  // Whether the index is a number, or none, which is the first element. A negative one is that of
  // no element.
  static bool IsNumber(std::string_view text, std::size_t& number) {
    const char* const end = text.data() + text.size();
    std::int64_t value = 0;
    const bool is_number = text.empty() || std::from_chars(text.data(), end, value).ptr == end;
    if (is_number)
      number = value < 0 ? std::numeric_limits<std::size_t>::max() : static_cast<size_t>(value);
    return is_number;
  }

  // The index of A[T[i]]: `i`, looked up in T. A table without known values is a part of its text.
  StageIndex IndexOf(const EffectShader& shader) const {
    StageIndex index;
    const auto constant = constants_.find(shader.index);
    index.text = constant == constants_.end() ? shader.index : std::to_string(constant->second);
    std::string text = index.text;
    for (const std::string& name : shader.tables | std::views::reverse) {
      text = fmt::format("{}[{}]", name, text);
      if (const auto table = tables_.find(name); table != tables_.end()) {
        index.tables.insert(index.tables.begin(), table->second);
      } else {
        index.text = text;
        index.tables.clear();
      }
    }
    return index;
  }

  std::size_t GroupOf(const EffectProgram& program, std::size_t technique, std::size_t number) {
    const ast::EffectPass& pass = effect_.techniques[technique].passes[number];
    std::string key;
    std::string element;
    for (const EffectStage& stage : program.shaders) {
      const EffectShader& shader = *stage.shader;
      key += fmt::format("{}\n{}\n{}\n", stage.profile, shader.function, shader.call);
      if (stage.element) element += fmt::format(".{}", *stage.element);
    }
    for (const std::string& capture : program.captures) key += fmt::format("capture {}\n", capture);
    const auto [known, is_new] = by_key_.try_emplace(std::move(key), found_.groups.size());
    if (!is_new) return known->second;
    ShaderGroup& group = found_.groups.emplace_back();
    group.command = command_;
    group.command.header.clear();  // that is of all passes together
    group.command.variable.clear();
    group.source = command_.inputs[0];
    const auto name_of = [](const std::string& name, const char* kind, std::size_t at) {
      return name.empty() ? fmt::format("{}{}", kind, at) : name;
    };
    const std::string words[] = {
        name_of(effect_.techniques[technique].name, "technique", technique),
        name_of(pass.name, "pass", number)};
    group.label = fmt::format("{}.{}{}", words[0], words[1], element);
    group.name = fmt::format("{}.{}{}", AsFileName(words[0]), AsFileName(words[1]), element);
    ProgramRequest& request = group.command.request;
    const std::optional<std::string> text = request.first().text;
    request.shaders.clear();
    for (const EffectStage& stage : program.shaders) {
      request.shaders.push_back({.entry = stage.shader->function,
                                 .entry_call = stage.shader->call,
                                 .profile = stage.profile});
    }
    request.first().text = text;
    request.language.effect = number_;
    request.outputs.facts = true;
    // What is captured stays, though the next stage may not read it.
    request.link.keep_outputs |=
        !program.captures.empty() && program.shaders.back().stage == Stage::kPixel;
    for (const EffectStage& stage : program.shaders) {
      const auto at = std::ranges::find(kMiddleStages, stage.stage) - std::begin(kMiddleStages);
      if (at == std::ssize(kMiddleStages) || request.shaders.size() == 1) continue;
      group.command.middle[at] = {
          stage.shader->function,
          fmt::format("{}{}", InfoOf(stage.stage).extension, request.outputs.spirv ? ".spv" : "")};
    }
    if (request.shaders.size() > 1 && program.shaders.back().stage == Stage::kPixel)
      group.command.pixel_output = request.outputs.spirv ? ".frag.spv" : ".frag";
    return found_.groups.size() - 1;
  }

  static std::uint64_t NextNumber() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
  }

  const std::uint64_t number_ = NextNumber();  // LanguageOptions::effect
  const ast::Effect& effect_;
  const CommandLine& command_;
  Diagnostics& diagnostics_;
  Variables variables_;
  std::unordered_map<std::string_view, const std::vector<std::int64_t>*> tables_;
  std::unordered_map<std::string_view, std::int64_t> constants_;
  std::vector<std::string_view> functions_;
  std::map<std::string, std::size_t> by_key_;
  std::size_t count_ = 0;  // of programs
  EffectPrograms found_;
};

}  // namespace

EffectPrograms FindPrograms(const ast::File& file, const ast::Effect& effect,
                            const CommandLine& command, Diagnostics& diagnostics) {
  return ProgramFinder(file, effect, command, diagnostics).Find();
}

}  // namespace clipc
