// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/context.h"

#include <algorithm>
#include <set>

namespace clipc::random {
namespace {

// Words that mean something in GLSL and nothing in HLSL.
constexpr const char* kGlslWords[] = {
    "vec4",       "mix",   "fract", "input",  "output", "mat4",      "attribute",
    "filter",     "ivec3", "mod",   "buffer", "common", "active",    "highp",
    "subroutine", "patch", "flat",  "gl_x",   "a__b",   "invariant", "layout",
    "varying",    "dFdx",  "bvec2", "equal",  "not",    "imageLoad", "greaterThan"};

}  // namespace

std::string Context::FreshName(const char* prefix) {
  const std::string number = std::to_string(names++);
  if (!Has(Feature::kOddNames) || !choices.Chance(8)) return prefix + number;
  std::string word = choices.OneOf(kGlslWords);
  const bool is_known = std::ranges::any_of(scopes, [&](const std::vector<Variable>& scope) {
    return std::ranges::find(scope, word, &Variable::name) != scope.end();
  });
  return is_known ? word + number : word;
}

std::vector<const Variable*> Context::Visible() const {
  std::vector<const Variable*> visible;
  std::set<std::string> known;
  for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope) {
    for (auto variable = scope->rbegin(); variable != scope->rend(); ++variable) {
      if (known.insert(variable->name).second) visible.push_back(&*variable);
    }
  }
  return visible;
}

bool Context::MayUse(const Variable& variable, bool writes) const {
  if (Has(Feature::kUnsequenced) || !variable.writable) return true;
  return !written.contains(variable.name) && (!writes || !read.contains(variable.name));
}

void Context::Use(const Variable& variable, bool writes) {
  (writes ? written : read).insert(variable.name);
}

bool Context::MayUseStatics(bool writes) const {
  return std::ranges::all_of(scopes[0],
                             [&](const Variable& variable) { return MayUse(variable, writes); });
}

void Context::UseStatics(bool writes) {
  for (const Variable& variable : scopes[0]) {
    if (variable.writable) Use(variable, writes);
  }
}

Range RangeOf(const Variable& variable, Kind kind) {
  switch (variable.holds) {
    case Holds::kInput: return InputRange(kind);
    case Holds::kWild:
      return kind == Kind::kInt || kind == Kind::kUint ? Wild(kind) : VariableRange(kind);
    case Holds::kCounter: return {0, variable.greatest};
    case Holds::kVariable: break;
  }
  return VariableRange(kind);
}

}  // namespace clipc::random
