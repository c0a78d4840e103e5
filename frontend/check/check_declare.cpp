// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/overloaded.h"
#include "frontend/check/checker.h"

// Entering the declarations of namespaces under their names; nothing is resolved yet.
namespace clipc {

ScopeId Checker::AddScope(ScopeKind kind, ScopeId parent, Name name, std::uint32_t order) {
  Scope scope;
  scope.order = order;
  scope.kind = kind;
  scope.parent = parent;
  scope.name = name;
  return scopes_.Add(std::move(scope));
}

void Checker::DeclareAll(std::span<const ast::DeclId> decls, ScopeId scope) {
  for (ast::DeclId id : decls) DeclareOne(id, scope);
}

void Checker::DeclareOne(ast::DeclId id, ScopeId scope) {
  const ast::Decl& decl = file_.decls[id];
  Visit(Overloaded{
            [&](const ast::VarDecl& var) { DeclareVar(id, var, scope); },
            [&](const ast::FunctionDecl& function) { DeclareFunction(id, function, scope); },
            [&](const ast::StructDecl& structure) { DeclareStruct(id, structure, scope); },
            [&](const ast::TypedefDecl& alias) {
              DeclareTypeInside(alias.type, scope);
              Declare(SymbolKind::kType, scope, alias.name, id, alias.name_span);
            },
            [&](const ast::BufferDecl& buffer) { DeclareBuffer(id, buffer, scope); },
            [&](const ast::NamespaceDecl& space) { DeclareNamespace(space, decl.span, scope); },
            [&](const ast::EnumDecl& enumeration) { DeclareEnum(id, enumeration, scope); },
            [&](const ast::UsingDecl& use) { DeclareUsing(use, decl.span, scope); },
        },
        decl.node);
}

// `struct S {...} x;` declares S too.
void Checker::DeclareTypeInside(ast::TypeId type, ScopeId scope) {
  if (!type) return;
  const ast::DeclId definition = file_.types[type].struct_definition;
  if (!definition || struct_symbols_.contains(definition.index)) return;
  const std::uint32_t next = symbols_.size();
  DeclareOne(definition, scope);
  // The definition of what was declared before is no new symbol.
  const SymbolId symbol =
      symbols_.size() > next ? SymbolId{next} : FindIn(scope, file_.types[type].name.name, true);
  struct_symbols_.emplace(definition.index, symbol);
}

void Checker::DeclareVar(ast::DeclId id, const ast::VarDecl& var, ScopeId scope) {
  DeclareTypeInside(var.type, scope);
  const SymbolId older = FindIn(scope, var.name);
  const SymbolId symbol = Declare(SymbolKind::kVariable, scope, var.name, id, var.name_span);
  if (older && symbols_[older].kind == SymbolKind::kVariable) {
    const bool is_extern = (var.qualifiers & ast::kExtern) != 0;
    if (!is_extern) ReportRedefinition(older, var.name, var.name_span);
  }
  if (!(var.qualifiers & (ast::kStatic | ast::kGroupShared)))
    buffers_[globals_buffer_].members.push_back(symbol);
}

void Checker::DeclareBuffer(ast::DeclId id, const ast::BufferDecl& buffer, ScopeId scope) {
  Buffer entry;
  entry.decl = id;
  entry.kind = buffer.kind == ast::BufferKind::kCbuffer ? ir::CbufferKind::kCbuffer
                                                        : ir::CbufferKind::kTbuffer;
  entry.scope = scope;
  const BufferId buffer_id = buffers_.Add(entry);
  std::vector<SymbolId> members;
  members.reserve(buffer.members.size);
  for (std::uint32_t i = 0; i < buffer.members.size; ++i) {
    const ast::DeclId member = file_.decl_lists[buffer.members][i];
    const auto* var = std::get_if<ast::VarDecl>(&file_.decls[member].node);
    if (!var || (var->qualifiers & ast::kStatic)) {
      DeclareOne(member, scope);
      continue;
    }
    DeclareTypeInside(var->type, scope);
    const SymbolId older = FindIn(scope, var->name);
    if (older && symbols_[older].kind == SymbolKind::kVariable)
      ReportRedefinition(older, var->name, var->name_span);
    const SymbolId symbol =
        Declare(SymbolKind::kVariable, scope, var->name, member, var->name_span);
    symbols_[symbol].owner = buffer_id.index;
    members.push_back(symbol);
  }
  buffers_[buffer_id].members = std::move(members);
  buffers_[buffer_id].order = symbols_.size();
}

// A namespace may be opened several times.
void Checker::DeclareNamespace(const ast::NamespaceDecl& space, Span span, ScopeId scope) {
  const SymbolId older = space.name ? FindIn(scope, space.name) : SymbolId{};
  ScopeId inner;
  if (older && symbols_[older].kind == SymbolKind::kNamespace) {
    inner = ScopeId{symbols_[older].value};
  } else {
    inner = AddScope(ScopeKind::kNamespace, scope, space.name);
    const SymbolId symbol =
        Declare(SymbolKind::kNamespace, scope, space.name, {}, space.name ? space.name_span : span);
    symbols_[symbol].value = inner.index;
    symbols_[symbol].resolution = Resolution::kDone;
    if (!space.name) scopes_[scope].nested.push_back(inner);
  }
  for (std::uint32_t i = 0; i < space.members.size; ++i)
    DeclareOne(file_.decl_lists[space.members][i], inner);
}

// `using namespace a;` makes the names of `a` visible in this scope, `using a::b;` gives one of
// them a second home.
void Checker::DeclareUsing(const ast::UsingDecl& use, Span span, ScopeId scope) {
  ContextSwitch in(*this, {.scope = scope});
  const SymbolId target = Find(use.name);
  if (!target) {
    ReportUndeclared(span, use.name, false, false);
  } else if (!use.is_namespace) {
    const Symbol found = symbols_[target];
    const SymbolId alias = Declare(found.kind, scope, use.name.name, found.decl, found.span);
    symbols_[alias].owner = found.owner;
    symbols_[alias].value = found.value;
    symbols_[alias].resolution = found.resolution;
  } else if (symbols_[target].kind == SymbolKind::kNamespace) {
    scopes_[scope].nested.push_back(ScopeId{symbols_[target].value});
  } else {
    diagnostics_.Report(span, diag::NoSuchScope, QualifiedText(use.name));
  }
}

// A forward declaration and the definition are one symbol, the definition's declaration.
void Checker::DeclareStruct(ast::DeclId id, const ast::StructDecl& decl, ScopeId scope) {
  const SymbolId older = decl.name ? FindIn(scope, decl.name, true) : SymbolId{};
  const auto* before =
      older ? std::get_if<ast::StructDecl>(&file_.decls[symbols_[older].decl].node) : nullptr;
  if (before && !decl.template_arguments.empty()) {
    Declare(SymbolKind::kType, scope, decl.name, id, decl.name_span);
    return;
  }
  if (before && !decl.is_definition) return;
  if (before && !before->is_definition) {
    symbols_[older].decl = id;
    return;
  }
  if (before) ReportRedefinition(older, decl.name, decl.name_span);
  Declare(SymbolKind::kType, scope, decl.name, id, decl.name_span);
}

void Checker::DeclareEnum(ast::DeclId id, const ast::EnumDecl& decl, ScopeId scope) {
  const SymbolId symbol = Declare(SymbolKind::kType, scope, decl.name, id, decl.name_span);
  const ScopeId inner = decl.is_class ? AddScope(ScopeKind::kEnum, scope, decl.name) : scope;
  // `E::a` is fine for a plain enum, too.
  const ScopeId own = decl.is_class ? inner : AddScope(ScopeKind::kEnum, scope, decl.name);
  symbols_[symbol].owner = own.index;
  for (std::uint32_t i = 0; i < decl.enumerators.size; ++i) {
    const ast::Enumerator& enumerator = file_.enumerators[decl.enumerators][i];
    const SymbolId value =
        Declare(SymbolKind::kEnumerator, inner, enumerator.name, id, enumerator.span);
    symbols_[value].owner = symbol.index;
    symbols_[value].value = i;
    if (decl.is_class) continue;
    const SymbolId again =
        Declare(SymbolKind::kEnumerator, own, enumerator.name, id, enumerator.span);
    symbols_[again].owner = symbol.index;
    symbols_[again].value = i;
  }
}

void Checker::DeclareFunction(ast::DeclId id, const ast::FunctionDecl& decl, ScopeId scope) {
  DeclareTypeInside(decl.return_type, scope);
  if (decl.out_of_line_of.name) {
    out_of_line_[decl.name.index].push_back(id);
    return;
  }
  Declare(SymbolKind::kFunction, scope, decl.name, id, decl.name_span);
}

}  // namespace clipc
