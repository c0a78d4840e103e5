// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/enum.h"

#include "frontend/check/type.h"
#include "frontend/check/value.h"

namespace clipc::check {
void DeclareEnum(Context& context, ast::DeclId id, const ast::EnumDecl& decl, ScopeId scope) {
  const SymbolId symbol =
      context.names.Declare(SymbolKind::kType, scope, decl.name, id, decl.name_span);
  const ScopeId inner =
      decl.is_class ? context.names.AddScope(ScopeKind::kEnum, scope, decl.name) : scope;
  // `E::a` is fine for a plain enum, too.
  const ScopeId own =
      decl.is_class ? inner : context.names.AddScope(ScopeKind::kEnum, scope, decl.name);
  context[symbol].owner = own.index;
  for (std::uint32_t i = 0; i < decl.enumerators.size; ++i) {
    const ast::Enumerator& enumerator = context[decl.enumerators][i];
    const SymbolId value =
        context.names.Declare(SymbolKind::kEnumerator, inner, enumerator.name, id, enumerator.span);
    context[value].owner = symbol.index;
    context[value].value = i;
    if (decl.is_class) continue;
    const SymbolId again =
        context.names.Declare(SymbolKind::kEnumerator, own, enumerator.name, id, enumerator.span);
    context[again].owner = symbol.index;
    context[again].value = i;
  }
}

ir::TypeId EnumType(Context& context, const ast::EnumDecl& decl) {
  if (!decl.underlying) return context.program.types.Make(ir::Scalar::kInt);
  const ir::TypeId type = ResolveType(context, decl.underlying);
  const ir::Type& underlying = context[type];
  if (underlying.kind == ir::TypeKind::kScalar && ir::IsInteger(underlying.scalar)) return type;
  if (underlying.kind == ir::TypeKind::kScalar && underlying.scalar == ir::Scalar::kBool)
    return type;
  if (!context.IsError(type)) {
    context.Report(context[decl.underlying].span, diag::EnumNotInteger, context.TypeName(type));
  }
  return context.program.types.Make(ir::Scalar::kInt);
}

void ResolveEnum(Context& context, SymbolId id, const ast::EnumDecl& decl) {
  if (!context.structs.enum_values.try_emplace(id.index).second) return;
  View view = ContextOf(context, id);
  view.scope = ScopeId{context[id].owner};
  const ViewSwitch in(context, view);
  std::int64_t next = 0;
  for (const ast::Enumerator& enumerator : context[decl.enumerators]) {
    if (enumerator.value) next = ConstantInteger(context, enumerator.value).value_or(next);
    context.structs.enum_values[id.index].push_back(static_cast<std::uint32_t>(next++));
  }
}

}  // namespace clipc::check
