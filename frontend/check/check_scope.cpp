// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/checker.h"
#include "frontend/rules/intrinsics.h"

// Names: entering them, finding them, and what to say when they are not found.
namespace clipc {
namespace {

constexpr int kMaxScopeNesting = 64;  // of `using namespace` and base structs

std::uint64_t KeyOf(ScopeId scope, Name name) {
  return std::uint64_t{scope.index} << 32 | name.index;
}

}  // namespace

SymbolId Checker::Declare(SymbolKind kind, ScopeId scope, Name name, ast::DeclId decl, Span span) {
  Symbol symbol;
  symbol.kind = kind;
  symbol.name = name;
  symbol.scope = scope;
  symbol.decl = decl;
  symbol.span = span;
  const SymbolId id{symbols_.size()};
  if (name) {
    auto [slot, is_new] = by_scope_and_name_.try_emplace(KeyOf(scope, name), id);
    if (!is_new) {
      symbol.older = slot->second;
      slot->second = id;
    }
  }
  return symbols_.Add(symbol);
}

SymbolId Checker::DeclareLocal(SymbolKind kind, Name name, ast::DeclId decl, Span span) {
  Symbol symbol;
  symbol.kind = kind;
  symbol.name = name;
  symbol.decl = decl;
  symbol.span = span;
  if (!name) return symbols_.Add(symbol);
  SymbolId& innermost = local_by_name_[name.index];
  const bool same_scope =
      innermost && !local_scopes_.empty() && innermost.index >= local_scopes_.back();
  if (same_scope && !symbols_[innermost].is_leaked) ReportRedefinition(innermost, name, span);
  symbol.older = innermost;
  innermost = symbols_.Add(symbol);
  locals_.push_back(innermost);
  return innermost;
}

void Checker::ForgetLocals(std::size_t mark) {
  while (locals_.size() > mark) {
    const Symbol& symbol = symbols_[locals_.back()];
    local_by_name_[symbol.name.index] = symbol.older;
    locals_.pop_back();
  }
}

bool Checker::IsVisible(SymbolId id) const {
  const Symbol& symbol = symbols_[id];
  return id.index < context_.order || scopes_[symbol.scope].kind != ScopeKind::kNamespace;
}

SymbolId Checker::FindIn(ScopeId scope, Name name, bool types_only) const {
  const auto found = by_scope_and_name_.find(KeyOf(scope, name));
  if (found == by_scope_and_name_.end()) return {};
  for (SymbolId id = found->second; id; id = symbols_[id].older) {
    if (types_only && symbols_[id].kind != SymbolKind::kType) continue;
    if (IsVisible(id)) return id;
  }
  return {};
}

// In a scope, the scopes of its base structs and the namespaces it uses.
SymbolId Checker::FindNested(ScopeId scope, Name name, bool types_only, int depth) const {
  if (const SymbolId id = FindIn(scope, name, types_only)) return id;
  if (depth >= kMaxScopeNesting) return {};
  for (ScopeId nested : scopes_[scope].nested) {
    if (const SymbolId id = FindNested(nested, name, types_only, depth + 1)) return id;
  }
  return {};
}

SymbolId Checker::FindUnqualified(Name name, bool types_only) const {
  for (SymbolId id = local_by_name_[name.index]; id && id.index >= context_.local_floor;
       id = symbols_[id].older) {
    if (!types_only || symbols_[id].kind == SymbolKind::kType) return id;
  }
  for (ScopeId scope = context_.scope; scope; scope = scopes_[scope].parent) {
    if (const SymbolId id = FindNested(scope, name, types_only, 0)) return id;
  }
  return {};
}

// The scope that `a::b::` names; none, and which name was missing in which scope, when there is no
// such scope.
ScopeId Checker::FindScope(const ast::QualifiedName& name, ScopeId* missing_in, Name* missing) {
  ScopeId scope = name.from_global ? global_scope_ : ScopeId{};
  for (std::uint32_t i = 0; i < name.scopes.size; ++i) {
    const Name part = file_.name_lists[name.scopes][i];
    const SymbolId id = scope ? FindNested(scope, part, false, 0) : FindUnqualified(part);
    *missing_in = scope;
    *missing = part;
    if (!id) return {};
    scope = ScopeOf(id);
    if (!scope) return {};
  }
  return scope;
}

// The scope a symbol opens: of a namespace, a struct, an enum, a typedef of one of them.
ScopeId Checker::ScopeOf(SymbolId id) {
  switch (symbols_[id].kind) {
    case SymbolKind::kNamespace: return ScopeId{symbols_[id].value};
    case SymbolKind::kType: {
      const ir::TypeId type = ResolveTypeSymbol(id);
      if (symbols_[id].owner != ~0u) return ScopeId{symbols_[id].owner};
      const StructInfo* info = InfoOf(type);
      return info ? info->scope : ScopeId{};
    }
    default: return {};
  }
}

// None when there is nothing of that name; nothing is reported.
SymbolId Checker::Find(const ast::QualifiedName& name, bool types_only) {
  if (name.scopes.empty() && !name.from_global) return FindUnqualified(name.name, types_only);
  ScopeId missing_in;
  Name missing;
  const ScopeId scope = FindScope(name, &missing_in, &missing);
  return scope ? FindNested(scope, name.name, types_only, 0) : SymbolId{};
}

// What a use would have found if it stood at the end of the text.
SymbolId Checker::FindLater(Name name) const {
  for (ScopeId scope = context_.scope; scope; scope = scopes_[scope].parent) {
    const auto found = by_scope_and_name_.find(KeyOf(scope, name));
    if (found != by_scope_and_name_.end()) return found->second;
  }
  return {};
}

std::string Checker::QualifiedText(const ast::QualifiedName& name) const {
  std::string text = name.from_global ? "::" : "";
  for (std::uint32_t i = 0; i < name.scopes.size; ++i) {
    text += Text(file_.name_lists[name.scopes][i]);
    text += "::";
  }
  return text += Text(name.name);
}

// The names that can be seen from here and are nearly `name`: "`a`, `b`"; empty when there is none.
std::string Checker::NearText(Name name, bool types_only, bool functions_only) const {
  std::vector<std::string_view> candidates;
  for (SymbolId id : symbols_.ids()) {
    const Symbol& symbol = symbols_[id];
    if (!symbol.name || symbol.name == name) continue;
    if (types_only && symbol.kind != SymbolKind::kType) continue;
    if (functions_only && symbol.kind != SymbolKind::kFunction) continue;
    if (symbol.scope ? !IsVisible(id) : local_by_name_[symbol.name.index] != id) continue;
    candidates.push_back(Text(symbol.name));
  }
  std::vector<std::string_view> near = NearNames(Text(name), candidates);
  if (functions_only) {
    for (std::string_view intrinsic : NearIntrinsics(Text(name))) {
      if (near.size() < 3) near.push_back(intrinsic);
    }
  }
  std::string text;
  for (std::string_view candidate : near)
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", candidate);
  return text;
}

void Checker::ReportUndeclared(Span span, const ast::QualifiedName& name, bool as_type,
                               bool as_function) {
  ScopeId missing_in;
  Name missing;
  if (!name.scopes.empty() && !FindScope(name, &missing_in, &missing)) {
    diagnostics_.Report(span, diag::NoSuchScope, Text(missing));
    return;
  }
  const SymbolId later = name.scopes.empty() ? FindLater(name.name) : SymbolId{};
  const std::string near = later ? "" : NearText(name.name, as_type, as_function);
  const std::string tail = later          ? "; a name must be declared before its use"
                           : near.empty() ? ""
                                          : fmt::format("; did you mean {}?", near);
  const std::string text = QualifiedText(name);
  Diagnostic& report = as_type       ? diagnostics_.Report(span, diag::UnknownType, text, tail)
                       : as_function ? diagnostics_.Report(span, diag::UnknownFunction, text, tail)
                                     : diagnostics_.Report(span, diag::UndeclaredName, text, tail);
  if (later) report.Note(symbols_[later].span, diag::DeclaredHere, Text(name.name));
  const bool is_one = !near.empty() && near.find(',') == std::string::npos && name.scopes.empty();
  if (is_one) report.Fix(span, near.substr(1, near.size() - 2));
}

void Checker::ReportRedefinition(SymbolId older, Name name, Span span) {
  diagnostics_.Report(span, diag::Redefinition, Text(name))
      .Note(symbols_[older].span, diag::DeclaredHere, Text(name));
}

}  // namespace clipc
