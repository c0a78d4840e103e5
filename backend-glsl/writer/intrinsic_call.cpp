// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/intrinsic_call.h"

#include <utility>

#include "backend-glsl/intrinsics.h"
#include "backend-glsl/writer/operand.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

Text CastOn(Code& code, Scalar to, const Operand& operand) {
  const Scalar from = operand.shape.scalar;
  if (from == to) return Full(code, operand);
  if (from != Scalar::kFloat && to != Scalar::kFloat) return ConvertOn(code, to, operand);
  code.Require(Feature::kBitCasts);
  const char* function = to == Scalar::kInt     ? "floatBitsToInt"
                         : to == Scalar::kUint  ? "floatBitsToUint"
                         : from == Scalar::kInt ? "intBitsToFloat"
                                                : "uintBitsToFloat";
  return CallOn(code, function, {&operand, 1});
}

// The text of all() or any() of the operand.
Text ReduceOn(Code& code, const char* function, const Operand& operand) {
  const Shape& shape = operand.shape;
  if (shape.IsScalar()) return ConvertOn(code, Scalar::kBool, operand);
  if (shape.scalar == Scalar::kBool) return CallOn(code, function, {&operand, 1});
  const Text zero{ZeroText(code, shape.Component())};
  return Called(function, {BinaryOn(code, BinaryOp::kNotEqual, operand,
                                    {zero, shape, true, Constant{0, shape.scalar}, true})
                               .text});
}

// The text of mul(left, right). GLSL's matrices are the transposes of HLSL's, so the factors are
// swapped: mul(v, M) is M * v.
Text MulText(Code& code, ExprId left, ExprId right, const Shape& result) {
  Operand a = OperandOf(code, left), b = OperandOf(code, right);
  if (a.shape.IsScalar() || b.shape.IsScalar()) {
    // In a product of a scalar with anything, or of float1x1 with a row, the scalar multiplies all
    // components.
    Operand& scalar = a.shape.IsScalar() ? a : b;
    if (!result.IsScalar() && !(a.shape.IsScalar() && b.shape.IsScalar())) {
      scalar.is_scalar = true;
      scalar.shape = result;
    }
    return BinaryOn(code, BinaryOp::kMul, std::move(a), std::move(b));
  }
  if (a.shape.IsVector() && b.shape.IsVector()) {
    // A vector is a row on the left and a column on the right.
    const Type& type = code.TypeOf(left);
    const bool left_is_column = type.kind == TypeKind::kMatrix && type.columns == 1;
    if (left_is_column) std::swap(a, b);
    const Operand sides[] = {std::move(a), std::move(b)};
    return CallOn(code, left_is_column ? "outerProduct" : "dot", sides);
  }
  return Infix(Full(code, std::move(b)), "*", Full(code, std::move(a)), Binding::kProduct);
}

// The GLSL name of a function of bits, and that of the helper function that makes its value highp,
// if it needs one; empty for other functions.
struct BitNames {
  std::string_view glsl, highp;
};

BitNames BitFunction(Intrinsic op) {
  switch (op) {
    case Intrinsic::kCountBits: return {"bitCount", "count_bits"};
    case Intrinsic::kFirstBitHigh: return {"findMSB", "first_bit_high"};
    case Intrinsic::kFirstBitLow: return {"findLSB", "first_bit_low"};
    case Intrinsic::kReverseBits: return {"bitfieldReverse", ""};
    default: return {};
  }
}

}  // namespace

Text IntrinsicText(Code& code, TypeId type, const IntrinsicCall& node) {
  const bool is_numeric = code[type].IsNumeric();
  if (node.op == Intrinsic::kMul) {
    const auto arguments = code[node.arguments];
    return MulText(code, arguments[0], arguments[1], ShapeOf(code[type], code.target));
  }
  const std::vector<Operand> operands = OperandsOf(code, node.arguments);
  const Operand& x = operands[0];
  const Shape& shape = x.shape;
  const Shape result = is_numeric ? ShapeOf(code[type], code.target) : shape;
  const auto call = [&](std::string_view function) { return CallOn(code, function, operands); };
  // Some functions give a uint in HLSL, an int in GLSL, or the other way round.
  const auto converted = [&](Text value) {
    return Called(TypeName(code, result), {Argument(std::move(value))});
  };
  if (const BuiltinFunction* builtin = BuiltinOf(node.op, shape, code.target)) {
    Text text = CallOn(code, builtin->glsl, operands, shape.IsVector() ? builtin->scalars : 0);
    const bool is_sign = node.op == Intrinsic::kSign && result.scalar != shape.scalar;
    return is_sign ? converted(std::move(text)) : text;
  }
  switch (node.op) {
    case Intrinsic::kAll:
    case Intrinsic::kAny: return ReduceOn(code, NameOf(node.op), x);
    case Intrinsic::kTranspose: return shape.HasRows() ? call("transpose") : Full(code, x);
    case Intrinsic::kDot:
      return shape.IsScalar() ? BinaryOn(code, BinaryOp::kMul, x, operands[1]) : call("dot");
    case Intrinsic::kDeterminant:
      if (!shape.HasRows()) return Full(code, x);
      if (code.Has(Feature::kDeterminant)) return call("determinant");
      return SnippetCall(code, "determinant" + std::to_string(shape.rows), operands);
    case Intrinsic::kSmoothstep:
      // GLSL leaves smoothstep undefined if the edges are not in order; then HLSL's formula is
      // spelled out.
      if (!AreInOrder(x.constant, operands[1].constant)) break;
      return CallOn(code, "smoothstep", operands, shape.IsVector() ? 0b011 : 0);
    case Intrinsic::kNonUniform:
      if (!code.target.IsVulkan()) return Full(code, x);
      code.Require("GL_EXT_nonuniform_qualifier");
      return call("nonuniformEXT");
    case Intrinsic::kFrexp: code.Require(Feature::kBitCasts); break;
    case Intrinsic::kAsFloat: return CastOn(code, Scalar::kFloat, x);
    case Intrinsic::kAsInt: return CastOn(code, Scalar::kInt, x);
    case Intrinsic::kAsUint:
      if (operands.size() == 1) return CastOn(code, Scalar::kUint, x);
      return SnippetCall(code, "asuint64", operands);
    case Intrinsic::kAsDouble: return Called("packDouble2x32", {call("uvec2").text});
    case Intrinsic::kF16ToF32:
      if (code.Has(Feature::kHalfPacking)) return {call("unpackHalf2x16").text + ".x"};
      code.Require(Feature::kBitCasts);
      break;
    case Intrinsic::kF32ToF16:
      if (code.Has(Feature::kHalfPacking)) {
        return Called("packHalf2x16", {Called("vec2", {Argument(Full(code, x)), "0.0"}).text});
      }
      code.Require(Feature::kBitCasts);
      break;
    default: break;
  }
  const BitNames bits = BitFunction(node.op);
  if (bits.glsl.empty() || !code.Has(Feature::kBitFunctions)) {
    return SnippetCall(code, NameOf(node.op), operands);
  }
  if (bits.highp.empty()) return call(bits.glsl);
  if (code.target.IsEs()) return SnippetCall(code, bits.highp, operands);
  return converted(call(bits.glsl));
}

}  // namespace clipc::glsl
