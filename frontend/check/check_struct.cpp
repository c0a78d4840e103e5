// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/overloaded.h"
#include "frontend/check/checker.h"
#include "frontend/rules/constant.h"

// Structs, their members and bases; enums.
namespace clipc {

ir::TypeId Checker::ResolveStruct(ast::DeclId id, SymbolId symbol, ScopeId scope,
                                  std::uint32_t order) {
  const auto& decl = std::get<ast::StructDecl>(file_.decls[id].node);
  const Span span = decl.name ? decl.name_span : file_.decls[id].span;
  const ir::StructId structure = program_.types.AddStruct({std::string(Text(decl.name)), {}, span});
  const ir::TypeId type = program_.types.Of(structure);
  StructInfo info;
  info.decl = id;
  info.scope = AddScope(ScopeKind::kStruct, scope, decl.name, order);
  scopes_[info.scope].self = type;
  struct_infos_.push_back(std::move(info));
  symbols_[symbol].value = type.index;

  Context context = context_;
  const bool is_local = !symbols_[symbol].scope;
  if (!is_local) context = {.scope = scope, .order = order, .local_floor = symbols_.size()};
  context.scope = struct_infos_[structure.index].scope;
  const ContextSwitch in(*this, context);
  program_.types[structure].fields.reserve(decl.members.size);
  struct_infos_[structure.index].fields.reserve(decl.members.size);
  AddBases(decl, type);
  for (std::uint32_t i = 0; i < decl.members.size; ++i)
    AddMember(file_.decl_lists[decl.members][i], type);
  MeasureStruct(type, span);
  return type;
}

void Checker::AddBases(const ast::StructDecl& decl, ir::TypeId type) {
  const ir::StructId structure = program_.types[type].structure;
  for (std::uint32_t i = 0; i < decl.bases.size; ++i) {
    const ast::TypeId written = file_.type_lists[decl.bases][i];
    const ir::TypeId base = ResolveType(written);
    const StructInfo* info = InfoOf(base);
    if (!info) {
      if (base != program_.types.Error()) {
        diagnostics_.Report(file_.types[written].span, diag::BaseNotStruct, TypeName(base));
      }
      continue;
    }
    struct_infos_[structure.index].bases.push_back(base);
    const ScopeId scope = struct_infos_[structure.index].scope;
    scopes_[scope].nested.push_back(info->scope);
    const ir::Struct& base_struct = program_.types.StructOf(base);
    for (std::size_t f = 0; f < base_struct.fields.size(); ++f) {
      const Name name = info->fields[f];
      const SymbolId symbol =
          Declare(SymbolKind::kField, scope, name, {}, base_struct.fields[f].span);
      symbols_[symbol].value = static_cast<std::uint32_t>(program_.types[structure].fields.size());
      symbols_[symbol].resolution = Resolution::kDone;
      program_.types[structure].fields.push_back(base_struct.fields[f]);
      struct_infos_[structure.index].fields.push_back(name);
    }
  }
}

void Checker::AddMember(ast::DeclId id, ir::TypeId type) {
  const ScopeId scope = struct_infos_[program_.types[type].structure.index].scope;
  const ast::Decl& decl = file_.decls[id];
  if (const auto* var = std::get_if<ast::VarDecl>(&decl.node)) {
    DeclareTypeInside(var->type, scope);
    const SymbolId older = FindIn(scope, var->name);
    // A field may hide one of a base, which has no declaration here.
    if (older && symbols_[older].decl && symbols_[older].kind != SymbolKind::kType)
      ReportRedefinition(older, var->name, var->name_span);
    if (var->qualifiers & ast::kStatic) {
      Declare(SymbolKind::kVariable, scope, var->name, id, var->name_span);
    } else {
      AddField(*var, id, type);
    }
    return;
  }
  DeclareOne(id, scope);
}

void Checker::AddField(const ast::VarDecl& var, ast::DeclId id, ir::TypeId type) {
  const ir::StructId structure = program_.types[type].structure;
  const SymbolId symbol = Declare(SymbolKind::kField, struct_infos_[structure.index].scope,
                                  var.name, id, var.name_span);
  ir::Field field = MakeField(var);
  struct_infos_[structure.index].fields.push_back(var.name);
  auto& fields = program_.types[structure].fields;
  symbols_[symbol].value = static_cast<std::uint32_t>(fields.size());
  symbols_[symbol].resolution = Resolution::kDone;
  fields.push_back(std::move(field));
}

ir::Field Checker::MakeField(const ast::VarDecl& var) {
  const ast::Qualifiers qualifiers = QualifiersOf(var);
  ir::Field field;
  field.name = Text(var.name);
  field.type = ResolveVarType(var);
  field.span = var.name_span;
  field.row_major = IsRowMajor(qualifiers);
  field.semantic = Text(var.semantic.name);
  field.semantic_span = var.semantic.span;
  field.precise = (qualifiers & ast::kPrecise) != 0;
  ReadInterpolation(qualifiers, field.interpolation, field.centroid, field.sample);
  if (var.bit_width)
    diagnostics_.Report(file_.exprs[var.bit_width].span, diag::Unsupported, "a bit-field");
  return field;
}

void Checker::MeasureStruct(ir::TypeId type, Span span) {
  StructInfo& info = struct_infos_[program_.types[type].structure.index];
  for (const ir::Field& field : program_.types.StructOf(type).fields) {
    info.components += ComponentsOf(field.type);
    info.depth = std::max(info.depth, DepthOf(field.type) + 1);
  }
  if (!IsTooLarge(type, span)) return;
  // What is too large to walk is left without fields.
  info.components = 0;
  info.depth = 1;
  info.fields.clear();
  program_.types[program_.types[type].structure].fields.clear();
}

void Checker::ReadInterpolation(ast::Qualifiers qualifiers, ir::Interpolation& interpolation,
                                bool& centroid, bool& sample) const {
  if (qualifiers & ast::kLinear) interpolation = ir::Interpolation::kLinear;
  if (qualifiers & ast::kNoPerspective) interpolation = ir::Interpolation::kNoPerspective;
  if (qualifiers & ast::kNoInterpolation) interpolation = ir::Interpolation::kNoInterpolation;
  centroid = (qualifiers & ast::kCentroid) != 0;
  sample = (qualifiers & ast::kSample) != 0;
}

const StructInfo* Checker::InfoOf(ir::TypeId type) const {
  if (program_.types[type].kind != ir::TypeKind::kStruct) return nullptr;
  return &struct_infos_[program_.types[type].structure.index];
}

SymbolId Checker::FindMember(ir::TypeId type, Name name) const {
  const StructInfo* info = InfoOf(type);
  return info ? FindNested(info->scope, name, false, 0) : SymbolId{};
}

// The number of a field of the struct; none when the struct has no such field.
std::optional<std::uint32_t> Checker::FindField(ir::TypeId type, Name name) const {
  const StructInfo* info = InfoOf(type);
  const SymbolId id = info ? FindIn(info->scope, name) : SymbolId{};
  if (!id || symbols_[id].kind != SymbolKind::kField) return std::nullopt;
  const std::uint32_t field = symbols_[id].value;
  if (field >= program_.types.StructOf(type).fields.size()) return std::nullopt;
  return field;
}

bool Checker::DerivesFrom(ir::TypeId derived, ir::TypeId base) const {
  const StructInfo* info = InfoOf(derived);
  if (!info) return false;
  for (ir::TypeId parent : info->bases) {
    if (parent == base || DerivesFrom(parent, base)) return true;
  }
  return false;
}

ir::TypeId Checker::EnumType(const ast::EnumDecl& decl) {
  if (!decl.underlying) return program_.types.Make(ir::Scalar::kInt);
  const ir::TypeId type = ResolveType(decl.underlying);
  const ir::Type& underlying = program_.types[type];
  if (underlying.kind == ir::TypeKind::kScalar && ir::IsInteger(underlying.scalar)) return type;
  if (underlying.kind == ir::TypeKind::kScalar && underlying.scalar == ir::Scalar::kBool)
    return type;
  if (type != program_.types.Error()) {
    diagnostics_.Report(file_.types[decl.underlying].span, diag::EnumNotInteger, TypeName(type));
  }
  return program_.types.Make(ir::Scalar::kInt);
}

// A struct or enum defined inside a function.
void Checker::DeclareLocalType(ast::DeclId id) {
  if (const auto* decl = std::get_if<ast::StructDecl>(&file_.decls[id].node)) {
    struct_symbols_[id.index] = DeclareLocal(SymbolKind::kType, decl->name, id, decl->name_span);
    ResolveTypeSymbol(struct_symbols_[id.index]);
  } else if (const auto* alias = std::get_if<ast::TypedefDecl>(&file_.decls[id].node)) {
    ResolveTypeSymbol(DeclareLocal(SymbolKind::kType, alias->name, id, alias->name_span));
  } else if (const auto* enumeration = std::get_if<ast::EnumDecl>(&file_.decls[id].node)) {
    const SymbolId symbol =
        DeclareLocal(SymbolKind::kType, enumeration->name, id, enumeration->name_span);
    struct_symbols_[id.index] = symbol;
    const ScopeId own =
        AddScope(ScopeKind::kEnum, context_.scope, enumeration->name, context_.order);
    symbols_[symbol].owner = own.index;
    for (std::uint32_t i = 0; i < enumeration->enumerators.size; ++i) {
      const ast::Enumerator& enumerator = file_.enumerators[enumeration->enumerators][i];
      const SymbolId inner =
          Declare(SymbolKind::kEnumerator, own, enumerator.name, id, enumerator.span);
      symbols_[inner].owner = symbol.index;
      symbols_[inner].value = i;
      if (enumeration->is_class) continue;
      const SymbolId outer =
          DeclareLocal(SymbolKind::kEnumerator, enumerator.name, id, enumerator.span);
      symbols_[outer].owner = symbol.index;
      symbols_[outer].value = i;
    }
  }
}

// All values of the enum `id`, in order; a value may use the ones before it.
void Checker::ResolveEnum(SymbolId id, const ast::EnumDecl& decl) {
  if (!enum_values_.try_emplace(id.index).second) return;
  Context context = ContextOf(id);
  context.scope = ScopeId{symbols_[id].owner};
  const ContextSwitch in(*this, context);
  std::int64_t next = 0;
  for (std::uint32_t i = 0; i < decl.enumerators.size; ++i) {
    const ast::Enumerator& enumerator = file_.enumerators[decl.enumerators][i];
    if (enumerator.value) next = ConstantInteger(enumerator.value).value_or(next);
    enum_values_[id.index].push_back(static_cast<std::uint32_t>(next++));
  }
}

}  // namespace clipc
