// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/formula.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ir/access.h"

namespace clipc::legalize {

using namespace ir;

namespace {

constexpr std::string_view kComponents = "xyzw";

// The operand as a value of the type: a number or a scalar is that of all components.
ExprId ValueOf(HelperBody& body, const Operand& operand, TypeId type) {
  const Scalar kind = body.program.types[type].scalar;
  const ExprId value = operand.expr
                           ? operand.expr
                           : Formula(body).Number(kind, operand.number, operand.is_mask).expr;
  const bool is_scalar = TypeOf(body.program, value).kind == TypeKind::kScalar;
  return is_scalar ? body.b.SplatTo(type, value) : value;
}

// The type of a call of the function, whose first argument has the type `first`.
TypeId ResultOf(TypeTable& types, Intrinsic op, TypeId first) {
  const IntrinsicSlot slot = InfoOf(op).signature.result;
  const Scalar kind = slot.kind == 'b'   ? Scalar::kBool
                      : slot.kind == 'i' ? Scalar::kInt
                      : slot.kind == 'u' ? Scalar::kUint
                                         : types[first].scalar;
  if (slot.shape == 's') return types.Make(kind);
  const bool is_sized = slot.shape >= '2' && slot.shape <= '4';
  return is_sized ? types.Vector(kind, slot.shape - '0') : types.WithScalar(first, kind);
}

}  // namespace

Scalar Local::Kind() const { return body->program.types[body->program.vars[var].type].scalar; }
Term Local::operator[](int row) const { return Term(*this)[row]; }
Term Local::operator[](std::string_view components) const { return Term(*this)[components]; }

Term Term::operator[](int row) const {
  return {body, body->b.At(expr, static_cast<std::uint32_t>(row))};
}

Term Term::operator[](std::string_view components) const {
  std::vector<std::uint8_t> numbers;
  for (const char component : components)
    numbers.push_back(static_cast<std::uint8_t>(kComponents.find(component)));
  return {body, body->b.Swizzled(expr, numbers)};
}

Term Join(BinaryOp op, const Operand& left, const Operand& right) {
  HelperBody& body = *(left.body ? left.body : right.body);
  TypeTable& types = body.program.types;
  const auto is_whole = [&](const Operand& operand) {
    return operand.expr && TypeOf(body.program, operand.expr).kind != TypeKind::kScalar;
  };
  const TypeId type = TypeIdOf(
      body.program, is_whole(left) || (left.expr && !is_whole(right)) ? left.expr : right.expr);
  TypeId right_type = type;
  if (IsShift(op)) {
    const Scalar count = right.expr ? TypeOf(body.program, right.expr).scalar : Scalar::kInt;
    right_type = types.WithScalar(type, count);
  }
  const ExprId first = ValueOf(body, left, type), second = ValueOf(body, right, right_type);
  return {&body, body.b.BinaryOf(op, first, second)};
}

Term operator-(const Term& x) { return {x.body, x.body->b.UnaryOf(UnaryOp::kNegate, x.expr)}; }
Term operator!(const Term& x) { return {x.body, x.body->b.UnaryOf(UnaryOp::kNot, x.expr)}; }

Term Formula::Number(Scalar kind, double value, bool is_mask) {
  const ExprId number = body_.b.LiteralOf(kind, value);
  std::get<Literal>(body_.program.exprs[number].node).is_mask = is_mask;
  return {&body_, number};
}

Term Formula::Sign(const Term& x) {
  return To(TypeOf(body_.program, x.expr).scalar, Call(CommonIntrinsic::kSign, {x}));
}

Term Formula::Call(Intrinsic op, std::initializer_list<Operand> arguments) {
  TypeId first;
  for (auto i = std::rbegin(arguments); i != std::rend(arguments); ++i)
    if (i->expr) first = TypeIdOf(body_.program, i->expr);
  std::vector<ExprId> values;
  for (const Operand& argument : arguments)
    values.push_back(argument.expr ? argument.expr : ValueOf(body_, argument, first));
  const List<ExprId> list = body_.program.expr_lists.Add(std::span<const ExprId>(values));
  return {&body_, body_.b.Add(ResultOf(body_.program.types, op, first), IntrinsicCall{op, list})};
}

Term Formula::Bits(Scalar kind, const Term& x) {
  const TypeId type = body_.program.types.WithScalar(TypeIdOf(body_.program, x.expr), kind);
  const Intrinsic op = kind == Scalar::kUint ? CommonIntrinsic::kAsUint : CommonIntrinsic::kAsFloat;
  return {&body_, body_.b.IntrinsicOf(op, type, {x.expr})};
}

Term Formula::To(Scalar kind, const Term& x) { return {&body_, body_.b.ConvertTo(kind, x.expr)}; }

Term Formula::Choose(const Term& condition, const Operand& when_true, const Operand& when_false) {
  const TypeId type = TypeIdOf(body_.program, when_true.expr ? when_true.expr : when_false.expr);
  const ExprId first = ValueOf(body_, when_true, type), second = ValueOf(body_, when_false, type);
  return {&body_, body_.b.Add(type, Conditional{condition.expr, first, second})};
}

Term Formula::Vector(Scalar kind, std::initializer_list<Operand> parts) {
  TypeTable& types = body_.program.types;
  const TypeId component = types.Make(kind);
  std::vector<ExprId> values;
  for (const Operand& part : parts)
    values.push_back(part.expr ? part.expr : ValueOf(body_, part, component));
  return {&body_, body_.b.ConstructOf(types.Vector(kind, static_cast<int>(parts.size())), values)};
}

Term Formula::Splat(int size, const Term& scalar) {
  TypeTable& types = body_.program.types;
  const TypeId type = types.Vector(TypeOf(body_.program, scalar.expr).scalar, size);
  return {&body_, body_.b.SplatTo(type, scalar.expr)};
}

Local Formula::Let(std::string_view name, const Term& value) {
  const Local local{&body_, body_.b.Local(std::string(name), TypeIdOf(body_.program, value.expr))};
  body_.Add(body_.b.Stmt(Declare{local.var, value.expr}));
  return local;
}

void Formula::Set(const Local& local, const Operand& value) {
  const TypeId type = body_.program.vars[local.var].type;
  body_.Do(body_.b.AssignTo(body_.b.Ref(local.var), ValueOf(body_, value, type)));
}

void Formula::Change(BinaryOp op, const Local& local, const Operand& value) {
  const TypeId type = body_.program.vars[local.var].type;
  body_.Do(body_.b.AssignTo(body_.b.Ref(local.var), ValueOf(body_, value, type), op));
}

StmtId Formula::BlockOf(const std::function<void()>& write) {
  std::vector<StmtId> outer = std::exchange(body_.statements, {});
  write();
  const StmtId block = body_.b.BlockOf(body_.statements);
  body_.statements = std::move(outer);
  return block;
}

void Formula::If(const Term& condition, const std::function<void()>& then) {
  body_.Add(body_.b.Stmt(ir::If{condition.expr, BlockOf(then), {}}));
}

void Formula::Loop(int first, const std::function<Term(const Local&)>& condition, ExprId step,
                   VarId counter, const std::function<void(const Local& i)>& body) {
  const Local i{&body_, counter};
  const StmtId init = body_.b.Stmt(Declare{counter, body_.b.Int(first)});
  const List<StmtId> inits = body_.program.stmt_lists.Add(std::span<const StmtId>(&init, 1));
  const ExprId goes_on = condition(i).expr;
  body_.Add(body_.b.Stmt(For{inits, goes_on, step, BlockOf([&] { body(i); })}));
}

void Formula::CountUp(int end, int step, const std::function<void(const Local& i)>& body) {
  const VarId i = body_.b.Local("i", body_.program.types.Make(Scalar::kInt));
  const ExprId next = step == 1
                          ? body_.b.UnaryOf(UnaryOp::kPreIncrement, body_.b.Ref(i))
                          : body_.b.AssignTo(body_.b.Ref(i), body_.b.Int(step), BinaryOp::kAdd);
  Loop(0, [&](const Local& counter) { return counter < end; }, next, i, body);
}

void Formula::CountDown(int first, const std::function<void(const Local& i)>& body) {
  const VarId i = body_.b.Local("i", body_.program.types.Make(Scalar::kInt));
  const ExprId next = body_.b.UnaryOf(UnaryOp::kPreDecrement, body_.b.Ref(i));
  Loop(first, [](const Local& counter) { return counter >= 0; }, next, i, body);
}

}  // namespace clipc::legalize
