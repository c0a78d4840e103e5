// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Calls of HLSL's functions, as far as the legalising passes left them.
#include <algorithm>
#include <optional>

#include "backend-glsl/intrinsics.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The number that every component of an operand is, where the program says it.
std::optional<double> NumberIn(const Operand& operand) {
  if (!operand.constant) return std::nullopt;
  return NumberOf(operand.constant->bits, operand.constant->kind);
}

}  // namespace

Text Writer::IntrinsicText(const ir::Expr& expr, const IntrinsicCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  if (node.op == Intrinsic::kMul)
    return MulText(arguments[0], arguments[1], ShapeOf(program_.types[expr.type]));
  if (WritesArgument(node.op, 1)) NotConstant();
  const std::vector<Operand> operands = OperandsOf(node.arguments);
  const Operand& x = operands[0];
  const Shape& shape = x.shape;
  const Type& type = program_.types[expr.type];
  const Shape result = type.IsNumeric() ? ShapeOf(type) : shape;
  if (const BuiltinFunction* builtin = BuiltinOf(node.op, shape, target_)) {
    Text call = CallOn(builtin->glsl, operands, shape.IsVector() ? builtin->scalars : 0);
    if (node.op != Intrinsic::kSign || result.scalar == shape.scalar) return call;
    return {TypeName(result) + "(" + Argument(std::move(call)) + ")"};
  }
  switch (node.op) {
    case Intrinsic::kAll:
    case Intrinsic::kAny: return ReduceOn(node.op, x);
    case Intrinsic::kTranspose: return shape.HasRows() ? CallOn("transpose", operands) : Full(x);
    case Intrinsic::kDot:
      return shape.IsScalar() ? BinaryOn(BinaryOp::kMul, x, operands[1]) : CallOn("dot", operands);
    case Intrinsic::kDeterminant:
      if (!shape.HasRows()) return Full(x);
      if (target_.Has(Feature::kDeterminant)) return CallOn("determinant", operands);
      return SnippetCall("determinant" + std::to_string(shape.rows), operands);
    case Intrinsic::kSmoothstep: {
      // GLSL leaves smoothstep undefined when the edges are not in order; then HLSL's formula is
      // spelled out.
      const auto low = NumberIn(x), high = NumberIn(operands[1]);
      if (!low || !high || *low >= *high) break;
      return CallOn("smoothstep", operands, shape.IsVector() ? 0b011 : 0);
    }
    case Intrinsic::kFrexp: Require(Feature::kBitCasts); break;
    case Intrinsic::kAsFloat: return CastOn(Scalar::kFloat, x);
    case Intrinsic::kAsInt: return CastOn(Scalar::kInt, x);
    case Intrinsic::kAsUint:
      return operands.size() == 1 ? CastOn(Scalar::kUint, x) : SnippetCall("asuint64", operands);
    case Intrinsic::kAsDouble:
      return {"packDouble2x32(uvec2(" + Argument(Full(x)) + ", " + Argument(Full(operands[1])) +
              "))"};
    case Intrinsic::kF16ToF32:
      if (target_.Has(Feature::kHalfPacking)) {
        return {"unpackHalf2x16(" + Argument(Full(x)) + ").x"};
      }
      Require(Feature::kBitCasts);
      break;
    case Intrinsic::kF32ToF16:
      if (target_.Has(Feature::kHalfPacking)) {
        return {"packHalf2x16(vec2(" + Argument(Full(x)) + ", 0.0))"};
      }
      Require(Feature::kBitCasts);
      break;
    default: break;
  }
  if (const auto bits = BitFunctionOn(node.op, operands, result)) return *bits;
  return SnippetCall(NameOf(node.op), operands);
}

// countbits and the others give uint in HLSL, int in GLSL.
std::optional<Text> Writer::BitFunctionOn(Intrinsic op, std::span<const Operand> operands,
                                          const Shape& result) {
  if (!target_.Has(Feature::kBitFunctions)) return std::nullopt;
  const auto counted = [&](std::string_view function) {
    return Text{TypeName(result) + "(" + CallOn(function, operands).text + ")"};
  };
  switch (op) {
    case Intrinsic::kCountBits: return counted("bitCount");
    case Intrinsic::kFirstBitHigh: return counted("findMSB");
    case Intrinsic::kFirstBitLow: return counted("findLSB");
    case Intrinsic::kReverseBits: return CallOn("bitfieldReverse", operands);
    default: return std::nullopt;
  }
}

Text Writer::CastOn(Scalar to, const Operand& operand) {
  const Scalar from = operand.shape.scalar;
  if (from == to) return Full(operand);
  if (from != Scalar::kFloat && to != Scalar::kFloat) return ConvertOn(to, operand);
  Require(Feature::kBitCasts);
  const char* function = to == Scalar::kInt     ? "floatBitsToInt"
                         : to == Scalar::kUint  ? "floatBitsToUint"
                         : from == Scalar::kInt ? "intBitsToFloat"
                                                : "uintBitsToFloat";
  return CallOn(function, {&operand, 1});
}

Text Writer::ReduceOn(Intrinsic op, const Operand& operand) {
  const Shape& shape = operand.shape;
  if (shape.IsScalar()) return ConvertOn(Scalar::kBool, operand);
  const std::string function = NameOf(op);
  if (shape.scalar == Scalar::kBool) return CallOn(function, {&operand, 1});
  const Operand zero{.text = {},
                     .shape = shape,
                     .scalar = Text{ZeroText(shape.Component())},
                     .constant = Constant{0, shape.scalar},
                     .repeatable = true};
  return {function + "(" + BinaryOn(BinaryOp::kNotEqual, operand, zero).text + ")"};
}

// mul(). GLSL's matrices are the transposes of HLSL's, so products turn round: mul(v, M) is M * v.
Text Writer::MulText(ExprId left, ExprId right, const Shape& result) {
  Operand a = OperandOf(left), b = OperandOf(right);
  if (a.shape.IsScalar() || b.shape.IsScalar()) {
    // Of a scalar with anything, or of float1x1 with a row: the scalar stands for all components.
    const auto widen = [&](Operand& operand) {
      if (result.IsScalar()) return;
      operand.scalar = Full(operand);
      operand.shape = result;
    };
    if (!(a.shape.IsScalar() && b.shape.IsScalar())) widen(a.shape.IsScalar() ? a : b);
    return BinaryOn(BinaryOp::kMul, std::move(a), std::move(b));
  }
  if (a.shape.IsVector() && b.shape.IsVector()) {
    // A vector is a row on the left and a column on the right.
    const bool left_is_column = TypeOf(left).kind == TypeKind::kMatrix && TypeOf(left).columns == 1;
    const Operand sides[] = {std::move(left_is_column ? b : a), std::move(left_is_column ? a : b)};
    return CallOn(left_is_column ? "outerProduct" : "dot", sides);
  }
  return Infix(Full(b), "*", Full(a), Binding::kProduct);
}

}  // namespace clipc::glsl
