// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/builder.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::ir {

ExprId Builder::Bool(bool value) {
  return Add(program_.types.Make(Scalar::kBool), Literal{value ? 1u : 0u});
}
ExprId Builder::Int(std::int32_t value) {
  return Add(program_.types.Make(Scalar::kInt), Literal{BitsOf(value)});
}
ExprId Builder::Uint(std::uint32_t value) {
  return Add(program_.types.Make(Scalar::kUint), Literal{value});
}
ExprId Builder::Float(float value) {
  return Add(program_.types.Make(Scalar::kFloat), Literal{BitsOf(value)});
}

ExprId Builder::LiteralOf(Scalar kind, double value) {
  return Add(program_.types.Make(kind), Literal{ConvertBits(BitsOf(value), Scalar::kDouble, kind)});
}

ExprId Builder::ZeroOf(TypeId type) { return Add(type, Zero{}); }

ExprId Builder::Ref(VarId var) { return Add(program_.vars[var].type, VarRef{var}); }

ExprId Builder::Field(ExprId base, std::uint32_t field) {
  const Struct& structure = program_.types.StructOf(TypeOf(base));
  CLIPC_CHECK(field < structure.fields.size());
  return Add(structure.fields[field].type, FieldRef{base, field});
}

ExprId Builder::At(ExprId base, ExprId index) {
  const Type type = program_.types[TypeOf(base)];
  TypeId element = type.element;
  if (type.kind == TypeKind::kVector) element = program_.types.Make(type.scalar);
  if (type.kind == TypeKind::kMatrix) element = program_.types.Vector(type.scalar, type.columns);
  CLIPC_CHECK(element);
  return Add(element, Index{base, index});
}

ExprId Builder::Part(ExprId whole, std::uint32_t part) {
  const bool is_struct = program_.types[TypeOf(whole)].kind == TypeKind::kStruct;
  return is_struct ? Field(whole, part) : At(whole, part);
}

ExprId Builder::SwizzledRun(ExprId base, std::size_t first, std::size_t count) {
  constexpr std::array<std::uint8_t, 4> kInOrder = {0, 1, 2, 3};
  return Swizzled(base, std::span(kInOrder).subspan(first, count));
}

ExprId Builder::Swizzled(ExprId base, std::span<const std::uint8_t> components) {
  CLIPC_CHECK(!components.empty() && components.size() <= 4);
  Swizzle node{
      .base = base, .components = {}, .count = static_cast<std::uint8_t>(components.size())};
  for (std::size_t i = 0; i < components.size(); ++i) node.components[i] = components[i];
  const Scalar kind = program_.types[TypeOf(base)].scalar;
  const TypeId type =
      node.count == 1 ? program_.types.Make(kind) : program_.types.Vector(kind, node.count);
  return Add(type, node);
}

ExprId Builder::Swizzled(ExprId base, std::initializer_list<int> components) {
  std::vector<std::uint8_t> copy;
  for (int component : components) copy.push_back(static_cast<std::uint8_t>(component));
  return Swizzled(base, std::span<const std::uint8_t>(copy));
}

ExprId Builder::UnaryOf(UnaryOp op, ExprId operand) {
  return Add(TypeOf(operand), Unary{op, operand});
}

ExprId Builder::BinaryOf(BinaryOp op, ExprId left, ExprId right) {
  const TypeId type = TypeOf(left);
  return Add(GivesBool(op) ? program_.types.WithScalar(type, Scalar::kBool) : type,
             Binary{op, left, right});
}

ExprId Builder::AssignTo(ExprId target, ExprId value, std::optional<BinaryOp> op) {
  return Add(TypeOf(target), Assign{op, target, value});
}

ExprId Builder::ConvertTo(Scalar kind, ExprId operand) {
  const TypeId type = program_.types.WithScalar(TypeOf(operand), kind);
  return type == TypeOf(operand) ? operand : Add(type, Convert{operand});
}

ExprId Builder::SplatTo(TypeId type, ExprId scalar) {
  return type == TypeOf(scalar) ? scalar : Add(type, Splat{scalar});
}

ExprId Builder::ValueOf(TypeId type, std::span<const std::uint64_t> bits) {
  return NextValue(type, bits);
}

// Makes a value of the type from the components at the front of `bits`, and removes them there.
ExprId Builder::NextValue(TypeId id, std::span<const std::uint64_t>& bits) {
  const Type type = program_.types[id];
  const auto next = [&](TypeId scalar) {
    const std::uint64_t first = bits.front();
    bits = bits.subspan(1);
    return Add(scalar, Literal{first});
  };
  if (type.kind == TypeKind::kScalar) return next(id);
  std::vector<ExprId> parts;
  if (type.IsNumeric()) {
    const TypeId component = program_.types.Make(type.scalar);
    for (std::uint32_t i = 0; i < type.Components(); ++i) parts.push_back(next(component));
  } else {
    for (std::uint32_t i = 0; i < program_.types.PartCount(id); ++i)
      parts.push_back(NextValue(program_.types.PartType(id, i), bits));
  }
  return ConstructOf(id, parts);
}

ExprId Builder::ConstructOf(TypeId type, std::span<const ExprId> arguments) {
  return Add(type, Construct{program_.expr_lists.Add(arguments)});
}

ExprId Builder::IntrinsicOf(Intrinsic op, TypeId type, std::initializer_list<ExprId> arguments) {
  return Add(type, IntrinsicCall{op, program_.expr_lists.Add(arguments)});
}

ExprId Builder::ObjectCallOf(ObjectOp op, TypeId type, std::span<const NamedOperand> operands) {
  ObjectCall call{.op = op, .arguments = {}};
  std::vector<ExprId> list;
  list.reserve(operands.size());
  OperandKind last = OperandKind::kObject;
  std::uint32_t tiled = 0;
  for (const auto [kind, expr] : operands) {
    const bool is_clamp = kind == OperandKind::kClamp, is_texel = kind == OperandKind::kTexel;
    CLIPC_CHECK(last <= kind && (is_clamp || is_texel || Takes(op, kind)));
    last = kind;
    call.has_clamp |= is_clamp, call.has_texel |= is_texel;
    tiled += is_clamp || is_texel;
    list.push_back(expr);
  }
  call.arguments = program_.expr_lists.Add(std::span<const ExprId>(list));
  call.arguments.size -= tiled;
  return Add(type, call);
}

ExprId Builder::CallOf(FunctionId function, std::span<const ExprId> arguments) {
  return Add(program_.functions[function].return_type,
             Call{function, program_.expr_lists.Add(arguments)});
}

ExprId Builder::ClipsAt(ExprId value) {
  const TypeId type = TypeOf(value), one = program_.types.Make(Scalar::kBool);
  ExprId zero = LiteralOf(program_.types[type].scalar, 0);
  if (TypeOf(zero) != type) zero = SplatTo(type, zero);
  const ExprId is_below = BinaryOf(BinaryOp::kLess, value, zero);
  return TypeOf(is_below) == one ? is_below : IntrinsicOf(CommonIntrinsic::kAny, one, {is_below});
}

ExprId Builder::CommaOf(ExprId first, ExprId second) {
  return Add(TypeOf(second), Comma{first, second});
}

ExprId Builder::CopyOf(TypeId type, const decltype(Expr::node)& node) {
  const ExprId copy = Add(type, node);
  const auto own = [&](auto& of_copy) {
    if constexpr (requires { of_copy.arguments; }) {
      List<ExprId> all = of_copy.arguments;
      if constexpr (requires { of_copy.Operands(); }) all = of_copy.Operands();
      of_copy.arguments.begin =
          program_.expr_lists.Add(std::as_const(program_).expr_lists[all]).begin;
    }
  };
  Visit(own, program_.exprs[copy].node);
  return copy;
}

StmtId Builder::BlockOf(std::span<const StmtId> body) {
  return Stmt(Block{program_.stmt_lists.Add(body)});
}

VarId Builder::Local(std::string name, TypeId type) {
  return program_.vars.Add({.name = std::move(name), .type = type, .span = span_});
}

ExprId Clone(Program& program, ExprId expr) {
  const Expr& original = program.exprs[expr];
  const ExprId copy = Builder(program, original.span).CopyOf(original.type, original.node);
  MapOperands(program, copy, [&](ExprId operand) { return Clone(program, operand); });
  return copy;
}

void IndexWholeVector(Program& program, ExprId expr) {
  const auto* index = As<Index>(program, expr);
  const auto* found = index ? As<Swizzle>(program, index->base) : nullptr;
  if (!found) return;
  const Swizzle swizzle = *found;
  const ExprId number = index->index;
  Builder at(program, program.exprs[number].span);
  std::vector<ExprId> components;
  for (int i = 0; i < swizzle.count; ++i) components.push_back(at.Int(swizzle.components[i]));
  const TypeId type = program.types.Vector(Scalar::kInt, swizzle.count);
  program.exprs[expr].node = Index{swizzle.base, at.At(at.ConstructOf(type, components), number)};
}

std::optional<std::vector<ExprId>> StepsTo(Program& program, ExprId path, ExprId whole) {
  std::vector<ExprId> steps;
  for (; path != whole; path = WholeOf(program, path)) {
    IndexWholeVector(program, path);
    Builder at(program, program.exprs[path].span);
    if (const auto* field = As<FieldRef>(program, path)) {
      steps.push_back(at.Uint(field->field));
    } else if (const auto* index = As<Index>(program, path)) {
      const auto* number = As<Literal>(program, index->index);
      const Type& type = TypeOf(program, index->base);
      const std::uint32_t parts = type.kind == TypeKind::kVector
                                      ? type.columns
                                      : program.types.PartCount(TypeIdOf(program, index->base));
      const bool is_outside = number && UintOf(number->bits) >= parts;
      if (is_outside || As<MatrixSwizzle>(program, index->base)) return std::nullopt;
      steps.push_back(index->index);
    } else {
      const auto* swizzle = As<Swizzle>(program, path);
      if (!swizzle) return std::nullopt;
      for (std::uint8_t i = 0; i < swizzle->count; ++i)
        if (swizzle->components[i] != swizzle->components[0] + i) return std::nullopt;
      steps.push_back(at.Uint(swizzle->components[0]));
    }
  }
  std::ranges::reverse(steps);
  return steps;
}

}  // namespace clipc::ir
