// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string_view>

#include "legalize/helper_body.h"

// Bodies of helper functions that read as the functions do:
//
//   const Local x = f[0], e = f.Let("e", f.Call(kExp, {-2.0 * x}));
//   f.Return((1.0 - e) / (1.0 + e));
//
// A number beside a value has the value's type; beside a shift it is an int. A scalar stands for
// all components beside a vector.
namespace clipc::legalize {

class Term;

// A parameter or a variable of the function.
struct Local {
  HelperBody* body;
  ir::VarId var;

  Term operator[](int row) const;
  Term operator[](std::string_view components) const;
  ir::Scalar Kind() const;
};

// A value, which has one place in the function.
class Term {
 public:
  Term(HelperBody* body, ir::ExprId expr) : body(body), expr(expr) {}
  Term(const Local& local) : body(local.body), expr(local.body->b.Ref(local.var)) {}

  // A row of a matrix, and components of a vector: "yz".
  Term operator[](int row) const;
  Term operator[](std::string_view components) const;

  HelperBody* body;
  ir::ExprId expr;
};

// A number that people read in hexadecimal.
struct Mask {
  std::uint32_t bits;
};

// A value, or a number that has no type yet.
struct Operand {
  Operand(const Term& term) : body(term.body), expr(term.expr) {}
  Operand(const Local& local) : Operand(Term(local)) {}
  Operand(double number) : number(number) {}
  Operand(Mask mask) : number(mask.bits), is_mask(true) {}

  HelperBody* body = nullptr;
  ir::ExprId expr = {};  // none: the number
  double number = 0;
  bool is_mask = false;
};

Term Join(ir::BinaryOp op, const Operand& left, const Operand& right);
inline Term operator+(const Operand& a, const Operand& b) { return Join(ir::BinaryOp::kAdd, a, b); }
inline Term operator-(const Operand& a, const Operand& b) { return Join(ir::BinaryOp::kSub, a, b); }
inline Term operator*(const Operand& a, const Operand& b) { return Join(ir::BinaryOp::kMul, a, b); }
inline Term operator/(const Operand& a, const Operand& b) { return Join(ir::BinaryOp::kDiv, a, b); }
inline Term operator&(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kBitAnd, a, b);
}
inline Term operator|(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kBitOr, a, b);
}
inline Term operator<<(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kShiftLeft, a, b);
}
inline Term operator>>(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kShiftRight, a, b);
}
inline Term operator<(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kLess, a, b);
}
inline Term operator>(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kGreater, a, b);
}
inline Term operator>=(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kGreaterEqual, a, b);
}
inline Term operator==(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kEqual, a, b);
}
inline Term operator!=(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kNotEqual, a, b);
}
inline Term operator&&(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kShortCircuitAnd, a, b);
}
inline Term operator||(const Operand& a, const Operand& b) {
  return Join(ir::BinaryOp::kShortCircuitOr, a, b);
}
Term operator-(const Term& x);
Term operator!(const Term& x);

// The function whose body is written.
class Formula {
 public:
  explicit Formula(HelperBody& body) : body_(body) {}

  Local operator[](std::size_t parameter) { return {&body_, body_.parameters[parameter]}; }

  // ---- values
  Term Number(ir::Scalar kind, double value, bool is_mask = false);
  Term Sign(const Term& x);  // of floats, as a float
  // A call of a function whose signature gives the type of its value. The first of the arguments
  // that is a value gives the numbers their type.
  Term Call(ir::Intrinsic op, std::initializer_list<Operand> arguments);
  // The bits of a float as a uint, or the other way round.
  Term Bits(ir::Scalar kind, const Term& x);
  Term To(ir::Scalar kind, const Term& x);
  Term Choose(const Term& condition, const Operand& when_true, const Operand& when_false);
  // A vector of parts of this kind, or of one scalar in all components.
  Term Vector(ir::Scalar kind, std::initializer_list<Operand> parts);
  Term Splat(int size, const Term& scalar);

  // ---- statements
  Local Let(std::string_view name, const Term& value);
  void Set(const Local& local, const Operand& value);
  void Change(ir::BinaryOp op, const Local& local, const Operand& value);
  void If(const Term& condition, const std::function<void()>& then);
  // for (int i = first; i < end; i += step), and for (int i = first; i >= 0; --i)
  void CountUp(int end, int step, const std::function<void(const Local& i)>& body);
  void CountDown(int first, const std::function<void(const Local& i)>& body);
  void Return(const Term& value) { body_.Return(value.expr); }
  void Remark(std::string_view remark) { body_.remark = remark; }

 private:
  ir::StmtId BlockOf(const std::function<void()>& write);
  void Loop(int first, const std::function<Term(const Local&)>& condition, ir::ExprId step,
            ir::VarId counter, const std::function<void(const Local& i)>& body);

  HelperBody& body_;
};

}  // namespace clipc::legalize
