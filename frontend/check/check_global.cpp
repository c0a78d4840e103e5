// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/checker.h"

// Variables outside functions: uniforms and their buffers, statics, resources.
namespace clipc {

// Works out what a variable is. False after an error, which was reported.
bool Checker::ResolveVar(SymbolId id) {
  Symbol& symbol = symbols_[id];
  if (symbol.resolution == Resolution::kNone) {
    const Depth depth(*this, symbol.span, kDeclarationWeight);
    symbol.resolution = Resolution::kUnderWay;
    if (depth.ok()) ResolveGlobal(id, std::get<ast::VarDecl>(file_.decls[symbol.decl].node));
    symbol.resolution = Resolution::kDone;
  } else if (symbol.resolution == Resolution::kUnderWay) {
    diagnostics_.Report(symbol.span, diag::InitialisedByItself, Text(symbol.name));
    symbol.resolution = Resolution::kDone;
  }
  return symbol.value != ~0u;
}

void Checker::ResolveGlobal(SymbolId id, const ast::VarDecl& var) {
  const std::uint32_t buffer = symbols_[id].owner;
  if (buffer != ~0u) return ReachBuffer(BufferId{buffer});
  const ContextSwitch in(*this, ContextOf(id));
  if (IsConstantBuffer(var)) return ResolveConstantBuffer(id, var);
  if (var.qualifiers & (ast::kStatic | ast::kGroupShared)) return ResolveStatic(id, var);
  const ir::TypeId type = ResolveVarType(var);
  if (type == program_.types.Error()) return;
  if (type == program_.types.String()) {
    diagnostics_.Report(symbols_[id].span, diag::StringUsed, Text(var.name));
  } else if (HoldsObjects(type)) {
    ResolveObject(id, var, type);
  } else {
    ReachBuffer(globals_buffer_);
  }
}

bool Checker::HoldsObjects(ir::TypeId type) const {
  while (program_.types[type].kind == ir::TypeKind::kArray) type = program_.types[type].element;
  return program_.types[type].kind == ir::TypeKind::kObject;
}

ir::VarId Checker::AddVar(Name name, ir::TypeId type, ir::Storage storage, Span span) {
  ir::Var var;
  var.name = Text(name);
  var.type = type;
  var.storage = storage;
  var.span = span;
  return program_.vars.Add(std::move(var));
}

// Where a declaration stands among those of namespaces.
std::uint32_t Checker::OrderOf(SymbolId id) const {
  const ScopeId scope = symbols_[id].scope;
  if (!scope) return context_.order;
  return scopes_[scope].kind == ScopeKind::kNamespace ? id.index : scopes_[scope].order;
}

void Checker::ResolveStatic(SymbolId id, const ast::VarDecl& var) {
  const ir::TypeId type = ResolveVarType(var);
  if (type == program_.types.Error()) return;
  const ir::ExprId init = var.init ? CheckInit(var.init, type) : ir::ExprId{};
  if (init && IsError(init)) return;
  if (HoldsObjects(type)) {
    // An alias of the object it is initialised with.
    const auto* ref = init ? std::get_if<ir::VarRef>(&program_.exprs[init].node) : nullptr;
    if (ref)
      symbols_[id].value = ref->var.index;
    else
      diagnostics_.Report(symbols_[id].span, diag::ObjectNotGlobal, Text(var.name), TypeName(type));
    return;
  }
  const ast::Qualifiers qualifiers = QualifiersOf(var);
  const bool is_const = (qualifiers & ast::kConst) != 0;
  const bool is_constant = is_const && init && IsConstantExpr(init);
  const ir::VarId result =
      AddVar(var.name, type, is_constant ? ir::Storage::kConstant : ir::Storage::kStatic,
             symbols_[id].span);
  program_.vars[result].init = init;
  program_.vars[result].row_major = IsRowMajor(qualifiers);
  if (is_const) MarkConst(result);
  symbols_[id].value = result.index;
  reached_globals_.push_back({OrderOf(id), result});
}

// Whether GLSL, too, takes the expression for a constant: literals and constants under pure
// operators.
bool Checker::IsConstantExpr(ir::ExprId expr) const {
  const bool reads_more = ir::AnyExpr(program_, expr, [&](ir::ExprId part) {
    const auto* ref = ir::As<ir::VarRef>(program_, part);
    return (ref && program_.vars[ref->var].storage != ir::Storage::kConstant) ||
           ir::As<ir::ObjectCall>(program_, part) || ir::As<ir::Comma>(program_, part);
  });
  return !reads_more && ir::IsPure(program_, expr);
}

void Checker::ResolveObject(SymbolId id, const ast::VarDecl& var, ir::TypeId type) {
  const ir::VarId result = AddVar(var.name, type, ir::Storage::kResource, symbols_[id].span);
  MarkConst(result);
  symbols_[id].value = result.index;
  reached_resources_.push_back({OrderOf(id), result});
  ir::TypeId element = type;
  while (program_.types[element].kind == ir::TypeKind::kArray)
    element = program_.types[element].element;
  const ir::ObjectKind object = program_.types[element].object;
  const bool is_sampler =
      object >= ir::ObjectKind::kSampler && object <= ir::ObjectKind::kSamplerCube;
  ir::Register reg;
  const bool is_written = ir::IsWritable(object);
  reg.letter = is_sampler ? 's' : is_written ? 'u' : 't';
  if (const ast::RegisterBinding* binding = BindingOf(var.registers, is_sampler   ? "s"
                                                                     : is_written ? "u"
                                                                                  : "tu")) {
    reg.number = binding->number;
    reg.space = binding->space;
    reg.is_explicit = binding->letter != 0;
  }
  resource_registers_.emplace(result.index, reg);
}

// ---- buffers

// ConstantBuffer<T> and TextureBuffer<T>, of HLSL 5.1, unless the user gave the name to something
// else.
bool Checker::IsConstantBuffer(const ast::VarDecl& var) const {
  const ast::Type& type = file_.types[var.type];
  if (!type.has_arguments || !type.name.scopes.empty()) return false;
  const std::string_view text = Text(type.name.name);
  return (text == "ConstantBuffer" || text == "TextureBuffer") &&
         !FindUnqualified(type.name.name, true);
}

void Checker::ResolveConstantBuffer(SymbolId id, const ast::VarDecl& var) {
  Buffer buffer;
  buffer.decl = symbols_[id].decl;
  buffer.kind = Text(file_.types[var.type].name.name) == "ConstantBuffer"
                    ? ir::CbufferKind::kConstantBuffer
                    : ir::CbufferKind::kTbuffer;
  buffer.scope = symbols_[id].scope;
  buffer.order = OrderOf(id);
  buffer.members.push_back(id);
  const BufferId buffer_id = buffers_.Add(std::move(buffer));
  symbols_[id].owner = buffer_id.index;
  ReachBuffer(buffer_id);
}

void Checker::ReachBuffer(BufferId id) {
  Buffer& buffer = buffers_[id];
  if (buffer.resolution != Resolution::kNone) return;
  buffer.resolution = Resolution::kUnderWay;
  for (std::size_t i = 0; i < buffer.members.size(); ++i) {
    const SymbolId member = buffer.members[i];
    Context context = ContextOf(member);
    if (buffer.kind == ir::CbufferKind::kCbuffer || buffer.kind == ir::CbufferKind::kTbuffer)
      context.order = buffer.order;
    const ContextSwitch in(*this, context);
    ResolveMember(buffer, member);
  }
  buffer.resolution = Resolution::kDone;
}

void Checker::ResolveMember(Buffer& buffer, SymbolId id) {
  Symbol& symbol = symbols_[id];
  const auto& var = std::get<ast::VarDecl>(file_.decls[symbol.decl].node);
  if (buffer.kind == ir::CbufferKind::kGlobals &&
      (symbol.resolution == Resolution::kDone || IsConstantBuffer(var)))
    return;
  const ir::TypeId type = ResolveVarType(var);
  if (type == program_.types.Error() || type == program_.types.String()) return;
  if (HoldsObjects(type)) {
    if (buffer.kind == ir::CbufferKind::kGlobals) return;
    return ResolveObject(id, var, type);
  }
  const ast::Qualifiers qualifiers = QualifiersOf(var);
  const ir::VarId result = AddVar(var.name, type, ir::Storage::kUniform, symbol.span);
  program_.vars[result].row_major = IsRowMajor(qualifiers);
  MarkConst(result);
  symbol.owner = (buffer.kind == ir::CbufferKind::kGlobals ? globals_buffer_.index : symbol.owner);
  symbol.is_const = (qualifiers & ast::kConst) != 0;
  symbol.value = result.index;
  symbol.resolution = Resolution::kDone;
}

// The binding that counts under this profile.
const ast::RegisterBinding* Checker::BindingOf(List<ast::RegisterBinding> bindings,
                                               std::string_view letters) const {
  const ast::RegisterBinding* best = nullptr;
  for (const ast::RegisterBinding& binding : file_.registers[bindings]) {
    if (binding.letter != 0 && letters.find(binding.letter) == std::string_view::npos) continue;
    if (!binding.profile) {
      if (!best) best = &binding;
    } else if (std::string_view profile = Text(binding.profile);
               EqualIgnoringCase(profile, options_.profile.name) ||
               EqualIgnoringCase(profile, options_.profile.stage)) {
      best = &binding;
    }
  }
  return best;
}

// ---- the end of the check: what was reached goes into the program, in the order of the text

void Checker::FinishBuffers() {
  std::vector<BufferId> reached;
  for (BufferId id : buffers_.ids()) {
    if (buffers_[id].resolution != Resolution::kNone) reached.push_back(id);
  }
  // $Globals was made first, with order 0; $Params has the highest.
  std::stable_sort(reached.begin(), reached.end(),
                   [&](BufferId a, BufferId b) { return buffers_[a].order < buffers_[b].order; });
  for (BufferId id : reached) FinishBuffer(buffers_[id]);
}

void Checker::FinishBuffer(const Buffer& buffer) {
  ir::Cbuffer result;
  result.kind = buffer.kind;
  List<ast::RegisterBinding> registers;
  if (buffer.kind == ir::CbufferKind::kGlobals) {
    result.name = "$Globals";
  } else if (buffer.kind == ir::CbufferKind::kParams) {
    result.name = "$Params";
  } else if (const auto* decl = std::get_if<ast::BufferDecl>(&file_.decls[buffer.decl].node)) {
    result.name = Text(decl->name);
    result.span = decl->name ? decl->name_span : file_.decls[buffer.decl].span;
    registers = decl->registers;
  } else {
    const auto& var = std::get<ast::VarDecl>(file_.decls[buffer.decl].node);
    result.name = Text(var.name);
    result.span = var.name_span;
    registers = var.registers;
  }
  const bool is_texture = buffer.kind == ir::CbufferKind::kTbuffer;
  result.reg.letter = is_texture ? 't' : 'b';
  if (const ast::RegisterBinding* binding = BindingOf(registers, is_texture ? "t" : "b")) {
    result.reg.number = binding->number;
    result.reg.space = binding->space;
    result.reg.is_explicit = binding->letter != 0;
  }
  const ir::CbufferId id{program_.cbuffers.size()};
  result.members.reserve(buffer.members.size());
  for (SymbolId symbol : buffer.members) {
    const bool is_member =
        symbols_[symbol].value != ~0u && symbols_[symbol].kind == SymbolKind::kVariable;
    const ir::VarId var{symbols_[symbol].value};
    if (!is_member || program_.vars[var].storage != ir::Storage::kUniform) continue;
    if (buffer.kind == ir::CbufferKind::kGlobals && symbols_[symbol].owner != globals_buffer_.index)
      continue;
    ir::CbufferMember member;
    member.var = var;
    FinishMember(std::get<ast::VarDecl>(file_.decls[symbols_[symbol].decl].node), member);
    program_.vars[var].cbuffer = id;
    if (buffer.kind == ir::CbufferKind::kConstantBuffer) {
      result.count = CountOfArray(program_.vars[var].type);
      member.has_packoffset = false;
    }
    result.members.push_back(member);
  }
  program_.cbuffers.Add(std::move(result));
}

void Checker::FinishMember(const ast::VarDecl& var, ir::CbufferMember& member) {
  constexpr std::uint32_t kRow = 16, kMaxRow = 65536;
  if (var.packoffset && var.packoffset->reg < kMaxRow) {
    member.offset = var.packoffset->reg * kRow + var.packoffset->component * 4;
    member.has_packoffset = true;
  } else if (const ast::RegisterBinding* binding = BindingOf(var.registers, "c");
             binding && binding->letter == 'c') {
    if (binding->number >= kMaxRow) return;
    member.offset = binding->number * kRow;
    member.has_packoffset = true;
  }
}

// Of T[2][3]: 6; of T: 1.
std::uint32_t Checker::CountOfArray(ir::TypeId type) const {
  std::uint32_t count = 1;
  for (; program_.types[type].kind == ir::TypeKind::kArray; type = program_.types[type].element) {
    count *= program_.types[type].count;
  }
  return count;
}

void Checker::FinishGlobals() {
  const auto before = [](const Ordered& a, const Ordered& b) { return a.order < b.order; };
  std::stable_sort(reached_globals_.begin(), reached_globals_.end(), before);
  for (const Ordered& global : reached_globals_) program_.globals.push_back(global.var);
  std::stable_sort(reached_resources_.begin(), reached_resources_.end(), before);
  for (const Ordered& resource : reached_resources_) {
    program_.resources.push_back({resource.var, resource_registers_.at(resource.var.index)});
  }
}

}  // namespace clipc
