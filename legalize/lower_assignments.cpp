// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <variant>

#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// Whether GLSL has `target op= value` for numbers of this shape.
bool IsNative(Legalizer& legalizer, BinaryOp op, const Shape& shape, ExprId value) {
  if (shape.kind == Shape::kRows) return false;
  const bool is_modulo_of_uint = shape.scalar == Scalar::kUint && !legalizer.needs.signed_integers;
  // LowerDivisions has such a division.
  const bool is_signed = !IsFloat(shape.scalar) && !IsUnsigned(shape.scalar);
  if (op == BinaryOp::kDiv && is_signed && legalizer.NamesLeastInteger()) return false;
  const bool divides = op == BinaryOp::kDiv || op == BinaryOp::kMod;
  if (divides && legalizer.MayDivideByZero(value)) return false;
  if (op == BinaryOp::kMod) return !shape.HasRows() && is_modulo_of_uint;
  if (shape.kind != Shape::kMatrix) return true;
  const auto& node = legalizer.program.exprs[value].node;
  const bool is_scalar = std::holds_alternative<Splat>(node) || std::holds_alternative<Zero>(node);
  return IsLinear(op) && (op != BinaryOp::kMul || is_scalar);
}

}  // namespace

void LowerAssignments(Legalizer& legalizer) {
  legalizer.ForEach([&](ExprId expr) {
    const auto* found = As<Assign>(legalizer.program, expr);
    if (!found || !found->op) return;
    const Assign assign = *found;
    if (IsNative(legalizer, *assign.op, legalizer.ShapeAt(assign.target), assign.value)) return;
    if (legalizer.MayBeSkipped(assign.target)) {
      Builder b = legalizer.At(expr);
      const ExprId old = Clone(legalizer.program, assign.target);
      const ExprId value = b.BinaryOf(*assign.op, old, assign.value);
      legalizer.program.exprs[expr].node = Assign{std::nullopt, assign.target, value};
      return;
    }
    const Parameter parameters[] = {
        {"target", legalizer.program.exprs[assign.target].type, Storage::kInOut},
        {"value", legalizer.program.exprs[assign.value].type}};
    const ExprId arguments[] = {assign.target, assign.value};
    const std::string name = "assign_" + std::string(NameOf(*assign.op));
    legalizer.BecomeCall(expr, name, parameters, arguments, [&](HelperBody& body) {
      body.Do(body.b.AssignTo(body[0], body.b.BinaryOf(*assign.op, body[0], body[1])));
      body.Return(body[0]);
    });
  });
}

}  // namespace clipc::legalize
