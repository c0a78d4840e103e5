// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/reserved.h"

#include "frontend/check/buffer.h"
#include "frontend/check/global.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/parse/keywords.h"

namespace clipc::check {
namespace {

// Whether the type is written as one that HLSL has built in: Texture2D<float4>.
bool IsWrittenObject(const Context& context, const ast::Type& type) {
  return !type.struct_definition && type.name.name && type.name.scopes.empty() &&
         ClassifyWord(context[type.name.name]).word == Word::kObjectType;
}

// Adds `count` registers of the letter, if one is written.
void Add(Context& context, List<ast::RegisterBinding> bindings, char letter, std::uint32_t count,
         std::vector<ReservedRegisters>& list) {
  const bool is_dxc = context.program.profile.IsAtLeast(6, 0);
  const auto* binding = BindingOf(context, "", bindings, letter, false);
  // In dxc a letter of another kind does not matter: line 84 of that file.
  if (!binding && is_dxc) binding = &context[bindings].back();
  if (!binding || binding->letter == 0) return;
  const std::uint32_t number = is_dxc ? binding->number : NumberOf(context, *binding);
  list.push_back({{letter, number, binding->space, true}, count});
}

void AddObject(Context& context, const ast::VarDecl& var, std::vector<ReservedRegisters>& list) {
  const TypeId type = ResolveVarType(context, var);
  if (context.IsError(type) || !HoldsObjects(context, type)) return;
  const ObjectKind kind = context[context.types.Innermost(type)].object;
  if (kind == ObjectKind::kOther) return;
  Add(context, var.registers, RegisterLetter(kind), RegisterCount(context.types, type), list);
}

// Whether the symbol is a variable outside of functions and buffers that nothing reached names.
bool IsUnusedGlobal(const Context& context, const Symbol& symbol) {
  return symbol.kind == SymbolKind::kVariable && symbol.resolution == Resolution::kNone &&
         symbol.owner == ~0u && symbol.scope && context[symbol.scope].kind == ScopeKind::kNamespace;
}

}  // namespace

std::vector<ReservedRegisters> RegistersOfUnused(Context& context) {
  std::vector<ReservedRegisters> list;
  for (const SymbolId id : context.names.symbol_ids()) {
    if (!IsUnusedGlobal(context, context[id])) continue;
    const auto* var = context.GetIf<ast::VarDecl>(context[id].decl);
    if (!var) continue;
    const ast::Type& type = context[var->type];
    const bool has_register =
        !var->registers.empty() && !(var->qualifiers & (ast::kStatic | ast::kGroupShared));
    const bool may_misfit = MayMisfit(context, type);
    if (!has_register && !may_misfit) continue;
    const ViewSwitch in(context, ViewOf(context, id));
    if (may_misfit && !CheckTypeArgument(context, type)) continue;
    if (has_register && IsWrittenObject(context, type)) AddObject(context, *var, list);
  }
  for (const BufferId id : context.globals.buffers.ids()) {
    const Buffer& buffer = context[id];
    if (buffer.resolution != Resolution::kNone || !buffer.decl) continue;
    const auto* decl = context.GetIf<ast::BufferDecl>(buffer.decl);
    if (!decl || decl->registers.empty()) continue;
    Add(context, decl->registers, buffer.kind == CbufferKind::kTbuffer ? 't' : 'b', 1, list);
  }
  return list;
}

void ReachAllBindings(Context& context) {
  for (const SymbolId id : context.names.symbol_ids()) {
    if (!IsUnusedGlobal(context, context[id])) continue;
    const auto* var = context.GetIf<ast::VarDecl>(context[id].decl);
    if (!var || (var->qualifiers & (ast::kStatic | ast::kGroupShared))) continue;
    if (IsWrittenObject(context, context[var->type]) || IsBuffer(context, *var))
      ResolveVar(context, id);
  }
  for (const BufferId id : context.globals.buffers.ids()) {
    if (context[id].decl) ReachBuffer(context, id);
  }
}

}  // namespace clipc::check
