// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/call.h"

#include <algorithm>
#include <utility>

#include "frontend/check/assign.h"
#include "frontend/check/body.h"
#include "frontend/check/byte_access.h"
#include "frontend/check/cast_target.h"
#include "frontend/check/construct.h"
#include "frontend/check/element.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/expand_call.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/init.h"
#include "frontend/check/large_literal.h"
#include "frontend/check/member.h"
#include "frontend/check/operator.h"
#include "frontend/check/out_element.h"
#include "frontend/check/overload.h"
#include "frontend/check/real_literal.h"
#include "frontend/check/scope.h"
#include "frontend/check/struct.h"
#include "frontend/check/template.h"
#include "frontend/check/text.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/check/value.h"
#include "frontend/typing/intrinsics.h"
#include "frontend/typing/objects.h"

namespace clipc::check {
namespace {

// The definition of a function template of which `id` may be the declaration: the template of the
// same parameters, as they are written, that has a body.
SymbolId DefinitionOf(Context& context, SymbolId id) {
  const ast::FunctionDecl& declared = DeclOf(context, id);
  if (declared.body) return id;
  SymbolId other = context.names.NewestIn(context[id].scope, context[id].name);
  for (; other; other = context[other].older) {
    if (context[other].kind != SymbolKind::kFunction) continue;
    const ast::FunctionDecl& decl = DeclOf(context, other);
    const bool is_alike = decl.is_template && decl.body &&
                          decl.parameters.size == declared.parameters.size &&
                          decl.template_parameters.size == declared.template_parameters.size;
    bool is_same = is_alike;
    for (std::uint32_t i = 0; is_same && i < decl.parameters.size; ++i) {
      const auto type_at = [&](const ast::FunctionDecl& of) {
        return TypeText(context, context.Get<ast::VarDecl>(context[of.parameters][i]).type);
      };
      is_same = type_at(decl) == type_at(declared);
    }
    if (is_same) return other;
  }
  return id;
}

// The functions of a name, and the instances of templates of that name that the arguments
// determine.
KeptVector<FunctionInfoId> CandidatesOf(Context& context, SymbolId symbol, TypeId self,
                                        List<ast::ExprId> explicit_arguments, ExprSpan arguments) {
  KeptVector<FunctionInfoId> candidates;
  if (explicit_arguments.empty()) candidates = OverloadsOf(context, symbol, self);
  for (SymbolId id = symbol; id; id = context[id].older) {
    if (context[id].kind != SymbolKind::kFunction) continue;
    if (!DeclOf(context, id).is_template) continue;
    const FunctionInfoId instance = InstantiateFunction(context, DefinitionOf(context, id), self,
                                                        explicit_arguments, arguments);
    if (!instance) continue;
    context[instance].declared = std::min(context[instance].declared, id.index);
    if (std::ranges::find(candidates, instance) == candidates.end()) candidates.push_back(instance);
  }
  return candidates;
}

// The call of a value's operator(); for a value without one an error, in which `text` names it.
struct Callee {
  ExprId value;
  std::string text;
  Span span;
};
ExprId CallValue(Context& context, const Callee& callee, const ast::CallExpr& expr, Span span) {
  Exprs operands = {callee.value};
  const bool ok = CheckArguments(context, expr.arguments, operands);
  if (context.IsError(callee.value) || !ok) return context.ErrorExpr(span);
  if (const auto call = CallOperator(context, "()", operands, callee.span, span)) return *call;
  return context.Fail(callee.span, diag::NotCallable, callee.text);
}

// A call of a function by its name, whose arguments are checked.
struct NamedCall {
  const ast::NameExpr& callee;
  Exprs arguments;
  UseSpans spans;

  Name name() const { return callee.name.name; }
};

IntrinsicCheck IntrinsicOf(Context& context, const NamedCall& call) {
  return {context.program, context[call.name()], call.spans.name, call.arguments, call.spans.whole,
          context,         context.diagnostics};
}

ExprId CallIntrinsic(Context& context, NamedCall& call) {
  if (call.arguments.size() > 1 && HasUntyped(context)) AdaptArguments(context, call.arguments);
  Exprs steps;
  OutElements elements;
  const std::string_view name = context[call.name()];
  const bool writes = IsWritingIntrinsic(name);
  if (writes) {
    for (ExprId& argument : call.arguments) argument = TakeSteps(context, argument, steps);
  }
  if (writes || name.starts_with("Interlocked"))
    elements = TakeOutElements(context, name, call.arguments);
  ExprId value = CheckIntrinsicCall(IntrinsicOf(context, call));
  value = WithOutElements(context, std::move(elements), value);
  return WithPrologue(context, steps, ExpandCall(context, value));
}

// The call of the shader's function `symbol`, or of the intrinsic of that name, if there is one.
ExprId CallOverload(Context& context, NamedCall& call, SymbolId symbol, bool is_intrinsic) {
  const Name name = call.name();
  const Span name_span = call.spans.name;
  const VarId self = context.view.body ? context.view.body->self : VarId{};
  const bool is_method = context[context[symbol].scope].kind == ScopeKind::kStruct;
  KeptVector<FunctionInfoId> overloads =
      CandidatesOf(context, symbol, is_method && self ? context[self].type : TypeId{},
                   call.callee.arguments, call.arguments);
  for (const SymbolId other : OtherFunctions(context, call.callee.name, symbol)) {
    const KeptVector<FunctionInfoId> more =
        CandidatesOf(context, other, {}, call.callee.arguments, call.arguments);
    overloads.insert(overloads.end(), more.begin(), more.end());
  }
  const Choice choice = ChooseOverload(context, overloads, call.arguments, name, name_span);
  if (choice.reported) return context.ErrorExpr(call.spans.whole);
  // A function is declared before it is called: fxc X3004, dxc's undeclared identifier (vkd3d's
  // function.shader_test, checked against native).
  const bool is_later = choice.function && context[choice.function].declared >= context.view.order;
  // fxc calls an intrinsic where no function of the shader's can take the arguments.
  const bool is_6 = context.program.profile.IsAtLeast(6, 0);
  const auto takes = [&] { return TakesArguments(IntrinsicOf(context, call)); };
  const bool is_last = choice.changes_shape && is_6 && is_intrinsic && takes();
  const bool shadows = choice.function && !is_later && !is_last;
  const auto report = [&](const auto& kind) {
    const ast::FunctionDecl& decl = DeclOf(context, context[choice.function]);
    context.Report(name_span, kind, context[name])
        .Note(decl.name_span, diag::DeclaredHere, context[decl.name]);
  };
  // DXC looks for a function of the shader's only where no intrinsic takes the arguments
  // (HLSLExternalSource::AddOverloadedCallCandidates; vkd3d's intrinsic-override.shader_test).
  if (shadows && is_intrinsic && !is_method && is_6 && takes()) {
    report(diag::IntrinsicBeforeFunction);
    return CallIntrinsic(context, call);
  }
  if (is_intrinsic && !shadows) return CallIntrinsic(context, call);
  if (!choice.function) {
    ReportNoOverload(context, overloads, call.arguments, name, name_span);
    return context.ErrorExpr(call.spans.whole);
  }
  if (is_later) {
    report(diag::CalledBeforeDeclared);
    return context.ErrorExpr(call.spans.whole);
  }
  ExprId object;
  if (context[choice.function].self) {
    if (!self) return context.Fail(name_span, diag::FieldWithoutObject, context[name]);
    object = context.At(name_span).Ref(self);
  }
  return CallFunction(context, choice.function, object, std::move(call.arguments), call.spans);
}

ExprId CallNamed(Context& context, const ast::NameExpr& name, const ast::CallExpr& expr,
                 const UseSpans& spans) {
  const bool is_plain = name.name.scopes.empty() && !name.name.from_global;
  const bool is_intrinsic = is_plain && IsIntrinsicName(context[name.name.name]);
  SymbolId symbol = Find(context, name.name);
  if (symbol && context[symbol].kind == SymbolKind::kType) {
    return CheckConstructor(context, TypeArgument(context, expr.callee), expr.arguments,
                            spans.whole);
  }
  // Real files define functions after the entry point; and a variable does not hide a function that
  // is called.
  if (!symbol || context[symbol].kind != SymbolKind::kFunction) {
    const SymbolId function = FindFunction(context, name.name);
    if (symbol && !function && !is_intrinsic) {
      const Callee callee = {UseSymbol(context, symbol, spans.name),
                             QualifiedText(context, name.name), spans.name};
      return CallValue(context, callee, expr, spans.whole);
    }
    symbol = function;
  }
  NamedCall call{name, {}, spans};
  const bool ok = CheckArguments(context, expr.arguments, call.arguments);
  if (!symbol && !is_intrinsic) {
    ReportUndeclared(context, spans.name, name.name, NameUse::kFunction);
    return context.ErrorExpr(spans.whole);
  }
  if (!ok) return context.ErrorExpr(spans.whole);
  return symbol ? CallOverload(context, call, symbol, is_intrinsic) : CallIntrinsic(context, call);
}

ExprId CallMember(Context& context, const ast::MemberExpr& member, const ast::CallExpr& expr,
                  Span span) {
  const auto* owner = context.GetIf<ast::TypeExpr>(member.base);  // S<int> in S<int>::f()
  ExprId object = owner ? ExprId{} : CheckExpr(context, member.base);
  Exprs arguments;
  const bool ok = CheckArguments(context, expr.arguments, arguments);
  if ((object && context.IsError(object)) || !ok) return context.ErrorExpr(span);
  TypeId type = owner ? ResolveType(context, owner->type) : context.TypeIdOf(object);
  if (context.IsError(type)) return context.ErrorExpr(span);
  if (object && context[type].kind == TypeKind::kObject) {
    if (IsTypedAccess(context, member, object))
      return CheckTypedAccess(context, member, object, arguments, span);
    OutElements elements = TakeOutElements(context, context[member.name], arguments);
    const ExprId call = CheckMethodCall({context.program, context[member.name], member.name_span,
                                         arguments, span, context, context.diagnostics},
                                        object);
    return WithOutElements(context, std::move(elements), call);
  }
  const TypeId named = OwnerOf(context, member, type);
  if (context.IsError(named)) return context.ErrorExpr(span);
  const SymbolId symbol = FindMember(context, named, member.name);
  if (!symbol) {
    ReportNoMember(context, type, member.name, member.name_span);
    return context.ErrorExpr(span);
  }
  if (context[symbol].kind != SymbolKind::kFunction) {
    const auto field = object ? FindField(context, type, named, member.name) : std::nullopt;
    const ExprId value = field ? context.At(member.name_span).Field(object, *field)
                               : UseSymbol(context, symbol, member.name_span);
    return CallValue(context, {value, std::string(context[member.name]), member.name_span}, expr,
                     span);
  }
  const VarId self = context.view.body ? context.view.body->self : VarId{};
  if (owner && self && DerivesFrom(context, context[self].type, type)) {  // the method of a base
    object = context.At(member.name_span).Ref(self);
    type = context[self].type;
  }
  const KeptVector<FunctionInfoId> overloads =
      CandidatesOf(context, symbol, type, member.arguments, arguments);
  const Choice choice =
      ChooseOverload(context, overloads, arguments, member.name, member.name_span);
  if (choice.reported) return context.ErrorExpr(span);
  if (!choice.function) {
    ReportNoOverload(context, overloads, arguments, member.name, member.name_span);
    return context.ErrorExpr(span);
  }
  const bool is_static = !context[choice.function].self;
  if (!object && !is_static)
    return context.Fail(member.name_span, diag::FieldWithoutObject, context[member.name]);
  return CallFunction(context, choice.function, is_static ? ExprId{} : object, std::move(arguments),
                      {member.name_span, span});
}

// A temporary that is written before it is read.
VarId MakeEmpty(Context& context, TypeId type, Span span) {
  const VarId var = context.At(span).Local("temporary", type);
  if (context.view.body) context.view.body->temporaries.push_back(var);
  return var;
}

// What a call evaluates before it, to copy arguments in, and after it, to copy them out.
struct CopySteps {
  Exprs before, after;
};

// f((A)v) => (t = (A)v, f(t), v.a = t.a, ...): the components of t go back into those of v that
// they came from. The operand is checked once more, since its cast is a value.
ExprId BindCast(Context& context, const Parameter& parameter, TypeId type, ast::ExprId operand,
                CopySteps& copies) {
  auto& [before, after] = copies;
  ExprId target = TakeSteps(context, CheckExpr(context, operand), before);
  const Span span = context[target].span;
  if (context.IsError(target) || !CheckCastTarget(context, target, {}, type))
    return context.ErrorExpr(span);
  target = Stabilize(context, target, before);
  ExprId copy;
  if (parameter.storage == Storage::kInOut) {
    const ExprId cast = ConvertSilently(context, Clone(context.program, target), type);
    const ExprId initial = Implicit(context, cast, parameter.type);
    if (context.IsError(initial)) return initial;
    copy = Hoist(context, initial, before);
  } else {
    copy = context.At(span).Ref(MakeEmpty(context, parameter.type, span));
  }
  const ExprId result = Implicit(context, Clone(context.program, copy), type);
  if (context.IsError(result)) return result;
  StoreComponents(context, target, Repeatable(context, result, after), after);
  return copy;
}

ExprId BindArgument(Context& context, const Parameter& parameter, ExprId argument,
                    CopySteps& copies) {
  auto& [before, after] = copies;
  if (parameter.storage == Storage::kIn) return Implicit(context, argument, parameter.type);
  const Span span = context[argument].span;
  if (const ast::ExprId operand = CastOperand(context, argument))
    return BindCast(context, parameter, context.TypeIdOf(argument), operand, copies);
  argument = TakeSteps(context, argument, before);
  if (const ExprId element = ElementIn(context, argument)) {
    const Exprs stores = ChangeElement(context, element, argument, true, before);
    const ExprId bound = BindArgument(context, parameter, argument, copies);
    after.insert(after.end(), stores.begin(), stores.end());
    return bound;
  }
  if (IsChosenComponent(context, argument)) {
    const ExprId store = ChangeChosen(context, argument, before);
    if (context.IsError(store)) return store;
    const ExprId bound = BindArgument(context, parameter, argument, copies);
    after.push_back(store);
    return bound;
  }
  if (!CheckTarget(context, argument)) return context.ErrorExpr(span);
  const bool is_swizzle = context.Is<MatrixSwizzle>(argument);
  if (context.TypeIdOf(argument) == parameter.type && !is_swizzle) return argument;
  // f(x) => (t = (P)x, f(t), x = (X)t)
  Builder at = context.At(span);
  argument = Stabilize(context, argument, before);
  const ExprId initial = parameter.storage == Storage::kInOut
                             ? Implicit(context, Clone(context.program, argument), parameter.type)
                             : ExprId{};
  VarId copy;
  if (initial) {
    if (context.IsError(initial)) return initial;
    const TemporaryMaker::Temporary temporary = context.Make(initial);
    before.push_back(temporary.prologue);
    copy = temporary.var;
  } else {
    copy = MakeEmpty(context, parameter.type, span);
  }
  const ExprId result = Implicit(context, at.Ref(copy), context.TypeIdOf(argument));
  if (context.IsError(result)) return result;
  after.push_back(StoreTo(context, argument, result, span));
  return at.Ref(copy);
}

// The view of the types in the function's declaration.
View OutsideOf(const Context& context, const FunctionInfo& function) {
  return {.scope = function.scope,
          .order = function.order,
          .local_floor = context.names.size(),
          .body = context.view.body};
}

bool TakesArgument(Context& context, const FunctionInfo& function, const Parameter& parameter,
                   ExprId argument) {
  const auto& var = context.Get<ast::VarDecl>(parameter.decl);
  const ViewSwitch in(context, OutsideOf(context, function));
  return !var.dimensions.empty() || CheckEnumClass(context, var.type, argument);
}

// The object that a method is called on, or a copy if the method may change it and nothing can be
// assigned to it.
ExprId BindSelf(Context& context, const FunctionInfo& function, ExprId self, Exprs& before) {
  if (!function.changes_self) return self;
  const VarId root = RootOf(context.program, self);
  const bool is_changeable =
      root && !IsConstVar(context, root) && context[root].storage != Storage::kUniform;
  return is_changeable ? self : Hoist(context, self, before);
}

ExprId DefaultArgument(Context& context, const FunctionInfo& function, std::uint32_t index) {
  const Parameter parameter = context[function.parameters][index];
  const auto& var = context.Get<ast::VarDecl>(parameter.with_default);
  const ViewSwitch in(context, OutsideOf(context, function));
  return CheckInit(context, var.init, parameter.type);
}

// Evaluates the arguments that are bound before the steps from `first` on, which evaluate a later
// one.
void EvaluateEarlier(Context& context, const FunctionInfo& info, Exprs& bound, Exprs& before,
                     std::size_t first) {
  Exprs earlier;
  const std::size_t selves = info.self ? 1 : 0;
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const bool is_place =
        i < selves || context[info.parameters][i - selves].storage != Storage::kIn;
    bound[i] = EvaluateNow(context, bound[i], is_place, earlier);
  }
  before.insert(before.begin() + static_cast<std::ptrdiff_t>(first), earlier.begin(),
                earlier.end());
}

ExprId FinishCall(Context& context, ExprId call, const CopySteps& copies) {
  const auto& [before, after] = copies;
  Exprs steps = before;
  if (after.empty()) return WithPrologue(context, steps, call);
  if (context.TypeIdOf(call) == context.types.Void()) {
    steps.push_back(call);
    steps.insert(steps.end(), after.begin(), after.end());
    const ExprId last = steps.back();
    steps.pop_back();
    return WithPrologue(context, steps, last);
  }
  const ExprId result = Hoist(context, call, steps);
  steps.insert(steps.end(), after.begin(), after.end());
  return WithPrologue(context, steps, result);
}

}  // namespace

ExprId CheckNode(Context& context, const ast::CallExpr& expr, Span span) {
  const ast::Expr& callee = context[expr.callee];
  if (const auto* type = std::get_if<ast::TypeExpr>(&callee.node)) {
    const TypeId made = ResolveType(context, type->type);
    // GLSL's texture(map, uv) and texture2D(map, uv): in HLSL the words are types.
    const std::string_view word = context[context[type->type].name.name];
    if (context[made].kind == TypeKind::kObject && word.starts_with("texture")) {
      return context.Fail(callee.span, diag::UnknownFunction, word,
                          "; in HLSL it is `map.Sample(sampler, uv)`, for Direct3D 9 "
                          "`tex2D(sampler, uv)`");
    }
    const ExprId value = CheckConstructor(context, made, expr.arguments, span);
    NoteCastTo(context, value, type->type);
    return value;
  }
  if (const auto* name = std::get_if<ast::NameExpr>(&callee.node))
    return CallNamed(context, *name, expr, {callee.span, span});
  if (const auto* member = std::get_if<ast::MemberExpr>(&callee.node))
    return CallMember(context, *member, expr, span);
  return CallValue(context,
                   {CheckExpr(context, expr.callee), TextOf(context, expr.callee), callee.span},
                   expr, span);
}

bool CheckArguments(Context& context, List<ast::ExprId> list, Exprs& arguments) {
  bool ok = true;
  arguments.reserve(arguments.size() + list.size);
  for (ast::ExprId argument : context[list]) {
    arguments.push_back(CheckExpr(context, argument));
    ok = ok && !context.IsError(arguments.back());
  }
  return ok;
}

ExprId CallFunction(Context& context, FunctionInfoId id, ExprId self, Exprs arguments,
                    const UseSpans& spans) {
  const auto [name_span, span] = spans;
  id = ForClasses(context, id, arguments);
  const FunctionId function = Reach(context, id);
  const FunctionInfo& info = context[id];
  if (info.is_broken) return context.ErrorExpr(span);
  if (info.self && IsInterface(context, info.self))
    return context.Fail(name_span, diag::InterfaceUnknown, context.TypeName(info.self));
  if (!DeclOf(context, info).body) {
    context.Report(name_span, diag::FunctionWithoutBody, SignatureText(context, info))
        .Note(DeclOf(context, info).name_span, diag::DeclaredHere,
              context[DeclOf(context, info).name]);
    return context.ErrorExpr(span);
  }
  if (context.view.body)
    context.functions.calls.push_back({context.view.body->function, function, name_span});
  Exprs bound;
  CopySteps copies;
  bool acts = false;  // whether an argument so far has side effects
  if (info.self && info.changes_self) {
    const VarId root = RootOf(context.program, self);
    if (root && context[root].storage == Storage::kUniform)
      context.functions.uniform_calls.push_back({function, root, name_span});
  }
  if (info.self) bound.push_back(BindSelf(context, info, self, copies.before));
  for (std::uint32_t i = 0; i < info.parameters.size; ++i) {
    const Parameter parameter = context[info.parameters][i];
    const bool is_given = i < arguments.size();
    const std::size_t first = copies.before.size();
    acts = acts || (is_given && !IsPure(context.program, arguments[i]));
    if (is_given && !TakesArgument(context, info, parameter, arguments[i]))
      return context.ErrorExpr(span);
    const ExprId argument = is_given ? BindArgument(context, parameter, arguments[i], copies)
                                     : DefaultArgument(context, info, i);
    if (context.IsError(argument)) return context.ErrorExpr(span);
    if (acts && copies.before.size() > first)
      EvaluateEarlier(context, info, bound, copies.before, first);
    bound.push_back(argument);
  }
  const ExprId call = context.At(span).CallOf(function, bound);
  const ViewSwitch in(context, OutsideOf(context, info));
  NoteCastTo(context, call, DeclOf(context, info).return_type);
  return FinishCall(context, call, copies);
}

}  // namespace clipc::check
