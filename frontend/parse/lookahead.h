// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/kept_blocks.h"
#include "base/not_copied.h"
#include "frontend/parse/token_cursor.h"

namespace clipc::ast {

// A cursor that knows what the names of the text mean so far, and answers the questions that need
// more than the current token: a cast or parentheses, template arguments or less-than, a
// declaration or an expression.
//
// Every question reads a bounded number of tokens, so parsing is linear for every text. `ahead`
// counts tokens from the current one; a Skip function returns the position after what it skips, or
// 0 if there is no such thing there.
class Lookahead : protected TokenCursor {
 protected:
  enum class Meaning : std::uint8_t {
    kUnknown,
    kValue,
    kFunction,
    kFunctionTemplate,
    kType,
    kNamespace
  };

  // A scope: the names declared during its life are forgotten at its end.
  class NameScope : NotCopied {
   public:
    explicit NameScope(Lookahead& names) : names_(names), mark_(names.undo_.size()) {}
    ~NameScope();

   private:
    Lookahead& names_;
    std::size_t mark_;
  };

  Lookahead(Tokens&& tokens, Diagnostics& diagnostics);

  // Gives `name` a meaning in the current scope; does nothing for a name that is none.
  void Declare(Name name, Meaning meaning);
  // The meaning of `name` in the scopes around the current token; if none of them declares it, the
  // meaning of a type or template of a scope that has ended (a namespace, a base class).
  Meaning MeaningOf(Name name) const;
  bool IsTypeName(std::size_t ahead) const;

  // Skips template arguments, from the `<` at `ahead` past the `>` that belongs to it.
  std::size_t SkipTemplateArguments(std::size_t ahead) const;
  // Skips from the bracket at `ahead` past the bracket that closes it.
  std::size_t SkipBrackets(std::size_t ahead) const;
  // Skips the name of a type: `a::b<c>`, `::a` or `unsigned int`.
  std::size_t SkipTypeName(std::size_t ahead) const;
  // Skips any number of qualifiers; returns `ahead` if there are none.
  std::size_t SkipQualifiers(std::size_t ahead) const;
  // The position of the last name of `a::b::c` or `::c`.
  std::size_t LastOfQualifiedName(std::size_t ahead) const;

  bool IsQualifier(std::size_t ahead) const;
  // Whether the token at `ahead` starts a type: not if it is a name that a variable has here.
  bool StartsType(std::size_t ahead) const;
  // Whether the current `(` starts a cast, `(T)e` or `(T[2])e`, as opposed to `(a) + b`.
  bool IsCast() const;
  // Whether the statement that starts here is a declaration: two names in a row are a type and a
  // variable, whatever they mean.
  bool IsDeclaration() const;
  // Whether the `<` at `less`, after the name of a function or type, starts template arguments.
  bool IsTemplateUse(Name name, std::size_t less) const;
  // Whether the `<` at `less`, after a name without a known declaration, starts template arguments:
  // types, `>` and a call follow.
  bool IsMemberTemplateUse(std::size_t less) const;
  // Whether the declaration of a struct ends after its `}`, the last token, although no `;`
  // follows. `struct S {} f() {}` and `struct S {} s;` go on; `struct S {} float4 f() {}` and
  // `struct S {} struct T {}` do not.
  bool StructEndsHere() const;

 private:
  // The meanings by Name. `outside_` has the types and templates of every scope, including the
  // scopes that have ended.
  KeptVector<Meaning> meanings_, outside_;
  KeptVector<std::pair<Name, Meaning>> undo_;
};

}  // namespace clipc::ast
