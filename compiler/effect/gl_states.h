// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/effect/effect_facts.h"

namespace clipc {

// A state of a pass for OpenGL: clipc_gl_state and its value.
enum class GlStateKind : std::uint8_t {
#define GL_STATE(Enumerator, Name) k##Enumerator,
#include "compiler/effect/gl_states.def"
  kCount
};
std::string_view NameOf(GlStateKind kind);  // "DEPTH_TEST"

struct GlState {
  GlStateKind kind;
  std::uint32_t value = 0;
};

// What has the states, in the words of the warnings about those that it leaves out.
struct StateHost {
  std::string_view name = "the header", api = "OpenGL", reader = "its runtime", member = "call",
                   cure = "after `clipc_gl_effect_apply`";
  bool (*has)(GlStateKind state) = nullptr;  // null: it has all
};

// Warns of what a host leaves out, of each text once.
class StateReport {
 public:
  StateReport(const StateHost& host, Diagnostics& diagnostics)
      : host_(host), diagnostics_(diagnostics) {}

  bool Has(GlStateKind state) const { return !host_.has || host_.has(state); }
  // `is_numbered` says that the host has the state of the first render target alone.
  void Unknown(const ast::EffectState& state, bool is_numbered = false);
  void NotConstant(const ast::EffectState& state);
  void NotBlock(const ast::EffectState& state);

 private:
  bool IsNew(const ast::EffectState& state) {
    return !state.is_wrong && said_.insert(state.name + '\n' + state.text).second;
  }

  StateHost host_;
  Diagnostics& diagnostics_;
  std::set<std::string> said_;
};

// The states of a pass, in the order of clipc_gl_state. `flips` says that the image is upside down,
// so that the front faces are the others. Reports what OpenGL does not have, what depends on a
// parameter, and what the report's host does not have.
std::vector<GlState> ReadGlStates(const EffectFacts& effect, const ast::EffectPass& pass,
                                  bool flips, StateReport& report);

}  // namespace clipc
