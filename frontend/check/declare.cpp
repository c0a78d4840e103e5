// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/declare.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/overloaded.h"
#include "frontend/check/enum.h"
#include "frontend/check/scope.h"
#include "frontend/check/text.h"

namespace clipc::check {
namespace {

void DeclareVar(Context& context, ast::DeclId id, const ast::VarDecl& var, ScopeId scope) {
  if (var.out_of_line_of.name) {
    context.globals.out_of_line.Add(var.name, var.out_of_line_of, id);
    return;
  }
  DeclareTypeInside(context, var.type, scope);
  const SymbolId older = context.names.FindIn(scope, var.name);
  const SymbolId symbol =
      context.names.Declare(SymbolKind::kVariable, scope, var.name, id, var.name_span);
  if (older && context[older].kind == SymbolKind::kVariable) {
    const bool is_extern = (var.qualifiers & ast::kExtern) != 0;
    if (!is_extern) ReportRedefinition(context, older, var.name, var.name_span);
  }
  if (!(var.qualifiers & (ast::kStatic | ast::kGroupShared)))
    context[context.globals.buffer].members.push_back(symbol);
}

void DeclareBuffer(Context& context, ast::DeclId id, const ast::BufferDecl& buffer, ScopeId scope) {
  Buffer entry;
  entry.decl = id;
  entry.kind =
      buffer.kind == ast::BufferKind::kCbuffer ? CbufferKind::kCbuffer : CbufferKind::kTbuffer;
  entry.scope = scope;
  const BufferId buffer_id = context.globals.buffers.Add(entry);
  std::vector<SymbolId> members;
  members.reserve(buffer.members.size);
  for (ast::DeclId member : context[buffer.members]) {
    const auto* var = context.GetIf<ast::VarDecl>(member);
    if (!var || (var->qualifiers & ast::kStatic)) {
      DeclareOne(context, member, scope);
      continue;
    }
    DeclareTypeInside(context, var->type, scope);
    const SymbolId older = context.names.FindIn(scope, var->name);
    if (older && context[older].kind == SymbolKind::kVariable)
      ReportRedefinition(context, older, var->name, var->name_span);
    const SymbolId symbol =
        context.names.Declare(SymbolKind::kVariable, scope, var->name, member, var->name_span);
    context[symbol].owner = buffer_id.index;
    members.push_back(symbol);
  }
  context[buffer_id].members = std::move(members);
  context[buffer_id].order = context.names.size();
}

// A namespace may be opened several times.
void DeclareNamespace(Context& context, const ast::NamespaceDecl& space, Span span, ScopeId scope) {
  const SymbolId older = space.name ? context.names.FindIn(scope, space.name) : SymbolId{};
  ScopeId inner;
  if (older && context[older].kind == SymbolKind::kNamespace) {
    inner = ScopeId{context[older].value};
  } else {
    inner = context.names.AddScope(ScopeKind::kNamespace, scope, space.name);
    const SymbolId symbol = context.names.Declare(SymbolKind::kNamespace, scope, space.name, {},
                                                  space.name ? space.name_span : span);
    context[symbol].Resolve(inner.index);
    if (!space.name) context.names.Use(scope, inner, false);
  }
  for (ast::DeclId member : context[space.members]) DeclareOne(context, member, inner);
}

// Reports a specialisation of what is not a template. A name that nothing else has is a type in
// error from then on, so that its uses are not reported too.
void ReportNoTemplate(Context& context, const ast::StructDecl& decl, SymbolId older,
                      ScopeId scope) {
  context.Report(decl.name_span, diag::SpecialisationOfNone, context[decl.name]);
  if (older) return;
  const SymbolId symbol =
      context.names.Declare(SymbolKind::kType, scope, decl.name, {}, decl.name_span);
  context[symbol].Resolve(context.types.Error().index);
}

// A forward declaration and the definition are one symbol, the definition's declaration.
void DeclareStruct(Context& context, ast::DeclId id, const ast::StructDecl& decl, ScopeId scope) {
  if (decl.is_template && !context.options.has_templates)
    ReportLanguage(context, decl.name_span, "templates", LanguageVersion::k2021);
  const SymbolId older = decl.name ? context.names.FindIn(scope, decl.name, true) : SymbolId{};
  const bool has_decl = older && context[older].decl;
  const auto* before = has_decl ? context.GetIf<ast::StructDecl>(context[older].decl) : nullptr;
  if (!decl.template_arguments.empty()) {
    if (!before || !before->is_template)
      ReportNoTemplate(context, decl, older, scope);
    else if (decl.is_definition)
      context.structs.specialisations[older.index].push_back(id);
    return;
  }
  if (before && !decl.is_definition) return;
  if (before && !before->is_definition) {
    context[older].decl = id;
    return;
  }
  if (before) ReportRedefinition(context, older, decl.name, decl.name_span);
  context.names.Declare(SymbolKind::kType, scope, decl.name, id, decl.name_span);
}

// Whether the function's name is that of an operator which dxc does not let a struct overload
// (err_hlsl_overloading_operator_disallowed): one that changes its operand, and `->`.
bool IsOfFixedOperator(std::string_view name) {
  if (!name.starts_with("operator")) return false;
  name.remove_prefix(std::string_view("operator").size());
  constexpr std::string_view kComparisons[] = {"==", "!=", "<=", ">="};
  return name == "++" || name == "--" || name.starts_with("->") ||
         (name.ends_with("=") && std::ranges::find(kComparisons, name) == std::end(kComparisons));
}

void DeclareFunction(Context& context, ast::DeclId id, const ast::FunctionDecl& decl,
                     ScopeId scope) {
  if (decl.is_template && !context.options.has_templates)
    ReportLanguage(context, decl.name_span, "templates", LanguageVersion::k2021);
  if (IsOfFixedOperator(context[decl.name]))
    context.Report(decl.name_span, diag::OperatorNotOverloaded, context[decl.name]);
  DeclareTypeInside(context, decl.return_type, scope);
  const bool is_special = decl.is_template && decl.template_parameters.empty();
  const bool has_arguments = !decl.template_arguments.empty();
  if (decl.out_of_line_of.name) {
    if (is_special || (has_arguments && !decl.is_template))
      context.Report(decl.name_span, diag::Unsupported,
                     fmt::format("a specialisation of the method `{}`, outside of its struct",
                                 context[decl.name]));
    context.functions.out_of_line.Add(decl.name, decl.out_of_line_of, id);
    return;
  }
  if (has_arguments && !is_special) {
    context.Report(decl.name_span, diag::SpecialisationWithoutHeader, context[decl.name]);
    return;
  }
  if (is_special) {
    context.functions.specialisations[decl.name.index].push_back(
        context.names.Declare(SymbolKind::kFunction, scope, {}, id, decl.name_span));
    return;
  }
  context.names.Declare(SymbolKind::kFunction, scope, decl.name, id, decl.name_span);
}

}  // namespace

void ReportLanguage(Context& context, Span span, std::string_view what, LanguageVersion first) {
  context.Report(span, diag::LanguageNeeded, what, static_cast<int>(first),
                 static_cast<int>(context.options.language));
}

void DeclareAll(Context& context, std::span<const ast::DeclId> decls, ScopeId scope) {
  for (ast::DeclId id : decls) DeclareOne(context, id, scope);
}

void DeclareOne(Context& context, ast::DeclId id, ScopeId scope) {
  const ast::Decl& decl = context[id];
  Visit(
      Overloaded{
          [&](const ast::VarDecl& var) { DeclareVar(context, id, var, scope); },
          [&](const ast::FunctionDecl& function) { DeclareFunction(context, id, function, scope); },
          [&](const ast::StructDecl& structure) { DeclareStruct(context, id, structure, scope); },
          [&](const ast::TypedefDecl& alias) {
            DeclareTypeInside(context, alias.type, scope);
            context.names.Declare(SymbolKind::kType, scope, alias.name, id, alias.name_span);
          },
          [&](const ast::BufferDecl& buffer) { DeclareBuffer(context, id, buffer, scope); },
          [&](const ast::NamespaceDecl& space) {
            DeclareNamespace(context, space, decl.span, scope);
          },
          [&](const ast::EnumDecl& enumeration) {
            if (!context.options.has_enums)
              ReportLanguage(context, decl.span, "enums", LanguageVersion::k2017);
            DeclareEnum(context, id, enumeration, scope);
          },
          [&](const ast::UsingDecl& use) { DeclareUsing(context, use, decl.span, scope); },
      },
      decl.node);
}

void DeclareTypeInside(Context& context, ast::TypeId type, ScopeId scope) {
  if (!type) return;
  const ast::DeclId definition = context[type].struct_definition;
  if (!definition || context.structs.symbols.contains(definition.index)) return;
  const std::uint32_t next = context.names.size();
  DeclareOne(context, definition, scope);
  // The definition of a type that was declared before is not a new symbol.
  const SymbolId symbol = context.names.size() > next
                              ? SymbolId{next}
                              : context.names.FindIn(scope, context[type].name.name, true);
  context.structs.symbols.emplace(definition.index, symbol);
}

void DeclareUsing(Context& context, const ast::UsingDecl& use, Span span, ScopeId scope) {
  const bool is_local = context.view.body != nullptr;
  ViewSwitch in(context, {.scope = scope});
  const SymbolId target = Find(context, use.name);
  if (!target) {
    ReportUndeclared(context, span, use.name, NameUse::kValue);
  } else if (!use.is_namespace) {
    const Symbol found = context[target];
    const SymbolId alias =
        context.names.Declare(found.kind, scope, use.name.name, found.decl, found.span);
    context[alias].owner = found.owner;
    context[alias].value = found.value;
    context[alias].resolution = found.resolution;
  } else if (context[target].kind == SymbolKind::kNamespace) {
    context.names.Use(scope, ScopeId{context[target].value}, is_local);
  } else {
    context.Report(span, diag::NoSuchScope, QualifiedText(context, use.name));
  }
}

}  // namespace clipc::check
