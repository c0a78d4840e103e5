// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <unordered_map>

#include "base/kept_blocks.h"
#include "base/not_copied.h"
#include "frontend/check/symbols.h"

namespace clipc::check {

struct Body;

// The place that the checker looks from, which decides the meaning of a name.
struct View {
  ScopeId scope;
  // The order of the first symbol of a namespace that is not declared yet.
  std::uint32_t order = ~0u;
  // The index of the first symbol that may be a local of this function; locals before it belong to
  // other functions.
  std::uint32_t local_floor = 0;
  // The function body that is being checked; null outside functions.
  Body* body = nullptr;
  // Whether a `const` global stands for its initialiser.
  bool wants_constant = false;
};

// All symbols, by scope and name. Looking a name up finds the symbol that can be seen from `view`,
// which belongs to the caller and may change between calls.
class ScopeTable {
 public:
  ScopeTable(std::size_t name_count, const View& view);

  Symbol& operator[](SymbolId id) { return symbols_[id]; }
  const Symbol& operator[](SymbolId id) const { return symbols_[id]; }
  Scope& operator[](ScopeId id) { return scopes_[id]; }
  const Scope& operator[](ScopeId id) const { return scopes_[id]; }
  auto symbol_ids() const { return symbols_.ids(); }
  auto scope_ids() const { return scopes_.ids(); }
  // The number of symbols, which is the index of the next one.
  std::uint32_t size() const { return symbols_.size(); }
  ScopeId global() const { return global_; }

  // Adds a scope whose members see the symbols of namespaces before `order`.
  ScopeId AddScope(ScopeKind kind, ScopeId parent, Name name, std::uint32_t order = ~0u);
  // Adds a symbol to the scope. A symbol without a name cannot be found.
  SymbolId Declare(SymbolKind kind, ScopeId scope, Name name, ast::DeclId decl, Span span);
  // Adds a symbol that is found until the LocalScope in which it was declared ends.
  SymbolId DeclareLocal(SymbolKind kind, Name name, ast::DeclId decl, Span span);

  // The last symbol of the name in the scope, whether it can be seen or not; none if the scope does
  // not declare the name.
  SymbolId NewestIn(ScopeId scope, Name name) const;
  // The symbol of the name in the scope itself; none if the scope does not declare the name.
  SymbolId FindIn(ScopeId scope, Name name, bool types_only = false) const;
  // The symbol of the name in the scope, in the scopes of its base structs, or in the namespaces
  // that it uses; none if they do not declare the name.
  SymbolId FindNested(ScopeId scope, Name name, bool types_only = false, int depth = 0) const;
  // The symbol that a name without `::` means; none if it means nothing.
  SymbolId FindUnqualified(Name name, bool types_only = false) const;

  // Makes the names of a namespace visible in a scope, as `using namespace` does; inside a function
  // until the LocalScope ends that began last.
  void Use(ScopeId scope, ScopeId used, bool is_local);
  // Whether a `using namespace` is written: one name may mean several symbols only then.
  bool uses_any() const { return uses_any_; }
  // All symbols of which FindUnqualified, and FindNested, give the first: each the newest of its
  // scope. They are of different namespaces, of which `using namespace` makes one set
  // ([namespace.udir] and [namespace.qual] of C++).
  std::vector<SymbolId> FindAllUnqualified(Name name, bool types_only = false) const;
  std::vector<SymbolId> FindAllNested(ScopeId scope, Name name, bool types_only = false) const;
  // The local of the name that hides all others; none if no local has the name.
  SymbolId InnermostLocal(Name name) const { return local_by_name_[name.index]; }
  // Whether the local was declared in the LocalScope that began last.
  bool IsInLastScope(SymbolId local) const {
    return !scope_starts_.empty() && local.index >= scope_starts_.back();
  }
  bool IsVisible(SymbolId id) const;
  // The locals that have not been forgotten, in the order of their declarations.
  std::span<const SymbolId> locals() const { return locals_; }

  // A block: the locals that are declared during its life are forgotten at its end.
  class LocalScope : NotCopied {
   public:
    explicit LocalScope(ScopeTable& table);
    ~LocalScope();

   private:
    ScopeTable& table_;
    std::size_t mark_, uses_;
  };

 private:
  // A namespace whose names are visible, and the scope in which they seem to be declared.
  struct Used {
    ScopeId space, at;
  };
  void AddUsed(ScopeId scope, std::vector<Used>& used) const;
  ScopeId CommonScope(ScopeId one, ScopeId other) const;

  const View& view_;
  Arena<Symbol> symbols_;
  Arena<Scope> scopes_;
  ScopeId global_;
  // The memory of the symbols of most shaders, which so ask for none.
  std::array<std::byte, 4096> first_memory_;
  std::pmr::monotonic_buffer_resource memory_{first_memory_.data(), first_memory_.size()};
  std::pmr::unordered_map<std::uint64_t, SymbolId> newest_{64, &memory_};  // by scope and name
  KeptVector<SymbolId> local_by_name_;                                     // by Name: the innermost
  KeptVector<SymbolId> locals_;
  KeptVector<std::uint32_t> scope_starts_;  // the number of symbols at each LocalScope's start
  KeptVector<ScopeId> local_uses_;  // the scopes that `using namespace` in functions changed
  bool uses_any_ = false;
};

}  // namespace clipc::check
