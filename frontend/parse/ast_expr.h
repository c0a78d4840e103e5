// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "base/arena.h"
#include "base/id.h"
#include "base/name.h"
#include "base/operators.h"
#include "base/span.h"
#include "frontend/lex/token.h"

// Names, types, expressions and attributes of the syntax tree.
namespace clipc::ast {

struct Expr;
struct Stmt;
struct Decl;
struct Type;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using DeclId = Id<Decl>;
using TypeId = Id<Type>;

// A name with scopes, as in `a::b::c` or `::c`.
struct QualifiedName {
  Name name;
  List<Name> scopes;  // `a`, `b`
  bool from_global = false;
};

// A type as written: a name, which may have template arguments, or a struct or enum defined in
// place.
struct Type {
  Span span;
  // `float4`, `vector`, `Texture2D`, `ns::S`. The parser writes `uint` for `unsigned int` and
  // `dword`. The name of a type defined in place is that of its definition; it may be none.
  QualifiedName name;
  // The template arguments in <...>. A type is a TypeExpr; the array type `T[4]` is an IndexExpr
  // whose base is a TypeExpr.
  List<ExprId> arguments;
  // The definition of `struct {...} x;` or `enum E {...} x;`; otherwise none.
  DeclId struct_definition;
  bool has_arguments = false;  // tells `Texture2D<>` from `Texture2D`
  TypeId outer;                // A<int> in `A<int>::T`, where the name is T; otherwise none
  bool is_unsigned = false;    // `unsigned` before the name of a typedef
};

// ---- expressions

struct Literal {
  LiteralKind kind;
  // The value of an integer, 0 or 1 for a bool, the bits of a double for every floating-point kind,
  // the index of a Name for a string.
  std::uint64_t bits;
};
struct NameExpr {
  QualifiedName name;
  List<ExprId> arguments;  // explicit template arguments: f<float>
};
// A type used as an expression: the callee of float4(...), a template argument, the operand of
// sizeof.
struct TypeExpr {
  TypeId type;
  std::uint32_t qualifiers = 0;  // of a template argument: Qualifiers, as a declaration has them
};
struct UnaryExpr {
  std::optional<UnaryOp> op;  // none: `+`
  ExprId operand;
};
struct BinaryExpr {
  BinaryOp op;
  ExprId left, right;
  Span op_span;
};
struct CommaExpr {
  ExprId left, right;
};
// An assignment, `left = right` or `left op= right`.
struct AssignExpr {
  std::optional<BinaryOp> op;
  ExprId left, right;
};
struct ConditionalExpr {
  ExprId condition, when_true, when_false;
};
// A call: f(a); float4(a, b), where the callee is a TypeExpr; o.m(a), where it is a MemberExpr.
struct CallExpr {
  ExprId callee;
  List<ExprId> arguments;
};
// A cast, (T)e or (T[3])e.
struct CastExpr {
  TypeId type;
  List<ExprId> dimensions;
  ExprId operand;
};
struct IndexExpr {
  ExprId base, index;
};
// The member base.name: a field, a swizzle or a method, which the checker tells apart; or
// S<int>::x, where the base is a TypeExpr.
struct MemberExpr {
  ExprId base;
  Name of;  // S in a.S::x, the struct or the base of a that has the member; none: a's own type
  Name name;
  Span name_span;
  List<ExprId> arguments;  // explicit template arguments: buffer.Load<float4>(0)
};
// A list of initialisers, {a, {b, c}}; a trailing comma is allowed.
struct InitListExpr {
  List<ExprId> elements;
};
struct SizeofExpr {
  ExprId operand;  // a TypeExpr or any other expression
};
// An expression that the parser reported an error for.
struct ErrorExpr {};

// An expression. Parentheses are not kept: they widen the span of the expression that they enclose.
struct Expr {
  Span span;
  std::variant<Literal, NameExpr, TypeExpr, UnaryExpr, BinaryExpr, CommaExpr, AssignExpr,
               ConditionalExpr, CallExpr, CastExpr, IndexExpr, MemberExpr, InitListExpr, SizeofExpr,
               ErrorExpr>
      node;
};

// An attribute, [name], [name(arguments)] or [[ns::name(arguments)]].
struct Attr {
  Span span;  // with the brackets
  Name name;  // `ns::name` is one name
  Span name_span;
  List<ExprId> arguments;
  bool has_parens = false;
};

}  // namespace clipc::ast
