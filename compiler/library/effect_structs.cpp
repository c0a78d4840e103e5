// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/library/effect_structs.h"

#include <string_view>
#include <utility>

namespace clipc {

EffectStructs::EffectStructs(const EffectFacts& facts, std::vector<const clipc_result*> programs)
    : programs_(std::move(programs)) {
  List(facts.techniques, effect_.techniques, effect_.technique_count);
  List(facts.parameters, effect_.parameters, effect_.parameter_count);
}

template <class Facts, class Struct>
void EffectStructs::List(const Facts& facts, const Struct* const*& first, std::size_t& count) {
  auto structs = std::make_shared<std::vector<Struct>>();
  auto list = std::make_shared<std::vector<const Struct*>>();
  structs->reserve(facts.size());
  for (const auto& fact : facts) list->push_back(&structs->emplace_back(StructOf(fact)));
  first = list->data();
  count = list->size();
  kept_.push_back(std::move(structs));
  kept_.push_back(std::move(list));
}

clipc_effect_annotation EffectStructs::StructOf(const ast::Annotation& fact) {
  return {fact.type.c_str(), fact.name.c_str(), fact.value.c_str()};
}

clipc_effect_state EffectStructs::StructOf(const ast::EffectState& fact) {
  return {fact.name.c_str(), fact.text.c_str()};
}

clipc_effect_shader EffectStructs::StructOf(const EffectShaderFact& fact) {
  return {InfoOf(fact.stage).name.data(), fact.entry.c_str(), fact.profile.c_str(),
          fact.call.c_str(), fact.element ? static_cast<std::int32_t>(*fact.element) : -1};
}

clipc_effect_program EffectStructs::StructOf(const EffectProgramFact& fact) {
  clipc_effect_program program{nullptr, 0, programs_[fact.number], fact.number};
  List(fact.shaders, program.shaders, program.shader_count);
  return program;
}

clipc_effect_value EffectStructs::StructOf(const EffectChoice::Value& fact) {
  return {fact.text.c_str(), fact.count};
}

clipc_effect_choice EffectStructs::StructOf(const EffectChoice& fact) {
  clipc_effect_choice choice{};
  List(fact.values, choice.values, choice.value_count);
  auto programs = std::make_shared<std::vector<std::int32_t>>();
  programs->reserve(fact.programs.size());
  for (const std::optional<std::size_t>& program : fact.programs)
    programs->push_back(program ? static_cast<std::int32_t>(*program) : -1);
  choice.programs = programs->data();
  choice.program_count = programs->size();
  kept_.push_back(std::move(programs));
  return choice;
}

clipc_effect_pass EffectStructs::StructOf(const EffectPassFact& fact) {
  clipc_effect_pass pass{};
  pass.name = fact.text.name.c_str();
  pass.is_left_out = fact.is_left_out;
  List(fact.text.annotations, pass.annotations, pass.annotation_count);
  List(fact.programs, pass.programs, pass.program_count);
  List(fact.choices, pass.choices, pass.choice_count);
  List(fact.text.states, pass.states, pass.state_count);
  return pass;
}

clipc_effect_technique EffectStructs::StructOf(const EffectTechniqueFact& fact) {
  clipc_effect_technique technique{};
  technique.kind = fact.kind.c_str();
  technique.group = fact.group.c_str();
  technique.name = fact.name.c_str();
  List(fact.annotations, technique.annotations, technique.annotation_count);
  List(fact.passes, technique.passes, technique.pass_count);
  return technique;
}

clipc_effect_parameter EffectStructs::StructOf(const EffectParameterFact& fact) {
  clipc_effect_parameter parameter{};
  parameter.name = fact.text.name.c_str();
  parameter.type = fact.text.type.c_str();
  parameter.semantic = fact.text.semantic.c_str();
  parameter.value = fact.text.value.c_str();
  const auto bytes = std::make_shared<std::string>(fact.initial.begin(), fact.initial.end());
  parameter.bytes = {bytes->c_str(), bytes->size()};
  kept_.push_back(bytes);
  List(fact.text.annotations, parameter.annotations, parameter.annotation_count);
  List(fact.text.states, parameter.states, parameter.state_count);
  return parameter;
}

}  // namespace clipc
