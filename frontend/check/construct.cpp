// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/construct.h"

#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/call.h"
#include "frontend/check/large_literal.h"
#include "frontend/check/real_literal.h"
#include "frontend/check/value.h"
#include "frontend/typing/conversion.h"
#include "frontend/typing/reread.h"

namespace clipc::check {
namespace {

// The value S(a) of a struct type, which HLSL 2021 has for casts of one value. S(a, b) is an error.
ExprId ConstructStruct(Context& context, TypeId type, ExprSpan arguments, Span span) {
  if (arguments.size() == 1) {
    if (context.TypeIdOf(arguments[0]) == type) return arguments[0];
    if (RefusesBits(context, context.TypeIdOf(arguments[0]), type, span))
      return context.ErrorExpr(span);
    if (IsExplicitlyConvertible(context.types, context.TypeIdOf(arguments[0]), type)) {
      return ConvertExplicit(context.program, arguments[0], type, context);
    }
  }
  return context.Fail(span, diag::NotConstructible, context.TypeName(type));
}

// A vector of scalars and vectors whose components add up; matrices among them are taken apart.
ExprId ConstructVector(Context& context, TypeId type, ExprSpan arguments, Span span) {
  if (arguments.size() == 1 && context.TypeIdOf(arguments[0]) == type) return arguments[0];
  Exprs parts, prologue;
  parts.reserve(arguments.size());
  for (ExprId argument : arguments) {
    if (context.TypeOf(argument).kind == TypeKind::kMatrix)
      TakeApart(context, argument, parts, prologue);
    else
      parts.push_back(argument);
  }
  return WithPrologue(context, prologue, context.At(span).ConstructOf(type, parts));
}

// A matrix made of rows if the arguments make up rows, otherwise of scalars.
ExprId ConstructMatrix(Context& context, TypeId type_id, ExprSpan arguments, Span span) {
  const Type type = context[type_id];
  const auto is_scalar = [&](ExprId argument) {
    return context.TypeOf(argument).kind == TypeKind::kScalar;
  };
  if (std::ranges::all_of(arguments, is_scalar))
    return context.At(span).ConstructOf(type_id, arguments);
  const TypeId row_type = context.types.Vector(type.scalar, type.columns);
  Exprs rows, row;
  std::uint32_t filled = 0;
  bool fits = true;
  for (ExprId argument : arguments) {
    fits = fits && context.TypeOf(argument).kind != TypeKind::kMatrix;
    row.push_back(argument);
    filled += context.TypeOf(argument).Components();
    if (filled < type.columns) continue;
    fits = fits && filled == type.columns;
    if (!fits) break;
    rows.push_back(ConstructVector(context, row_type, row, span));
    row.clear();
    filled = 0;
  }
  if (fits) return context.At(span).ConstructOf(type_id, rows);
  Exprs scalars, prologue;
  for (ExprId argument : arguments) TakeApart(context, argument, scalars, prologue);
  return WithPrologue(context, prologue, context.At(span).ConstructOf(type_id, scalars));
}

// Puts the components of structs and arrays in the place of those among the arguments, as fxc and
// DXC do (vkd3d's cast-componentwise-compatible.shader_test, checked against native). Reports and
// returns false where an argument does not consist of numbers.
bool TakeAggregatesApart(Context& context, TypeId type, Exprs& arguments, Exprs& prologue) {
  Exprs taken;
  for (const ExprId argument : arguments) {
    const TypeId id = context.TypeIdOf(argument);
    const Span span = context[argument].span;
    if (context[id].IsNumeric()) {
      taken.push_back(argument);
    } else if (!Flatten(context.types, id)) {
      context.Report(span, diag::CannotConvert, context.TypeName(id), context.TypeName(type));
      return false;
    } else if (RefusesBits(context, id, type, span)) {
      return false;
    } else {
      TakeApart(context, argument, taken, prologue);
    }
  }
  arguments = std::move(taken);
  return true;
}

}  // namespace

ExprId CheckConstructor(Context& context, TypeId type, List<ast::ExprId> list, Span span) {
  Exprs arguments;
  const bool ok = CheckArguments(context, list, arguments);
  if (!ok || context.IsError(type)) return context.ErrorExpr(span);
  for (std::size_t i = 0; HasUntyped(context) && i < arguments.size(); ++i) {
    const ExprId exact = ExactFor(context, arguments[i], type);
    arguments[i] = SettleInt(context, exact, context[type].scalar, true);
  }
  const Type wanted = context[type];
  if (wanted.kind == TypeKind::kStruct) return ConstructStruct(context, type, arguments, span);
  if (!wanted.IsNumeric()) {
    return context.Fail(span, diag::NotConstructible, context.TypeName(type));
  }
  Exprs prologue;
  const bool is_single = arguments.size() == 1 && !context.TypeOf(arguments[0]).IsNumeric();
  // float3x3(s) is what (float3x3)s is.
  if (is_single && IsExplicitlyConvertible(context.types, context.TypeIdOf(arguments[0]), type))
    return ConvertExplicit(context.program, arguments[0], type, context);
  if (!TakeAggregatesApart(context, type, arguments, prologue)) return context.ErrorExpr(span);
  std::uint32_t given = 0;
  for (const ExprId argument : arguments) given += context.TypeOf(argument).Components();
  const std::uint32_t needed = wanted.Components();
  const bool is_cast = arguments.size() == 1 && (needed == 1 || given != needed ||
                                                 wanted.kind == context.TypeOf(arguments[0]).kind);
  if (is_cast && IsExplicitlyConvertible(context.types, context.TypeIdOf(arguments[0]), type)) {
    // fxc refuses float4(1) and float3x3(m); HLSL 2021 and glslang accept them as
    // casts, and no compiler gives them another meaning.
    NoteTyped(context, arguments[0]);
    return ConvertExplicit(context.program, arguments[0], type, context);
  }
  if (given != needed) {
    return context.Fail(span, diag::WrongComponentCount, context.TypeName(type),
                        WithCount(needed, "component"), given);
  }
  for (ExprId& argument : arguments) {
    argument = Implicit(context, argument,
                        context.types.WithScalar(context.TypeIdOf(argument), wanted.scalar));
  }
  return WithPrologue(context, prologue,
                      wanted.kind == TypeKind::kMatrix
                          ? ConstructMatrix(context, type, arguments, span)
                          : ConstructVector(context, type, arguments, span));
}

ExprId Component(Context& context, ExprId vector, std::uint8_t component) {
  Builder at = context.At(context[vector].span);
  if (const auto* matrix = context.GetIf<MatrixSwizzle>(vector)) {
    const MatrixSwizzle node = *matrix;
    return at.At(at.At(node.base, std::uint32_t{node.rows[component]}),
                 std::uint32_t{node.columns[component]});
  }
  if (const auto* swizzle = context.GetIf<Swizzle>(vector)) {
    component = swizzle->components[component];
    vector = swizzle->base;
  }
  return at.Swizzled(vector, {component});
}

void TakeApart(Context& context, ExprId value, Exprs& scalars, Exprs& prologue) {
  const Type type = context.TypeOf(value);
  if (type.kind == TypeKind::kScalar) {
    scalars.push_back(value);
    return;
  }
  Builder at = context.At(context[value].span);
  if (!type.IsNumeric()) {
    const ExprId whole = Repeatable(context, value, prologue);
    for (std::uint32_t i = 0; i < context.types.PartCount(context.TypeIdOf(whole)); ++i)
      TakeApart(context, at.Part(Clone(context.program, whole), i), scalars, prologue);
    return;
  }
  Reread source(context.program, value, &context);
  for (std::uint32_t row = 0; row < type.rows; ++row) {
    for (int column = 0; column < type.columns; ++column) {
      ExprId vector = source.Read();
      if (type.kind == TypeKind::kMatrix) vector = at.At(vector, row);
      scalars.push_back(Component(context, vector, static_cast<std::uint8_t>(column)));
    }
  }
  if (source.prologue()) prologue.push_back(source.prologue());
}

}  // namespace clipc::check
