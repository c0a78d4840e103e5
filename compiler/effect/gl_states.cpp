// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/gl_states.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/spelling.h"
#include "compiler/effect/gl_words.h"
#include "compiler/effect/state_values.h"

namespace clipc {
namespace {

using ast::EffectState;
using ast::EffectValue;
using enum GlStateKind;

struct Rule {
  StatePlace place;
  std::string_view name;
  GlStateKind state;
  ValueReading read;
};
constexpr Rule kRules[] = {
#define GL_RULE(Place, Name, State, Read) {StatePlace::k##Place, Name, GlStateKind::k##State, Read},
#include "compiler/effect/gl_states.def"
};

const Rule* FindRule(StatePlace place, std::string_view name) {
  const auto found = std::ranges::find_if(kRules, [&](const Rule& rule) {
    return rule.place == place && IsSameState(rule.name, name);
  });
  return found == std::end(kRules) ? nullptr : found;
}

// The calls that set a block of states, with what all passes that have one begin with: where
// Direct3D 10's default is another one than that of Direct3D 9.
struct ObjectCall {
  std::string_view name;
  StatePlace place;
  std::vector<GlState> defaults;
};
const ObjectCall* FindCall(std::string_view name) {
  static const ObjectCall kCalls[] = {
      {"SETBLENDSTATE", StatePlace::kBlendState, {{kBlendSeparateAlpha, 1}}},
      {"SETRASTERIZERSTATE", StatePlace::kRasterizerState, {}},
      {"SETDEPTHSTENCILSTATE",
       StatePlace::kDepthStencilState,
       {{kDepthFunc, 0x201},
        {kStencilTwoSided, 1},
        {kStencilReadMask, 255},
        {kStencilWriteMask, 255}}}};
  const auto found = std::ranges::find(kCalls, name, &ObjectCall::name);
  return found == std::end(kCalls) ? nullptr : found;
}

class StateReader {
 public:
  StateReader(const EffectFacts& effect, StateReport& report) : effect_(effect), report_(report) {}

  void AddPass(const ast::EffectPass& pass) {
    for (const EffectState& state : pass.states) {
      const std::string name = ToUpper(state.word);
      // The shader's own sampler says the same as Sampler[0] and Texture[0].
      if (state.has_index && (name == "SAMPLER" || name == "TEXTURE")) continue;
      if (const ObjectCall* call = FindCall(name)) {
        AddCall(*call, state);
      } else {
        Add(StatePlace::kPass, state);
      }
    }
  }

  void Flip() {
    const bool is_counterclockwise = At(kFrontFace) == kCounterclockwise;
    At(kFrontFace) = is_counterclockwise ? kClockwise : kCounterclockwise;
  }

  std::vector<GlState> Finish() const {
    std::vector<GlState> states;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (found_[i]) states.push_back({static_cast<GlStateKind>(i), *found_[i]});
    }
    return states;
  }

 private:
  std::optional<std::uint32_t>& At(GlStateKind kind) {
    return found_[static_cast<std::size_t>(kind)];
  }

  // Whether the state of another render target says what that of the first does, which holds for
  // all of them: BlendEnable[1]. RenderTargetWriteMask[1] is a state of its own.
  bool SaysFirst(StatePlace place, const Rule& first, const EffectState& state) {
    const auto value = first.read(state.value);
    return !FindRule(place, state.word + "1") && value && *value == At(first.state).value_or(0);
  }

  void Add(StatePlace place, const EffectState& state) {
    const Rule* const first = FindRule(place, state.word);
    const Rule* const rule =
        state.index == 0 ? first : FindRule(place, state.word + std::to_string(state.index));
    if (!rule && first && SaysFirst(place, *first, state)) return;
    if (place == StatePlace::kPass && IsSameState(state.word, "BlendFactor") && state.index == 0)
      return AddBlendFactor(state);
    if (!rule || !report_.Has(rule->state)) return report_.Unknown(state, !rule && first);
    if (const auto value = rule->read(state.value)) {
      At(rule->state) = value;
    } else {
      report_.NotConstant(state);
    }
  }

  // BlendFactor = 0xAARRGGBB
  void AddBlendFactor(const EffectState& state) {
    const auto color = ReadUnsigned(state.value);
    if (!color) return report_.NotConstant(state);
    const auto channel = [&](int shift) { return FloatBits((*color >> shift & 255) / 255.0); };
    At(kBlendRed) = channel(16);
    At(kBlendGreen) = channel(8);
    At(kBlendBlue) = channel(0);
    At(kBlendAlpha) = channel(24);
  }

  // SetBlendState(Blend, float4(0, 0, 0, 0), 0xFFFFFFFF)
  void AddCall(const ObjectCall& call, const EffectState& state) {
    for (const auto& [kind, value] : call.defaults) At(kind) = value;
    const std::vector<EffectValue>& arguments = state.value.parts;
    const std::string name = arguments.empty() ? "" : arguments[0].word;
    if (!EqualIgnoringCase(name, "NULL")) {
      const EffectParameterFact* const block = effect_.FindParameter(name);
      if (state.is_wrong) return;
      if (!block || !block->text.is_block) {
        report_.NotBlock(state);
      } else {
        for (const EffectState& inner : block->text.states) Add(call.place, inner);
      }
    }
    const bool is_read = call.place == StatePlace::kBlendState ? AddBlendArguments(arguments)
                         : call.place == StatePlace::kDepthStencilState && arguments.size() > 1
                             ? AddUnsigned(kStencilReference, arguments[1])
                             : true;
    if (!is_read) report_.NotConstant(state);
  }

  bool AddBlendArguments(const std::vector<EffectValue>& arguments) {
    if (arguments.size() > 1) {
      const auto factors = ReadNumbers(arguments[1]);
      if (!factors) return false;
      constexpr GlStateKind kChannels[] = {kBlendRed, kBlendGreen, kBlendBlue, kBlendAlpha};
      for (std::size_t i = 0; i < std::min(factors->size(), std::size(kChannels)); ++i)
        At(kChannels[i]) = FloatBits((*factors)[i]);
    }
    return arguments.size() < 3 || AddUnsigned(kSampleMask, arguments[2]);
  }

  bool AddUnsigned(GlStateKind kind, const EffectValue& argument) {
    const auto value = ReadUnsigned(argument);
    if (value) At(kind) = value;
    return value.has_value();
  }

  const EffectFacts& effect_;
  StateReport& report_;
  std::array<std::optional<std::uint32_t>, static_cast<std::size_t>(kCount)> found_;
};

}  // namespace

std::string_view NameOf(GlStateKind kind) {
  static constexpr std::string_view kNames[] = {
#define GL_STATE(Enumerator, Name) Name,
#include "compiler/effect/gl_states.def"
  };
  return kNames[static_cast<std::size_t>(kind)];
}

void StateReport::Unknown(const EffectState& state, bool is_numbered) {
  if (IsNew(state))
    diagnostics_.Report(state.span, diag::EffectStateUnknown, host_.name, state.name,
                        is_numbered ? host_.reader : host_.api, host_.member, host_.cure);
}

void StateReport::NotConstant(const EffectState& state) {
  if (IsNew(state))
    diagnostics_.Report(state.span, diag::EffectStateValue, host_.name, state.text, state.name,
                        host_.api, host_.cure);
}

void StateReport::NotBlock(const EffectState& state) {
  if (IsNew(state))
    diagnostics_.Report(state.span, diag::EffectStateBlock, host_.name, state.name, state.text,
                        host_.cure);
}

std::vector<GlState> ReadGlStates(const EffectFacts& effect, const ast::EffectPass& pass,
                                  bool flips, StateReport& report) {
  StateReader reader(effect, report);
  reader.AddPass(pass);
  if (flips) reader.Flip();
  return reader.Finish();
}

}  // namespace clipc
