// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "base/diagnostics.h"
#include "base/kept_blocks.h"
#include "base/not_copied.h"
#include "frontend/check/check_options.h"
#include "frontend/check/overloads.h"
#include "frontend/check/scope_table.h"
#include "frontend/check/symbols.h"
#include "frontend/check/tables.h"
#include "frontend/parse/ast.h"
#include "frontend/typing/conversion.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/program.h"

namespace clipc::check {

// The function body that is being checked.
struct Body {
  FunctionId function;
  TypeId return_type;
  ast::TypeId written_return_type;
  // The variable that `this` names; none if the function is not a method.
  VarId self;
  int loops = 0;
  int switches = 0;
  bool is_in_switch = false;  // whether the innermost loop or switch is a switch
  // Temporaries that the current statement needs and that are not declared yet.
  std::vector<VarId> temporaries;
  // The variables of loops that have ended, where they end with their loops.
  std::vector<SymbolId> ended;
  // Declarations to put before the first statement.
  std::vector<StmtId> hoisted;
};

// Where a call or an operation is in the text, and the name or the operator in it.
struct UseSpans {
  Span name, whole;
};

using Exprs = KeptVector<ExprId>;
using ExprSpan = std::span<const ExprId>;

// The state that all subjects of the checker share. A subject is a header of free functions over
// it.
//
// Declarations are entered under their names first, all of them; the meaning of a name is worked
// out when something reached first uses it, as seen from its declaration (View). So the code of
// other stages costs next to nothing. Function bodies wait in a queue, so calls do not nest.
struct Context final : TemporaryMaker {
  Context(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics);

  const ast::File& file;
  const CheckOptions& options;
  Diagnostics& diagnostics;
  Program program;
  TypeTable& types;  // of the program
  View view;
  ScopeTable names;
  Overloads functions;
  Structs structs;
  Globals globals;
  // The operands of casts of paths, by the expression that each became: cast_target.h.
  KeptMap<std::uint32_t, ast::ExprId> casts;
  // What is known of enum classes (enum_class.h): the enum of an expression and of a variable, none
  // for a number. They are empty if the file has no enum class.
  KeptMap<std::uint32_t, SymbolId> enum_values;
  KeptMap<std::uint32_t, SymbolId> enum_symbols;
  // The bit-fields that are read, by the expression that each became: bit_field.h.
  KeptMap<std::uint32_t, BitAccess> bits;
  // Expressions: large_literal.h and real_literal.h.
  std::unordered_map<std::uint32_t, std::int64_t> int_literals;
  std::unordered_map<std::uint32_t, double> real_literals;
  struct InfiniteLiteral {
    ExprId literal;
    double number;  // which a float does not hold
  };
  std::vector<InfiniteLiteral> infinite_literals;
  KeptVector<TypeId> numeric_types;  // by Name: float4x3 and the like, once looked up
  KeptVector<StmtId> stmts;          // the statements of the blocks in progress
  bool drops_value = false;          // whether the assignment checked next is a statement
  int depth = 0;                     // the weights of the RecursionGuards that are open
  bool is_too_large = false;         // whether RecursionGuard has reported that it is

  // The row that an id or a list stands for, in the table that has ids of this kind: a node of the
  // syntax tree, a node or variable of the program, a symbol, the text of a name.
  template <typename Key>
  decltype(auto) operator[](Key key) {
    return RowOf(*this, key);
  }
  template <typename Key>
  decltype(auto) operator[](Key key) const {
    return RowOf(*this, key);
  }
  // The node that an id stands for, as std::get, std::get_if and std::holds_alternative see it.
  template <typename Node, typename Id>
  auto& Get(Id id) {
    return std::get<Node>((*this)[id].node);
  }
  template <typename Node, typename Id>
  auto& Get(Id id) const {
    return std::get<Node>((*this)[id].node);
  }
  template <typename Node, typename Id>
  auto* GetIf(Id id) const {
    return std::get_if<Node>(&(*this)[id].node);
  }
  template <typename Node, typename Id>
  bool Is(Id id) const {
    return std::holds_alternative<Node>((*this)[id].node);
  }

  template <typename... Args>
  Diagnostic& Report(Span where, const diag::Kind<Args...>& kind,
                     const std::type_identity_t<Args>&... args) {
    return diagnostics.Report(where, kind, args...);
  }
  // Reports, and returns an expression of the error type, which silences errors that follow from
  // it.
  template <typename... Args>
  ExprId Fail(Span where, const diag::Kind<Args...>& kind,
              const std::type_identity_t<Args>&... args) {
    diagnostics.Report(where, kind, args...);
    return ErrorExpr(where);
  }
  // Reports, and returns the error type.
  template <typename... Args>
  TypeId FailType(Span where, const diag::Kind<Args...>& kind,
                  const std::type_identity_t<Args>&... args) {
    diagnostics.Report(where, kind, args...);
    return types.Error();
  }
  ExprId ErrorExpr(Span span) { return At(span).ZeroOf(types.Error()); }
  // Whether one of the types or expressions comes from an error, which was reported.
  bool IsError(auto first, auto... others) const {
    if constexpr (std::is_same_v<decltype(first), ExprId>) {
      return IsError(TypeIdOf(first), others...);
    } else {
      return first == types.Error() || (... || IsError(others));
    }
  }

  TypeId TypeIdOf(ExprId expr) const { return program.exprs[expr].type; }
  const Type& TypeOf(ExprId expr) const { return types[TypeIdOf(expr)]; }
  std::string TypeName(TypeId type) const { return types.Name(type); }
  std::string TypeName(ExprId expr) const { return TypeName(TypeIdOf(expr)); }
  // The view from a scope, outside of function bodies.
  View ViewFrom(ScopeId scope, std::uint32_t order) const {
    return {.scope = scope, .order = order, .local_floor = names.size()};
  }
  Builder At(Span span) { return Builder(program, span); }
  // Makes a local variable of the body in progress, or a static variable outside of functions.
  Temporary Make(ExprId value) override;

 private:
  template <typename Key>
  static decltype(auto) RowOf(auto& self, Key key) {
    auto& program = self.program;
    auto& file = self.file;
    return TableOf<Key>(program.exprs, program.types, program.vars, program.stmts,
                        program.functions, program.cbuffers, program.expr_lists, program.stmt_lists,
                        program.switch_cases, self.names, self.functions, self.globals.buffers,
                        file.names, file.exprs, file.stmts, file.decls, file.types, file.expr_lists,
                        file.stmt_lists, file.decl_lists, file.type_lists, file.name_lists,
                        file.attrs, file.registers, file.enumerators,
                        file.template_parameters)[key];
  }
  template <typename Key>
  static auto& TableOf(auto& table, auto&... others) {
    if constexpr (requires(Key key) { table[key]; }) {
      return table;
    } else {
      return TableOf<Key>(others...);
    }
  }
};

// A change of view: during its life the checker looks from `view`.
class ViewSwitch : NotCopied {
 public:
  ViewSwitch(Context& context, const View& view)
      : context_(context), saved_(std::exchange(context.view, view)) {}
  ~ViewSwitch() { context_.view = saved_; }

 private:
  Context& context_;
  View saved_;
};

// Whether a value of the type is an object or a string, or holds one.
bool IsOrHoldsObject(const Context& context, TypeId id);

// One level of the checker's own recursion. It is not ok if there are too many levels, or if the
// program has become too large; it reports both.
class RecursionGuard : NotCopied {
 public:
  // The weight of a declaration that is resolved on the way; the weight of an expression is 1.
  static constexpr int kDeclaration = 8;

  RecursionGuard(Context& context, Span where, int weight = 1)
      : context_(context), weight_(weight) {
    context.depth += weight;
    ok_ = context.depth <= kMaxCheckDepth && context.program.exprs.size() <= kMaxCheckedExpressions;
    if (!ok_) Report(where);
  }
  ~RecursionGuard() { context_.depth -= weight_; }
  bool ok() const { return ok_; }

 private:
  // The limit on the levels of expressions, statements and declarations inside each other. The
  // checker's frames are small enough for a stack of 8 MiB, with sanitizers too.
  static constexpr int kMaxCheckDepth = 2500;
  // The limit on the expressions of a program. A cast of a struct is an expression for each of its
  // leaves, so a short text may make many.
  static constexpr std::size_t kMaxCheckedExpressions = std::size_t{1} << 22;

  void Report(Span where);

  Context& context_;
  int weight_;
  bool ok_;
};

}  // namespace clipc::check
