// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/make_effect_facts.h"

#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "compiler/effect/captures.h"

namespace clipc {
namespace {

using Code = std::vector<std::shared_ptr<const EffectCode>>;

EffectShaderFact FactOf(const EffectStage& stage) {
  const ast::EffectShader& shader = *stage.shader;
  return {stage.stage, shader.function, shader.profile, shader.call, stage.element};
}

// What the effect's JSON calls the file of a stage.
constexpr std::string_view kFileKinds[] = {"vertex",   "fragment", "compute",
                                           "geometry", "hull",     "domain"};
static_assert(std::size(kFileKinds) == kStageCount);

// What the effect's JSON calls a file of a batch: the stage, whether it is GLSL or SPIR-V, and the
// number of a variant. `first_stage` is the first stage of the program.
std::string FileKind(std::string_view kind, Stage first_stage) {
  if (kind.ends_with(".spirv")) return std::string(kind.substr(0, kind.find('.')));
  for (const std::string_view first : {"glsl", "spirv"}) {
    if (kind == first || (kind.starts_with(first) && kind[first.size()] == '.'))
      return std::string(kFileKinds[static_cast<std::size_t>(first_stage)]) +
             std::string(kind.substr(first.size()));
  }
  return std::string(kind);
}

EffectProgramFact FactOf(const EffectProgram& program, const BatchEntry& entry, const Code& code) {
  EffectProgramFact fact;
  for (const EffectStage& stage : program.shaders) fact.shaders.push_back(FactOf(stage));
  fact.is_compiled = entry.status == BatchStatus::kCompiled;
  for (const auto& [kind, file] : entry.files)
    fact.files.emplace_back(FileKind(kind, fact.shaders.front().stage), file);
  fact.number = program.group;
  fact.code = code[program.group];
  fact.captures = ReadCaptures(program.captures, fact.code ? &fact.code->facts : nullptr);
  return fact;
}

// The bytes of the constants that have a value, by name.
std::map<std::string_view, const std::vector<std::uint8_t>*> InitialValues(const Code& code) {
  std::map<std::string_view, const std::vector<std::uint8_t>*> values;
  for (const auto& program : code) {
    if (!program) continue;
    for (const StageFacts& stage : program->facts.stages) {
      for (const BufferFact& buffer : stage.buffers) {
        for (const MemberFact& member : buffer.members) {
          if (!member.initial.empty()) values.emplace(member.name, &member.initial);
        }
      }
    }
  }
  return values;
}

}  // namespace

EffectFacts MakeEffectFacts(const ast::Effect& effect, const EffectPrograms& programs,
                            const CommandLine& command, const std::vector<BatchEntry>& entries,
                            const Code& code) {
  EffectFacts facts{.effect = command.inputs[0],
                    .target = std::string(command.request.target.name()),
                    .is_for_vulkan = command.request.target.IsVulkan()};
  std::size_t last = effect.techniques.size();
  for (const PassPrograms& pass : programs.passes) {
    const ast::EffectTechnique& technique = effect.techniques[pass.technique];
    if (pass.technique != last) {
      facts.techniques.push_back({technique.kind, technique.group, technique.name,
                                  technique.annotations, technique.not_read});
    }
    last = pass.technique;
    EffectPassFact& fact = facts.techniques.back().passes.emplace_back();
    fact.text = technique.passes[pass.pass];
    fact.is_left_out = pass.is_left_out;
    fact.choices = pass.choices;
    for (const EffectProgram& program : pass.programs)
      fact.programs.push_back(FactOf(program, entries[program.group], code));
  }
  const auto values = InitialValues(code);
  for (const ast::EffectParameter& parameter : effect.parameters) {
    EffectParameterFact& fact = facts.parameters.emplace_back();
    fact.text = parameter;
    if (const auto found = values.find(parameter.name); found != values.end())
      fact.initial = *found->second;
  }
  return facts;
}

}  // namespace clipc
