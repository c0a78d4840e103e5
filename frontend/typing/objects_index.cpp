// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>

#include <fmt/format.h>

#include "frontend/typing/object_call.h"
#include "frontend/typing/objects.h"
#include "ir/access.h"

// object[index], object.mips[level][index] and object.sample[sample][index].
namespace clipc::typing {
namespace {

ExprId ReportIndex(Program& program, ExprId index, std::string_view expected,
                   Diagnostics& diagnostics) {
  const Span span = program.exprs[index].span;
  diagnostics.Report(span, diag::ObjectIndexType, program.types.Name(TypeIdOf(program, index)),
                     expected);
  return Builder(program, span).ZeroOf(program.types.Error());
}

TypeId IntVector(TypeTable& types, int count) {
  return count == 1 ? types.Make(Scalar::kInt) : types.Vector(Scalar::kInt, count);
}

// Whether the index converts to `place` and has a component for each dimension: unlike an argument,
// an index is neither filled up nor cut off (fxc X3120).
bool IsPlace(Program& program, ExprId index, TypeId place) {
  const Type& type = TypeOf(program, index);
  return RankImplicit(program.types, TypeIdOf(program, index), place) &&
         type.Components() == program.types[place].Components();
}

ExprId IndexTexture(Program& program, const ObjectIndex& of, Diagnostics& diagnostics) {
  const auto [object, index, given_level, span] = of;
  const ExprId level = given_level ? *given_level : Builder(program, span).Int(0);
  const Type type = TypeOf(program, object);
  const TypeId coordinate = IntVector(program.types, TraitsOf(type.object).texel);
  const TypeId number = program.types.Make(Scalar::kInt);
  if (!IsPlace(program, index, coordinate))
    return ReportIndex(program, index, program.types.Name(coordinate), diagnostics);
  if (!RankImplicit(program.types, TypeIdOf(program, level), number))
    return ReportIndex(program, level, "int", diagnostics);
  const std::array<NamedOperand, 3> operands = {
      {{OperandKind::kObject, object},
       {OperandKind::kPlace, ConvertImplicit(program, index, coordinate, diagnostics)},
       {OperandKind::kLevel, ConvertImplicit(program, level, number, diagnostics)}}};
  const bool is_image = IsImage(type.object);
  return Builder(program, span)
      .ObjectCallOf(is_image ? ObjectOp::kImageLoad : ObjectOp::kTextureLoad,
                    ElementOf(program.types, type), std::span(operands).first(is_image ? 2 : 3));
}

ExprId IndexBuffer(Program& program, const ObjectIndex& of, Diagnostics& diagnostics) {
  const auto& [object, index, _, span] = of;
  const Type type = TypeOf(program, object);
  const Type& index_type = TypeOf(program, index);
  const bool is_buffer = !IsStructured(type.object);
  const bool keeps_uint =
      !is_buffer && index_type.IsNumeric() && BaseOf(index_type.scalar) == Scalar::kUint;
  const TypeId number = program.types.Make(keeps_uint ? Scalar::kUint : Scalar::kInt);
  if (!IsPlace(program, index, number)) return ReportIndex(program, index, "int", diagnostics);
  const ExprId place = ConvertImplicit(program, index, number, diagnostics);
  return Builder(program, span)
      .ObjectCallOf(is_buffer ? ObjectOp::kBufferLoad : ObjectOp::kStructuredLoad,
                    ElementOf(program.types, type),
                    {{OperandKind::kObject, object}, {OperandKind::kPlace, place}});
}

}  // namespace

ExprId CheckObjectIndex(Program& program, const ObjectIndex& of, Diagnostics& diagnostics) {
  const auto& [object, index, level, span] = of;
  const Type type = TypeOf(program, object);
  Builder builder(program, span);
  const auto is_error = [&](ExprId expr) {
    return TypeIdOf(program, expr) == program.types.Error();
  };
  if (is_error(object) || is_error(index) || (level && is_error(*level)))
    return builder.ZeroOf(program.types.Error());
  if (type.kind == TypeKind::kObject) {
    const bool is_of_pixels = IsOrdered(type.object) && !InfoOf(program.stage).draws_pixels;
    if (type.object == ObjectKind::kOther || is_of_pixels) {
      diagnostics.Report(span, diag::ObjectUnusable, "[]", InfoOf(program.stage).name);
      return builder.ZeroOf(program.types.Error());
    }
    if (TraitsOf(type.object).texel != 0 && !(level && IsImage(type.object))) {
      // Direct3D 9 has no instruction that reads a texel by its place.
      const bool has_object = program.profile.HasModel(InfoOf(type.object).model);
      if (program.profile.IsDirect3D9() && has_object && !program.is_interface_only) {
        diagnostics.Report(span, diag::IntrinsicProfile, "[]",
                           fmt::format("{}_4_0", InfoOf(program.stage).prefix),
                           program.profile.name);
        return builder.ZeroOf(program.types.Error());
      }
      return IndexTexture(program, of, diagnostics);
    }
    if (!level && (InfoOf(type.object).category == ObjectCategory::kTypedBuffer ||
                   (IsStructured(type.object) && HasNamedElements(type.object)))) {
      return IndexBuffer(program, of, diagnostics);
    }
  }
  diagnostics.Report(span, diag::ObjectNotIndexed, program.types.Name(TypeIdOf(program, object)));
  return builder.ZeroOf(program.types.Error());
}

}  // namespace clipc::typing
