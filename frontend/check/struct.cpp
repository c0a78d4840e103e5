// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/struct.h"

#include <algorithm>

#include "frontend/check/declare.h"
#include "frontend/check/entry_signature.h"
#include "frontend/check/scope.h"
#include "frontend/check/type.h"

namespace clipc::check {
namespace {

void AddBases(Context& context, const ast::StructDecl& decl, ir::TypeId type) {
  const ir::StructId structure = context[type].structure;
  for (ast::TypeId written : context[decl.bases]) {
    const ir::TypeId base = ResolveType(context, written);
    const StructInfo* info = InfoOf(context, base);
    if (!info) {
      if (!context.IsError(base)) {
        context.Report(context[written].span, diag::BaseNotStruct, context.TypeName(base));
      }
      continue;
    }
    context.structs.infos[structure.index].bases.push_back(base);
    const ScopeId scope = context.structs.infos[structure.index].scope;
    context[scope].nested.push_back(info->scope);
    const ir::Struct& base_struct = context.program.types.StructOf(base);
    for (std::size_t f = 0; f < base_struct.fields.size(); ++f) {
      const Name name = info->fields[f];
      const SymbolId symbol =
          context.names.Declare(SymbolKind::kField, scope, name, {}, base_struct.fields[f].span);
      context[symbol].value = static_cast<std::uint32_t>(context[structure].fields.size());
      context[symbol].resolution = Resolution::kDone;
      context[structure].fields.push_back(base_struct.fields[f]);
      context.structs.infos[structure.index].fields.push_back(name);
    }
  }
}

ir::Field MakeField(Context& context, const ast::VarDecl& var) {
  const ast::Qualifiers qualifiers = QualifiersOf(context, var);
  ir::Field field;
  field.name = context[var.name];
  field.type = ResolveVarType(context, var);
  field.span = var.name_span;
  field.row_major = IsRowMajor(context, qualifiers);
  field.semantic = context[var.semantic.name];
  field.semantic_span = var.semantic.span;
  field.precise = (qualifiers & ast::kPrecise) != 0;
  ReadInterpolation(qualifiers, field.interpolation, field.centroid, field.sample);
  if (var.bit_width) context.Report(context[var.bit_width].span, diag::Unsupported, "a bit-field");
  return field;
}

void AddField(Context& context, const ast::VarDecl& var, ast::DeclId id, ir::TypeId type) {
  const ir::StructId structure = context[type].structure;
  const SymbolId symbol =
      context.names.Declare(SymbolKind::kField, context.structs.infos[structure.index].scope,
                            var.name, id, var.name_span);
  ir::Field field = MakeField(context, var);
  context.structs.infos[structure.index].fields.push_back(var.name);
  auto& fields = context[structure].fields;
  context[symbol].value = static_cast<std::uint32_t>(fields.size());
  context[symbol].resolution = Resolution::kDone;
  fields.push_back(std::move(field));
}

void AddMember(Context& context, ast::DeclId id, ir::TypeId type) {
  const ScopeId scope = context.structs.infos[context[type].structure.index].scope;
  const ast::Decl& decl = context[id];
  if (const auto* var = std::get_if<ast::VarDecl>(&decl.node)) {
    DeclareTypeInside(context, var->type, scope);
    const SymbolId older = context.names.FindIn(scope, var->name);
    // A field may hide one of a base, which has no declaration here.
    if (older && context[older].decl && context[older].kind != SymbolKind::kType)
      ReportRedefinition(context, older, var->name, var->name_span);
    if (var->qualifiers & ast::kStatic) {
      context.names.Declare(SymbolKind::kVariable, scope, var->name, id, var->name_span);
    } else {
      AddField(context, *var, id, type);
    }
    return;
  }
  DeclareOne(context, id, scope);
}

void MeasureStruct(Context& context, ir::TypeId type, Span span) {
  StructInfo& info = context.structs.infos[context[type].structure.index];
  for (const ir::Field& field : context.program.types.StructOf(type).fields) {
    info.components += ComponentsOf(context, field.type);
    info.depth = std::max(info.depth, DepthOf(context, field.type) + 1);
  }
  if (!IsTooLarge(context, type, span)) return;
  // What is too large to walk is left without fields.
  info.components = 0;
  info.depth = 1;
  info.fields.clear();
  context[context[type].structure].fields.clear();
}

}  // namespace

ir::TypeId ResolveStruct(Context& context, ast::DeclId id, SymbolId symbol, ScopeId scope,
                         std::uint32_t order) {
  const auto& decl = context.Get<ast::StructDecl>(id);
  const Span span = decl.name ? decl.name_span : context[id].span;
  const ir::StructId structure =
      context.program.types.AddStruct({std::string(context[decl.name]), {}, span});
  const ir::TypeId type = context.program.types.Of(structure);
  StructInfo info;
  info.decl = id;
  info.scope = context.names.AddScope(ScopeKind::kStruct, scope, decl.name, order);
  context[info.scope].self = type;
  context.structs.infos.push_back(std::move(info));
  context[symbol].value = type.index;

  View view = context.view;
  const bool is_local = !context[symbol].scope;
  if (!is_local) view = {.scope = scope, .order = order, .local_floor = context.names.size()};
  view.scope = context.structs.infos[structure.index].scope;
  const ViewSwitch in(context, view);
  context[structure].fields.reserve(decl.members.size);
  context.structs.infos[structure.index].fields.reserve(decl.members.size);
  AddBases(context, decl, type);
  for (ast::DeclId member : context[decl.members]) AddMember(context, member, type);
  MeasureStruct(context, type, span);
  return type;
}

const StructInfo* InfoOf(const Context& context, ir::TypeId type) {
  if (context[type].kind != ir::TypeKind::kStruct) return nullptr;
  return &context.structs.infos[context[type].structure.index];
}

SymbolId FindMember(const Context& context, ir::TypeId type, Name name) {
  const StructInfo* info = InfoOf(context, type);
  return info ? context.names.FindNested(info->scope, name) : SymbolId{};
}

std::optional<std::uint32_t> FindField(const Context& context, ir::TypeId type, Name name) {
  const StructInfo* info = InfoOf(context, type);
  const SymbolId id = info ? context.names.FindIn(info->scope, name) : SymbolId{};
  if (!id || context[id].kind != SymbolKind::kField) return std::nullopt;
  const std::uint32_t field = context[id].value;
  if (field >= context.program.types.StructOf(type).fields.size()) return std::nullopt;
  return field;
}

bool DerivesFrom(const Context& context, ir::TypeId derived, ir::TypeId base) {
  const StructInfo* info = InfoOf(context, derived);
  if (!info) return false;
  for (ir::TypeId parent : info->bases) {
    if (parent == base || DerivesFrom(context, parent, base)) return true;
  }
  return false;
}

void DeclareLocalType(Context& context, ast::DeclId id) {
  if (const auto* decl = context.GetIf<ast::StructDecl>(id)) {
    context.structs.symbols[id.index] =
        DeclareLocal(context, SymbolKind::kType, decl->name, id, decl->name_span);
    ResolveTypeSymbol(context, context.structs.symbols[id.index]);
  } else if (const auto* alias = context.GetIf<ast::TypedefDecl>(id)) {
    ResolveTypeSymbol(context,
                      DeclareLocal(context, SymbolKind::kType, alias->name, id, alias->name_span));
  } else if (const auto* enumeration = context.GetIf<ast::EnumDecl>(id)) {
    const SymbolId symbol =
        DeclareLocal(context, SymbolKind::kType, enumeration->name, id, enumeration->name_span);
    context.structs.symbols[id.index] = symbol;
    const ScopeId own = context.names.AddScope(ScopeKind::kEnum, context.view.scope,
                                               enumeration->name, context.view.order);
    context[symbol].owner = own.index;
    for (std::uint32_t i = 0; i < enumeration->enumerators.size; ++i) {
      const ast::Enumerator& enumerator = context[enumeration->enumerators][i];
      const SymbolId inner =
          context.names.Declare(SymbolKind::kEnumerator, own, enumerator.name, id, enumerator.span);
      context[inner].owner = symbol.index;
      context[inner].value = i;
      if (enumeration->is_class) continue;
      const SymbolId outer =
          DeclareLocal(context, SymbolKind::kEnumerator, enumerator.name, id, enumerator.span);
      context[outer].owner = symbol.index;
      context[outer].value = i;
    }
  }
}

}  // namespace clipc::check
