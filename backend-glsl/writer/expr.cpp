// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/expr.h"

#include <algorithm>

#include <fmt/format.h>

#include "backend-glsl/literal.h"
#include "backend-glsl/writer/construct.h"
#include "backend-glsl/writer/intrinsic_call.h"
#include "backend-glsl/writer/object_call.h"
#include "backend-glsl/writer/operand.h"
#include "backend-glsl/writer/stmt.h"
#include "backend-glsl/writer/types.h"
#include "backend-glsl/writer/uniform.h"
#include "base/overloaded.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

Text VarText(Code& code, VarId id) {
  if (code[id].storage == Storage::kUniform) return UniformText(code, id);
  return {code.NameOf(id)};
}

Text IndexText(Code& code, const Expr& expr, const Index& node) {
  const Type& type = code.TypeOf(node.base);
  if (type.kind == TypeKind::kArray) {
    const auto* ref = code.As<VarRef>(node.base);
    if (ref && code[ref->var].storage == Storage::kUniform) {
      return UniformElement(code, ref->var, node.index);
    }
  }
  Text base = ExprText(code, node.base);
  if (IsOnlyElement(code.program, node)) return base;
  std::string text = std::move(base).At(Binding::kPostfix);
  // Mesa 22.3 reads the wrong component for t[1] after `ivec2 t = a.yw`, but not for t.y. An
  // element of a matrix is m[1][2].
  const auto* literal = code.As<Literal>(node.index);
  const auto* row = code.As<Index>(node.base);
  const bool is_element =
      row && code.TypeOf(row->base).IsNumeric() && code.ShapeAt(row->base).HasRows();
  if (literal && !is_element && type.IsNumeric() && ShapeOf(type, code.target).IsVector()) {
    text += {'.', "xyzw"[UintOf(literal->bits) % 4]};
    return {std::move(text)};
  }
  if (HasFields(code, type)) return {Concat(text, ".e", IndexValue(code, node.index))};
  Append(text, "[", IndexValue(code, node.index), "]");
  if (type.kind == TypeKind::kArray && IsWrapped(code, expr.type)) text += ".e";
  return {std::move(text)};
}

Text SwizzleText(Code& code, const Swizzle& node) {
  Text base = ExprText(code, node.base);
  const Shape shape = code.ShapeAt(node.base);
  if (shape.IsScalar()) {
    if (node.count == 1) return base;
    return Called(TypeName(code, ShapeOf(shape.scalar, 1, node.count)),
                  {Argument(std::move(base))});
  }
  char components[] = ".xyzw";
  for (int i = 0; i < node.count; ++i) components[i + 1] = "xyzw"[node.components[i]];
  std::string text = std::move(base).At(Binding::kPostfix);
  text.append(components, std::size_t{node.count} + 1);
  return {std::move(text)};
}

Text MatrixSwizzleText(Code& code, const Expr& expr, const MatrixSwizzle& node) {
  const Shape shape = code.ShapeAt(node.base);
  std::string base = ExprText(code, node.base).At(Binding::kPostfix);
  if (shape.IsScalar() && node.count == 1) return {std::move(base)};
  const bool has_rows = shape.HasRows();
  const bool is_one_row = std::all_of(node.rows.begin(), node.rows.begin() + node.count,
                                      [&](std::uint8_t row) { return row == node.rows[0]; });
  if (!shape.IsScalar() && (!has_rows || (is_one_row && node.count > 1))) {
    if (has_rows) base = RowOf(code, shape, base, node.rows[0]);
    base += '.';
    const auto& components = code.TypeOf(node.base).columns == 1 ? node.rows : node.columns;
    for (int i = 0; i < node.count; ++i) base += "xyzw"[components[i]];
    return {std::move(base)};
  }
  const auto element = [&](int i) {
    return has_rows ? Concat(RowOf(code, shape, base, node.rows[i]), "[",
                             std::to_string(node.columns[i]), "]")
                    : base;
  };
  if (node.count == 1) return {element(0)};
  return Called(TypeName(code, ShapeOf(code[expr.type], code.target)),
                {ListOf(int{node.count}, element)});
}

Text UnaryText(Code& code, const Unary& node) {
  if (!ChangesOperand(node.op)) return UnaryOn(code, node.op, OperandOf(code, node.operand));
  Text operand = ExprText(code, node.operand);
  switch (node.op) {
    case UnaryOp::kPreIncrement:
      return {"++" + std::move(operand).At(Binding::kUnary), Binding::kUnary};
    case UnaryOp::kPreDecrement:
      return {"--" + std::move(operand).At(Binding::kUnary), Binding::kMinus};
    case UnaryOp::kPostIncrement: return {std::move(operand).At(Binding::kPostfix) + "++"};
    default: return {std::move(operand).At(Binding::kPostfix) + "--"};
  }
}

Text AssignText(Code& code, const Assign& node) {
  // The value of a compound assignment may be a scalar beside a vector.
  Text value = node.op ? OperandOf(code, node.value).text : Text{};
  std::string text = ExprText(code, node.target).At(Binding::kUnary);
  if (!node.op) value = ExprText(code, node.value);
  Append(text, " ", node.op ? OperatorOf(*node.op).spelling : "", "= ", Argument(std::move(value)));
  return {std::move(text), Binding::kAssignment};
}

Text ConvertText(Code& code, const Expr& expr, const Convert& node) {
  const Scalar kind = code[expr.type].scalar;
  if (const auto* literal = code.As<Literal>(node.operand)) {
    const Scalar from = code.TypeOf(node.operand).scalar;
    return LiteralText(ConvertBits(literal->bits, from, kind), kind, code.target);
  }
  // sign() gives an int in HLSL and a float in GLSL, and mostly its value is wanted as a float.
  const auto* call = code.As<IntrinsicCall>(node.operand);
  if (call && call->op == Intrinsic::kSign) {
    const Operand argument = OperandOf(code, code[call->arguments][0]);
    if (argument.shape.scalar == BaseOf(kind) && argument.shape.IsFloating() &&
        !argument.shape.HasRows()) {
      return CallOn(code, "sign", {&argument, 1});
    }
  }
  return ConvertOn(code, kind, OperandOf(code, node.operand));
}

Text CallText(Code& code, const Call& node) {
  const std::string arguments =
      ListOf(code[node.arguments], [&](ExprId argument) { return Argument(code, argument); });
  const bool is_helper = code[node.function].is_helper;
  return Called(
      is_helper ? HelperFunction(code, node.function) : code.names.functions[node.function.index],
      {arguments});
}

}  // namespace

Text ExprText(Code& code, ExprId id) {
  const Expr& expr = code[id];
  code.RequireType(code[expr.type]);
  return Visit(
      Overloaded{
          [&](const Literal& node) {
            return LiteralText(node.bits, code.TypeOf(id).scalar, code.target);
          },
          [&](const Zero&) { return Text{ZeroText(code, expr.type)}; },
          [&](const VarRef& node) {
            return IsInstance(code, id) ? InstanceValue(code, id) : VarText(code, node.var);
          },
          [&](const FieldRef& node) {
            const std::string base = IsInstance(code, node.base)
                                         ? InstancePath(code, node.base)
                                         : ExprText(code, node.base).At(Binding::kPostfix);
            const auto& fields = code.names.fields[code.TypeOf(node.base).structure.index];
            return Text{Concat(base, ".", fields[node.field])};
          },
          [&](const Index& node) {
            return IsInstance(code, id) ? InstanceValue(code, id) : IndexText(code, expr, node);
          },
          [&](const Swizzle& node) { return SwizzleText(code, node); },
          [&](const MatrixSwizzle& node) { return MatrixSwizzleText(code, expr, node); },
          [&](const Unary& node) { return UnaryText(code, node); },
          [&](const Binary& node) {
            Operand left = OperandOf(code, node.left);
            return BinaryOn(code, node.op, std::move(left), OperandOf(code, node.right));
          },
          [&](const Assign& node) { return AssignText(code, node); },
          [&](const Conditional& node) {
            std::string text = ExprText(code, node.condition).At(Tighter(Binding::kConditional));
            Append(text, " ? ", Argument(code, node.when_true));
            Append(text, " : ", ExprText(code, node.when_false).At(Binding::kConditional));
            return Text{std::move(text), Binding::kConditional};
          },
          [&](const Select& node) {
            const Operand mixed[] = {OperandOf(code, node.when_false),
                                     OperandOf(code, node.when_true),
                                     OperandOf(code, node.condition)};
            return CallOn(code, "mix", mixed);
          },
          [&](const Convert& node) { return ConvertText(code, expr, node); },
          [&](const Splat&) { return Full(code, OperandOf(code, id)); },
          [&](const Construct& node) {
            return ConstructText(code, expr.type, code[node.arguments]);
          },
          [&](const MatrixTruncate& node) { return TruncateText(code, expr.type, node.operand); },
          [&](const Call& node) { return CallText(code, node); },
          [&](const IntrinsicCall& node) { return IntrinsicText(code, expr.type, node); },
          [&](const ObjectCall& node) { return ObjectText(code, expr.type, node); },
          [&](const Comma& node) {
            std::string text = ExprText(code, node.first).text;
            Append(text, ", ", Argument(code, node.second));
            return Text{std::move(text), Binding::kComma};
          },
      },
      expr.node);
}

std::string Argument(Code& code, ExprId id) { return Argument(ExprText(code, id)); }

std::string IndexValue(Code& code, ExprId index) {
  const auto* literal = code.As<Literal>(index);
  return literal ? std::to_string(UintOf(literal->bits)) : ExprText(code, index).text;
}

std::string IndexPath(Code& code, ExprId element) {
  const auto* index = code.As<Index>(element);
  if (!index) return "";
  std::string path = IndexPath(code, index->base);
  Append(path, "[", IndexValue(code, index->index), "]");
  return path;
}

std::string IntIndex(Code& code, ExprId index) {
  const bool is_int = code.TypeOf(index).scalar == Scalar::kInt || code.As<Literal>(index);
  const std::string value =
      code.As<Literal>(index) ? IndexValue(code, index) : Argument(code, index);
  return is_int ? value : Concat("int(", value, ")");
}

}  // namespace clipc::glsl
