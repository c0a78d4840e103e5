// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception Operators on operands already written.
// What GLSL's operators do otherwise than HLSL's, or only for some types, is done by helper
// functions.
#include <charconv>

#include "backend-glsl/writer_state.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

namespace {

struct Operator {
  std::string_view spelling, name, vector_function;
  Binding binding;
};
// In the order of BinaryOp.
constexpr Operator kOperators[] = {
    {"*", "multiply", "", Binding::kProduct},
    {"/", "divide", "", Binding::kProduct},
    {"%", "modulo", "", Binding::kProduct},
    {"+", "add", "", Binding::kSum},
    {"-", "subtract", "", Binding::kSum},
    {"<<", "shift_left", "", Binding::kShift},
    {">>", "shift_right", "", Binding::kShift},
    {"<", "less", "lessThan", Binding::kRelational},
    {">", "greater", "greaterThan", Binding::kRelational},
    {"<=", "less_equal", "lessThanEqual", Binding::kRelational},
    {">=", "greater_equal", "greaterThanEqual", Binding::kRelational},
    {"==", "equal_rows", "equal", Binding::kEquality},
    {"!=", "not_equal", "notEqual", Binding::kEquality},
    {"&", "bit_and", "", Binding::kBitAnd},
    {"^", "bit_xor", "", Binding::kBitXor},
    {"|", "bit_or", "", Binding::kBitOr},
    {"&&", "logical_and", "", Binding::kLogicalAnd},
    {"||", "logical_or", "", Binding::kLogicalOr},
    {"&&", "logical_and", "", Binding::kLogicalAnd},
    {"||", "logical_or", "", Binding::kLogicalOr},
};
const Operator& Of(BinaryOp op) { return kOperators[static_cast<int>(op)]; }

bool IsComparison(BinaryOp op) { return op >= BinaryOp::kLess && op <= BinaryOp::kNotEqual; }
bool IsLogical(BinaryOp op) { return op >= BinaryOp::kLogicalAnd; }
bool IsShift(BinaryOp op) { return op == BinaryOp::kShiftLeft || op == BinaryOp::kShiftRight; }
bool IsLinear(BinaryOp op) {
  return op == BinaryOp::kMul || op == BinaryOp::kDiv || op == BinaryOp::kAdd ||
         op == BinaryOp::kSub;
}

// The value of "5" or "5u"; nothing for what is no plain number.
std::optional<std::uint32_t> PlainNumber(const std::optional<Text>& text) {
  if (!text) return std::nullopt;
  std::uint32_t value = 0;
  const char* end = text->text.data() + text->text.size();
  const auto result = std::from_chars(text->text.data(), end, value);
  const bool whole =
      result.ec == std::errc{} && (result.ptr == end || std::string_view(result.ptr, end) == "u");
  return whole ? std::optional(value) : std::nullopt;
}

Text ScalarOr(Operand operand) {
  return operand.scalar ? std::move(*operand.scalar) : std::move(operand.text);
}

}  // namespace

std::string_view SpellingOf(BinaryOp op) { return Of(op).spelling; }
std::string_view HelperName(BinaryOp op) { return Of(op).name; }

Operand Writer::OperandOf(ExprId id) {
  const ir::Expr& expr = program_.exprs[id];
  Operand operand{{}, ShapeAt(id), std::nullopt, false};
  if (const auto* splat = std::get_if<Splat>(&expr.node)) {
    operand.repeatable = IsRepeatable(splat->operand);
    operand.scalar = Expr(splat->operand);
  } else if (std::holds_alternative<Zero>(expr.node)) {
    operand.repeatable = true;
    operand.scalar = Text{ZeroText(operand.shape.Component())};
  } else if (std::holds_alternative<Literal>(expr.node)) {
    operand.repeatable = true;
    operand.scalar = Expr(id);
  } else {
    operand.repeatable = IsRepeatable(id);
    operand.text = Expr(id);
  }
  return operand;
}

std::vector<Operand> Writer::OperandsOf(List<ExprId> list) {
  std::vector<Operand> operands;
  operands.reserve(list.size);
  for (ExprId id : program_.expr_lists[list]) operands.push_back(OperandOf(id));
  return operands;
}

Text Writer::Full(const Operand& operand) {
  return operand.scalar ? SplatText(*operand.scalar, operand.shape, operand.repeatable)
                        : operand.text;
}

Text Writer::SplatText(const Text& scalar, const Shape& shape, bool repeatable) {
  if (shape.IsScalar()) return scalar;
  const std::string type = TypeName(shape);
  if (shape.IsVector()) return {type + "(" + Argument(scalar) + ")"};
  if (!repeatable) {
    const std::string component = TypeName(shape.Component());
    const std::string name = Helper("splat_" + type, component, [&](const std::string& helper) {
      return type + " " + helper + "(" + component + " x) {\n    return " +
             SplatText({"x"}, shape, true).text + ";\n}\n";
    });
    return {name + "(" + Argument(scalar) + ")"};
  }
  // mat4(x) is x on the diagonal only.
  if (shape.kind == Shape::kMatrix && scalar.text == ZeroText(shape.Component()))
    return {type + "(" + scalar.text + ")"};
  std::string text = type + "(";
  for (int i = 0; i < shape.rows; ++i)
    text += (i > 0 ? ", " : "") + SplatText(scalar, shape.Row(), true).text;
  return {text + ")"};
}

Text Writer::UnaryOn(UnaryOp op, const Operand& operand) {
  const Apply again = [&](std::span<const Operand> row) { return UnaryOn(op, row[0]); };
  if (operand.shape.kind == Shape::kRows) {
    const char* name = op == UnaryOp::kNegate ? "negate"
                       : op == UnaryOp::kNot  ? "logical_not"
                                              : "complement";
    return ByRows(name, {&operand, 1}, operand.shape, again);
  }
  if (op == UnaryOp::kNot && operand.shape.IsVector()) return CallOn("not", {&operand, 1});
  const char* spelling = op == UnaryOp::kNegate ? "-" : op == UnaryOp::kNot ? "!" : "~";
  std::string text = Full(operand).At(Binding::kUnary);
  if (text.starts_with(spelling) && op == UnaryOp::kNegate) text = "(" + text + ")";
  return {spelling + text, Binding::kUnary};
}

bool Writer::IsNative(BinaryOp op, const Shape& shape, const Operand& right) const {
  if (shape.kind == Shape::kRows) return false;
  if (shape.kind == Shape::kMatrix) return IsLinear(op) && (op != BinaryOp::kMul || right.scalar);
  if (IsLinear(op)) return true;
  if (!target_.HasUnsigned()) return false;
  if (op == BinaryOp::kMod) return shape.scalar == Scalar::kUint;
  if (IsShift(op)) return PlainNumber(right.scalar).value_or(32) < 32;
  return true;
}

Text Writer::BinaryOn(BinaryOp op, Operand left, Operand right, bool right_is_pure) {
  const Shape shape = left.shape;
  if (shape.kind == Shape::kRows || (shape.kind == Shape::kMatrix && !IsLinear(op))) {
    const Operand operands[] = {std::move(left), std::move(right)};
    const bool gives_bool = IsComparison(op) || IsLogical(op);
    return ByRows(Of(op).name, operands, gives_bool ? shape.With(Scalar::kBool) : shape,
                  [&](std::span<const Operand> row) { return BinaryOn(op, row[0], row[1], true); });
  }
  if (IsLogical(op)) return LogicalOn(op, left, right, right_is_pure);
  if (IsComparison(op)) return CompareOn(op, left, right);
  if (IsShift(op)) return ShiftOn(op, left, right);
  if (op == BinaryOp::kMod) return ModOn(left, right);
  return ArithmeticOn(op, std::move(left), std::move(right));
}

// A scalar operand may stand beside a vector or matrix as it is.
Text Writer::ArithmeticOn(BinaryOp op, Operand left, Operand right) {
  if (left.shape.kind == Shape::kMatrix && op == BinaryOp::kMul && !left.scalar && !right.scalar) {
    const Operand operands[] = {left, right};
    return CallOn("matrixCompMult", operands);
  }
  const bool both = left.scalar && right.scalar && !left.shape.IsScalar();
  Text first = both ? Full(left) : ScalarOr(std::move(left));
  return Infix(std::move(first), Of(op).spelling, ScalarOr(std::move(right)), Of(op).binding);
}

Text Writer::ModOn(const Operand& left, const Operand& right) {
  const Operand operands[] = {left, right};
  if (left.shape.IsFloating()) return Snippet("fmod", operands, left.shape);
  const bool is_unsigned =
      left.shape.scalar == Scalar::kUint || left.shape.scalar == Scalar::kUint64;
  if (is_unsigned && target_.HasUnsigned()) return ArithmeticOn(BinaryOp::kMod, left, right);
  // GLSL's % is undefined when an operand is negative.
  return Snippet("imod", operands, left.shape);
}

// GLSL leaves shifts by more than 31 undefined; HLSL takes the count modulo the number of bits.
Text Writer::ShiftCount(const Operand& count, Scalar shifted) {
  const Scalar kind = count.shape.scalar;
  const std::uint32_t mask = shifted == Scalar::kInt64 || shifted == Scalar::kUint64 ? 63 : 31;
  const std::string suffix = kind == Scalar::kUint || kind == Scalar::kUint64 ? "u" : "";
  if (const auto number = PlainNumber(count.scalar))
    return {std::to_string(*number & mask) + suffix};
  return Infix(ScalarOr(count), "&", {std::to_string(mask) + suffix}, Binding::kBitAnd);
}

Text Writer::ShiftOn(BinaryOp op, const Operand& left, const Operand& right) {
  Text count = ShiftCount(right, left.shape.scalar);
  const bool both = left.scalar && right.scalar && !left.shape.IsScalar();
  // A vector may be shifted by a scalar, not a scalar by a vector.
  Text value = both || (left.scalar && !left.shape.IsScalar()) ? Full(left) : ScalarOr(left);
  return Infix(std::move(value), Of(op).spelling, std::move(count), Of(op).binding);
}

Text Writer::CompareOn(BinaryOp op, const Operand& left, const Operand& right) {
  const Operand operands[] = {left, right};
  if (left.shape.IsVector()) return CallOn(Of(op).vector_function, operands);
  return Infix(ScalarOr(left), Of(op).spelling, ScalarOr(right), Of(op).binding);
}

Text Writer::LogicalOn(BinaryOp op, const Operand& left, const Operand& right, bool right_is_pure) {
  const Operand operands[] = {left, right};
  if (left.shape.IsVector()) {
    return ByComponents(Of(op).name, operands, left.shape, [&](std::span<const Operand> part) {
      return BinaryOn(op, part[0], part[1], true);
    });
  }
  const bool is_eager = op == BinaryOp::kLogicalAnd || op == BinaryOp::kLogicalOr;
  if (!is_eager || right_is_pure)
    return Infix(ScalarOr(left), Of(op).spelling, ScalarOr(right), Of(op).binding);
  // Both sides are evaluated, as in HLSL before 2021.
  const std::string arguments = Argument(ScalarOr(left)) + ", " + Argument(ScalarOr(right));
  return {(op == BinaryOp::kLogicalAnd ? "all(bvec2(" : "any(bvec2(") + arguments + "))"};
}

Text Writer::SelectOn(std::span<const Operand> operands, bool pure) {
  const Shape& shape = operands[1].shape;
  const Apply again = [&](std::span<const Operand> part) { return SelectOn(part, true); };
  if (shape.HasRows()) return ByRows("select", operands, shape, again);
  if (shape.IsVector()) {
    if (shape.IsFloating() ? target_.HasBoolMix() : target_.HasIntegerMix()) {
      const Operand mixed[] = {operands[2], operands[1], operands[0]};
      return CallOn("mix", mixed);
    }
    return ByComponents("select", operands, shape, again);
  }
  if (pure) {
    std::string text = Full(operands[0]).At(Tighter(Binding::kConditional)) + " ? ";
    text += Full(operands[1]).At(Binding::kAssignment) + " : " +
            Full(operands[2]).At(Binding::kConditional);
    return {std::move(text), Binding::kConditional};
  }
  const std::string type = TypeName(shape);
  const std::string name = Helper("select", type, [&](const std::string& helper) {
    return type + " " + helper + "(bool condition, " + type + " a, " + type +
           " b) {\n    return condition ? a : b;\n}\n";
  });
  return CallOn(name, operands);
}

Text Writer::ConvertOn(Scalar kind, const Operand& operand) {
  const Shape to = operand.shape.With(kind);
  if (TypeName(to) == TypeName(operand.shape)) return Full(operand);
  const bool both_matrices = to.kind == Shape::kMatrix && operand.shape.kind == Shape::kMatrix;
  if (operand.shape.HasRows() && !both_matrices) {
    return ByRows("to_" + GlslName(kind), {&operand, 1}, to,
                  [&](std::span<const Operand> row) { return ConvertOn(kind, row[0]); });
  }
  if (operand.scalar && !operand.shape.IsScalar() && !operand.shape.HasRows()) {
    return {TypeName(to) + "(" + Argument(*operand.scalar) + ")"};
  }
  return {TypeName(to) + "(" + Argument(Full(operand)) + ")"};
}

}  // namespace clipc::glsl
