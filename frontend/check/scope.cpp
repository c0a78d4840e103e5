// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/scope.h"

#include <algorithm>
#include <vector>

#include "base/spelling.h"
#include "frontend/check/glsl_names.h"
#include "frontend/check/struct.h"
#include "frontend/check/text.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/typing/intrinsics.h"

namespace clipc::check {
namespace {

// The scope that `a::b::` names; none if there is no such scope: then `missing` is the unknown
// name.
ScopeId FindScope(Context& context, const ast::QualifiedName& name, Name& missing) {
  ScopeId scope = name.from_global ? context.names.global() : ScopeId{};
  for (Name part : context[name.scopes]) {
    const SymbolId id =
        scope ? context.names.FindNested(scope, part) : context.names.FindUnqualified(part);
    missing = part;
    scope = id ? ScopeOf(context, id) : ScopeId{};
    if (!scope) break;
  }
  return scope;
}

// The symbol that the name would mean at the end of the text; none if it would mean nothing.
SymbolId FindLater(const Context& context, Name name) {
  for (ScopeId scope = context.view.scope; scope; scope = context[scope].parent) {
    if (const SymbolId id = context.names.NewestIn(scope, name)) return id;
  }
  return {};
}

// The variable of that name of a loop before; none if there is none.
SymbolId FindEnded(const Context& context, const ast::QualifiedName& name) {
  if (!context.view.body || !name.scopes.empty()) return {};
  const std::vector<SymbolId>& ended = context.view.body->ended;
  const auto found = std::ranges::find(ended.rbegin(), ended.rend(), name.name,
                                       [&](SymbolId id) { return context[id].name; });
  return found == ended.rend() ? SymbolId{} : *found;
}

// The names that can be seen from here and are spelt nearly like `name`: "`a`, `b`".
std::string NearText(const Context& context, Name name, NameUse use) {
  std::vector<std::string_view> candidates;
  for (SymbolId id : context.names.symbol_ids()) {
    const Symbol& symbol = context[id];
    if (!symbol.name || symbol.name == name) continue;
    if (use == NameUse::kType && symbol.kind != SymbolKind::kType) continue;
    if (use == NameUse::kFunction && symbol.kind != SymbolKind::kFunction) continue;
    if (symbol.scope ? !context.names.IsVisible(id)
                     : context.names.InnermostLocal(symbol.name) != id)
      continue;
    candidates.push_back(context[symbol.name]);
  }
  std::vector<std::string> types;
  if (use == NameUse::kType) types = NearTypes(context[name]);
  candidates.insert(candidates.end(), types.begin(), types.end());
  std::vector<std::string_view> near = NearNames(context[name], candidates);
  if (use == NameUse::kFunction) {
    for (std::string_view intrinsic : NearIntrinsics(context[name])) {
      if (near.size() < 3) near.push_back(intrinsic);
    }
  }
  return QuotedList(near);
}

bool IsBuffer(const Context& context, Name name) {
  for (const ast::DeclId id : context.file.decls.ids()) {
    const auto* buffer = context.GetIf<ast::BufferDecl>(id);
    if (buffer && buffer->name == name) return true;
  }
  return false;
}

// Whether a struct of that name has a field `field`.
bool HasField(const Context& context, Name structure, Name field) {
  const auto is_field = [&](ast::DeclId member) {
    const auto* variable = context.GetIf<ast::VarDecl>(member);
    return variable && variable->name == field;
  };
  for (const ast::DeclId id : context.file.decls.ids()) {
    const auto* found = context.GetIf<ast::StructDecl>(id);
    if (found && found->name == structure && std::ranges::any_of(context[found->members], is_field))
      return true;
  }
  return false;
}

// "`frame.plane`", "`lights[i].color`": the variables that have a field of that name.
std::string OwnersOf(const Context& context, Name field) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> owners;
  for (const SymbolId id : context.names.symbol_ids()) {
    const Symbol& symbol = context[id];
    if (symbol.kind != SymbolKind::kVariable || !symbol.decl || !symbol.name) continue;
    if (owners.size() == kMost) break;
    const bool is_visible = symbol.scope ? context.names.IsVisible(id)
                                         : context.names.InnermostLocal(symbol.name) == id;
    const auto* variable = context.GetIf<ast::VarDecl>(symbol.decl);
    if (!variable || !is_visible || !HasField(context, context[variable->type].name.name, field))
      continue;
    std::string owner(context[symbol.name]);
    for (std::size_t i = 0; i < variable->dimensions.size; ++i)
      owner += fmt::format("[{}]", "ijk"[std::min<std::size_t>(i, 2)]);
    owners.push_back(fmt::format("{}.{}", owner, context[field]));
  }
  return QuotedList(std::vector<std::string_view>(owners.begin(), owners.end()));
}

// The end of a message about an unknown name if no known name is spelt nearly like it.
std::string AdviceFor(const Context& context, Name unknown, NameUse use) {
  const std::string_view name = context[unknown];
  if (IsBuffer(context, unknown))
    return fmt::format("; `{}` is a constant buffer, and its members have no prefix", name);
  if (const std::string owners = OwnersOf(context, unknown); !owners.empty())
    return fmt::format("; did you mean {}?", owners);
  if (use == NameUse::kClipPlane)
    return "; a clip plane is a global variable or a member of a constant buffer";
  return name.starts_with("gl_") ? "; what GLSL calls `gl_...` is a semantic in HLSL, `SV_Position`"
                                 : "";
}

}  // namespace

ScopeId ScopeOf(Context& context, SymbolId id) {
  switch (context[id].kind) {
    case SymbolKind::kNamespace: return ScopeId{context[id].value};
    case SymbolKind::kType: {
      const TypeId type = ResolveTypeSymbol(context, id);
      if (context[id].owner != ~0u) return ScopeId{context[id].owner};
      const StructInfo* info = InfoOf(context, type);
      return info ? info->scope : ScopeId{};
    }
    default: return {};
  }
}

SymbolId Find(Context& context, const ast::QualifiedName& name, bool types_only) {
  if (name.scopes.empty() && !name.from_global)
    return context.names.FindUnqualified(name.name, types_only);
  Name missing;
  const ScopeId scope = FindScope(context, name, missing);
  return scope ? context.names.FindNested(scope, name.name, types_only) : SymbolId{};
}

namespace {

// The symbols of different namespaces that the name means; empty where only one can be meant.
std::vector<SymbolId> FindAll(Context& context, const ast::QualifiedName& name, bool types_only) {
  if (!context.names.uses_any()) return {};
  if (name.scopes.empty() && !name.from_global)
    return context.names.FindAllUnqualified(name.name, types_only);
  Name missing;
  const ScopeId scope = FindScope(context, name, missing);
  return scope ? context.names.FindAllNested(scope, name.name, types_only)
               : std::vector<SymbolId>{};
}

// Whether both symbols are names of one thing: `using A::x;` makes another symbol of it, and
// several typedefs may name one type.
bool IsSame(Context& context, SymbolId one, SymbolId other) {
  const SymbolKind kind = context[one].kind;
  if (kind != context[other].kind) return false;
  if (kind == SymbolKind::kNamespace || context[one].decl == context[other].decl) return true;
  const auto is_alias = [&](SymbolId id) {
    const ast::DeclId decl = context[id].decl;
    const auto* alias = decl ? context.GetIf<ast::TypedefDecl>(decl) : nullptr;
    return alias && !alias->is_template;
  };
  return kind == SymbolKind::kType && (is_alias(one) || is_alias(other)) &&
         ResolveTypeSymbol(context, one) == ResolveTypeSymbol(context, other);
}

}  // namespace

std::vector<SymbolId> OtherFunctions(Context& context, const ast::QualifiedName& name,
                                     SymbolId first) {
  std::vector<SymbolId> others;
  for (const SymbolId id : FindAll(context, name, false)) {
    if (id != first && context[id].kind == SymbolKind::kFunction && !IsSame(context, id, first))
      others.push_back(id);
  }
  return others;
}

bool IsOneThing(Context& context, Span span, const ast::QualifiedName& name, bool types_only) {
  const std::vector<SymbolId> all = FindAll(context, name, types_only);
  const auto differs = [&](SymbolId id) {
    const bool are_functions = context[id].kind == SymbolKind::kFunction &&
                               context[all.front()].kind == SymbolKind::kFunction;
    return !are_functions && !IsSame(context, id, all.front());
  };
  const auto other = std::ranges::find_if(all, differs);
  if (other == all.end()) return true;
  context.Report(span, diag::AmbiguousName, context[name.name])
      .Note(context[all.front()].span, diag::DeclaredHere, context[name.name])
      .Note(context[*other].span, diag::DeclaredHere, context[name.name]);
  return false;
}

void ReportUndeclared(Context& context, Span span, const ast::QualifiedName& name, NameUse use) {
  Name missing;
  if (!name.scopes.empty() && !FindScope(context, name, missing)) {
    context.Report(span, diag::NoSuchScope, context[missing]);
    return;
  }
  if (context[name.name] == "ResourceDescriptorHeap" ||
      context[name.name] == "SamplerDescriptorHeap") {
    context.Report(span, diag::DescriptorHeap, context[name.name]);
    return;
  }
  const SymbolId later = name.scopes.empty() ? FindLater(context, name.name) : SymbolId{};
  const SymbolId ended = later ? SymbolId{} : FindEnded(context, name);
  const std::string_view hlsl = later || !name.scopes.empty() ? "" : HlslNameOf(context[name.name]);
  const bool is_glsl = context[name.name].starts_with("gl_");
  const std::string near = later || ended || is_glsl ? ""
                           : !hlsl.empty()           ? fmt::format("`{}`", hlsl)
                                                     : NearText(context, name.name, use);
  const std::string tail = later           ? "; a name must be declared before its use"
                           : !hlsl.empty() ? fmt::format("; in HLSL it is `{}`", hlsl)
                           : !near.empty() ? fmt::format("; did you mean {}?", near)
                                           : AdviceFor(context, name.name, use);
  const std::string text = QualifiedText(context, name);
  Diagnostic& report = use == NameUse::kType ? context.Report(span, diag::UnknownType, text, tail)
                       : use == NameUse::kFunction
                           ? context.Report(span, diag::UnknownFunction, text, tail)
                           : context.Report(span, diag::UndeclaredName, text, tail);
  if (ended) report.Note(context[ended].span, diag::LoopVariableEnded, context[name.name]);
  if (later) report.Note(context[later].span, diag::DeclaredHere, context[name.name]);
  const bool is_one =
      !near.empty() && near.find_first_of(",([") == std::string::npos && name.scopes.empty();
  if (is_one) report.Fix(span, near.substr(1, near.size() - 2));
}

SymbolId DeclareLocal(Context& context, SymbolKind kind, Name name, ast::DeclId decl, Span span) {
  const SymbolId older = name ? context.names.InnermostLocal(name) : SymbolId{};
  if (older && context.names.IsInLastScope(older) && !context[older].is_leaked)
    ReportRedefinition(context, older, name, span);
  return context.names.DeclareLocal(kind, name, decl, span);
}

void ReportRedefinition(Context& context, SymbolId older, Name name, Span span) {
  context.Report(span, diag::Redefinition, context[name])
      .Note(context[older].span, diag::DeclaredHere, context[name]);
}

}  // namespace clipc::check
