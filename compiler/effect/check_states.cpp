// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/check_states.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/spelling.h"
#include "compiler/compile/suggest.h"
#include "compiler/effect/dialect.h"
#include "compiler/effect/gl_words.h"
#include "compiler/effect/state_values.h"

namespace clipc {
namespace {

using ast::EffectState;
using ast::EffectValue;
using Names = std::vector<std::string_view>;

struct KnownState {
  StatePlace place;
  std::string_view name;
  ValueReading read;
};
constexpr KnownState kStates[] = {
#define GL_RULE(Place, Name, State, Read) {StatePlace::k##Place, Name, Read},
#include "compiler/effect/gl_states.def"
#define D3D_STATE(Place, Name, Read) {StatePlace::k##Place, Name, Read},
#include "compiler/effect/d3d_states.def"
};

struct StateWord {
  std::string_view state, word;
};
constexpr StateWord kStateWords[] = {
#define D3D_WORD(State, Word) {State, Word},
#include "compiler/effect/d3d_states.def"
};

const KnownState* FindState(StatePlace place, std::string_view word) {
  const std::string_view stem = word.substr(0, word.find_last_not_of("0123456789") + 1);
  const auto found = std::ranges::find_if(kStates, [&](const KnownState& state) {
    if (state.place != place) return false;
    const bool has_digits = state.name.ends_with('#');
    return IsSameState(has_digits ? state.name.substr(0, state.name.size() - 1) : state.name,
                       has_digits ? stem : word);
  });
  return found == std::end(kStates) ? nullptr : found;
}

Names StatesIn(StatePlace place) {
  Names names;
  for (const KnownState& state : kStates) {
    if (state.place == place && !state.name.ends_with('#')) names.push_back(state.name);
  }
  return names;
}

bool IsNull(const EffectValue& value) { return EqualIgnoringCase(value.word, "NULL"); }

// Whether a word is a value of the state.
bool Takes(const KnownState& state, const EffectValue& value) {
  if (state.read(value)) return true;
  return std::ranges::any_of(kStateWords, [&](const StateWord& row) {
    return row.state == state.name && row.word == PlainWord(value.word);
  });
}

// The words that are values of the state.
Names WordsOf(const KnownState& state) {
  Names words;
  for (const std::string_view word : Words()) {
    const EffectValue value{.kind = EffectValue::Kind::kWord, .word = std::string(word)};
    if (state.read(value) && std::ranges::find(words, word) == words.end()) words.push_back(word);
  }
  for (const StateWord& row : kStateWords) {
    if (row.state == state.name) words.push_back(row.word);
  }
  return words;
}

StatePlace PlaceOf(const ast::EffectParameter& parameter) {
  const std::string type = ToLower(parameter.type);
  if (type.starts_with("sampler")) return StatePlace::kSampler;
  if (type.starts_with("blendstate")) return StatePlace::kBlendState;
  if (type.starts_with("depthstencilstate")) return StatePlace::kDepthStencilState;
  if (type.starts_with("rasterizerstate")) return StatePlace::kRasterizerState;
  return StatePlace::kPass;
}

class StateChecker {
 public:
  StateChecker(const ast::File& file, EffectDialect dialect, Diagnostics& diagnostics)
      : dialect_(dialect), diagnostics_(diagnostics) {
    for (const ast::EffectVariable& variable : file.effect->variables)
      variables_.push_back(file.names[variable.name]);
    std::ranges::sort(variables_);
    for (const ast::DeclId decl : file.top_level) {
      if (const auto* function = std::get_if<ast::FunctionDecl>(&file.decls[decl].node))
        functions_.push_back(file.names[function->name]);
    }
    std::ranges::sort(functions_);
  }

  void Check(ast::EffectParameter& parameter) {
    const StatePlace place = PlaceOf(parameter);
    for (EffectState& state : parameter.states) Check(place, state);
    for (std::vector<EffectState>& element : parameter.elements) {
      for (EffectState& state : element) Check(place, state);
    }
    for (const Span end : parameter.unended) diagnostics_.Report(end, diag::EffectNoSemicolon);
  }

  void Check(ast::EffectPass& pass) {
    for (EffectState& state : pass.states) Check(StatePlace::kPass, state);
    for (const Span end : pass.unended) diagnostics_.Report(end, diag::EffectNoSemicolon);
  }

 private:
  void Check(StatePlace place, EffectState& state) {
    const KnownState* known = FindState(place, state.word);
    // A pass has the states of samplers by the number of a texture: MinFilter[0] = Linear.
    if (!known && place == StatePlace::kPass && state.has_index)
      known = FindState(StatePlace::kSampler, state.word);
    // A shader is not a state, so its name is another one: `vertex_shader`.
    if (!known || known->read == Shader) return ReportUnknown(place, state, known != nullptr);
    const EffectValue& value = state.value;
    if (known->read == Reference) {
      const bool is_call = value.kind == EffectValue::Kind::kList && !value.parts.empty();
      CheckReference(state, is_call ? value.parts[0] : value);
    } else if (value.kind == EffectValue::Kind::kUnion) {
      for (const EffectValue& part : value.parts) CheckWord(*known, state, part);
    } else {
      CheckWord(*known, state, value);
    }
  }

  void ReportUnknown(StatePlace place, EffectState& state, bool names_shader) {
    state.is_wrong = true;
    const bool has_shader = names_shader || ToLower(state.text).starts_with("compile") ||
                            IsIn(functions_, CalledBy(state.text));
    const Names own = has_shader ? ShaderNames(dialect_) : Names();
    const Names names = own.empty() ? StatesIn(place) : own;
    const std::string near = Suggest(state.word, NearNames(state.word, names));
    if (has_shader) {
      diagnostics_.Report(state.span, diag::EffectShaderName, state.word, near);
    } else {
      diagnostics_.Report(state.span, diag::EffectStateName, state.word, near);
    }
  }

  void CheckReference(EffectState& state, const EffectValue& value) {
    if (value.kind != EffectValue::Kind::kWord || IsNull(value) || IsVariable(value.word)) return;
    state.is_wrong = true;
    diagnostics_.Report(state.span, diag::EffectNotDeclared, value.word,
                        Suggest(value.word, NearNames(value.word, variables_)));
  }

  void CheckWord(const KnownState& known, EffectState& state, const EffectValue& value) {
    if (value.kind != EffectValue::Kind::kWord || IsNull(value)) return;
    if (Takes(known, value) || IsVariable(value.word)) return;
    state.is_wrong = true;
    constexpr std::size_t kFew = 8;
    const std::string plain = PlainWord(value.word);
    const Names words = WordsOf(known), near = NearNames(plain, words);
    diagnostics_.Report(state.span, diag::EffectStateWord, value.word, known.name,
                        Suggest(plain, near.empty() && words.size() <= kFew ? words : near));
  }

  static bool IsIn(const Names& names, std::string_view name) {
    return std::ranges::binary_search(names, name);
  }
  bool IsVariable(std::string_view name) const { return IsIn(variables_, name); }

  // The name before the first parenthesis.
  static std::string_view CalledBy(std::string_view text) {
    const std::string_view before = text.substr(0, std::min(text.find('('), text.size()));
    return before.substr(0, before.find_last_not_of(' ') + 1);
  }

  EffectDialect dialect_;
  Diagnostics& diagnostics_;
  Names variables_, functions_;  // sorted
};

}  // namespace

void CheckStates(const ast::File& file, EffectDialect dialect, ast::Effect& effect,
                 Diagnostics& diagnostics) {
  StateChecker checker(file, dialect, diagnostics);
  for (ast::EffectParameter& parameter : effect.parameters) checker.Check(parameter);
  for (ast::EffectTechnique& technique : effect.techniques) {
    for (ast::EffectPass& pass : technique.passes) checker.Check(pass);
  }
}

}  // namespace clipc
