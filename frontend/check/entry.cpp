// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/entry.h"

#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/function.h"
#include "frontend/check/scope.h"
#include "frontend/check/text.h"

namespace clipc::check {
namespace {

// The parts of a qualified name: "NS::main" => {"NS", "main"}.
std::vector<std::string_view> SplitQualified(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t colons = text.find("::");
    if (colons != 0) parts.push_back(text.substr(0, colons));
    if (colons == std::string_view::npos) return parts;
    text.remove_prefix(colons + 2);
  }
}

// The name of the file that has the text `text`; none if the file does not use it.
Name NameOf(const Context& context, std::string_view text) {
  for (std::uint32_t i = 0; i < context.file.names.size(); ++i) {
    if (context[Name{i}] == text) return Name{i};
  }
  return {};
}

// The functions of the name in the scope that have a body and are not templates.
std::vector<SymbolId> EntriesIn(const Context& context, ScopeId scope, Name name) {
  std::vector<SymbolId> found;
  for (SymbolId id = context.names.FindIn(scope, name); id; id = context[id].older) {
    if (context[id].kind != SymbolKind::kFunction) continue;
    const auto& decl = DeclOf(context, id);
    if (decl.body && !decl.is_template) found.push_back(id);
  }
  std::ranges::reverse(found);
  return found;
}

// Whether a struct with the type's name, in any scope, has a field with a semantic.
bool HasSemantics(const Context& context, ast::TypeId type) {
  const auto has_semantic = [&](ast::DeclId member) {
    const auto* field = context.GetIf<ast::VarDecl>(member);
    return field && field->semantic.name;
  };
  const Name name = context[type].name.name;
  for (const ast::DeclId id : context.file.decls.ids()) {
    const auto* structure = context.GetIf<ast::StructDecl>(id);
    if (structure && structure->name == name &&
        std::ranges::any_of(context[structure->members], has_semantic))
      return true;
  }
  return false;
}

bool IsLikelyEntry(const Context& context, const ast::FunctionDecl& decl) {
  return decl.body && (!decl.attributes.empty() || MayBeEntry(context, decl));
}

// The first functions that techniques of the file compile for the stage.
std::vector<std::string_view> CompiledByTechniques(const Context& context) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string_view> names;
  for (const auto& [function, stage] : context.file.technique_shaders) {
    if (stage == context.program.stage && names.size() < kMost) names.push_back(context[function]);
  }
  return names;
}

void ReportNoEntry(Context& context, const std::string& entry) {
  std::vector<std::string> names, likely;
  std::vector<Span> places;
  for (SymbolId id : context.names.symbol_ids()) {
    if (context[id].kind != SymbolKind::kFunction) continue;
    names.push_back(ScopedName(context, id));
    if (names.back() == entry) {
      context.Report(context[id].span, diag::EntryOnlyDeclared, names.back());
      return;
    }
    places.push_back(DeclOf(context, id).name_span);
    if (IsLikelyEntry(context, DeclOf(context, id))) likely.push_back(names.back());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::vector<std::string_view> near = NearNames(entry, candidates);
  if (near.empty() && likely.size() == 1) near = {likely.front()};
  if (near.empty() && candidates.size() == 1) near = candidates;
  bool has_hints = false;
  if (near.empty()) {
    near = CompiledByTechniques(context);
    has_hints = !near.empty();
  }
  const std::string text = QuotedList(near);
  constexpr std::size_t kMaxCandidates = 8;
  // What may be an entry comes before what others call.
  std::vector<std::string_view> listed(likely.begin(), likely.end());
  for (const std::string_view name : candidates) {
    if (std::ranges::find(likely, name) == likely.end()) listed.push_back(name);
  }
  if (listed.size() > kMaxCandidates) listed.resize(std::min(likely.size(), kMaxCandidates));
  const std::string tail =
      text.empty()
          ? (listed.empty() ? "" : fmt::format("; `-E` names one of {}", QuotedList(listed)))
      : has_hints ? fmt::format("; its techniques compile {}", text)
                  : fmt::format("; did you mean {}?", text);
  // The place of the function that was probably meant, or the start of the file's last declaration.
  Span where =
      context.file.top_level.empty() ? Span{} : context[context.file.top_level.back()].span;
  where.end = where.begin;
  if (!near.empty() && !has_hints)
    where = places[static_cast<std::size_t>(std::ranges::find(names, near[0]) - names.begin())];
  context.Report(where, diag::EntryNotFound, entry, tail);
}

}  // namespace

std::string ScopedName(const Context& context, SymbolId id) {
  std::string text(context[context[id].name]);
  for (ScopeId scope = context[id].scope; scope && scope != context.names.global();
       scope = context[scope].parent) {
    text = fmt::format("{}::{}", context[context[scope].name], text);
  }
  return text;
}

bool MayBeEntry(const Context& context, const ast::FunctionDecl& decl) {
  const auto has_semantics = [&](ast::DeclId id) {
    const auto& parameter = std::get<ast::VarDecl>(context[id].node);
    return parameter.semantic.name || HasSemantics(context, parameter.type);
  };
  return decl.return_semantic.name || HasSemantics(context, decl.return_type) ||
         std::ranges::any_of(context[decl.parameters], has_semantics);
}

FunctionInfoId FindEntry(Context& context, const std::string& entry) {
  std::vector<std::string_view> parts = SplitQualified(entry);
  const Name name = NameOf(context, parts.back());
  std::vector<SymbolId> found;
  ScopeId scope = context.names.global();
  for (std::size_t i = 0; i + 1 < parts.size() && scope; ++i) {
    const Name part = NameOf(context, parts[i]);
    const SymbolId symbol = part ? context.names.FindIn(scope, part) : SymbolId{};
    scope = symbol ? ScopeOf(context, symbol) : ScopeId{};
  }
  if (name && scope) found = EntriesIn(context, scope, name);
  if (name && found.empty() && parts.size() == 1) {
    for (ScopeId id : context.names.scope_ids()) {
      if (context[id].kind != ScopeKind::kNamespace) continue;
      const std::vector<SymbolId> more = EntriesIn(context, id, name);
      found.insert(found.end(), more.begin(), more.end());
    }
  }
  if (found.empty()) {
    ReportNoEntry(context, entry);
    return {};
  }
  if (found.size() > 1) {
    Diagnostic& report =
        context.Report(context[found[0]].span, diag::EntryAmbiguous, entry, found.size());
    for (SymbolId id : found)
      report.Note(context[id].span, diag::Candidate, ScopedName(context, id));
    return {};
  }
  // The default arguments and attributes of the function's prototypes belong to it.
  FunctionInfoId function;
  for (FunctionInfoId id : OverloadsOf(context, found[0], {})) {
    if (context[id].decl == context[found[0]].decl) function = id;
  }
  return function;
}

}  // namespace clipc::check
