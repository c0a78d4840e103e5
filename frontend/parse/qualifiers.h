// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/parse/ast_decl.h"

// The rules about where a qualifier may be written, and with which others. Source: the messages of
// fxc and DXC for each qualifier and pair at each kind of declaration, in DXC's varmods-syntax.hlsl
// and typemods-syntax_noerr.hlsl.
namespace clipc::ast {

enum class QualifierOwner : std::uint8_t {
  kGlobal,  // a global variable or a member of a buffer
  kLocal,
  kField,
  kParameter,
  kFunction,
  kMethod,
  kTypedef,
};

std::string_view TextOf(QualifierOwner owner);  // a noun phrase: "a local variable"
// Returns the bits of `qualifiers` that no declaration of `owner` may have: they ask for another
// kind of declaration, and fxc refuses them.
Qualifiers RefusedAt(QualifierOwner owner, Qualifiers qualifiers);
// Returns the bits of `qualifiers` that change nothing at `owner`. fxc refuses some of them.
Qualifiers WithoutEffectAt(QualifierOwner owner, Qualifiers qualifiers);
// Returns two of `qualifiers` that contradict each other, a bit each; {0, 0} if there are none.
std::pair<Qualifiers, Qualifiers> ConflictIn(Qualifiers qualifiers);

// Returns the words of `qualifiers`, "static" and "const"; the two bits of `inout` are one word.
std::vector<std::string_view> SpellingsOf(Qualifiers qualifiers);

}  // namespace clipc::ast
