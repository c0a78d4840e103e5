// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <variant>

#include "backend-glsl/literal.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"
#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

Text Writer::Expr(ExprId id) {
  const ir::Expr& expr = program_.exprs[id];
  RequireType(program_.types[expr.type]);
  return Visit(
      Overloaded{
          [&](const Literal& node) { return LiteralText(node.bits, TypeOf(id).scalar, target_); },
          [&](const Zero&) { return Text{ZeroText(expr.type)}; },
          [&](const VarRef& node) {
            if (const auto path = InstancePath(id)) return InstanceValue(id, *path);
            return VarText(node.var);
          },
          [&](const FieldRef& node) {
            const auto path = InstancePath(node.base);
            const std::string base = path ? *path : Expr(node.base).At(Binding::kPostfix);
            return Text{base + "." + FieldName(TypeOf(node.base).structure, node.field)};
          },
          [&](const Index& node) {
            if (const auto path = InstancePath(id)) return InstanceValue(id, *path);
            return IndexText(expr, node);
          },
          [&](const Swizzle& node) { return SwizzleText(node); },
          [&](const MatrixSwizzle& node) { return MatrixSwizzleText(expr, node); },
          [&](const Unary& node) { return UnaryText(node); },
          [&](const Binary& node) {
            Operand left = OperandOf(node.left), right = OperandOf(node.right);
            return BinaryOn(node.op, std::move(left), std::move(right));
          },
          [&](const Assign& node) { return AssignText(node); },
          [&](const Conditional& node) {
            std::string text = Expr(node.condition).At(Tighter(Binding::kConditional));
            text += " ? " + Expr(node.when_true).At(Binding::kAssignment);
            text += " : " + Expr(node.when_false).At(Binding::kConditional);
            return Text{std::move(text), Binding::kConditional};
          },
          [&](const Select& node) {
            const Operand mixed[] = {OperandOf(node.when_false), OperandOf(node.when_true),
                                     OperandOf(node.condition)};
            return CallOn("mix", mixed);
          },
          [&](const Convert& node) { return ConvertText(expr, node); },
          [&](const Splat&) { return Full(OperandOf(id)); },
          [&](const Construct& node) { return ConstructText(expr, node); },
          [&](const MatrixTruncate& node) { return MatrixTruncateText(expr, node); },
          [&](const Call& node) { return CallText(node); },
          [&](const IntrinsicCall& node) { return IntrinsicText(expr, node); },
          [&](const ObjectCall& node) { return ObjectText(expr, node); },
          [&](const Comma& node) {
            NotConstant();
            Text first = Expr(node.first);
            return Text{std::move(first).At(Binding::kComma) + ", " + ArgumentOf(node.second),
                        Binding::kComma};
          },
      },
      expr.node);
}

Text Writer::VarText(VarId id) {
  const Var& var = program_.vars[id];
  if (var.storage == Storage::kUniform) return UniformText(id);
  if (var.storage != Storage::kConstant || mutable_globals_.contains(id)) NotConstant();
  // A name; of an input that is a built-in variable of GLSL the call of a constructor.
  return {var_names_[id.index]};
}

std::string Writer::IndexValue(ExprId index) {
  if (const auto* literal = std::get_if<Literal>(&program_.exprs[index].node)) {
    return std::to_string(UintOf(literal->bits));
  }
  return Expr(index).At(Binding::kComma);
}

Text Writer::IndexText(const ir::Expr& expr, const Index& node) {
  const Type& type = TypeOf(node.base);
  if (type.kind == TypeKind::kArray) {
    const auto* ref = std::get_if<VarRef>(&program_.exprs[node.base].node);
    if (ref && program_.vars[ref->var].storage == Storage::kUniform) {
      return UniformElement(ref->var, node.index);
    }
    std::string text = Expr(node.base).At(Binding::kPostfix) + "[" + IndexValue(node.index) + "]";
    if (IsWrapped(expr.type)) text += ".e";
    return {std::move(text)};
  }
  Text base = Expr(node.base);
  const Shape shape = ShapeOf(type);
  const bool whole_row = type.kind == TypeKind::kMatrix && type.rows == 1;
  if (shape.IsScalar() || whole_row) return base;
  return {std::move(base).At(Binding::kPostfix) + "[" + IndexValue(node.index) + "]"};
}

Text Writer::SwizzleText(const Swizzle& node) {
  Text base = Expr(node.base);
  const Shape shape = ShapeAt(node.base);
  if (shape.IsScalar()) {
    if (node.count == 1) return base;
    return {TypeName(ShapeOf(shape.scalar, 1, node.count)) + "(" + Argument(std::move(base)) + ")"};
  }
  char components[] = ".xyzw";
  for (int i = 0; i < node.count; ++i) components[i + 1] = "xyzw"[node.components[i]];
  std::string text = std::move(base).At(Binding::kPostfix);
  text.append(components, static_cast<std::size_t>(node.count) + 1);
  return {std::move(text)};
}

Text Writer::MatrixSwizzleText(const ir::Expr& expr, const MatrixSwizzle& node) {
  const Shape shape = ShapeAt(node.base);
  const std::string base = Expr(node.base).At(Binding::kPostfix);
  const bool is_column = TypeOf(node.base).columns == 1;
  const auto component = [&](int i) { return "xyzw"[is_column ? node.rows[i] : node.columns[i]]; };

  if (shape.IsScalar() && node.count == 1) return {base};
  const bool one_row = std::all_of(node.rows.begin(), node.rows.begin() + node.count,
                                   [&](std::uint8_t row) { return row == node.rows[0]; });
  if (!shape.IsScalar() && (!shape.HasRows() || (one_row && node.count > 1))) {
    std::string text = base;
    if (shape.HasRows()) text += "[" + std::to_string(node.rows[0]) + "]";
    text += '.';
    for (int i = 0; i < node.count; ++i) text += component(i);
    return {std::move(text)};
  }
  std::string elements;
  for (int i = 0; i < node.count; ++i) {
    elements += i == 0 ? base : ", " + base;
    if (!shape.HasRows()) continue;
    elements += "[" + std::to_string(node.rows[i]) + "][" + std::to_string(node.columns[i]) + "]";
  }
  if (node.count == 1) return {std::move(elements)};
  return {TypeName(ShapeOf(program_.types[expr.type])) + "(" + elements + ")"};
}

Text Writer::UnaryText(const Unary& node) {
  const bool is_prefix = node.op == UnaryOp::kPreIncrement || node.op == UnaryOp::kPreDecrement;
  const bool is_postfix = node.op == UnaryOp::kPostIncrement || node.op == UnaryOp::kPostDecrement;
  if (!is_prefix && !is_postfix) return UnaryOn(node.op, OperandOf(node.operand));

  NotConstant();
  const bool is_increment = node.op == UnaryOp::kPreIncrement || node.op == UnaryOp::kPostIncrement;
  const std::string op = is_increment ? "++" : "--";
  Text operand = Expr(node.operand);
  if (is_postfix) return {std::move(operand).At(Binding::kPostfix) + op};
  return {op + std::move(operand).At(Binding::kUnary), Binding::kUnary};
}

Text Writer::AssignText(const Assign& node) {
  NotConstant();
  const std::string_view op = node.op ? OperatorOf(*node.op).spelling : "";
  // The value of a compound assignment may be a scalar beside a vector.
  Text value = node.op ? ScalarOr(OperandOf(node.value)) : Text{};
  std::string text = Expr(node.target).At(Binding::kUnary);
  if (!node.op) value = Expr(node.value);
  Append(text, " ", op, "= ", Argument(std::move(value)));
  return {std::move(text), Binding::kAssignment};
}

Text Writer::ConvertText(const ir::Expr& expr, const Convert& node) {
  const Scalar kind = program_.types[expr.type].scalar;
  const auto& operand = program_.exprs[node.operand].node;
  if (const auto* literal = std::get_if<Literal>(&operand)) {
    return LiteralText(ConvertBits(literal->bits, TypeOf(node.operand).scalar, kind), kind,
                       target_);
  }
  // sign() gives an int in HLSL and a float in GLSL, which is mostly what is wanted of it.
  const auto* call = std::get_if<IntrinsicCall>(&operand);
  if (call && call->op == Intrinsic::kSign) {
    const Operand argument = OperandOf(program_.expr_lists[call->arguments][0]);
    if (argument.shape.scalar == BaseOf(kind) && argument.shape.IsFloating() &&
        !argument.shape.HasRows()) {
      return CallOn("sign", {&argument, 1});
    }
  }
  return ConvertOn(kind, OperandOf(node.operand));
}

Text Writer::CallText(const Call& node) {
  NotConstant();
  std::string arguments;
  for (ExprId argument : program_.expr_lists[node.arguments]) {
    Append(arguments, arguments.empty() ? "" : ", ", ArgumentOf(argument));
  }
  const bool is_helper = program_.functions[node.function].is_helper;
  const std::string& name =
      is_helper ? HelperFunction(node.function) : function_names_[node.function.index];
  return {Concat(name, "(", arguments, ")")};
}

bool Writer::IsRepeatable(ExprId id) const {
  const auto* index = As<Index>(program_, id);
  if (index && !As<Literal>(program_, index->index)) return false;
  if (As<MatrixSwizzle>(program_, id)) return false;
  const ExprId whole = WholeOf(program_, id);
  return whole ? IsRepeatable(whole) : As<Literal>(program_, id) || As<VarRef>(program_, id);
}

}  // namespace clipc::glsl
