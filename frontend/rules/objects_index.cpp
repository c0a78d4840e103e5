// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "frontend/rules/object_call.h"
#include "frontend/rules/objects.h"

// object[index], object.mips[level][index] and object.sample[sample][index].
namespace clipc {
namespace {

using ir::ExprId;
using ir::ObjectKind;
using ir::ObjectOp;
using ir::Scalar;
using ir::Type;
using ir::TypeId;

ExprId ReportIndex(ir::Program& program, ExprId index, std::string_view expected,
                   Diagnostics& diagnostics) {
  const Span span = program.exprs[index].span;
  diagnostics.Report(span, diag::ObjectIndexType, program.types.Name(program.exprs[index].type),
                     expected);
  return ir::Builder(program, span).ZeroOf(program.types.Error());
}

TypeId IntVector(ir::TypeTable& types, int count) {
  return count == 1 ? types.Make(Scalar::kInt) : types.Vector(Scalar::kInt, count);
}

ExprId IndexTexture(ir::Program& program, ExprId object, ExprId index, ExprId level, Span span,
                    Diagnostics& diagnostics) {
  const Type type = program.types[program.exprs[object].type];
  const TypeId coordinate = IntVector(program.types, TraitsOf(type.object).texel);
  const TypeId number = program.types.Make(Scalar::kInt);
  // A scalar is not a place in a texture of several dimensions: unlike arguments, an index is not
  // splatted (fxc X3120).
  const auto rank = RankImplicit(program.types, program.exprs[index].type, coordinate);
  if (!rank || rank->splat != 0)
    return ReportIndex(program, index, program.types.Name(coordinate), diagnostics);
  if (!RankImplicit(program.types, program.exprs[level].type, number))
    return ReportIndex(program, level, "int", diagnostics);
  const std::array<ExprId, 3> arguments = {object,
                                           ConvertImplicit(program, index, coordinate, diagnostics),
                                           ConvertImplicit(program, level, number, diagnostics)};
  const TypeId element = ElementOf(program.types, type);
  if (IsImage(type.object)) {
    return MakeObjectCall(ir::Builder(program, span), program, element, ObjectOp::kImageLoad,
                          std::span(arguments).first(2));
  }
  return MakeObjectCall(ir::Builder(program, span), program, element, ObjectOp::kTextureLoad,
                        arguments);
}

ExprId IndexBuffer(ir::Program& program, ExprId object, ExprId index, Span span,
                   Diagnostics& diagnostics) {
  const Type type = program.types[program.exprs[object].type];
  const Type& index_type = program.types[program.exprs[index].type];
  const bool is_buffer = !IsStructured(type.object);
  const bool keeps_uint =
      !is_buffer && index_type.IsNumeric() && ir::BaseOf(index_type.scalar) == Scalar::kUint;
  const TypeId number = program.types.Make(keeps_uint ? Scalar::kUint : Scalar::kInt);
  if (!RankImplicit(program.types, program.exprs[index].type, number))
    return ReportIndex(program, index, "int", diagnostics);
  const std::array<ExprId, 2> arguments = {object,
                                           ConvertImplicit(program, index, number, diagnostics)};
  const TypeId element = ElementOf(program.types, type);
  return MakeObjectCall(ir::Builder(program, span), program, element,
                        is_buffer ? ObjectOp::kBufferLoad : ObjectOp::kStructuredLoad, arguments);
}

}  // namespace

ExprId CheckObjectIndex(ir::Program& program, ExprId object, ExprId index,
                        std::optional<ExprId> level, Span span, Diagnostics& diagnostics) {
  const Type type = program.types[program.exprs[object].type];
  ir::Builder builder(program, span);
  const auto is_error = [&](ExprId expr) {
    return program.exprs[expr].type == program.types.Error();
  };
  if (is_error(object) || is_error(index) || (level && is_error(*level)))
    return builder.ZeroOf(program.types.Error());
  if (type.kind == ir::TypeKind::kObject) {
    if (type.object == ObjectKind::kOther) {
      diagnostics.Report(span, diag::ObjectUnusable, std::string_view("[]"));
      return builder.ZeroOf(program.types.Error());
    }
    if (TraitsOf(type.object).texel != 0 && !(level && IsImage(type.object))) {
      return IndexTexture(program, object, index, level ? *level : builder.Int(0), span,
                          diagnostics);
    }
    if (!level && (type.object == ObjectKind::kBuffer || type.object == ObjectKind::kRWBuffer ||
                   IsStructured(type.object))) {
      return IndexBuffer(program, object, index, span, diagnostics);
    }
  }
  diagnostics.Report(span, diag::ObjectNotIndexed, program.types.Name(program.exprs[object].type));
  return builder.ZeroOf(program.types.Error());
}

}  // namespace clipc
