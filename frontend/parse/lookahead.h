// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/not_copied.h"
#include "frontend/parse/token_cursor.h"

namespace clipc::ast {

// A cursor that knows what the names of the text mean so far, and answers the questions that need
// more than the current token: a cast or parentheses, template arguments or less-than, a
// declaration or an expression.
//
// Every question reads a bounded number of tokens, so parsing is linear for every text. `ahead`
// counts tokens from the current one; a Skip function returns the position after what it skips, or
// 0 where that does not stand there.
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

  // The names declared during its life are forgotten at its end.
  class NameScope : NotCopied {
   public:
    explicit NameScope(Lookahead& names) : names_(names), mark_(names.undo_.size()) {}
    ~NameScope();

   private:
    Lookahead& names_;
    std::size_t mark_;
  };

  Lookahead(Tokens&& tokens, Diagnostics& diagnostics);

  // A name that is none is allowed, and ignored.
  void Declare(Name name, Meaning meaning);
  // The meaning in the scopes around the current token; for a name that none of them declares, that
  // of a type or template of a scope that has ended (a namespace, a base class).
  Meaning MeaningOf(Name name) const;
  bool IsTypeName(std::size_t ahead) const;

  // Past the `>` that belongs to the `<` at `ahead`.
  std::size_t SkipTemplateArguments(std::size_t ahead) const;
  // Past the bracket that closes the one at `ahead`.
  std::size_t SkipBrackets(std::size_t ahead) const;
  // Past `a::b<c>`, `::a` or `unsigned int`.
  std::size_t SkipTypeName(std::size_t ahead) const;
  // Past any number of qualifiers, which may be none.
  std::size_t SkipQualifiers(std::size_t ahead) const;
  // The last name of `a::b::c` or `::c`.
  std::size_t LastOfQualifiedName(std::size_t ahead) const;

  bool IsQualifier(std::size_t ahead) const;
  // At a token that can only belong to a type here: not at a name that a variable has.
  bool StartsType(std::size_t ahead) const;
  // `(T)e`, `(T[2])e`, as opposed to `(a) + b`.
  bool IsCast() const;
  // At the start of a statement: two names in a row are a type and a variable, whatever they mean.
  bool IsDeclaration() const;
  // Whether the `<` at `less`, after the name of a function or type, starts template arguments.
  bool IsTemplateUse(Name name, std::size_t less) const;
  // Whether the `<` does so after a name without a known declaration: `<`, types, `>` and a call.
  bool IsMemberTemplateUse(std::size_t less) const;
  // After the `}` of a struct: whether its declaration ends there although no `;` follows.
  // `struct S {} f() {}` and `struct S {} s;` go on; `struct S {} float4 f() {}` and
  // `struct S {} struct T {}` do not.
  bool StructEndsHere() const;

 private:
  // By Name. `outside_` has the types and templates of every scope, including those that have
  // ended.
  std::vector<Meaning> meanings_, outside_;
  std::vector<std::pair<Name, Meaning>> undo_;
};

}  // namespace clipc::ast
