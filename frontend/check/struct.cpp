// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/struct.h"

#include <algorithm>

#include "frontend/check/bit_field.h"
#include "frontend/check/declare.h"
#include "frontend/check/entry_signature.h"
#include "frontend/check/enum.h"
#include "frontend/check/scope.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/check/vulkan.h"
#include "ir/packing.h"

namespace clipc::check {
namespace {

// Adds a field to the struct. Its symbol is declared already.
void AddField(Context& context, StructId structure, SymbolId symbol, Field field) {
  auto& fields = context[structure].fields;
  context[symbol].Resolve(static_cast<std::uint32_t>(fields.size()));
  context.structs.infos[structure.index].fields.push_back(context[symbol].name);
  fields.push_back(std::move(field));
}

void AddBases(Context& context, const ast::StructDecl& decl, TypeId type) {
  const StructId structure = context[type].structure;
  for (ast::TypeId written : context[decl.bases]) {
    const TypeId base = ResolveType(context, written);
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
    const Struct& base_struct = context.types.StructOf(base);
    const auto first = static_cast<std::uint32_t>(context[structure].fields.size());
    for (std::size_t f = 0; f < base_struct.fields.size(); ++f) {
      const SymbolId symbol = context.names.Declare(SymbolKind::kField, scope, info->fields[f], {},
                                                    base_struct.fields[f].span);
      AddField(context, structure, symbol, base_struct.fields[f]);
    }
    for (BitField bits : info->bits) {
      const bool is_declared = info->fields[bits.field] == bits.name;
      bits.field += first;
      context.structs.infos[structure.index].bits.push_back(bits);
      if (is_declared || !bits.name) continue;
      context[context.names.Declare(SymbolKind::kField, scope, bits.name, {}, {})].Resolve(
          bits.field);
    }
  }
}

Field MakeField(Context& context, const ast::VarDecl& var) {
  const ast::Qualifiers qualifiers = QualifiersOf(context, var);
  Field field;
  field.name = context[var.name];
  field.type = WithoutString(context, ResolveVarType(context, var), var);
  field.span = var.name_span;
  const bool is_object = context[context.types.Innermost(field.type)].kind == TypeKind::kObject;
  field.row_major = IsRowMajor(context, is_object ? ElementQualifiersOf(context, var) : qualifiers);
  field.semantic = context[var.semantic.name];
  field.semantic_span = var.semantic.span;
  field.precise = (qualifiers & ast::kPrecise) != 0;
  ReadInterpolation(qualifiers, field);
  ReadVulkan(context, var.attributes, field);
  field.offset = OffsetOf(context, var.attributes);
  return field;
}

void AddMember(Context& context, ast::DeclId id, TypeId type) {
  const ScopeId scope = context.structs.infos[context[type].structure.index].scope;
  const ast::Decl& decl = context[id];
  if (const auto* var = std::get_if<ast::VarDecl>(&decl.node)) {
    DeclareTypeInside(context, var->type, scope);
    const SymbolId older = context.names.FindIn(scope, var->name);
    // A field may hide a field of a base, which has no declaration here.
    if (older && context[older].decl && context[older].kind != SymbolKind::kType)
      ReportRedefinition(context, older, var->name, var->name_span);
    const bool is_static = (var->qualifiers & ast::kStatic) != 0;
    const SymbolId symbol =
        context.names.Declare(is_static ? SymbolKind::kVariable : SymbolKind::kField, scope,
                              var->name, id, var->name_span);
    if (is_static) return;
    if (var->init) context.Report(var->name_span, diag::FieldInitialised, context[var->name]);
    Field field = MakeField(context, *var);
    if (var->bit_width && !context.IsError(field.type)) {
      if (!context.options.has_templates)
        ReportLanguage(context, context[var->bit_width].span, "bit-fields", LanguageVersion::k2021);
      if (AddBitField(context, *var, type, symbol, field)) return;
    }
    AddField(context, context[type].structure, symbol, std::move(field));
    return;
  }
  DeclareOne(context, id, scope);
}

void MeasureStruct(Context& context, TypeId type, Span span) {
  StructInfo& info = context.structs.infos[context[type].structure.index];
  for (const Field& field : context.types.StructOf(type).fields) {
    info.components += ComponentsOf(context, field.type);
    info.fields_of_all += FieldsOf(context, field.type) + 1;
    info.holds_bits |= HoldsBits(context, field.type);
    info.holds_objects |= IsOrHoldsObject(context, field.type);
    info.depth = std::max(info.depth, DepthOf(context, field.type) + 1);
  }
  for (const BitField& bits : info.bits) info.components += bits.name && bits.first != 0 ? 1 : 0;
  info.holds_bits |= !info.bits.empty();
  if (!IsTooLarge(context, type, span)) return;
  // A struct that is too large to walk is left without fields.
  info.components = 0;
  info.fields_of_all = 0;
  info.depth = 1;
  info.fields.clear();
  context[context[type].structure].fields.clear();
}

// Reports each [[vk::offset]] that Direct3D's packing does not allow, and removes it.
void CheckOffsets(Context& context, TypeId type) {
  std::uint32_t end = 0;
  auto& fields = context[context[type].structure].fields;
  if (std::ranges::none_of(fields, [](const Field& field) { return field.offset.has_value(); }))
    return;
  for (Field& field : fields) {
    const Extent extent = PackedExtent(context.types, field.type, field.row_major);
    const std::uint32_t least = std::max(end, field.offset.value_or(end));
    const std::uint32_t place = PackedOffset(context.types, field.type, field.row_major, least);
    if (field.offset && place != *field.offset) {
      context.Report(field.span, diag::OffsetMisfit, field.name, context.TypeName(field.type),
                     *field.offset);
      field.offset.reset();
    }
    end = place + extent.size;
  }
}

}  // namespace

TypeId ResolveStruct(Context& context, ast::DeclId id, SymbolId symbol, ScopeId scope,
                     std::uint32_t order) {
  const auto& decl = context.Get<ast::StructDecl>(id);
  const Span span = decl.name ? decl.name_span : context[id].span;
  const StructId structure = context.types.AddStruct({std::string(context[decl.name]), {}, span});
  const TypeId type = context.types.Of(structure);
  StructInfo info;
  info.decl = id;
  info.scope = context.names.AddScope(ScopeKind::kStruct, scope, decl.name, order);
  context[info.scope].self = type;
  context.structs.infos.push_back(std::move(info));
  context[symbol].value = type.index;

  View view = context.view;
  const bool is_local = !context[symbol].scope;
  if (!is_local) view = context.ViewFrom(scope, order);
  view.scope = context.structs.infos[structure.index].scope;
  const ViewSwitch in(context, view);
  context[structure].fields.reserve(decl.members.size);
  context.structs.infos[structure.index].fields.reserve(decl.members.size);
  AddBases(context, decl, type);
  for (ast::DeclId member : context[decl.members]) AddMember(context, member, type);
  MeasureStruct(context, type, span);
  // Push constants belong to one stage: their places are no part of its interface with another.
  if (!context.program.is_interface_only) CheckOffsets(context, type);
  context.types.Measure(structure);
  return type;
}

const StructInfo* InfoOf(const Context& context, TypeId type) {
  if (context[type].kind != TypeKind::kStruct) return nullptr;
  return &context.structs.infos[context[type].structure.index];
}

SymbolId FindMember(const Context& context, TypeId type, Name name) {
  const StructInfo* info = InfoOf(context, type);
  return info ? context.names.FindNested(info->scope, name) : SymbolId{};
}

std::optional<std::uint32_t> FirstFieldOf(const Context& context, TypeId type, TypeId base) {
  if (type == base) return 0;
  const StructInfo* info = InfoOf(context, type);
  if (!info) return std::nullopt;
  std::uint32_t first = 0;
  for (TypeId parent : info->bases) {
    if (const auto inside = FirstFieldOf(context, parent, base)) return first + *inside;
    first += static_cast<std::uint32_t>(context.types.StructOf(parent).fields.size());
  }
  return std::nullopt;
}

std::optional<std::uint32_t> FindField(const Context& context, TypeId type, TypeId base,
                                       Name name) {
  const StructInfo* info = InfoOf(context, base);
  const SymbolId id = info ? context.names.FindIn(info->scope, name) : SymbolId{};
  if (!id || context[id].kind != SymbolKind::kField) return std::nullopt;
  const auto first = FirstFieldOf(context, type, base);
  if (!first || context[id].value >= context.types.StructOf(base).fields.size())
    return std::nullopt;
  const std::uint32_t field = *first + context[id].value;
  if (field >= context.types.StructOf(type).fields.size()) return std::nullopt;
  return field;
}

bool IsInterface(const Context& context, TypeId type) {
  const StructInfo* info = InfoOf(context, type);
  return info && context.Get<ast::StructDecl>(info->decl).kind == ast::StructKind::kInterface;
}

bool DerivesFrom(const Context& context, TypeId derived, TypeId base) {
  return derived != base && FirstFieldOf(context, derived, base);
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
    context.structs.symbols[id.index] = DeclareEnum(context, id, *enumeration, {});
  }
}

}  // namespace clipc::check
