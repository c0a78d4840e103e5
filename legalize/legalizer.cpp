// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/legalizer.h"

#include <variant>

#include "base/operators.h"
#include "ir/evaluate.h"
#include "ir/walk.h"
#include "legalize/functions.h"

namespace clipc::legalize {

using namespace ir;

namespace {

bool IsMatrix(const Program& program, TypeId type) {
  return program.types[type].kind == TypeKind::kMatrix;
}

// Whether `left op right` or `left op= right` may differ from GLSL's, which has other operators of
// matrices, evaluates one side of a logical operator first, and defines less of divisions of
// integers and of shifts.
bool MayDiffer(const Program& program, BinaryOp op, ExprId left) {
  const Type& type = program.types[program.exprs[left].type];
  return op == BinaryOp::kLogicalAnd || op == BinaryOp::kLogicalOr || op == BinaryOp::kMod ||
         (op == BinaryOp::kDiv && !IsFloat(type.scalar)) || IsShift(op) ||
         type.kind == TypeKind::kMatrix;
}

// Whether the expression is an operator between literals, or between literals with a sign.
bool IsOfLiterals(const Program& program, const Expr& expr) {
  const auto is_literal = [&](ExprId operand) {
    const auto* sign = As<Unary>(program, operand);
    return As<Literal>(program, sign ? sign->operand : operand) != nullptr;
  };
  if (const auto* unary = std::get_if<Unary>(&expr.node)) return is_literal(unary->operand);
  const auto* binary = std::get_if<Binary>(&expr.node);
  return binary && is_literal(binary->left) && is_literal(binary->right);
}

// Whether the expression is the least integer of 32 or 64 bits, as a literal, as 1 << 31 or as
// -2147483647 - 1.
bool IsLeastInteger(const Program& program, ExprId id) {
  const Expr& expr = program.exprs[id];
  if (IsOfLiterals(program, expr)) {
    const Scalar kind = program.types[expr.type].scalar;
    const auto bits =
        IsFloat(kind) || kind == Scalar::kBool ? std::nullopt : ConstantBits(program, id);
    return bits && bits->front() == std::uint64_t{1} << (IsWide(kind) ? 63 : 31);
  }
  const auto* literal = std::get_if<Literal>(&expr.node);
  if (!literal || literal->bits < std::uint64_t{1} << 31) return false;
  const Scalar kind = program.types[expr.type].scalar;
  return !IsFloat(kind) && literal->bits == std::uint64_t{1} << (IsWide(kind) ? 63 : 31);
}

// Whether a pass may change a call. No pass changes functions of scalars and vectors of floats that
// the target has, or products of floats where the target has all matrices.
bool MayDiffer(const Program& program, const Needs& needs, const IntrinsicCall& call) {
  const auto arguments = program.expr_lists[call.arguments];
  if (arguments.empty()) return false;
  const Type& type = program.types[program.exprs[arguments[0]].type];
  if (!type.IsNumeric() || !IsFloat(type.scalar)) return true;
  if (call.op == CommonIntrinsic::kMul) return needs.square_matrices;
  return type.kind == TypeKind::kMatrix || IsComposed(call.op) || WritesArguments(call.op) ||
         FindFunction(call.op, type, needs) || IsOfScalars(call.op, type, needs);
}

// Whether a pass may change the node. Most nodes of a program are names, literals, and operators
// and functions of numbers and vectors, which GLSL has too; visiting only the others makes the
// passes cheap.
bool MayChange(const Program& program, const Needs& needs, const Expr& expr) {
  return Visit(
      Overloaded{
          [&](const Binary& node) { return MayDiffer(program, node.op, node.left); },
          [&](const Assign& node) { return node.op && MayDiffer(program, *node.op, node.target); },
          [&](const IntrinsicCall& node) { return MayDiffer(program, needs, node); },
          [&](const Unary&) { return IsMatrix(program, expr.type); },
          [&](const Convert& node) {
            // An expression that was replaced may be incomplete.
            return IsMatrix(program, expr.type) || !node.operand ||
                   (!IsFloat(program.types[expr.type].scalar) &&
                    IsFloat(program.types[program.exprs[node.operand].type].scalar));
          },
          [&](const Index& node) {
            return node.base &&
                   (IsOnlyElement(program, node) || TypeOf(program, node.base).count == 1 ||
                    As<Swizzle>(program, node.base) != nullptr);
          },
          [&](const Conditional&) {
            const TypeKind kind = program.types[expr.type].kind;
            return kind != TypeKind::kScalar && kind != TypeKind::kVector;
          },
          [](const OneOf<Select, MatrixTruncate> auto&) { return true; },
          [](const auto&) { return false; },
      },
      expr.node);
}

// The words for the operators, in the order of BinaryOp.
constexpr std::string_view kNames[] = {
    "multiply",      "divide",      "modulo",     "add",         "subtract",
    "shift_left",    "shift_right", "less",       "greater",     "less_equal",
    "greater_equal", "equal_rows",  "not_equal",  "bit_and",     "bit_xor",
    "bit_or",        "logical_and", "logical_or", "logical_and", "logical_or",
};

}  // namespace

std::string_view NameOf(BinaryOp op) { return kNames[static_cast<int>(op)]; }

Legalizer::Legalizer(Program& program, const Needs& needs)
    : program(program), needs(needs), first_new_(program.exprs.size()), divisors_(program) {
  program.exprs.ForEach([&](ExprId id, const Expr& expr) {
    if (MayChange(program, needs, expr)) operations_.push_back(id);
  });
}

bool Legalizer::NamesLeastInteger() {
  if (names_least_integer_) return *names_least_integer_;
  bool found = false;
  for (const ExprId expr : program.exprs.ids())
    found = found || (expr.index < first_new_ && IsLeastInteger(program, expr));
  names_least_integer_ = found;
  return found;
}

bool Legalizer::GuardsDivisions() const {
  return program.profile.IsAtLeast(4, 0) && program.profile.level9 == Level9::kNone;
}

bool Legalizer::MayDivideByZero(ExprId divisor) {
  const Type& type = TypeOf(divisor);
  if (!GuardsDivisions() || !type.IsNumeric() || IsFloat(type.scalar)) return false;
  if (IsUnsigned(type.scalar) && needs.signed_integers) return false;
  return divisors_.MayBeZero(divisor);
}

bool Legalizer::MayBeSkipped(ExprId expr) {
  if (!effects_ || effects_functions_ != program.functions.size()) {
    effects_.emplace(program);
    effects_functions_ = program.functions.size();
  }
  return effects_->MayBeSkipped(expr);
}

ExprId Legalizer::Component(Builder b, ExprId expr, int i) {
  const Type type = TypeOf(expr);
  if (type.kind == TypeKind::kScalar) return expr;
  const auto component = static_cast<std::uint8_t>(i);
  if (type.kind == TypeKind::kVector) return b.Swizzled(expr, {i});
  MatrixSwizzle node{expr, {}, {}, 1};
  (type.columns == 1 ? node.rows : node.columns)[0] = component;
  return b.Add(program.types.Make(type.scalar), node);
}

FunctionId Legalizer::Helper(std::string_view name, std::span<const Parameter> parameters,
                             TypeId result, const Define& define) {
  std::string key(name);
  for (const Parameter& parameter : parameters) {
    const std::uint32_t type = parameter.type.index;
    key.append(reinterpret_cast<const char*>(&type), sizeof type);
  }
  FunctionId& helper = helpers_[key];
  if (!helper) helper = AddHelper(program, name, parameters, result, define);
  return helper;
}

void Legalizer::BecomeCall(ExprId expr, std::string_view name,
                           std::span<const Parameter> parameters, std::span<const ExprId> arguments,
                           const Define& define) {
  const FunctionId helper = Helper(name, parameters, program.exprs[expr].type, define);
  program.exprs[expr].node = Call{helper, program.expr_lists.Add(arguments)};
}

void Legalizer::BecomeCall(ExprId expr, std::string_view name, std::span<const ExprId> arguments,
                           const Define& define) {
  static constexpr std::string_view kNames[] = {"a", "b", "c", "d"};
  std::vector<Parameter> parameters;
  parameters.reserve(arguments.size());
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    parameters.push_back({kNames[i], program.exprs[arguments[i]].type});
  }
  BecomeCall(expr, name, parameters, arguments, define);
}

void Legalizer::ByParts(ExprId expr, std::string_view name, const Node& node, bool rows) {
  const std::vector<ExprId> operands = OperandsOf(program, expr);
  const TypeId result = program.exprs[expr].type;
  const Type type = program.types[result];
  const TypeId part_type =
      rows ? program.types.Vector(type.scalar, type.columns) : program.types.Make(type.scalar);
  const int count = rows ? type.rows : static_cast<int>(type.Components());
  BecomeCall(expr, name, operands, [&, node = node](HelperBody& body) {
    std::vector<ExprId> parts;
    for (int i = 0; i < count; ++i) parts.push_back(PartOf(body, node, part_type, i, rows));
    body.Return(body.b.ConstructOf(result, parts));
  });
}

ExprId Legalizer::PartOf(HelperBody& body, const Node& node, TypeId type, int part, bool rows) {
  Builder& b = body.b;
  const ExprId copy = b.CopyOf(type, node);
  std::size_t operand = 0;
  MapOperands(program, copy, [&](ExprId) {
    const ExprId whole = body[operand++];
    return rows ? b.At(whole, static_cast<std::uint32_t>(part)) : Component(b, whole, part);
  });
  return copy;
}

}  // namespace clipc::legalize
