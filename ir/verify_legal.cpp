// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The promises of Form::kLegalized about each node: C-like shading languages have the node as it
// is.

#include <algorithm>

#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "ir/verifier.h"

namespace clipc::ir {
namespace {

bool IsMatrix(const Type& type) {
  return type.kind == TypeKind::kMatrix && type.rows > 1 && type.columns > 1;
}

// Whether the count of a shift is known to be less than `bits`: a literal, or a mask by one.
bool IsBounded(const Program& program, ExprId count, std::uint32_t bits) {
  if (const auto* splat = As<Splat>(program, count))
    return IsBounded(program, splat->operand, bits);
  if (const auto* convert = As<Convert>(program, count))
    return IsInteger(program.types[program.exprs[convert->operand].type].scalar) &&
           IsBounded(program, convert->operand, bits);
  if (const auto* literal = As<Literal>(program, count)) return literal->bits < bits;
  if (const auto* construct = As<Construct>(program, count)) {
    return std::ranges::all_of(program.expr_lists[construct->arguments],
                               [&](ExprId each) { return IsBounded(program, each, bits); });
  }
  const auto* mask = As<Binary>(program, count);
  return mask && mask->op == BinaryOp::kBitAnd && IsBounded(program, mask->right, bits);
}

std::string_view BrokenBy(const Program& program, BinaryOp op, const Type& type, ExprId right) {
  using enum BinaryOp;
  const bool is_linear = op == kMul || op == kDiv || op == kAdd || op == kSub;
  if (IsMatrix(type) && !(is_linear && IsFloat(type.scalar))) {
    return "only + - * / take matrices, of floats";
  }
  if (op == kLogicalAnd || op == kLogicalOr) {
    return "logical operators evaluate one side first";
  }
  if (op == kMod && !IsUnsigned(type.scalar)) return "% is of unsigned integers";
  if (IsShift(op) && !IsBounded(program, right, 8 * ByteSize(type.scalar)))
    return "a shift count is below the number of bits";
  return {};
}

std::string_view BrokenBy(const Program& program, const IntrinsicCall& call) {
  using enum Intrinsic;
  if (IsComposed(call.op))
    return "the function stands for others, which a pass writes in its place";
  if (call.arguments.empty()) return {};
  const Type& type = program.types[program.exprs[program.expr_lists[call.arguments][0]].type];
  switch (call.op) {
    case kMul:
    case kTranspose:
      if (!IsMatrix(type) || IsFloat(type.scalar)) return {};
      break;
    case kDeterminant: return {};
    default: break;
  }
  return IsMatrix(type) ? "the function takes no matrix" : std::string_view{};
}

}  // namespace

std::string_view RuleBrokenBy(const Program& program, ExprId expr) {
  const auto type_of = [&](ExprId id) -> const Type& {
    return program.types[program.exprs[id].type];
  };
  return Visit(Overloaded{
                   [&](const Binary& node) {
                     return BrokenBy(program, node.op, type_of(node.left), node.right);
                   },
                   [&](const Assign& node) {
                     if (!node.op) return std::string_view{};
                     return BrokenBy(program, *node.op, type_of(node.target), node.value);
                   },
                   [&](const Unary& node) -> std::string_view {
                     const Type& type = type_of(node.operand);
                     return IsMatrix(type) && !IsFloat(type.scalar)
                                ? "the operator takes no such matrix"
                                : "";
                   },
                   [&](const Select&) -> std::string_view {
                     return IsMatrix(type_of(expr)) ? "a choice takes no matrices" : "";
                   },
                   [&](const IntrinsicCall& node) { return BrokenBy(program, node); },
                   [&](const Index& node) -> std::string_view {
                     const Type& type = type_of(node.base);
                     const bool is_only = type.kind == TypeKind::kMatrix && type.rows == 1;
                     return is_only && !IsPure(program, node.index)
                                ? "the index of an only row changes nothing"
                                : "";
                   },
                   [](const auto&) { return std::string_view{}; },
               },
               program.exprs[expr].node);
}

}  // namespace clipc::ir
