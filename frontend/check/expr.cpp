// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/expr.h"

#include <bit>
#include <limits>

#include "base/overloaded.h"
#include "frontend/check/assign.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/call.h"
#include "frontend/check/cast_target.h"
#include "frontend/check/emit.h"
#include "frontend/check/enum.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/global.h"
#include "frontend/check/index.h"
#include "frontend/check/init.h"
#include "frontend/check/large_literal.h"
#include "frontend/check/loop.h"
#include "frontend/check/member.h"
#include "frontend/check/operator.h"
#include "frontend/check/real_literal.h"
#include "frontend/check/scope.h"
#include "frontend/check/struct.h"
#include "frontend/check/text.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/check/value.h"
#include "frontend/typing/constant.h"
#include "frontend/typing/intrinsics.h"

namespace clipc::check {
namespace {

// Whether the literal is a uint up to 5.1. fxc takes 0x3 for a uint and 3000000000 for an int,
// -1294967296. Direct3D 9 counts in floats, where 0x3 makes no difference.
bool IsUnsigned(const Context& context, const ast::Literal& literal) {
  const Profile& profile = context.program.profile;
  const bool is_large = literal.bits > std::numeric_limits<std::int32_t>::max();
  if (literal.kind == LiteralKind::kUint) return true;
  return literal.kind == LiteralKind::kHexadecimal && (is_large || !profile.IsDirect3D9());
}

// An integer without `ll` from profile 6.0 on. With `u` it is a uint (SemaExpr.cpp of DXC: `long`
// is the same as `int`).
ExprId UntypedInt(Context& context, const ast::Literal& literal, Span span) {
  const auto number = static_cast<std::int64_t>(literal.bits);
  return literal.kind == LiteralKind::kUint ? TruncateLiteral(context, number, Scalar::kUint, span)
                                            : IntLiteral(context, number, span);
}

ExprId CheckNode(Context& context, const ast::Literal& literal, Span span) {
  Builder at = context.At(span);
  const double number = std::bit_cast<double>(literal.bits);
  constexpr std::uint64_t kMaxUint = std::numeric_limits<std::uint32_t>::max();
  const bool is_integer = !IsFloatingPoint(literal.kind) && literal.kind != LiteralKind::kString;
  const bool has_wide = context.program.profile.IsAtLeast(6, 0);
  if (is_integer && literal.bits > kMaxUint && !has_wide)
    return context.Fail(span, diag::IntegerTooLarge, literal.bits);
  switch (literal.kind) {
    case LiteralKind::kBool: return at.Bool(literal.bits != 0);
    case LiteralKind::kInt:
    case LiteralKind::kUint:
    case LiteralKind::kHexadecimal:
      if (has_wide) return UntypedInt(context, literal, span);
      return IsUnsigned(context, literal) ? at.Uint(static_cast<std::uint32_t>(literal.bits))
                                          : at.Int(static_cast<std::int32_t>(literal.bits));
    case LiteralKind::kInt64:
      // fxc has the suffix, and no integers of 64 bits.
      if (!has_wide) return at.Int(static_cast<std::int32_t>(literal.bits));
      return at.Add(context.types.Make(Scalar::kInt64), Literal{literal.bits});
    case LiteralKind::kUint64:
      if (!has_wide) return at.Uint(static_cast<std::uint32_t>(literal.bits));
      return at.Add(context.types.Make(Scalar::kUint64), Literal{literal.bits});
    case LiteralKind::kHalf: return at.LiteralOf(Scalar::kHalf, number);
    case LiteralKind::kTypedFloat: return at.LiteralOf(Scalar::kFloat, number);
    case LiteralKind::kFloat:
      return has_wide ? RealLiteral(context, number, span) : at.LiteralOf(Scalar::kFloat, number);
    case LiteralKind::kDouble: return at.LiteralOf(Scalar::kDouble, number);
    case LiteralKind::kString: break;
  }
  return at.ZeroOf(context.types.String());
}

ExprId CheckNode(Context& context, const ast::NameExpr& name, Span span) {
  if (const SymbolId symbol = Find(context, name.name)) {
    if (context.names.uses_any() && !IsOneThing(context, span, name.name))
      return context.ErrorExpr(span);
    return UseSymbol(context, symbol, span);
  }
  const bool is_plain = name.name.scopes.empty();
  const std::string_view text = context[name.name.name];
  if (is_plain && text == "this" && context.view.body && context.view.body->self)
    return context.At(span).Ref(context.view.body->self);
  if (is_plain && IsIntrinsicName(text)) {
    context.Report(span, diag::FunctionAsValue, text);
  } else {
    ReportUndeclared(context, span, name.name, NameUse::kValue);
  }
  return context.ErrorExpr(span);
}

ExprId UseVariable(Context& context, SymbolId id, Span span) {
  Symbol& symbol = context[id];
  if (!symbol.scope) {
    if (symbol.is_leaked) HoistLoopVariable(context, id);
    return symbol.value == ~0u ? context.ErrorExpr(span)
                               : context.At(span).Ref(VarId{symbol.value});
  }
  const auto& var = context.Get<ast::VarDecl>(symbol.decl);
  const bool is_uniform = !(var.qualifiers & ast::kStatic);
  if (context.view.wants_constant && is_uniform && (var.qualifiers & ast::kConst) && var.init) {
    // fxc uses the value of a `const` global only where it needs a constant.
    context.globals.used_as_constants.push_back(id);
    View view = ViewOf(context, id);
    view.wants_constant = true;
    const ViewSwitch in(context, view);
    const TypeId type = ResolveVarType(context, var);
    return context.IsError(type) ? context.ErrorExpr(span) : CheckInit(context, var.init, type);
  }
  if (!ResolveVar(context, id)) return context.ErrorExpr(span);
  if (is_uniform && symbol.is_const && var.init) {
    context.Report(symbol.span, diag::ConstGlobalIsUniform, context[symbol.name]);
    symbol.is_const = false;
  }
  return context.At(span).Ref(VarId{symbol.value});
}

ExprId CheckNode(Context& context, const ast::ConditionalExpr& expr, Span span) {
  ExprId condition = CheckExpr(context, expr.condition);
  ExprId when_true = CheckExpr(context, expr.when_true);
  ExprId when_false = CheckExpr(context, expr.when_false);
  if (context.IsError(condition, when_true, when_false)) return context.ErrorExpr(span);
  const Span condition_span = context[expr.condition].span;
  if (!context.TypeOf(condition).IsNumeric()) {
    return context.Fail(condition_span, diag::ConditionNotScalar,
                        "?:", context.TypeName(condition));
  }
  AdaptLarge(context, when_true, when_false);
  const bool is_scalar = context.TypeOf(condition).Components() == 1;
  if (!is_scalar && context.options.short_circuits) {
    return context.Fail(condition_span, diag::NeedsScalars, "?:", context.TypeName(condition),
                        "select(condition, a, b)");
  }
  std::optional<TypeId> type =
      CommonType(context.types, context.TypeIdOf(when_true), context.TypeIdOf(when_false));
  if (type && !is_scalar) {
    const TypeId sides = *type;
    type = CommonType(context.types,
                      context.types.WithScalar(context.TypeIdOf(condition), context[sides].scalar),
                      sides);
    // The sides decide whether the result is a float4 or a float1x4.
    if (type && context[*type].Components() == context[sides].Components()) type = sides;
  }
  if (!type || *type == context.types.Void() || *type == context.types.String()) {
    return context.Fail(span, diag::BranchesDiffer, context.TypeName(when_true),
                        context.TypeName(when_false));
  }
  when_true = Implicit(context, when_true, *type);
  when_false = Implicit(context, when_false, *type);
  const TypeId boolean = context.types.Make(Scalar::kBool);
  condition = is_scalar
                  ? ConvertSilently(context, condition, boolean)
                  : Implicit(context, condition, context.types.WithScalar(*type, Scalar::kBool));
  if (!is_scalar) return context.At(span).Add(*type, Select{condition, when_true, when_false});
  Exprs prologue;
  if (!context.options.short_circuits &&
      !(MayBeSkipped(context.program, when_true) && MayBeSkipped(context.program, when_false))) {
    condition = Hoist(context, condition, prologue);
    const bool is_literal = context.Is<Literal>(when_true);
    if (!is_literal) when_true = Hoist(context, when_true, prologue);
    // The last value is evaluated directly before the choice.
    if (!MayBeSkipped(context.program, when_false))
      when_false = Hoist(context, when_false, prologue);
  }
  const ExprId choice = context.At(span).Add(*type, Conditional{condition, when_true, when_false});
  NoteChoice(context, choice, when_true, when_false);
  return WithPrologue(context, prologue, choice);
}

ExprId CheckNode(Context& context, const ast::CastExpr& expr, Span span) {
  const TypeId type =
      ArrayOf(context, ResolveType(context, expr.type), expr.dimensions, context[expr.type].span);
  const ExprId value = CheckExpr(context, expr.operand);
  if (context.IsError(value, type)) return context.ErrorExpr(span);
  if (context.TypeIdOf(value) == type) {
    NoteCastTo(context, value, expr.type);
    NoteTyped(context, value);
    return value;
  }
  const bool is_zero =
      As<Literal>(context.program, value) && EvaluateInteger(context.program, value) == 0;
  if (!is_zero && RefusesBits(context, context.TypeIdOf(value), type, span))
    return context.ErrorExpr(span);
  // A cast takes the first components, which are not those of a base after another one.
  if (FirstFieldOf(context, context.TypeIdOf(value), type).value_or(0) != 0)
    return Implicit(context, value, type);
  if (IsExplicitlyConvertible(context.types, context.TypeIdOf(value), type)) {
    const ast::ExprId path = PathOfCast(context, value, expr.operand, type);
    const ExprId converted = ConvertSilently(context, value, type);
    if (path) NoteCast(context, converted, path);
    NoteCastTo(context, converted, expr.type);
    return converted;
  }
  if (DerivesFrom(context, context.TypeIdOf(value), type)) return Implicit(context, value, type);
  return context.Fail(span, diag::CannotCast, context.TypeName(value), context.TypeName(type));
}

ExprId CheckNode(Context& context, const ast::TypeExpr& expr, Span span) {
  return context.Fail(span, diag::TypeAsValue, QualifiedText(context, context[expr.type].name));
}

ExprId CheckNode(Context& context, const ast::CommaExpr& expr, Span span) {
  const ExprId left = CheckExpr(context, expr.left);
  const ExprId right = CheckExpr(context, expr.right);
  if (context.IsError(left, right)) return context.ErrorExpr(span);
  const ExprId first = WithoutString(context, left);
  return first ? context.At(span).CommaOf(first, right) : right;
}

ExprId CheckNode(Context& context, const ast::InitListExpr&, Span span) {
  return context.Fail(span, diag::InitListAsValue);
}

ExprId CheckNode(Context& context, const ast::ErrorExpr&, Span span) {
  return context.ErrorExpr(span);
}

// The value of sizeof, as in DXC: the bytes of the components, without padding.
ExprId CheckNode(Context& context, const ast::SizeofExpr& expr, Span span) {
  const ast::Expr& operand = context[expr.operand];
  TypeId type;
  ast::ExprId element = expr.operand;  // of float4[2], a type with sizes after it
  while (const auto* array = context.GetIf<ast::IndexExpr>(element)) element = array->base;
  if (context.GetIf<ast::TypeExpr>(element)) {
    type = TypeArgument(context, expr.operand);
  } else if (const auto* name = std::get_if<ast::NameExpr>(&operand.node);
             name && Find(context, name->name, true)) {
    type = TypeArgument(context, expr.operand);
  } else {
    type = context.TypeIdOf(CheckExpr(context, expr.operand));
  }
  if (context.IsError(type)) return context.ErrorExpr(span);
  const auto leaves = Flatten(context.types, type);
  if (!leaves) {
    return context.Fail(span, diag::SizeUnknown, context.TypeName(type));
  }
  std::uint32_t size = 0;
  for (Scalar leaf : *leaves) size += ByteSize(leaf);
  return context.At(span).Uint(size);
}

}  // namespace

ExprId CheckExpr(Context& context, ast::ExprId id) {
  const ast::Expr& expr = context[id];
  const RecursionGuard guard(context, expr.span);
  if (!guard.ok()) return context.ErrorExpr(expr.span);
  return Visit([&](const auto& node) { return CheckNode(context, node, expr.span); }, expr.node);
}

ExprId UseSymbol(Context& context, SymbolId id, Span span) {
  const Symbol& symbol = context[id];
  switch (symbol.kind) {
    case SymbolKind::kVariable: {
      const ExprId value = UseVariable(context, id, span);
      NoteValue(context, value, id);
      return value;
    }
    case SymbolKind::kField: {
      const VarId self = context.view.body ? context.view.body->self : VarId{};
      const ExprId field = self ? FieldNamed(context, context.At(span).Ref(self),
                                             context[symbol.scope].self, symbol.name, span)
                                : ExprId{};
      if (field) return field;
      context.Report(span, diag::FieldWithoutObject, context[symbol.name])
          .Note(symbol.span, diag::DeclaredHere, context[symbol.name]);
      return context.ErrorExpr(span);
    }
    case SymbolKind::kEnumerator: {
      const SymbolId owner{symbol.owner};
      ResolveEnum(context, owner, context.Get<ast::EnumDecl>(symbol.decl));
      const auto& values = context.structs.enum_values[owner.index];
      if (symbol.value < values.size()) {
        const auto number = static_cast<std::uint64_t>(values[symbol.value]);
        const TypeId type = ResolveTypeSymbol(context, owner);
        const bool is_wide = IsWide(context[type].scalar);
        const ExprId value = context.At(span).Add(
            type, Literal{is_wide ? number : static_cast<std::uint32_t>(number)});
        NoteEnumerator(context, value, owner);
        return value;
      }
      return context.Fail(span, diag::InitialisedByItself, context[symbol.name]);
    }
    case SymbolKind::kTemplateValue:
      return context.At(span).Add(TypeId{symbol.owner}, Literal{symbol.value});
    case SymbolKind::kFunction:
      context.Report(span, diag::FunctionAsValue, context[symbol.name]);
      break;
    case SymbolKind::kType: context.Report(span, diag::TypeAsValue, context[symbol.name]); break;
    case SymbolKind::kNamespace:
      context.Report(span, diag::NamespaceAsValue, context[symbol.name]);
      break;
  }
  return context.ErrorExpr(span);
}

}  // namespace clipc::check
