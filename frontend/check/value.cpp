// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/value.h"

#include <cmath>
#include <limits>

#include "frontend/check/bit_field.h"
#include "frontend/check/expr.h"
#include "frontend/check/large_literal.h"
#include "frontend/check/real_literal.h"
#include "frontend/check/struct.h"
#include "frontend/check/text.h"
#include "frontend/typing/constant.h"

namespace clipc::check {

ExprId Hoist(Context& context, ExprId value, Exprs& prologue) {
  const Span span = context[value].span;
  const TemporaryMaker::Temporary temporary = context.Make(value);
  prologue.push_back(temporary.prologue);
  return context.At(span).Ref(temporary.var);
}

ExprId Repeatable(Context& context, ExprId value, Exprs& prologue) {
  const bool is_path = RootOf(context.program, value) && IsPure(context.program, value);
  return is_path ? value : Hoist(context, value, prologue);
}

ExprId WithPrologue(Context& context, ExprSpan prologue, ExprId value) {
  for (std::size_t i = prologue.size(); i-- > 0;) {
    value = context.At(context[value].span).CommaOf(prologue[i], value);
  }
  return value;
}

namespace {

// Whether a value of one type becomes the other by a cast only: from HLSL 2021 on, a struct that is
// no base of the other (DXC's test conversions-between-type-shapes-strictudt.hlsl). A struct
// without a name, which no cast can say, is as free as before.
bool NeedsCast(const Context& context, TypeId from, TypeId to) {
  if (!context.options.casts_structs) return false;
  const auto is_struct = [&](TypeId type) { return context[type].kind == TypeKind::kStruct; };
  if (!is_struct(from) && !is_struct(to)) return false;
  const bool has_name =
      !is_struct(from) || !is_struct(to) || !context.types.StructOf(to).name.empty();
  return has_name && !DerivesFrom(context, from, to);
}

}  // namespace

ExprId Implicit(Context& context, ExprId value, TypeId to) {
  const TypeId from = context.TypeIdOf(value);
  const Span span = context[value].span;
  if (from == to) return value;
  if (context.IsError(from, to)) return context.ErrorExpr(span);
  if (HasUntyped(context)) {
    const ExprId exact = ExactFor(context, value, to);
    const ExprId settled = SettleInt(context, exact, context[to].scalar, false);
    if (settled != value) return Implicit(context, settled, to);
  }
  if (RankImplicit(context.types, from, to)) {
    if (RefusesBits(context, from, to, span)) return context.ErrorExpr(span);
    if (NeedsCast(context, from, to)) {
      return context.Fail(span, diag::CastNeeded, context.TypeName(from), context.TypeName(to));
    }
    const ExprId converted =
        ConvertImplicit(context.program, value, to, context.diagnostics, &context);
    if (!context.int_literals.empty() && to == context.types.Make(Scalar::kFloat))
      NoteReal(context, converted, value);
    return converted;
  }
  if (DerivesFrom(context, from, to)) {
    Exprs prologue, fields;
    const ExprId object = Repeatable(context, value, prologue);
    const Struct& base = context.types.StructOf(to);
    const std::uint32_t first = *FirstFieldOf(context, from, to);
    if (context.types.StructOf(from).fields.size() < first + base.fields.size())
      return context.ErrorExpr(span);  // a struct that is too large has no fields
    for (std::uint32_t i = 0; i < base.fields.size(); ++i)
      fields.push_back(context.At(span).Field(Clone(context.program, object), first + i));
    return WithPrologue(context, prologue, context.At(span).ConstructOf(to, fields));
  }
  return context.Fail(span, diag::CannotConvert, context.TypeName(from), context.TypeName(to));
}

ExprId ConvertSilently(Context& context, ExprId value, TypeId to) {
  if (HasUntyped(context))
    value = SettleInt(context, ExactFor(context, value, to), context[to].scalar, true);
  if (context.TypeIdOf(value) == to) return value;
  return ConvertExplicit(context.program, value, to, context);
}

bool IsConstantExpr(const Context& context, ExprId expr) {
  const Program& program = context.program;
  const bool reads_more = AnyExpr(program, expr, [&](ExprId part) {
    const auto* ref = context.GetIf<VarRef>(part);
    return (ref && context[ref->var].storage != Storage::kConstant) ||
           context.Is<ObjectCall>(part) || context.Is<Comma>(part);
  });
  return !reads_more && IsPure(program, expr);
}

std::optional<std::int64_t> ConstantInteger(Context& context, ast::ExprId id) {
  const ast::Expr& expr = context[id];
  if (const auto* literal = std::get_if<ast::Literal>(&expr.node);
      literal && literal->kind == LiteralKind::kInt) {
    return static_cast<std::int64_t>(literal->bits);
  }
  View view = context.view;
  view.wants_constant = true;
  const ViewSwitch in(context, view);
  const ExprId value = CheckExpr(context, id);
  if (context.IsError(value)) return std::nullopt;
  if (const auto number = NumberOf(context, value)) return number;
  if (const auto number = EvaluateInteger(context.program, value)) return number;
  // fxc truncates a float.
  if (const auto constant = EvaluateConstant(context.program, value);
      constant && constant->components.size() == 1) {
    const double number = constant->components[0];
    const bool fits = std::abs(number) <= std::numeric_limits<std::int32_t>::max();
    const bool truncates = !context.program.profile.IsAtLeast(6, 0);
    if (fits && (truncates || number == std::trunc(number)))
      return static_cast<std::int64_t>(number);
  }
  context.Report(expr.span, diag::NotConstantInteger, TextOf(context, id));
  return std::nullopt;
}

}  // namespace clipc::check
