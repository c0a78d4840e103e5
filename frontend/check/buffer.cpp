// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/buffer.h"

#include <algorithm>
#include <utility>

#include "frontend/check/assign.h"
#include "frontend/check/global.h"
#include "frontend/check/init.h"
#include "frontend/check/type.h"
#include "frontend/check/vulkan.h"
#include "frontend/rules/registers.h"
#include "ir/evaluate.h"
#include "ir/packing.h"

namespace clipc::check {
namespace {

// Keeps the components of the initial value of a member. It has no meaning for the shader:
// Direct3D's reflection has it (D3D11_SHADER_VARIABLE_DESC::DefaultValue), and effects set it.
void KeepInitial(Context& context, const ast::VarDecl& var, VarId member) {
  const Span span = context[member].span;
  const ExprId value = CheckInit(context, var.init, context[member].type);
  auto components = context.IsError(value) ? std::nullopt : ConstantBits(context.program, value);
  if (components)
    context.globals.initial.emplace(member.index, std::move(*components));
  else if (!context.diagnostics.has_errors())
    context.Report(span, diag::InitialValueUnknown, context[var.name]);
}

void ResolveMember(Context& context, Buffer& buffer, SymbolId id) {
  Symbol& symbol = context[id];
  const auto& var = context.Get<ast::VarDecl>(symbol.decl);
  if (buffer.kind == CbufferKind::kGlobals &&
      (symbol.resolution == Resolution::kDone || IsBuffer(context, var) ||
       HasConstantId(context, var.attributes)))
    return;
  const TypeId type = ResolveVarType(context, var);
  if (context.IsError(type) || type == context.types.String()) return;
  if (HoldsObjects(context, type)) {
    if (buffer.kind == CbufferKind::kGlobals) return;
    return ResolveObject(context, id, var, type);
  }
  const ast::Qualifiers qualifiers = QualifiersOf(context, var);
  const VarId result = AddVar(context, var.name, type, Storage::kUniform, symbol.span);
  context[result].row_major = IsRowMajor(context, qualifiers);
  MarkConst(context, result);
  symbol.owner =
      (buffer.kind == CbufferKind::kGlobals ? context.globals.buffer.index : symbol.owner);
  symbol.is_const = (qualifiers & ast::kConst) != 0;
  symbol.Resolve(result.index);
  if (var.init) KeepInitial(context, var, result);
}

// Adds the letters of the registers that the objects in a struct take.
void AddObjectLetters(const Context& context, TypeId type, std::string& letters) {
  type = context.types.Innermost(type);
  if (context[type].kind == TypeKind::kObject) {
    const char letter = RegisterLetter(context[type].object);
    if (letters.find(letter) == letters.npos) letters += letter;
  }
  if (context[type].kind != TypeKind::kStruct) return;
  for (const Field& field : context.types.StructOf(type).fields)
    AddObjectLetters(context, field.type, letters);
}

// Keeps the registers of the objects in a uniform struct, one for each letter: vkd3d's
// register-reservations-resources.shader_test, line 213.
void KeepObjectRegisters(Context& context, const ast::VarDecl& var, VarId made,
                         std::string_view letters) {
  for (const char letter : letters) {
    const auto* binding = BindingOf(context, context[var.name], var.registers, letter);
    if (!binding || binding->letter != letter) continue;
    context.globals.struct_registers[made].push_back(
        {letter, NumberOf(context, *binding), binding->space, true});
  }
}

void FinishMember(Context& context, const Buffer& buffer, const ast::VarDecl& var,
                  CbufferMember& member) {
  const Var& made = context[member.var];
  const auto start_at = [&](std::uint32_t row, std::uint32_t component, Span span) {
    constexpr std::uint32_t kRow = 16, kMaxRows = 65536;
    if (row >= kMaxRows) {
      context.Report(span, diag::RegisterTooHigh, fmt::format("c{}", row), made.name, kMaxRows - 1);
      return;
    }
    member.offset = row * kRow + component * 4;
    member.has_packoffset = true;
  };
  if (const auto& place = var.packoffset) {
    start_at(place->reg, place->component, place->span);
    if (!member.has_packoffset) return;
    if (PackedOffset(context.types, made.type, made.row_major, member.offset) != member.offset) {
      context.Report(place->span, diag::PackOffsetMisfit, made.name, context.TypeName(made.type),
                     fmt::format("`c{}.{}`", place->reg, "xyzw"[place->component]));
    }
    return;
  }
  // The registers of an object are the buffer's.
  if (var.registers.empty() || IsBuffer(context, var)) return;
  std::string letters = "cbi";
  AddObjectLetters(context, made.type, letters);
  CheckRegisterKinds(context, made.name, var.registers, letters);
  KeepObjectRegisters(context, var, member.var, std::string_view(letters).substr(3));
  if (const ast::RegisterBinding* binding = BindingOf(context, made.name, var.registers, 'c');
      binding && binding->letter == 'c') {
    if (buffer.kind != CbufferKind::kGlobals && !context.program.profile.IsDirect3D9()) {
      context.Report(binding->span, diag::RegisterWithoutEffect,
                     "a member of another buffer than `$Globals` has its place by `packoffset`");
      return;
    }
    start_at(NumberOf(context, *binding), 0, binding->span);
  }
}

// Reports a member without a packoffset in a cbuffer or tbuffer with a member that has one.
void CheckMixedPlaces(Context& context, const Buffer& buffer) {
  if (!buffer.decl || !context.GetIf<ast::BufferDecl>(buffer.decl)) return;
  const ast::VarDecl* without = nullptr;
  bool has_place = false;
  for (const SymbolId symbol : buffer.members) {
    const auto* var = context.GetIf<ast::VarDecl>(context[symbol].decl);
    const VarId made{context[symbol].value};
    if (!var || made.index == ~0u || context[made].storage != Storage::kUniform) continue;
    if (var->packoffset) has_place = true;
    if (!var->packoffset && !without) without = var;
  }
  if (has_place && without)
    context.Report(without->name_span, diag::PackOffsetMixed, context[without->name]);
}

// The variables that an expression of the program is, by VarId.
std::vector<bool> UsedVars(const Context& context) {
  std::vector<bool> used(context.program.vars.size());
  for (const ExprId expr : context.program.exprs.ids()) {
    if (const auto* ref = context.GetIf<VarRef>(expr)) used[ref->var.index] = true;
  }
  return used;
}

// Reports members of $Globals with registers in common. fxc does so from 4.0 on where one of them
// is used; Direct3D 9 where both are, and then counts only the elements of an array that are used;
// in dxc they are aliases (vkd3d's register-reservations-numeric.shader_test, checked against
// native).
void CheckCommonRegisters(Context& context, const Cbuffer& globals) {
  const Profile& profile = context.program.profile;
  if (profile.IsAtLeast(6, 0)) return;
  std::vector<const CbufferMember*> placed;
  for (const CbufferMember& member : globals.members)
    if (member.has_packoffset) placed.push_back(&member);
  std::ranges::stable_sort(placed, {}, &CbufferMember::offset);
  std::vector<bool> used;
  std::uint64_t end = 0;
  const CbufferMember* last = nullptr;  // the one that reaches as far as `end`
  for (const CbufferMember* member : placed) {
    const Var& var = context[member->var];
    if (last && member->offset < end &&
        (!profile.IsDirect3D9() || member->offset == last->offset)) {
      if (used.empty()) used = UsedVars(context);
      const int count = used[last->var.index] + used[member->var.index];
      if (count > (profile.IsDirect3D9() ? 1 : 0)) {
        const Var& other = context[last->var];
        context
            .Report(var.span, diag::RegisterTwice, other.name, var.name,
                    fmt::format("c{}", member->offset / 16))
            .Note(other.span, diag::DeclaredHere, other.name);
      }
    }
    const std::uint64_t size = PackedExtent(context.types, var.type, var.row_major).size;
    if (last && member->offset + size < end) continue;
    end = member->offset + size;
    last = member;
  }
}

void FinishBuffer(Context& context, const Buffer& buffer) {
  Cbuffer result;
  result.kind = buffer.kind;
  List<ast::RegisterBinding> registers;
  List<ast::Attr> attributes;
  if (buffer.kind == CbufferKind::kGlobals) {
    result.name = "$Globals";
  } else if (buffer.kind == CbufferKind::kParams) {
    result.name = "$Params";
  } else if (const auto* decl = context.GetIf<ast::BufferDecl>(buffer.decl)) {
    result.name = context[decl->name];
    result.span = decl->name ? decl->name_span : context[buffer.decl].span;
    registers = decl->registers;
    attributes = decl->attributes;
  } else {
    const auto& var = context.Get<ast::VarDecl>(buffer.decl);
    result.name = context[var.name];
    result.span = var.name_span;
    registers = var.registers;
    attributes = var.attributes;
  }
  const bool is_texture = buffer.kind == CbufferKind::kTbuffer;
  result.is_push_constant = IsPushConstant(context, attributes);
  const char letter = is_texture ? 't' : 'b';
  result.reg = RegisterOf(context, result.name, registers, attributes, letter);
  CheckRegisterKinds(context, result.name, registers, {&letter, 1});
  const CbufferId id{context.program.cbuffers.size()};
  result.members.reserve(buffer.members.size());
  for (SymbolId symbol : buffer.members) {
    const bool is_member =
        context[symbol].value != ~0u && context[symbol].kind == SymbolKind::kVariable;
    const VarId var{context[symbol].value};
    if (!is_member || context[var].storage != Storage::kUniform) continue;
    if (buffer.kind == CbufferKind::kGlobals &&
        context[symbol].owner != context.globals.buffer.index)
      continue;
    CbufferMember member;
    member.var = var;
    if (auto kept = context.globals.initial.find(var.index); kept != context.globals.initial.end())
      member.initial = std::move(kept->second);
    FinishMember(context, buffer, context.Get<ast::VarDecl>(context[symbol].decl), member);
    context[var].cbuffer = id;
    if (buffer.kind == CbufferKind::kConstantBuffer) {
      result.count = RegisterCount(context.types, context[var].type);
      member.has_packoffset = false;
    }
    result.members.push_back(std::move(member));
  }
  CheckMixedPlaces(context, buffer);
  if (buffer.kind == CbufferKind::kGlobals) CheckCommonRegisters(context, result);
  context.program.cbuffers.Add(std::move(result));
}

}  // namespace

bool IsBufferObject(const Context& context, const ast::VarDecl& var) {
  const ast::Type& type = context[var.type];
  if (!type.has_arguments || !type.name.scopes.empty()) return false;
  const std::string_view text = context[type.name.name];
  return (text == "ConstantBuffer" || text == "TextureBuffer") &&
         !context.names.FindUnqualified(type.name.name, true);
}

bool IsBuffer(const Context& context, const ast::VarDecl& var) {
  return IsPushConstant(context, var.attributes) || IsBufferObject(context, var);
}

void ResolveBuffer(Context& context, SymbolId id, const ast::VarDecl& var) {
  Buffer buffer;
  buffer.decl = context[id].decl;
  buffer.kind = context[context[var.type].name.name] == "TextureBuffer"
                    ? CbufferKind::kTbuffer
                    : CbufferKind::kConstantBuffer;
  buffer.scope = context[id].scope;
  buffer.order = OrderOf(context, id);
  buffer.members.push_back(id);
  const BufferId buffer_id = context.globals.buffers.Add(std::move(buffer));
  context[id].owner = buffer_id.index;
  ReachBuffer(context, buffer_id);
}

void ReachBuffer(Context& context, BufferId id) {
  Buffer& buffer = context[id];
  if (buffer.resolution != Resolution::kNone) return;
  buffer.resolution = Resolution::kUnderWay;
  for (std::size_t i = 0; i < buffer.members.size(); ++i) {
    const SymbolId member = buffer.members[i];
    View view = ViewOf(context, member);
    if (buffer.kind == CbufferKind::kCbuffer || buffer.kind == CbufferKind::kTbuffer)
      view.order = buffer.order;
    const ViewSwitch in(context, view);
    ResolveMember(context, buffer, member);
  }
  buffer.resolution = Resolution::kDone;
}

void FinishBuffers(Context& context) {
  std::vector<BufferId> reached;
  for (BufferId id : context.globals.buffers.ids()) {
    if (context[id].resolution != Resolution::kNone) reached.push_back(id);
  }
  // $Globals was made first, with order 0; $Params has the highest order.
  std::ranges::stable_sort(reached, {}, [&](BufferId id) { return context[id].order; });
  for (BufferId id : reached) FinishBuffer(context, context[id]);
}

}  // namespace clipc::check
