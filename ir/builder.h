// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "ir/program.h"

namespace clipc::ir {

struct NamedOperand {
  OperandKind kind;
  ExprId expr;
};

// A maker of well-typed nodes: each call computes the type that ir/expr.h promises for the node.
// New nodes get the builder's span.
class Builder {
 public:
  explicit Builder(Program& program, Span span = {}) : program_(program), span_(span) {}
  Builder At(Span span) const { return Builder(program_, span); }

  ExprId Bool(bool value);
  ExprId Int(std::int32_t value);
  ExprId Uint(std::uint32_t value);
  ExprId Float(float value);
  ExprId LiteralOf(Scalar kind, double value);  // the value is converted as by a Convert
  ExprId ZeroOf(TypeId type);
  // A value of Literals, from its components as ConstantBits (ir/evaluate.h) gives them.
  ExprId ValueOf(TypeId type, std::span<const std::uint64_t> bits);
  ExprId Ref(VarId var);
  ExprId Field(ExprId base, std::uint32_t field);
  ExprId At(ExprId base, ExprId index);
  ExprId At(ExprId base, std::uint32_t index) { return At(base, Uint(index)); }
  ExprId Part(ExprId whole, std::uint32_t part);  // as TypeTable::PartType counts them
  ExprId Swizzled(ExprId base, std::initializer_list<int> components);
  ExprId Swizzled(ExprId base, std::span<const std::uint8_t> components);
  // A swizzle of `count` components in a row, from the component `first` on.
  ExprId SwizzledRun(ExprId base, std::size_t first, std::size_t count);
  ExprId UnaryOf(UnaryOp op, ExprId operand);
  ExprId BinaryOf(BinaryOp op, ExprId left, ExprId right);
  ExprId AssignTo(ExprId target, ExprId value, std::optional<BinaryOp> op = std::nullopt);
  ExprId ConvertTo(Scalar kind, ExprId operand);  // the operand itself when it has that kind
  ExprId SplatTo(TypeId type, ExprId scalar);     // the operand itself when it has that type
  ExprId ConstructOf(TypeId type, std::span<const ExprId> arguments);
  ExprId ConstructOf(TypeId type, std::initializer_list<ExprId> arguments) {
    return ConstructOf(type, std::span<const ExprId>(arguments.begin(), arguments.size()));
  }
  ExprId IntrinsicOf(Intrinsic op, TypeId type, std::initializer_list<ExprId> arguments);
  // A call of an object. The operands come in the order of OperandKind.
  ExprId ObjectCallOf(ObjectOp op, TypeId type, std::span<const NamedOperand> operands);
  ExprId ObjectCallOf(ObjectOp op, TypeId type, std::initializer_list<NamedOperand> operands) {
    return ObjectCallOf(op, type, std::span<const NamedOperand>(operands.begin(), operands.size()));
  }
  ExprId CallOf(FunctionId function, std::span<const ExprId> arguments);
  ExprId CommaOf(ExprId first, ExprId second);
  // Whether clip(value) discards: a component is below zero, which NaN is not.
  ExprId ClipsAt(ExprId value);
  template <typename Node>
  ExprId Add(TypeId type, const Node& node) {
    if constexpr (std::is_same_v<Node, ObjectCall>) program_.calls_objects = true;
    if constexpr (std::is_same_v<Node, IntrinsicCall>)
      program_.calls_nonuniform |= node.op == CommonIntrinsic::kNonUniform;
    return program_.exprs.Make(type, span_, node);
  }
  // Adds a copy of the node. The copy has a list of operands of its own, so that they can be
  // replaced.
  ExprId CopyOf(TypeId type, const decltype(Expr::node)& node);

  template <typename Node>
  StmtId Stmt(const Node& node) {
    return program_.stmts.Make(span_, node);
  }
  StmtId BlockOf(std::span<const StmtId> body);
  StmtId Eval(ExprId expr) { return Stmt(Evaluate{expr}); }

  VarId Local(std::string name, TypeId type);

  TypeId TypeOf(ExprId expr) const { return program_.exprs[expr].type; }

 private:
  ExprId NextValue(TypeId type, std::span<const std::uint64_t>& bits);

  Program& program_;
  Span span_;
};

// Copies the tree under `expr`: an expression has one parent, so using a value twice needs two
// trees.
ExprId Clone(Program& program, ExprId expr);
// Turns v.zyx[i], an index into a swizzle, into v[int3(2, 1, 0)[i]], which can be assigned to. Any
// other expression is left as it is.
void IndexWholeVector(Program& program, ExprId expr);
// The steps to `path` in `whole`, which it is a part of, as a store takes them. None for components
// of a vector or a matrix that are not neighbours in their order, and for literals outside of their
// bounds.
std::optional<std::vector<ExprId>> StepsTo(Program& program, ExprId path, ExprId whole);

}  // namespace clipc::ir
