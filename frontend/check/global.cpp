// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/global.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/spelling.h"
#include "frontend/check/assign.h"
#include "frontend/check/buffer.h"
#include "frontend/check/init.h"
#include "frontend/check/scope.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"
#include "frontend/check/vulkan.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::check {
namespace {

// Resolves a variable that is `groupshared`. Files share such memory between their compute shaders
// and others, which do not use it: an error in those.
void ResolveShared(Context& context, SymbolId id, const ast::VarDecl& var) {
  const StageInfo& stage = InfoOf(context.program.stage);
  if (!stage.runs_in_groups) {
    context.Report(context[id].span, diag::GroupShared, context[var.name], stage.name);
    return ResolveStatic(context, id, var);
  }
  const TypeId type = ResolveVarType(context, var);
  if (context.IsError(type)) return;
  if (HoldsObjects(context, type)) {
    context.Report(context[id].span, diag::SharedObject, context[var.name], context.TypeName(type));
    return;
  }
  if (var.init) context.Report(context[id].span, diag::SharedInitialiser, context[var.name]);
  const VarId result = AddVar(context, var.name, type, Storage::kShared, context[id].span);
  context[id].value = result.index;
  context.globals.reached.push_back({OrderOf(context, id), result});
}

void ResolveGlobal(Context& context, SymbolId id, const ast::VarDecl& var) {
  const std::uint32_t buffer = context[id].owner;
  if (buffer != ~0u) return ReachBuffer(context, BufferId{buffer});
  const ViewSwitch in(context, ViewOf(context, id));
  if (IsBuffer(context, var)) return ResolveBuffer(context, id, var);
  if ((var.qualifiers & (ast::kStatic | ast::kGroupShared)) ||
      HasConstantId(context, var.attributes)) {
    const bool is_shared = (var.qualifiers & ast::kGroupShared) != 0;
    return is_shared ? ResolveShared(context, id, var) : ResolveStatic(context, id, var);
  }
  const TypeId type = ResolveVarType(context, var);
  if (context.IsError(type)) return;
  if (type == context.types.String()) {
    context.Report(context[id].span, diag::StringUsed, context[var.name]);
  } else if (HoldsObjects(context, type)) {
    ResolveObject(context, id, var, type);
  } else {
    ReachBuffer(context, context.globals.buffer);
  }
}

// Marks the variables and objects that the value changes, itself or in the functions that it calls.
void MarkChanged(const Program& program, ExprId value, std::vector<bool>& is_function_seen,
                 std::vector<bool>& is_changed) {
  std::vector<FunctionId> waiting;
  const auto mark = [&](ExprId part) {
    const auto change = [&](ExprId path) {
      if (const VarId root = RootOf(program, path)) is_changed[root.index] = true;
    };
    ForEachWrite(program, part, change);
    const auto* object = As<ObjectCall>(program, part);
    if (object && WritesObject(object->op))
      change(OperandOf(program, *object, OperandKind::kObject));
    const auto* call = As<Call>(program, part);
    if (!call || is_function_seen[call->function.index]) return;
    is_function_seen[call->function.index] = true;
    waiting.push_back(call->function);
  };
  ForEachExpr(program, value, mark);
  while (!waiting.empty()) {
    const FunctionId function = waiting.back();
    waiting.pop_back();
    ForEachExpr(program, program.functions[function].body, mark);
  }
}

// Moves an initialiser of a variable outside of functions to the beginning of `main` if it calls a
// function or takes several steps, since an initialiser there must not have effects, or if it reads
// a texture, a buffer, or a variable whose initialiser was moved or that a moved one changes.
// Returns the statements that these are now.
std::vector<StmtId> InitialiseInMain(Program& program) {
  std::vector<bool> is_moved(program.vars.size()), is_seen(program.functions.size());
  std::vector<StmtId> body;
  for (const VarId global : program.globals) {
    ExprId value = program.vars[global].init;
    const auto is_late = [&](ExprId part) {
      const auto* ref = As<VarRef>(program, part);
      return As<ObjectCall>(program, part) || (ref && is_moved[ref->var.index]);
    };
    if (!value || (IsPure(program, value) && !AnyExpr(program, value, is_late))) continue;
    is_moved[global.index] = true;
    MarkChanged(program, value, is_seen, is_moved);
    Builder at(program, program.exprs[value].span);
    while (const auto* comma = As<Comma>(program, value)) {
      const auto [first, second] = *comma;
      body.push_back(at.Eval(first));
      value = second;
    }
    body.push_back(at.Eval(at.AssignTo(at.Ref(global), value)));
    program.vars[global].init = {};
  }
  if (body.empty()) return body;
  const std::span<const StmtId> old = MainBody(program);
  std::vector<StmtId> all = body;
  all.insert(all.end(), old.begin(), old.end());
  SetMainBody(program, all);
  return body;
}

ExprId CheckStaticInit(Context& context, SymbolId id, const ast::VarDecl& var, TypeId type) {
  if (var.init) return CheckInit(context, var.init, type);
  const ast::ExprId init = InitOf(context, id, var);
  if (!init) return {};
  const ViewSwitch in_struct(context, context.ViewFrom(context[id].scope, ~0u));
  return CheckInit(context, init, type);
}

// Whether the binding counts under this profile: register(vs_5_0, b0) does under one only, up to
// 5.0.
bool IsForProfile(const Context& context, const ast::RegisterBinding& binding) {
  if (binding.rest == ast::RegisterBinding::Rest::kProfileNumber) return false;
  const std::string_view profile = context[binding.profile];
  return !binding.profile || context.program.profile.IsAtLeast(5, 1) ||
         EqualIgnoringCase(profile, context.options.profile.name) ||
         EqualIgnoringCase(profile, context.options.profile.Prefix());
}

// The binding as in a message: "`t3`".
std::string TextOf(const ast::RegisterBinding& binding) {
  return fmt::format("`{}{}`", binding.letter, binding.number);
}

// Reports what the register of a variable with registers of `letters` has too much, as vkd3d's
// register-reservations-numeric.shader_test and -profile have it, checked against fxc and DXC: fxc
// takes text after a number, but not after `b`, which it does not read before a number of $Globals.
void CheckRest(Context& context, const ast::RegisterBinding& binding, std::string_view letters) {
  using Rest = ast::RegisterBinding::Rest;
  if (binding.rest == Rest::kNone) return;
  const Profile& profile = context.program.profile;
  const bool is_unread = binding.letter == 'b' && letters[0] == 'c' && profile.IsAtLeast(4, 0);
  if (profile.IsAtLeast(6, 0) || (binding.letter == 'b' && !is_unread)) {
    context.Report(binding.span, diag::BadRegister, "text after " + TextOf(binding));
  } else if (binding.rest == Rest::kProfileNumber || is_unread) {
    context.Report(binding.span, diag::RegisterWithoutEffect, "fxc does not read it");
  } else {
    context.Report(binding.span, diag::RegisterRest, TextOf(binding));
  }
}

// The binding that counts where their profiles do not: the first one in 5.1, the last one from 6.0
// on (vkd3d's register-reservations-space.shader_test and -profile, checked against fxc and dxc).
const ast::RegisterBinding* OfAnyProfile(Context& context, std::string_view name,
                                         List<ast::RegisterBinding> bindings, char letter,
                                         bool is_used) {
  const bool takes_last = context.program.profile.IsAtLeast(6, 0);
  const ast::RegisterBinding *taken = nullptr, *before = nullptr;
  for (const ast::RegisterBinding& binding : context[bindings]) {
    if (binding.letter != 0 && binding.letter != letter) continue;
    if (!is_used) {
    } else if (before && binding.profile == before->profile && binding.number != before->number) {
      context.Report(binding.span, diag::RegisterConflict, name, TextOf(*before), TextOf(binding));
    } else if (taken) {
      context.Report((takes_last ? *taken : binding).span, diag::RegisterWithoutEffect,
                     takes_last ? "from shader model 6 on the last one counts, whatever its profile"
                                : "in shader model 5.1 the first one counts, whatever its profile");
    }
    before = &binding;
    if (!taken || takes_last) taken = &binding;
  }
  return taken;
}

// Reports an object that the profile does not have.
void CheckObjectModel(Context& context, TypeId type, Span span) {
  const Program& program = context.program;
  const int model = FirstModelOf(context[type].object, InfoOf(program.stage));
  if (context[type].kind != TypeKind::kObject || program.is_interface_only ||
      program.profile.HasModel(model))
    return;
  context.Report(span, diag::TypeProfile, context.TypeName(type),
                 fmt::format("{}_{}_{}", InfoOf(program.stage).prefix, model / 10, model % 10),
                 program.profile.name);
}

}  // namespace

bool ResolveVar(Context& context, SymbolId id) {
  Symbol& symbol = context[id];
  if (symbol.resolution == Resolution::kNone) {
    const RecursionGuard guard(context, symbol.span, RecursionGuard::kDeclaration);
    symbol.resolution = Resolution::kUnderWay;
    if (guard.ok()) ResolveGlobal(context, id, context.Get<ast::VarDecl>(symbol.decl));
    symbol.resolution = Resolution::kDone;
  } else if (symbol.resolution == Resolution::kUnderWay) {
    context.Report(symbol.span, diag::InitialisedByItself, context[symbol.name]);
    symbol.resolution = Resolution::kDone;
  }
  return symbol.value != ~0u;
}

ast::ExprId InitOf(Context& context, SymbolId id, const ast::VarDecl& var) {
  const ScopeId scope = context[id].scope;
  if (var.init || !scope || context[scope].kind != ScopeKind::kStruct) return var.init;
  for (const ast::DeclId definition : context.globals.out_of_line.Of(context, var.name, scope)) {
    if (const ast::ExprId init = context.Get<ast::VarDecl>(definition).init) return init;
  }
  return {};
}

bool HoldsObjects(const Context& context, TypeId type) {
  return context[context.types.Innermost(type)].kind == TypeKind::kObject;
}

VarId AddVar(Context& context, Name name, TypeId type, Storage storage, Span span) {
  return context.program.vars.Add(
      {.name = std::string(context[name]), .type = type, .storage = storage, .span = span});
}

std::uint32_t OrderOf(const Context& context, SymbolId id) {
  const ScopeId scope = context[id].scope;
  if (!scope) return context.view.order;
  return context[scope].kind == ScopeKind::kNamespace ? id.index : context[scope].order;
}

void ResolveStatic(Context& context, SymbolId id, const ast::VarDecl& var) {
  const TypeId type = ResolveVarType(context, var);
  if (context.IsError(type)) return;
  const ExprId init = CheckStaticInit(context, id, var, type);
  if (init && context.IsError(init)) return;
  if (HoldsObjects(context, type)) {
    // The variable is an alias of the object that it is initialised with, or of the one that a
    // function assigns to it, which ResolveObjects finds.
    const auto* ref = init ? context.GetIf<VarRef>(init) : nullptr;
    if (ref) {
      context[id].value = ref->var.index;
    } else if (init) {
      context.Report(context[id].span, diag::ObjectNotGlobal, context[var.name],
                     context.TypeName(type));
    } else {
      context[id].value = AddVar(context, var.name, type, Storage::kStatic, context[id].span).index;
    }
    return;
  }
  AddStatic(context, id, var, type, init);
}

VarId AddStatic(Context& context, SymbolId id, const ast::VarDecl& var, TypeId type, ExprId init) {
  const ast::Qualifiers qualifiers = QualifiersOf(context, var);
  const bool is_const = (qualifiers & ast::kConst) != 0;
  const auto constant_id = ConstantIdOf(context, var.attributes);
  const bool is_known = init && IsConstantExpr(context, init);
  if (constant_id && (!is_known || context[type].kind != TypeKind::kScalar))
    context.Report(context[id].span, diag::ConstantIdNotScalar, context[var.name]);
  const bool is_constant = is_const && is_known && !constant_id;
  const VarId result =
      AddVar(context, var.name, type, is_constant ? Storage::kConstant : Storage::kStatic,
             context[id].span);
  context[result].init = init;
  context[result].row_major = IsRowMajor(context, qualifiers);
  context[result].constant_id = constant_id;
  context[result].precise = (qualifiers & ast::kPrecise) != 0;
  if (is_const || constant_id) MarkConst(context, result);
  context[id].value = result.index;
  context.globals.reached.push_back({OrderOf(context, id), result});
  return result;
}

void ResolveObject(Context& context, SymbolId id, const ast::VarDecl& var, TypeId type) {
  const VarId result = AddVar(context, var.name, type, Storage::kResource, context[id].span);
  MarkConst(context, result);
  context[result].row_major = IsRowMajor(context, ElementQualifiersOf(context, var));
  const ObjectKind kind = context[context.types.Innermost(type)].object;
  context[result].coherent = (var.qualifiers & ast::kGloballyCoherent) || IsOrdered(kind);
  context[id].value = result.index;
  context.globals.resources.push_back({OrderOf(context, id), result});
  const TypeId element = context.types.Innermost(type);
  CheckObjectModel(context, element, context[id].span);
  const char letter = RegisterLetter(context[element].object);
  context.globals.registers.emplace(
      result.index, RegisterOf(context, context[var.name], var.registers, var.attributes, letter));
  // An object that may only be declared has a register of any kind.
  if (context[element].object != ObjectKind::kOther)
    CheckRegisterKinds(context, context[var.name], var.registers, {&letter, 1});
  const TypeId texel = context[element].element;
  const Scalar components = texel ? BaseOf(context[texel].scalar) : Scalar::kFloat;
  std::string format = ImageFormatOf(context, var.attributes, components);
  if (!format.empty()) context.globals.formats.emplace(result.index, std::move(format));
  if (const auto number = InputAttachmentOf(context, var.attributes))
    context.globals.attachments.emplace(result.index, *number);
  if (const auto number = CounterBindingOf(context, var.attributes))
    context.globals.counter_bindings.emplace(result.index, *number);
}

const ast::RegisterBinding* BindingOf(Context& context, std::string_view name,
                                      List<ast::RegisterBinding> bindings, char letter,
                                      bool is_used) {
  const bool has_profiles = std::ranges::any_of(
      context[bindings], [](const ast::RegisterBinding& binding) { return bool{binding.profile}; });
  if (has_profiles && context.program.profile.IsAtLeast(5, 1))
    return OfAnyProfile(context, name, bindings, letter, is_used);
  const ast::RegisterBinding* best = nullptr;
  for (const ast::RegisterBinding& binding : context[bindings]) {
    if (binding.letter != 0 && binding.letter != letter) continue;
    if (!IsForProfile(context, binding)) continue;
    const Profile& profile = context.program.profile;
    if (is_used && binding.has_space && !profile.IsAtLeast(5, 1)) {
      context.Report(binding.span, diag::SpaceProfile, name,
                     fmt::format("{}_5_1", InfoOf(context.program.stage).prefix), profile.name);
    }
    if (!best || (binding.profile && binding.profile != best->profile)) {
      best = &binding;
      continue;
    }
    const bool same = binding.number == best->number && binding.space == best->space;
    if (is_used && binding.profile == best->profile && !same && !binding.subcomponent &&
        !best->subcomponent)
      context.Report(binding.span, diag::RegisterConflict, name, TextOf(*best), TextOf(binding));
  }
  return best;
}

void CheckRegisterKinds(Context& context, std::string_view name,
                        List<ast::RegisterBinding> bindings, std::string_view letters) {
  for (const ast::RegisterBinding& binding : context[bindings]) {
    CheckRest(context, binding, letters);
    const bool fits = binding.letter == 0 || letters.find(binding.letter) != letters.npos;
    if (!fits && IsForProfile(context, binding))
      context.Report(binding.span, diag::RegisterKind, TextOf(binding), name, letters.substr(0, 1));
  }
}

std::uint32_t NumberOf(Context& context, const ast::RegisterBinding& binding) {
  if (!binding.subcomponent) return binding.number;
  if (context.program.profile.IsAtLeast(6, 0)) {
    context.Report(binding.span, diag::RegisterWithoutEffect,
                   "the number in brackets counts up to shader model 5.1");
    return binding.number;
  }
  const auto offset = ConstantInteger(context, binding.subcomponent);
  if (!offset) return binding.number;
  // A number below 0 is as wrong as the highest one, which no profile has.
  constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::int64_t number = std::int64_t{binding.number} + std::clamp(*offset, -kMost, kMost);
  return static_cast<std::uint32_t>(number < 0 ? kMost : std::min(number, kMost));
}

Register RegisterOf(Context& context, std::string_view name, List<ast::RegisterBinding> bindings,
                    List<ast::Attr> attributes, char letter) {
  Register reg;
  reg.letter = letter;
  reg.descriptor = DescriptorOf(context, attributes);
  if (const ast::RegisterBinding* binding = BindingOf(context, name, bindings, letter)) {
    reg.number = NumberOf(context, *binding);
    reg.space = binding->space;
    reg.is_explicit = binding->letter != 0;
  }
  return reg;
}

void FinishGlobals(Context& context) {
  std::ranges::stable_sort(context.globals.reached, {}, &Globals::Ordered::order);
  for (const Globals::Ordered& global : context.globals.reached)
    context.program.globals.push_back(global.var);
  std::ranges::stable_sort(context.globals.resources, {}, &Globals::Ordered::order);
  for (const Globals::Ordered& resource : context.globals.resources) {
    const auto format = context.globals.formats.find(resource.var.index);
    Resource& added = context.program.resources.emplace_back(
        Resource{resource.var, context.globals.registers.at(resource.var.index),
                 format == context.globals.formats.end() ? "" : format->second});
    const auto attachment = context.globals.attachments.find(resource.var.index);
    if (attachment != context.globals.attachments.end())
      added.input_attachment = attachment->second;
    const auto counter = context.globals.counter_bindings.find(resource.var.index);
    if (counter != context.globals.counter_bindings.end()) added.counter_binding = counter->second;
  }
  if (!context.diagnostics.has_errors())
    context.globals.first_values = InitialiseInMain(context.program);
}

}  // namespace clipc::check
