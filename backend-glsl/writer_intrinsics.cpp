// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <charconv>
#include <optional>

#include "backend-glsl/literal.h"
#include "backend-glsl/writer_state.h"
#include "base/invariant.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// A function that GLSL has under the same or another name.
struct Direct {
  Intrinsic op;
  std::string_view glsl;
  unsigned scalars = 0;         // bit i: argument i may be a scalar beside vectors
  bool since_rounding = false;  // GLSL 1.30
};
constexpr Direct kDirect[] = {
    {Intrinsic::kAbs, "abs"},
    {Intrinsic::kAcos, "acos"},
    {Intrinsic::kAsin, "asin"},
    {Intrinsic::kAtan, "atan"},
    {Intrinsic::kAtan2, "atan"},
    {Intrinsic::kCeil, "ceil"},
    {Intrinsic::kClamp, "clamp", 0b110},
    {Intrinsic::kCos, "cos"},
    {Intrinsic::kCosh, "cosh", 0, true},
    {Intrinsic::kCross, "cross"},
    {Intrinsic::kDegrees, "degrees"},
    {Intrinsic::kDistance, "distance"},
    {Intrinsic::kExp, "exp"},
    {Intrinsic::kExp2, "exp2"},
    {Intrinsic::kFaceforward, "faceforward"},
    {Intrinsic::kFloor, "floor"},
    {Intrinsic::kFma, "fma"},
    {Intrinsic::kFrac, "fract"},
    {Intrinsic::kIsInf, "isinf", 0, true},
    {Intrinsic::kIsNan, "isnan", 0, true},
    {Intrinsic::kLength, "length"},
    {Intrinsic::kLerp, "mix", 0b100},
    {Intrinsic::kLog, "log"},
    {Intrinsic::kLog2, "log2"},
    {Intrinsic::kMax, "max", 0b10},
    {Intrinsic::kMin, "min", 0b10},
    {Intrinsic::kNormalize, "normalize"},
    {Intrinsic::kPow, "pow"},
    {Intrinsic::kRadians, "radians"},
    {Intrinsic::kReflect, "reflect"},
    {Intrinsic::kRefract, "refract"},
    {Intrinsic::kRound, "roundEven", 0, true},
    {Intrinsic::kRsqrt, "inversesqrt"},
    {Intrinsic::kSign, "sign"},
    {Intrinsic::kSin, "sin"},
    {Intrinsic::kSinh, "sinh", 0, true},
    {Intrinsic::kSqrt, "sqrt"},
    {Intrinsic::kStep, "step", 0b01},
    {Intrinsic::kTan, "tan"},
    {Intrinsic::kTanh, "tanh", 0, true},
    {Intrinsic::kTrunc, "trunc", 0, true},
};

Operand ScalarOperand(Text text, const Shape& shape) { return {{}, shape, std::move(text), true}; }

// The number that a literal operand is.
std::optional<double> NumberIn(const Operand& operand) {
  if (!operand.scalar) return std::nullopt;
  const std::string& text = operand.scalar->text;
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() ? std::optional(value)
                                                                             : std::nullopt;
}

// A number as a literal of a float or double shape.
Operand Constant(double value, const Shape& shape, const Target& target) {
  const std::uint64_t bits =
      shape.scalar == Scalar::kDouble ? BitsOf(value) : BitsOf(static_cast<float>(value));
  return ScalarOperand(LiteralText(bits, shape.scalar, target), shape);
}

}  // namespace

Text Writer::IntrinsicText(const ir::Expr& expr, const IntrinsicCall& node) {
  const auto arguments = program_.expr_lists[node.arguments];
  const Type& type = program_.types[expr.type];
  switch (node.op) {
    case Intrinsic::kFrexp:
    case Intrinsic::kModf:
    case Intrinsic::kSincos: return WithOutputs(node);
    case Intrinsic::kAsUint:
      if (arguments.size() == 3) return WithOutputs(node);
      break;
    case Intrinsic::kMul: return MulText(arguments[0], arguments[1], type);
    case Intrinsic::kTranspose: {
      const Operand operand = OperandOf(arguments[0]);
      if (!operand.shape.HasRows()) return Full(operand);
      if (operand.shape.kind == Shape::kMatrix) return CallOn("transpose", {&operand, 1});
      break;
    }
    default: break;
  }
  return IntrinsicOn(node.op, OperandsOf(node.arguments), ShapeOf(type));
}

std::optional<Text> Writer::DirectOn(Intrinsic op, std::span<const Operand> operands) {
  const auto* direct = std::ranges::find(kDirect, op, &Direct::op);
  if (direct == std::end(kDirect)) return std::nullopt;
  const Shape& shape = operands[0].shape;
  const bool integers_lack = !shape.IsFloating() && !target_.HasUnsigned();
  if ((direct->since_rounding && !target_.HasRounding()) || integers_lack) {
    return Snippet(
        NameOf(op), operands,
        op == Intrinsic::kIsInf || op == Intrinsic::kIsNan ? shape.With(Scalar::kBool) : shape);
  }
  return CallOn(direct->glsl, operands, shape.IsVector() ? direct->scalars : 0);
}

Text Writer::IntrinsicOn(Intrinsic op, std::span<const Operand> operands, const Shape& result) {
  const Shape& shape = operands[0].shape;
  const bool is_unsigned = shape.scalar == Scalar::kUint || shape.scalar == Scalar::kUint64;
  switch (op) {
    case Intrinsic::kAll:
    case Intrinsic::kAny: return ReduceOn(op, operands[0]);
    case Intrinsic::kDeterminant: {
      if (!shape.HasRows()) return Full(operands[0]);
      if (target_.HasDeterminant()) return CallOn("determinant", operands);
      return Snippet("determinant" + std::to_string(shape.rows), operands, result);
    }
    case Intrinsic::kTranspose: {
      std::string rows;
      for (int r = 0; r < result.rows; ++r) {
        rows += (r > 0 ? ", " : "") + TypeName(result.Row()) + "(";
        for (int c = 0; c < result.size; ++c) {
          rows += (c > 0 ? ", m[" : "m[") + std::to_string(c) + "]." + "xyzw"[r];
        }
        rows += ")";
      }
      const std::string name =
          Helper("transpose", TypeName(shape), [&](const std::string& function) {
            return TypeName(result) + " " + function + "(" + Declaration(shape, "m") +
                   ") {\n    return " + TypeName(result) + "(" + rows + ");\n}\n";
          });
      return CallOn(name, operands);
    }
    default: break;
  }
  if (shape.HasRows()) {
    return ByRows(NameOf(op), operands, result,
                  [&](std::span<const Operand> row) { return IntrinsicOn(op, row, result.Row()); });
  }
  if (op == Intrinsic::kAbs && is_unsigned) return Full(operands[0]);
  if (op == Intrinsic::kDot) return DotOn(operands[0], operands[1]);
  if (op == Intrinsic::kSign && shape.IsFloating()) {
    Text sign = CallOn("sign", operands);
    return {TypeName(result) + "(" + Argument(std::move(sign)) + ")"};
  }
  if (op == Intrinsic::kSign && is_unsigned) {
    Operand one = ScalarOperand(LiteralText(1, shape.scalar, target_), shape);
    const Operand both[] = {operands[0], one};
    return ConvertOn(result.scalar,
                     {IntrinsicOn(Intrinsic::kMin, both, shape), shape, std::nullopt, false});
  }
  if (auto direct = DirectOn(op, operands)) return std::move(*direct);
  return BitsOn(op, operands, result);
}

Text Writer::FloatOn(Intrinsic op, std::span<const Operand> operands, const Shape& result) {
  const Operand& x = operands[0];
  const Shape& shape = x.shape;
  const auto of = [&](Text text) { return Operand{std::move(text), shape, std::nullopt, false}; };
  switch (op) {
    case Intrinsic::kRcp: return ArithmeticOn(BinaryOp::kDiv, Constant(1, shape, target_), x);
    case Intrinsic::kLog10:
      return ArithmeticOn(BinaryOp::kMul, of(CallOn("log2", operands)),
                          Constant(0.30102999566398120, shape, target_));
    case Intrinsic::kLdexp:
      return ArithmeticOn(BinaryOp::kMul, x, of(CallOn("exp2", operands.subspan(1, 1))));
    case Intrinsic::kMad:
      return ArithmeticOn(BinaryOp::kAdd, of(ArithmeticOn(BinaryOp::kMul, x, operands[1])),
                          operands[2]);
    case Intrinsic::kFmod: return Snippet("fmod", operands, result);
    case Intrinsic::kSaturate:
    case Intrinsic::kIsFinite:
    case Intrinsic::kDst:
    case Intrinsic::kMsad4: return Snippet(NameOf(op), operands, result);
    case Intrinsic::kLit: return Snippet("lit", operands, result);
    case Intrinsic::kSmoothstep: {
      // GLSL leaves smoothstep undefined when the edges are not in order; then HLSL's formula is
      // spelled out.
      const auto low = NumberIn(x), high = NumberIn(operands[1]);
      if (low && high && *low < *high)
        return CallOn("smoothstep", operands, shape.IsVector() ? 0b011 : 0);
      return Snippet("smoothstep", operands, result);
    }
    case Intrinsic::kD3dColorToUbyte4: {
      const Operand zyxw = of({Full(x).At(Binding::kPostfix) + ".zyxw"});
      Text scaled = ArithmeticOn(BinaryOp::kMul, zyxw, Constant(255.001953, shape, target_));
      return {TypeName(result) + "(" + Argument(std::move(scaled)) + ")"};
    }
    default: break;
  }
  CLIPC_CHECK(!"an intrinsic that WriteGlsl knows");
  return {};
}

// countbits and the others give uint in HLSL, int in GLSL.
Text Writer::BitsOn(Intrinsic op, std::span<const Operand> operands, const Shape& result) {
  const Operand& x = operands[0];
  const auto counted = [&](std::string_view function) {
    if (!target_.HasBitFunctions()) return Snippet(NameOf(op), operands, result);
    return Text{TypeName(result) + "(" + CallOn(function, operands).text + ")"};
  };
  switch (op) {
    case Intrinsic::kAsFloat: return CastOn(Scalar::kFloat, x);
    case Intrinsic::kAsInt: return CastOn(Scalar::kInt, x);
    case Intrinsic::kAsUint: return CastOn(Scalar::kUint, x);
    case Intrinsic::kAsDouble: {
      if (result.IsVector()) {
        return ByComponents("asdouble", operands, result, [&](std::span<const Operand> part) {
          return BitsOn(op, part, result.Component());
        });
      }
      return {"packDouble2x32(uvec2(" + Argument(Full(x)) + ", " + Argument(Full(operands[1])) +
              "))"};
    }
    case Intrinsic::kCountBits: return counted("bitCount");
    case Intrinsic::kFirstBitHigh: return counted("findMSB");
    case Intrinsic::kFirstBitLow: return counted("findLSB");
    case Intrinsic::kReverseBits:
      return target_.HasBitFunctions() ? CallOn("bitfieldReverse", operands)
                                       : Snippet("reversebits", operands, result);
    case Intrinsic::kF16ToF32:
    case Intrinsic::kF32ToF16: {
      if (!target_.HasHalfPacking()) {
        Require(target_.BitCasts());
        return Snippet(NameOf(op), operands, result);
      }
      if (result.IsVector()) {
        return ByComponents(NameOf(op), operands, result, [&](std::span<const Operand> part) {
          return BitsOn(op, part, result.Component());
        });
      }
      if (op == Intrinsic::kF16ToF32) return {"unpackHalf2x16(" + Argument(Full(x)) + ").x"};
      return {"packHalf2x16(vec2(" + Argument(Full(x)) + ", 0.0))"};
    }
    default: return FloatOn(op, operands, result);
  }
}

Text Writer::CastOn(Scalar to, const Operand& operand) {
  const Scalar from = operand.shape.scalar;
  if (from == to) return Full(operand);
  if (from != Scalar::kFloat && to != Scalar::kFloat) return ConvertOn(to, operand);
  Require(target_.BitCasts());
  const char* function = to == Scalar::kInt     ? "floatBitsToInt"
                         : to == Scalar::kUint  ? "floatBitsToUint"
                         : from == Scalar::kInt ? "intBitsToFloat"
                                                : "uintBitsToFloat";
  return CallOn(function, {&operand, 1});
}

Text Writer::ReduceOn(Intrinsic op, const Operand& operand) {
  const Shape& shape = operand.shape;
  const std::string function = NameOf(op);
  if (shape.HasRows()) {
    const std::string name = Helper(function, TypeName(shape), [&](const std::string& helper) {
      std::string rows;
      for (int i = 0; i < shape.rows; ++i) {
        if (i > 0) rows += op == Intrinsic::kAll ? " && " : " || ";
        rows +=
            ReduceOn(op, {{"m[" + std::to_string(i) + "]"}, shape.Row(), std::nullopt, true}).text;
      }
      return "bool " + helper + "(" + Declaration(shape, "m") + ") {\n    return " + rows +
             ";\n}\n";
    });
    return CallOn(name, {&operand, 1});
  }
  if (shape.IsScalar()) return ConvertOn(Scalar::kBool, operand);
  if (shape.scalar == Scalar::kBool) return CallOn(function, {&operand, 1});
  const Operand zero = ScalarOperand({ZeroText(shape.Component())}, shape);
  return {function + "(" + CompareOn(BinaryOp::kNotEqual, operand, zero).text + ")"};
}

Text Writer::DotOn(const Operand& left, const Operand& right) {
  const Operand operands[] = {left, right};
  if (left.shape.IsScalar()) return ArithmeticOn(BinaryOp::kMul, left, right);
  if (left.shape.IsFloating()) return CallOn("dot", operands);
  const Shape& shape = left.shape;
  const std::string name = Helper("dot", TypeName(shape), [&](const std::string& function) {
    std::string sum;
    for (int i = 0; i < shape.size; ++i) {
      const std::string component = std::string(".") + "xyzw"[i];
      sum += (i > 0 ? " + a" : "a") + component + " * b" + component;
    }
    return TypeName(shape.Component()) + " " + function + "(" + Declaration(shape, "a") + ", " +
           Declaration(shape, "b") + ") {\n    return " + sum + ";\n}\n";
  });
  return CallOn(name, operands);
}

// frexp, modf, sincos, asuint(double): what they write are assignment targets, so they become
// functions with out parameters.
Text Writer::WithOutputs(const IntrinsicCall& node) {
  NotConstant();
  const std::vector<Operand> operands = OperandsOf(node.arguments);
  const Shape& shape = operands[0].shape;
  const bool has_value = node.op == Intrinsic::kFrexp || node.op == Intrinsic::kModf;
  if (node.op == Intrinsic::kModf && shape.IsFloating() && !shape.HasRows() &&
      target_.HasRounding()) {
    return CallOn("modf", operands);
  }
  if (node.op == Intrinsic::kFrexp) Require(target_.BitCasts());
  const std::string snippet = node.op == Intrinsic::kAsUint ? "asuint64" : NameOf(node.op);
  const bool by_parts = shape.HasRows() || (shape.IsVector() && node.op != Intrinsic::kSincos &&
                                            node.op != Intrinsic::kModf);
  if (!by_parts) return Snippet(snippet, operands, shape);

  const Shape part = shape.HasRows() ? shape.Row() : shape.Component();
  const int count = shape.HasRows() ? shape.rows : shape.size;
  const Shape written = node.op == Intrinsic::kAsUint ? shape.With(Scalar::kUint) : shape;
  const bool two = operands.size() == 3;
  const std::string name =
      Helper(NameOf(node.op), TypeName(shape), [&](const std::string& function) {
        std::string body, values;
        for (int i = 0; i < count; ++i) {
          const std::string at = "[" + std::to_string(i) + "]";
          std::vector<Operand> parts = {{{"a" + at}, part, std::nullopt, true},
                                        {{"b" + at}, part, std::nullopt, true}};
          if (two) parts.push_back({{"c" + at}, part, std::nullopt, true});
          const bool builtin =
              node.op == Intrinsic::kModf && shape.IsFloating() && target_.HasRounding();
          const std::string call =
              builtin ? CallOn("modf", parts).text : Snippet(snippet, parts, part).text;
          if (has_value) values += (i > 0 ? ", " : "") + call;
          if (!has_value) body += "    " + call + ";\n";
        }
        if (has_value) body = "    return " + TypeName(shape) + "(" + values + ");\n";
        return (has_value ? TypeName(shape) : "void") + " " + function + "(" +
               Declaration(shape, "a") + ", out " + Declaration(written, "b") +
               (two ? ", out " + Declaration(written, "c") : "") + ") {\n" + body + "}\n";
      });
  return CallOn(name, operands);
}

}  // namespace clipc::glsl
