// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"
#include "frontend/rules/intrinsics.h"

// Calls of functions, methods and built-in functions.
namespace clipc {

ir::ExprId Checker::CheckCall(const ast::CallExpr& expr, Span span) {
  const ast::Expr& callee = file_.exprs[expr.callee];
  if (const auto* type = std::get_if<ast::TypeExpr>(&callee.node)) {
    return CheckConstructor(ResolveType(type->type), expr.arguments, span);
  }
  if (const auto* name = std::get_if<ast::NameExpr>(&callee.node))
    return CallNamed(*name, callee.span, expr, span);
  if (const auto* member = std::get_if<ast::MemberExpr>(&callee.node))
    return CallMember(*member, expr, span);
  const ir::ExprId value = CheckExpr(expr.callee);
  if (!IsError(value)) diagnostics_.Report(callee.span, diag::NotCallable, TextOf(expr.callee));
  return ErrorExpr(span);
}

// False when an argument has an error.
bool Checker::CheckArguments(List<ast::ExprId> list, std::vector<ir::ExprId>& arguments) {
  bool ok = true;
  arguments.reserve(arguments.size() + list.size);
  for (std::uint32_t i = 0; i < list.size; ++i) {
    arguments.push_back(CheckExpr(file_.expr_lists[list][i]));
    ok = ok && !IsError(arguments.back());
  }
  return ok;
}

ir::ExprId Checker::CallNamed(const ast::NameExpr& name, Span name_span, const ast::CallExpr& expr,
                              Span span) {
  const bool is_plain = name.name.scopes.empty() && !name.name.from_global;
  const bool is_intrinsic = is_plain && IsIntrinsicName(Text(name.name.name));
  SymbolId symbol = Find(name.name);
  if (symbol && symbols_[symbol].kind == SymbolKind::kType) {
    ast::Type type;
    type.span = name_span;
    type.name = name.name;
    type.arguments = name.arguments;
    type.has_arguments = !name.arguments.empty();
    return CheckConstructor(ResolveNamedType(type), expr.arguments, span);
  }
  // Real files define functions after the entry point; and a variable does not hide a function that
  // is called.
  if (!symbol || symbols_[symbol].kind != SymbolKind::kFunction) symbol = FindFunction(name.name);
  std::vector<ir::ExprId> arguments;
  const bool ok = CheckArguments(expr.arguments, arguments);
  if (!symbol && !is_intrinsic) {
    const SymbolId other = Find(name.name);
    if (other)
      diagnostics_.Report(name_span, diag::NotCallable, QualifiedText(name.name));
    else
      ReportUndeclared(name_span, name.name, false, true);
    return ErrorExpr(span);
  }
  if (!ok) return ErrorExpr(span);
  if (!symbol) return CallIntrinsic(name.name.name, name_span, arguments, span);
  const ir::TypeId self =
      context_.body && context_.body->self ? program_.vars[context_.body->self].type : ir::TypeId{};
  const bool is_method = scopes_[symbols_[symbol].scope].kind == ScopeKind::kStruct;
  const std::vector<FunctionInfoId> overloads =
      CandidatesOf(symbol, is_method ? self : ir::TypeId{}, name.arguments, arguments);
  const Choice choice = ChooseOverload(overloads, arguments, name.name.name, name_span);
  if (choice.reported) return ErrorExpr(span);
  if (is_intrinsic && (!choice.function || choice.changes_shape)) {
    return CallIntrinsic(name.name.name, name_span, arguments, span);
  }
  if (!choice.function) {
    ReportNoOverload(overloads, arguments, name.name.name, name_span);
    return ErrorExpr(span);
  }
  ir::ExprId object;
  if (Info(choice.function).self) {
    if (!context_.body || !context_.body->self) {
      diagnostics_.Report(name_span, diag::FieldWithoutObject, Text(name.name.name));
      return ErrorExpr(span);
    }
    object = At(name_span).Ref(context_.body->self);
  }
  return CallFunction(choice.function, object, std::move(arguments), name_span, span);
}

// A function of that name that the context may call, those declared later included.
SymbolId Checker::FindFunction(const ast::QualifiedName& name) {
  Context context = context_;
  context.order = ~0u;
  context.local_floor = ~0u;
  const ContextSwitch in(*this, context);
  const SymbolId symbol = Find(name);
  return symbol && symbols_[symbol].kind == SymbolKind::kFunction ? symbol : SymbolId{};
}

// The functions of a name, and the instances of the templates of that name that these arguments ask
// for.
std::vector<FunctionInfoId> Checker::CandidatesOf(SymbolId symbol, ir::TypeId self,
                                                  List<ast::ExprId> explicit_arguments,
                                                  std::span<const ir::ExprId> arguments) {
  std::vector<FunctionInfoId> candidates;
  if (explicit_arguments.empty()) candidates = OverloadsOf(symbol, self);
  for (SymbolId id = symbol; id; id = symbols_[id].older) {
    if (symbols_[id].kind != SymbolKind::kFunction) continue;
    if (!std::get<ast::FunctionDecl>(file_.decls[symbols_[id].decl].node).is_template) continue;
    const FunctionInfoId instance = InstantiateFunction(id, self, explicit_arguments, arguments);
    if (instance) candidates.push_back(instance);
  }
  return candidates;
}

ir::ExprId Checker::CallIntrinsic(Name name, Span name_span, std::span<const ir::ExprId> arguments,
                                  Span span) {
  return CheckIntrinsicCall(program_, Text(name), name_span, arguments, span, *this, diagnostics_);
}

ir::ExprId Checker::CallMember(const ast::MemberExpr& member, const ast::CallExpr& expr,
                               Span span) {
  const ir::ExprId object = CheckExpr(member.base);
  std::vector<ir::ExprId> arguments;
  const bool ok = CheckArguments(expr.arguments, arguments);
  if (IsError(object) || !ok) return ErrorExpr(span);
  const ir::TypeId type = TypeIdOf(object);
  if (program_.types[type].kind == ir::TypeKind::kObject) {
    if (!member.arguments.empty()) return CallTemplatedLoad(member, object, arguments, span);
    return CheckMethodCall(program_, object, Text(member.name), member.name_span, arguments, span,
                           *this, diagnostics_);
  }
  const SymbolId symbol = FindMember(type, member.name);
  if (!symbol) {
    ReportNoMember(type, member.name, member.name_span);
    return ErrorExpr(span);
  }
  if (symbols_[symbol].kind != SymbolKind::kFunction) {
    diagnostics_.Report(member.name_span, diag::NotCallable, Text(member.name));
    return ErrorExpr(span);
  }
  const std::vector<FunctionInfoId> overloads =
      CandidatesOf(symbol, type, member.arguments, arguments);
  const Choice choice = ChooseOverload(overloads, arguments, member.name, member.name_span);
  if (choice.reported) return ErrorExpr(span);
  if (!choice.function) {
    ReportNoOverload(overloads, arguments, member.name, member.name_span);
    return ErrorExpr(span);
  }
  const ir::ExprId self = Info(choice.function).self ? object : ir::ExprId{};
  return CallFunction(choice.function, self, std::move(arguments), member.name_span, span);
}

// buffer.Load<float3>(address) of HLSL 6.2: the bits, taken for that type.
ir::ExprId Checker::CallTemplatedLoad(const ast::MemberExpr& member, ir::ExprId object,
                                      std::span<const ir::ExprId> arguments, Span span) {
  const ir::TypeId type_id = TypeArgument(file_.expr_lists[member.arguments][0]);
  const ir::Type type = program_.types[type_id];
  if (type_id == program_.types.Error()) return ErrorExpr(span);
  const ir::Scalar base = ir::BaseOf(type.scalar);
  const bool is_word =
      base == ir::Scalar::kFloat || base == ir::Scalar::kInt || base == ir::Scalar::kUint;
  const bool fits = type.IsNumeric() && type.kind != ir::TypeKind::kMatrix && is_word &&
                    Text(member.name) == "Load";
  if (!fits) {
    diagnostics_.Report(
        member.name_span, diag::Unsupported,
        fmt::format("`{}` with the type argument `{}`", Text(member.name), TypeName(type_id)));
    return ErrorExpr(span);
  }
  constexpr std::string_view kMethods[] = {"Load", "Load2", "Load3", "Load4"};
  const ir::ExprId words = CheckMethodCall(program_, object, kMethods[type.columns - 1],
                                           member.name_span, arguments, span, *this, diagnostics_);
  if (IsError(words) || base == ir::Scalar::kUint) return words;
  const ir::ExprId operand[] = {words};
  const std::string_view cast = base == ir::Scalar::kFloat ? "asfloat" : "asint";
  const ir::ExprId value =
      CheckIntrinsicCall(program_, cast, member.name_span, operand, span, *this, diagnostics_);
  return Implicit(value, type_id);
}

// A call with its object (for a method) and arguments, converted and with what `out` parameters
// need around it.
ir::ExprId Checker::CallFunction(FunctionInfoId id, ir::ExprId self,
                                 std::vector<ir::ExprId> arguments, Span name_span, Span span) {
  const ir::FunctionId function = Reach(id);
  FunctionInfo& info = Info(id);
  if (info.is_broken) return ErrorExpr(span);
  const ScopeId owner = info.self ? info.scope : ScopeId{};
  if (owner && scopes_[owner].kind == ScopeKind::kStruct && IsInterface(scopes_[owner].self)) {
    diagnostics_.Report(name_span, diag::Unsupported,
                        "a call through an interface, which the application fills in,");
    return ErrorExpr(span);
  }
  if (!DeclOf(info).body) {
    diagnostics_.Report(name_span, diag::FunctionWithoutBody, SignatureText(info))
        .Note(DeclOf(info).name_span, diag::DeclaredHere, Text(DeclOf(info).name));
    return ErrorExpr(span);
  }
  if (context_.body) calls_.push_back({context_.body->function, function, name_span});
  std::vector<ir::ExprId> bound, before, after;
  if (info.self) bound.push_back(BindSelf(info, self, before));
  for (std::uint32_t i = 0; i < info.parameters.size; ++i) {
    const Parameter parameter = parameters_[info.parameters][i];
    const bool is_given = i < arguments.size();
    const ir::ExprId argument =
        is_given ? BindArgument(parameter, arguments[i], before, after) : DefaultArgument(info, i);
    if (IsError(argument)) return ErrorExpr(span);
    bound.push_back(argument);
  }
  return FinishCall(At(span).CallOf(function, bound), before, after);
}

bool Checker::IsInterface(ir::TypeId type) const {
  const StructInfo* info = InfoOf(type);
  return info && std::get<ast::StructDecl>(file_.decls[info->decl].node).kind ==
                     ast::StructKind::kInterface;
}

ir::ExprId Checker::BindArgument(const Parameter& parameter, ir::ExprId argument,
                                 std::vector<ir::ExprId>& before, std::vector<ir::ExprId>& after) {
  if (parameter.storage == ir::Storage::kIn) return Implicit(argument, parameter.type);
  const Span span = program_.exprs[argument].span;
  if (!CheckTarget(argument)) return ErrorExpr(span);
  const bool is_swizzle = std::holds_alternative<ir::MatrixSwizzle>(program_.exprs[argument].node);
  if (TypeIdOf(argument) == parameter.type && !is_swizzle) return argument;
  // f(x) => (t = (P)x, f(t), x = (X)t)
  ir::Builder at = At(span);
  argument = Stabilize(argument, before);
  const ir::ExprId initial = parameter.storage == ir::Storage::kInOut
                                 ? Implicit(ir::Clone(program_, argument), parameter.type)
                                 : ir::ExprId{};
  ir::VarId copy;
  if (initial) {
    if (IsError(initial)) return initial;
    const Temporary temporary = Make(initial);
    before.push_back(temporary.prologue);
    copy = temporary.var;
  } else {
    copy = MakeEmpty(parameter.type, span);
  }
  const ir::ExprId result = Implicit(at.Ref(copy), TypeIdOf(argument));
  if (IsError(result)) return result;
  after.push_back(StoreTo(argument, result, span));
  return at.Ref(copy);
}

// A temporary that is written before it is read.
ir::VarId Checker::MakeEmpty(ir::TypeId type, Span span) {
  const ir::VarId var = At(span).Local("temporary", type);
  if (context_.body) context_.body->temporaries.push_back(var);
  return var;
}

// The object a method is called on. One that the method may change but nobody can assign to is
// changed in a copy.
ir::ExprId Checker::BindSelf(const FunctionInfo& function, ir::ExprId self,
                             std::vector<ir::ExprId>& before) {
  if (!function.changes_self) return self;
  const ir::VarId root = ir::RootOf(program_, self);
  const bool is_changeable =
      root && !IsConstVar(root) && program_.vars[root].storage != ir::Storage::kUniform;
  return is_changeable ? self : Hoist(self, before);
}

ir::ExprId Checker::DefaultArgument(const FunctionInfo& function, std::uint32_t index) {
  const Parameter parameter = parameters_[function.parameters][index];
  const auto& var = std::get<ast::VarDecl>(file_.decls[parameter.with_default].node);
  const ContextSwitch in(*this, {.scope = function.scope,
                                 .order = function.order,
                                 .local_floor = symbols_.size(),
                                 .body = context_.body});
  return CheckInit(var.init, parameter.type);
}

ir::ExprId Checker::FinishCall(ir::ExprId call, std::span<const ir::ExprId> before,
                               std::span<const ir::ExprId> after) {
  std::vector<ir::ExprId> steps(before.begin(), before.end());
  if (after.empty()) return WithPrologue(steps, call);
  if (TypeIdOf(call) == program_.types.Void()) {
    steps.push_back(call);
    steps.insert(steps.end(), after.begin(), after.end());
    const ir::ExprId last = steps.back();
    steps.pop_back();
    return WithPrologue(steps, last);
  }
  const ir::ExprId result = Hoist(call, steps);
  steps.insert(steps.end(), after.begin(), after.end());
  return WithPrologue(steps, result);
}

}  // namespace clipc
