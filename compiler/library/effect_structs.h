// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "compiler/clipc_effect.h"
#include "compiler/effect/effect_facts.h"

namespace clipc {

// The structs of compiler/clipc_effect.h, which refer to each other and to the texts of the facts.
class EffectStructs {
 public:
  // `programs` are those of the facts, by their numbers; null: it has errors.
  EffectStructs(const EffectFacts& facts, std::vector<const clipc_result*> programs);
  EffectStructs(const EffectStructs&) = delete;
  EffectStructs& operator=(const EffectStructs&) = delete;

  const clipc_effect& effect() const { return effect_; }

 private:
  // Sets the list of structs of the facts, and how many there are.
  template <class Facts, class Struct>
  void List(const Facts& facts, const Struct* const*& first, std::size_t& count);

  clipc_effect_annotation StructOf(const ast::Annotation& fact);
  clipc_effect_state StructOf(const ast::EffectState& fact);
  clipc_effect_shader StructOf(const EffectShaderFact& fact);
  clipc_effect_program StructOf(const EffectProgramFact& fact);
  clipc_effect_value StructOf(const EffectChoice::Value& fact);
  clipc_effect_choice StructOf(const EffectChoice& fact);
  clipc_effect_pass StructOf(const EffectPassFact& fact);
  clipc_effect_technique StructOf(const EffectTechniqueFact& fact);
  clipc_effect_parameter StructOf(const EffectParameterFact& fact);

  std::vector<const clipc_result*> programs_;
  clipc_effect effect_{};
  std::vector<std::shared_ptr<const void>> kept_;  // the structs and the lists of them
};

}  // namespace clipc
