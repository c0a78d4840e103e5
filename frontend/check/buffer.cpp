// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/buffer.h"

#include <algorithm>
#include <utility>

#include "frontend/check/assign.h"
#include "frontend/check/global.h"
#include "frontend/check/init.h"
#include "frontend/check/type.h"
#include "frontend/check/vulkan.h"
#include "frontend/resolve/registers.h"
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
    if (buffer.kind == CbufferKind::kConstantBuffer) {  // a push constant
      context.Report(symbol.span, diag::PushConstantNotStruct, context[var.name],
                     context.TypeName(type));
      return;
    }
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

// How much of a variable the program uses.
struct Use {
  bool is_used = false;
  std::uint32_t elements = 0;  // of an array: those that are used for certain
};

// By VarId. A loop that is unrolled may use few elements of an array, so an index that is not a
// constant counts only where it follows from uniforms and the inputs of the entry function alone.
std::vector<Use> UsesOf(const Context& context) {
  const Program& program = context.program;
  std::vector<Use> uses(program.vars.size());
  for (const ExprId expr : program.exprs.ids()) {
    if (const auto* ref = context.GetIf<VarRef>(expr)) uses[ref->var.index].is_used = true;
    const auto* index = context.GetIf<Index>(expr);
    const auto* array = index ? context.GetIf<VarRef>(index->base) : nullptr;
    if (!array || program.types[program.vars[array->var].type].kind != TypeKind::kArray) continue;
    Use& use = uses[array->var.index];
    const std::uint32_t count = program.types[program.vars[array->var].type].count;
    if (const auto bits = ConstantBits(program, index->index)) {
      const auto least =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(bits->front(), count - 1));
      use.elements = std::max(use.elements, least + 1);
      continue;
    }
    const auto& inputs = program.functions[program.entry].parameters;
    const bool is_unknown = AnyExpr(program, index->index, [&](ExprId part) {
      const auto* ref = As<VarRef>(program, part);
      if (!ref) return As<Call>(program, part) != nullptr;
      return program.vars[ref->var].storage != Storage::kUniform &&
             std::ranges::find(inputs, ref->var) == inputs.end();
    });
    if (!is_unknown) use.elements = count;
  }
  return uses;
}

// The bytes from the member's first on that are used for certain: the first of them for what is not
// an array, whose last columns or fields may be unused.
std::uint64_t UsedBytes(const Context& context, const Var& var, const Use& use) {
  const Type& type = context[var.type];
  if (type.kind != TypeKind::kArray || use.elements == 0) return use.is_used ? 1 : 0;
  const std::uint64_t step =
      (PackedExtent(context.types, type.element, var.row_major).size + 15) / 16 * 16;
  return step * (use.elements - 1) + 1;
}

// Calls `report(first, second)` for members that have components in common.
void ForEachOverlap(const Context& context, std::vector<const CbufferMember*> placed,
                    auto&& report) {
  std::ranges::stable_sort(placed, {}, &CbufferMember::offset);
  std::uint64_t end = 0;
  const CbufferMember* last = nullptr;  // the one that reaches as far as `end`
  for (const CbufferMember* member : placed) {
    if (last && member->offset < end) report(*last, *member);
    const Var& var = context[member->var];
    const std::uint64_t size = PackedExtent(context.types, var.type, var.row_major).size;
    if (last && member->offset + size < end) continue;
    end = member->offset + size;
    last = member;
  }
}

// "c2.y", the place of the byte in the registers.
std::string PlaceOf(std::uint32_t byte) {
  return fmt::format("c{}.{}", byte / 16, "xyzw"[byte % 16 / 4]);
}

// Reports members of a cbuffer or tbuffer whose `packoffset` gives them components in common: fxc
// does where the buffer is used (vkd3d's cbuffer.shader_test, checked against native), dxc
// everywhere. In Direct3D 9 both must be used, as with register(c#).
void CheckOverlaps(Context& context, const Buffer& buffer, const Cbuffer& made) {
  if (!buffer.decl || !context.GetIf<ast::BufferDecl>(buffer.decl)) return;
  std::vector<const CbufferMember*> placed;
  std::size_t i = 0;
  for (const CbufferMember& member : made.members) {
    while (VarId{context[buffer.members[i]].value} != member.var) ++i;
    if (context.Get<ast::VarDecl>(context[buffer.members[i]].decl).packoffset)
      placed.push_back(&member);
  }
  if (placed.size() < 2) return;
  std::vector<Use> uses;
  if (context.program.profile.IsDirect3D9()) uses = UsesOf(context);
  ForEachOverlap(context, placed, [&](const CbufferMember& first, const CbufferMember& second) {
    if (!uses.empty() && !(uses[first.var.index].is_used && uses[second.var.index].is_used)) return;
    const Var &one = context[first.var], &other = context[second.var];
    const std::uint32_t last =
        first.offset + PackedExtent(context.types, one.type, one.row_major).size - 4;
    context
        .Report(other.span, diag::PackOffsetOverlap, other.name, PlaceOf(second.offset), one.name,
                fmt::format("{} to {}", PlaceOf(first.offset), PlaceOf(last)))
        .Note(one.span, diag::DeclaredHere, one.name);
  });
}

// Reports members of $Globals with registers in common. fxc does so from 4.0 on where one of them
// is used; Direct3D 9 where both are, and then counts only the elements of an array that are used;
// in dxc they are aliases (vkd3d's register-reservations-numeric.shader_test, checked against
// native), but under -spirv an error (DXC's CodeGenSPIRV/cbuffer.overlap.hlsl).
void CheckCommonRegisters(Context& context, const Cbuffer& globals) {
  const Profile& profile = context.program.profile;
  std::vector<const CbufferMember*> placed;
  for (const CbufferMember& member : globals.members)
    if (member.has_packoffset) placed.push_back(&member);
  std::vector<Use> uses;
  ForEachOverlap(context, placed, [&](const CbufferMember& first, const CbufferMember& second) {
    if (uses.empty()) uses = UsesOf(context);
    const Var &one = context[first.var], &other = context[second.var];
    const Use &use = uses[first.var.index], &other_use = uses[second.var.index];
    const std::uint64_t used = first.offset + UsedBytes(context, one, use);
    const bool is_shared = profile.IsDirect3D9()     ? other_use.is_used && second.offset < used
                           : profile.IsAtLeast(6, 0) ? use.is_used && other_use.is_used
                                                     : use.is_used || other_use.is_used;
    if (!is_shared) return;
    const std::string place = fmt::format("c{}", second.offset / 16);
    auto&& report =
        profile.IsAtLeast(6, 0)
            ? context.Report(other.span, diag::RegisterShared, one.name, other.name, place)
            : context.Report(other.span, diag::RegisterTwice, one.name, other.name, place);
    report.Note(one.span, diag::DeclaredHere, one.name);
  });
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
    // GLSL's uniform block has no array without a size in it.
    const Type& type = context[context[var].type];
    if (buffer.kind == CbufferKind::kTbuffer && type.kind == TypeKind::kArray && type.count == 0)
      context.Report(context[var].span, diag::Unsupported,
                     "a `TextureBuffer` array without a size");
    result.members.push_back(std::move(member));
  }
  CheckMixedPlaces(context, buffer);
  CheckOverlaps(context, buffer, result);
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
