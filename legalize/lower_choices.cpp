// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

void LowerLogical(Legalizer& legalizer, ExprId expr, const Binary& node) {
  const bool is_and = node.op == BinaryOp::kLogicalAnd;
  const BinaryOp lazy = is_and ? BinaryOp::kShortCircuitAnd : BinaryOp::kShortCircuitOr;
  if (!legalizer.ShapeAt(expr).IsScalar()) {
    return legalizer.ByComponents(expr, NameOf(node.op), Binary{lazy, node.left, node.right});
  }
  Builder b = legalizer.At(expr);
  const ExprId left = legalizer.Component(b, node.left, 0);
  const ExprId right = legalizer.Component(b, node.right, 0);
  const bool is_pure = legalizer.MayBeSkipped(node.right);
  TypeTable& types = legalizer.program.types;
  const ExprId both = is_pure ? left : b.ConstructOf(types.Vector(Scalar::kBool, 2), {left, right});
  const ExprId value = is_pure
                           ? b.BinaryOf(lazy, left, right)
                           : b.IntrinsicOf(is_and ? CommonIntrinsic::kAll : CommonIntrinsic::kAny,
                                           types.Make(Scalar::kBool), {both});
  const TypeId type = legalizer.program.exprs[expr].type;
  legalizer.Become(expr, b.TypeOf(value) == type ? value : b.ConstructOf(type, {value}));
}

void LowerSelect(Legalizer& legalizer, ExprId expr, const Select& node) {
  const Shape shape = legalizer.ShapeAt(expr);
  const Conditional choice{node.condition, node.when_true, node.when_false};
  if (shape.IsVector()) {
    const Needs& needs = legalizer.needs;
    if (shape.IsFloating() ? needs.float_choices : needs.integer_choices)
      legalizer.ByComponents(expr, "select", choice);
    return;
  }
  Builder b = legalizer.At(expr);
  const ExprId condition = legalizer.Component(b, node.condition, 0);
  if (legalizer.MayBeSkipped(node.when_true) && legalizer.MayBeSkipped(node.when_false)) {
    legalizer.program.exprs[expr].node = Conditional{condition, node.when_true, node.when_false};
    return;
  }
  const TypeId type = legalizer.program.exprs[expr].type;
  const Parameter parameters[] = {{"condition", b.TypeOf(condition)}, {"a", type}, {"b", type}};
  const ExprId arguments[] = {condition, node.when_true, node.when_false};
  legalizer.BecomeCall(expr, "select", parameters, arguments, [&](HelperBody& body) {
    body.Return(body.b.Add(type, Conditional{body[0], body[1], body[2]}));
  });
}

// Whether a value of the type is an array of vectors, or of such arrays.
bool IsOfVectors(const Legalizer& legalizer, TypeId type) {
  const TypeTable& types = legalizer.program.types;
  const Type& element = types[types.Innermost(type)];
  if (!element.IsNumeric()) return false;
  const Shape shape = ShapeOf(element, legalizer.needs);
  return shape.kind == Shape::kRows || (types[type].kind == TypeKind::kArray && shape.IsVector());
}

// Whether a value of the type is a struct or an array in the target's language.
bool IsComposite(const Legalizer& legalizer, TypeId type) {
  const Type& node = legalizer.program.types[type];
  return node.kind == TypeKind::kStruct || node.kind == TypeKind::kArray ||
         (node.kind == TypeKind::kMatrix && ShapeOf(node, legalizer.needs).kind == Shape::kRows);
}

// Whether statements make a choice between two values of the type, in place of `?:`.
bool IsChosenByStatements(const Legalizer& legalizer, TypeId type) {
  return (legalizer.needs.array_choices && IsOfVectors(legalizer, type)) ||
         (legalizer.needs.struct_choices && IsComposite(legalizer, type));
}

void LowerConditional(Legalizer& legalizer, ExprId expr, const Conditional& node) {
  const TypeId type = legalizer.program.exprs[expr].type;
  if (!IsChosenByStatements(legalizer, type) || !legalizer.MayBeSkipped(node.when_true) ||
      !legalizer.MayBeSkipped(node.when_false)) {
    return;
  }
  const Parameter parameters[] = {
      {"condition", legalizer.program.exprs[node.condition].type}, {"a", type}, {"b", type}};
  const ExprId arguments[] = {node.condition, node.when_true, node.when_false};
  legalizer.BecomeCall(expr, "choose", parameters, arguments, [&](HelperBody& body) {
    body.Add(body.b.Stmt(If{body[0], body.b.Stmt(Return{body[1]}), {}}));
    body.Return(body[2]);
  });
}

}  // namespace

void LowerChoices(Legalizer& legalizer) {
  legalizer.ForEach([&](ExprId expr) {
    const auto* binary = As<Binary>(legalizer.program, expr);
    if (binary && (binary->op == BinaryOp::kLogicalAnd || binary->op == BinaryOp::kLogicalOr)) {
      LowerLogical(legalizer, expr, Binary(*binary));
    } else if (const auto* select = As<Select>(legalizer.program, expr)) {
      LowerSelect(legalizer, expr, Select(*select));
    } else if (const auto* choice = As<Conditional>(legalizer.program, expr)) {
      LowerConditional(legalizer, expr, Conditional(*choice));
    }
  });
}

}  // namespace clipc::legalize
