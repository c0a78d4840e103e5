// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"
#include "frontend/rules/reread.h"

// float4(a, b), float3x3(x, y, z)
namespace clipc {

ir::ExprId Checker::CheckConstructor(ir::TypeId type, List<ast::ExprId> list, Span span) {
  std::vector<ir::ExprId> arguments;
  const bool ok = CheckArguments(list, arguments);
  if (!ok || type == program_.types.Error()) return ErrorExpr(span);
  const ir::Type& wanted = program_.types[type];
  if (wanted.kind == ir::TypeKind::kStruct) return ConstructStruct(type, arguments, span);
  if (!wanted.IsNumeric()) {
    diagnostics_.Report(span, diag::NotConstructible, TypeName(type));
    return ErrorExpr(span);
  }
  std::uint32_t given = 0;
  for (ir::ExprId argument : arguments) {
    if (!TypeOf(argument).IsNumeric()) {
      // float3x3(s) is what (float3x3)s is.
      if (arguments.size() == 1 &&
          IsExplicitlyConvertible(program_.types, TypeIdOf(argument), type)) {
        return ConvertExplicit(program_, argument, type, *this);
      }
      diagnostics_.Report(program_.exprs[argument].span, diag::CannotConvert,
                          TypeName(TypeIdOf(argument)), TypeName(type));
      return ErrorExpr(span);
    }
    given += TypeOf(argument).Components();
  }
  const std::uint32_t needed = wanted.Components();
  const bool is_cast = arguments.size() == 1 &&
                       (needed == 1 || given != needed || wanted.kind == TypeOf(arguments[0]).kind);
  if (is_cast && IsExplicitlyConvertible(program_.types, TypeIdOf(arguments[0]), type)) {
    // fxc refuses float4(1) and float3x3(m); HLSL 2021 and glslang take them for casts, and nobody
    // for anything else.
    return ConvertExplicit(program_, arguments[0], type, *this);
  }
  if (given != needed) {
    diagnostics_.Report(span, diag::WrongComponentCount, TypeName(type), needed, given);
    return ErrorExpr(span);
  }
  for (ir::ExprId& argument : arguments) {
    argument = Implicit(argument, program_.types.WithScalar(TypeIdOf(argument), wanted.scalar));
  }
  return wanted.kind == ir::TypeKind::kMatrix ? ConstructMatrix(type, arguments, span)
                                              : ConstructVector(type, arguments, span);
}

// S(a, b) is an initialiser list in another spelling (HLSL 2021 has it for casts of one value).
ir::ExprId Checker::ConstructStruct(ir::TypeId type, std::span<const ir::ExprId> arguments,
                                    Span span) {
  if (arguments.size() == 1) {
    if (TypeIdOf(arguments[0]) == type) return arguments[0];
    if (IsExplicitlyConvertible(program_.types, TypeIdOf(arguments[0]), type)) {
      return ConvertExplicit(program_, arguments[0], type, *this);
    }
  }
  diagnostics_.Report(span, diag::NotConstructible, TypeName(type));
  return ErrorExpr(span);
}

// vector.x; a swizzle of a swizzle is one.
ir::ExprId Checker::Component(ir::ExprId vector, std::uint8_t component) {
  ir::Builder at = At(program_.exprs[vector].span);
  if (const auto* swizzle = std::get_if<ir::Swizzle>(&program_.exprs[vector].node)) {
    component = swizzle->components[component];
    vector = swizzle->base;
  }
  return at.Swizzled(vector, {component});
}

// The components of a value, row by row; `value` is evaluated once.
void Checker::TakeApart(ir::ExprId value, std::vector<ir::ExprId>& scalars,
                        std::vector<ir::ExprId>& prologue) {
  const ir::Type type = TypeOf(value);
  if (type.kind == ir::TypeKind::kScalar) {
    scalars.push_back(value);
    return;
  }
  ir::Builder at = At(program_.exprs[value].span);
  Reread source(program_, value, this);
  for (std::uint32_t row = 0; row < type.rows; ++row) {
    for (int column = 0; column < type.columns; ++column) {
      ir::ExprId vector = source.Read();
      if (type.kind == ir::TypeKind::kMatrix) vector = at.At(vector, row);
      scalars.push_back(Component(vector, static_cast<std::uint8_t>(column)));
    }
  }
  if (source.prologue()) prologue.push_back(source.prologue());
}

// From scalars and vectors whose components add up; matrices among them are taken apart.
ir::ExprId Checker::ConstructVector(ir::TypeId type, std::span<const ir::ExprId> arguments,
                                    Span span) {
  if (arguments.size() == 1 && TypeIdOf(arguments[0]) == type) return arguments[0];
  std::vector<ir::ExprId> parts, prologue;
  for (ir::ExprId argument : arguments) {
    if (TypeOf(argument).kind == ir::TypeKind::kMatrix)
      TakeApart(argument, parts, prologue);
    else
      parts.push_back(argument);
  }
  return WithPrologue(prologue, At(span).ConstructOf(type, parts));
}

// From rows, where the arguments make up rows; else from scalars.
ir::ExprId Checker::ConstructMatrix(ir::TypeId type_id, std::span<const ir::ExprId> arguments,
                                    Span span) {
  const ir::Type type = program_.types[type_id];
  const auto is_scalar = [&](ir::ExprId argument) {
    return TypeOf(argument).kind == ir::TypeKind::kScalar;
  };
  if (std::ranges::all_of(arguments, is_scalar)) return At(span).ConstructOf(type_id, arguments);
  const ir::TypeId row_type = program_.types.Vector(type.scalar, type.columns);
  std::vector<ir::ExprId> rows, row;
  std::uint32_t filled = 0;
  bool fits = true;
  for (ir::ExprId argument : arguments) {
    fits = fits && TypeOf(argument).kind != ir::TypeKind::kMatrix;
    row.push_back(argument);
    filled += TypeOf(argument).Components();
    if (filled < type.columns) continue;
    fits = fits && filled == type.columns;
    if (!fits) break;
    rows.push_back(ConstructVector(row_type, row, span));
    row.clear();
    filled = 0;
  }
  if (fits) return At(span).ConstructOf(type_id, rows);
  std::vector<ir::ExprId> scalars, prologue;
  for (ir::ExprId argument : arguments) TakeApart(argument, scalars, prologue);
  return WithPrologue(prologue, At(span).ConstructOf(type_id, scalars));
}

}  // namespace clipc
