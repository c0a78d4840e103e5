// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/scope_table.h"

#include <algorithm>

namespace clipc::check {
namespace {

constexpr int kMaxScopeNesting = 64;  // of `using namespace` and base structs

std::uint64_t KeyOf(ScopeId scope, Name name) {
  return std::uint64_t{scope.index} << 32 | name.index;
}

}  // namespace

ScopeTable::ScopeTable(std::size_t name_count, const View& view)
    : view_(view), global_(AddScope(ScopeKind::kNamespace, {}, {})), local_by_name_(name_count) {}

ScopeId ScopeTable::AddScope(ScopeKind kind, ScopeId parent, Name name, std::uint32_t order) {
  return scopes_.Add({kind, parent, name, order, {}, {}});
}

SymbolId ScopeTable::Declare(SymbolKind kind, ScopeId scope, Name name, ast::DeclId decl,
                             Span span) {
  const SymbolId id = symbols_.Add(
      {.kind = kind, .name = name, .scope = scope, .older = {}, .decl = decl, .span = span});
  if (name) {
    const auto [slot, is_new] = newest_.try_emplace(KeyOf(scope, name), id);
    if (!is_new) symbols_[id].older = std::exchange(slot->second, id);
  }
  return id;
}

SymbolId ScopeTable::DeclareLocal(SymbolKind kind, Name name, ast::DeclId decl, Span span) {
  const SymbolId id = symbols_.Add(
      {.kind = kind, .name = name, .scope = {}, .older = {}, .decl = decl, .span = span});
  if (name) {
    symbols_[id].older = std::exchange(local_by_name_[name.index], id);
    locals_.push_back(id);
  }
  return id;
}

bool ScopeTable::IsVisible(SymbolId id) const {
  return id.index < view_.order || scopes_[symbols_[id].scope].kind != ScopeKind::kNamespace;
}

SymbolId ScopeTable::NewestIn(ScopeId scope, Name name) const {
  const auto found = newest_.find(KeyOf(scope, name));
  return found == newest_.end() ? SymbolId{} : found->second;
}

SymbolId ScopeTable::FindIn(ScopeId scope, Name name, bool types_only) const {
  for (SymbolId id = NewestIn(scope, name); id; id = symbols_[id].older) {
    if (types_only && symbols_[id].kind != SymbolKind::kType) continue;
    if (IsVisible(id)) return id;
  }
  return {};
}

SymbolId ScopeTable::FindNested(ScopeId scope, Name name, bool types_only, int depth) const {
  if (const SymbolId id = FindIn(scope, name, types_only)) return id;
  if (depth >= kMaxScopeNesting) return {};
  for (ScopeId nested : scopes_[scope].nested) {
    if (const SymbolId id = FindNested(nested, name, types_only, depth + 1)) return id;
  }
  return {};
}

void ScopeTable::Use(ScopeId scope, ScopeId used, bool is_local) {
  while (scopes_[scope].kind != ScopeKind::kNamespace) scope = scopes_[scope].parent;
  scopes_[scope].nested.push_back(used);
  if (is_local) local_uses_.push_back(scope);
  uses_any_ = true;
}

ScopeId ScopeTable::CommonScope(ScopeId one, ScopeId other) const {
  for (; one; one = scopes_[one].parent) {
    for (ScopeId scope = other; scope; scope = scopes_[scope].parent) {
      if (scope == one) return one;
    }
  }
  return global_;
}

// Adds the namespaces that a scope uses, and those that they use.
void ScopeTable::AddUsed(ScopeId scope, std::vector<Used>& used) const {
  std::vector<ScopeId> open = {scope};
  while (!open.empty()) {
    const ScopeId user = open.back();
    open.pop_back();
    if (scopes_[user].kind != ScopeKind::kNamespace) continue;
    for (const ScopeId space : scopes_[user].nested) {
      if (std::ranges::find(used, space, &Used::space) != used.end()) continue;
      used.push_back({space, CommonScope(scope, space)});
      open.push_back(space);
    }
  }
}

std::vector<SymbolId> ScopeTable::FindAllUnqualified(Name name, bool types_only) const {
  for (SymbolId id = InnermostLocal(name); id && id.index >= view_.local_floor;
       id = symbols_[id].older) {
    if (!types_only || symbols_[id].kind == SymbolKind::kType) return {id};
  }
  std::vector<SymbolId> found;
  std::vector<Used> used;
  for (ScopeId scope = view_.scope; scope && found.empty(); scope = scopes_[scope].parent) {
    if (scopes_[scope].kind != ScopeKind::kNamespace) {
      if (const SymbolId id = FindNested(scope, name, types_only)) found.push_back(id);
      continue;
    }
    AddUsed(scope, used);
    if (const SymbolId id = FindIn(scope, name, types_only)) found.push_back(id);
    for (const Used& one : used) {
      if (one.at != scope) continue;
      if (const SymbolId id = FindIn(one.space, name, types_only)) found.push_back(id);
    }
  }
  return found;
}

std::vector<SymbolId> ScopeTable::FindAllNested(ScopeId scope, Name name, bool types_only) const {
  if (const SymbolId id = FindIn(scope, name, types_only)) return {id};
  if (scopes_[scope].kind != ScopeKind::kNamespace) {
    const SymbolId id = FindNested(scope, name, types_only);
    return id ? std::vector{id} : std::vector<SymbolId>{};
  }
  std::vector<SymbolId> found;
  std::vector<Used> used;
  AddUsed(scope, used);
  for (const Used& one : used) {
    if (const SymbolId id = FindIn(one.space, name, types_only)) found.push_back(id);
  }
  return found;
}

SymbolId ScopeTable::FindUnqualified(Name name, bool types_only) const {
  if (uses_any_) {
    const std::vector<SymbolId> found = FindAllUnqualified(name, types_only);
    return found.empty() ? SymbolId{} : found.front();
  }
  for (SymbolId id = InnermostLocal(name); id && id.index >= view_.local_floor;
       id = symbols_[id].older) {
    if (!types_only || symbols_[id].kind == SymbolKind::kType) return id;
  }
  for (ScopeId scope = view_.scope; scope; scope = scopes_[scope].parent) {
    if (const SymbolId id = FindNested(scope, name, types_only)) return id;
  }
  return {};
}

ScopeTable::LocalScope::LocalScope(ScopeTable& table)
    : table_(table), mark_(table.locals_.size()), uses_(table.local_uses_.size()) {
  table.scope_starts_.push_back(table.size());
}

ScopeTable::LocalScope::~LocalScope() {
  table_.scope_starts_.pop_back();
  for (; table_.local_uses_.size() > uses_; table_.local_uses_.pop_back())
    table_[table_.local_uses_.back()].nested.pop_back();
  while (table_.locals_.size() > mark_) {
    const Symbol& symbol = table_[table_.locals_.back()];
    table_.local_by_name_[symbol.name.index] = symbol.older;
    table_.locals_.pop_back();
  }
}

}  // namespace clipc::check
