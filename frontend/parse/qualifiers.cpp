// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/qualifiers.h"

#include <cstddef>

namespace clipc::ast {
namespace {

constexpr Qualifiers kInterpolation =
    kNoInterpolation | kLinear | kCentroid | kNoPerspective | kSample;

// Of the vertices that a geometry shader takes: parameters alone have them (vkd3d's
// geometry-shader-syntax.shader_test).
constexpr Qualifiers kPrimitive = kPoint | kLine | kTriangle | kLineAdjacent | kTriangleAdjacent;

struct Rules {
  std::string_view text;
  Qualifiers refused = 0;
  Qualifiers without_effect = 0;
};
// The rules in the order of QualifierOwner.
constexpr Rules kRules[] = {
    {"a global variable", kIn | kOut | kPrimitive, kVolatile | kInterpolation},
    {"a local variable", kExtern | kGroupShared | kUniform | kIn | kOut | kPrimitive,
     kVolatile | kInterpolation},
    {"a field", kGroupShared | kUniform | kIn | kOut | kPrimitive, kVolatile | kExtern | kConst},
    {"a parameter", kGroupShared | kStatic, kExtern | kVolatile},
    {"a function", kUniform | kIn | kOut | kPrimitive, kExtern | kGroupShared | kVolatile},
    {"a method", kUniform | kIn | kOut | kPrimitive,
     kExtern | kGroupShared | kVolatile | kInterpolation},
    {"a typedef", kGroupShared | kStatic | kUniform | kIn | kOut | kPrimitive,
     kExtern | kPrecise | kVolatile | kInterpolation},
};

const Rules& RulesOf(QualifierOwner owner) { return kRules[static_cast<std::size_t>(owner)]; }

}  // namespace

std::string_view TextOf(QualifierOwner owner) { return RulesOf(owner).text; }

Qualifiers RefusedAt(QualifierOwner owner, Qualifiers qualifiers) {
  return RulesOf(owner).refused & qualifiers;
}

Qualifiers WithoutEffectAt(QualifierOwner owner, Qualifiers qualifiers) {
  // A static member is a variable.
  if (qualifiers & kStatic) qualifiers &= ~kConst;
  return RulesOf(owner).without_effect & qualifiers;
}

std::pair<Qualifiers, Qualifiers> ConflictIn(Qualifiers qualifiers) {
  constexpr std::pair<Qualifiers, Qualifiers> kConflicts[] = {
      {kStatic, kExtern},
      {kStatic, kUniform},
      {kGroupShared, kExtern},
      {kGroupShared, kUniform},
      {kRowMajor, kColumnMajor},
      {kNoInterpolation, kLinear},
      {kNoInterpolation, kNoPerspective},
      {kNoInterpolation, kCentroid},
      {kSnorm, kUnorm},
  };
  for (const auto& [first, second] : kConflicts) {
    if ((qualifiers & first) && (qualifiers & second)) return {first, second};
  }
  return {};
}

std::vector<std::string_view> SpellingsOf(Qualifiers qualifiers) {
  std::vector<std::string_view> spellings;
  if ((qualifiers & kIn) && (qualifiers & kOut)) {
    spellings.push_back("inout");
    qualifiers &= ~(kIn | kOut);
  }
#define QUALIFIER(bit, spelling, word) \
  if (qualifiers & (bit)) spellings.push_back(spelling);
#include "frontend/parse/qualifier_bits.def"
  return spellings;
}

}  // namespace clipc::ast
