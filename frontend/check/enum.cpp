// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/enum.h"

#include "frontend/check/scope.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"

namespace clipc::check {

SymbolId DeclareEnum(Context& context, ast::DeclId id, const ast::EnumDecl& decl, ScopeId scope) {
  const auto declare = [&](SymbolKind kind, Name name, Span span) {
    return scope ? context.names.Declare(kind, scope, name, id, span)
                 : DeclareLocal(context, kind, name, id, span);
  };
  const SymbolId symbol = declare(SymbolKind::kType, decl.name, decl.name_span);
  // `E::a` is a name for every enum, a plain `a` only for enums that are not classes.
  const ScopeId own = scope ? context.names.AddScope(ScopeKind::kEnum, scope, decl.name)
                            : context.names.AddScope(ScopeKind::kEnum, context.view.scope,
                                                     decl.name, context.view.order);
  context[symbol].owner = own.index;
  std::uint32_t number = 0;
  const auto add = [&](SymbolId enumerator) {
    context[enumerator].owner = symbol.index;
    context[enumerator].value = number;
  };
  for (const ast::Enumerator& enumerator : context[decl.enumerators]) {
    if (!decl.is_class) add(declare(SymbolKind::kEnumerator, enumerator.name, enumerator.span));
    add(context.names.Declare(SymbolKind::kEnumerator, own, enumerator.name, id, enumerator.span));
    ++number;
  }
  return symbol;
}

TypeId EnumType(Context& context, const ast::EnumDecl& decl) {
  if (!decl.underlying) return context.types.Make(Scalar::kInt);
  const TypeId type = ResolveType(context, decl.underlying);
  const Type& underlying = context[type];
  const bool is_integer = IsInteger(underlying.scalar) || underlying.scalar == Scalar::kBool;
  if (underlying.kind == TypeKind::kScalar && is_integer) return type;
  if (!context.IsError(type)) {
    context.Report(context[decl.underlying].span, diag::EnumNotInteger, context.TypeName(type));
  }
  return context.types.Make(Scalar::kInt);
}

void ResolveEnum(Context& context, SymbolId id, const ast::EnumDecl& decl) {
  if (!context.structs.enum_values.try_emplace(id.index).second) return;
  View view = ViewOf(context, id);
  view.scope = ScopeId{context[id].owner};
  const ViewSwitch in(context, view);
  std::int64_t next = 0;
  for (const ast::Enumerator& enumerator : context[decl.enumerators]) {
    if (enumerator.value) next = ConstantInteger(context, enumerator.value).value_or(next);
    context.structs.enum_values[id.index].push_back(next);
    next = static_cast<std::int64_t>(static_cast<std::uint64_t>(next) + 1);
  }
}

}  // namespace clipc::check
