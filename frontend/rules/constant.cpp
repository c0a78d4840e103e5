// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/constant.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "frontend/rules/conversion.h"
#include "ir/evaluate_math.h"
#include "ir/scalar.h"

namespace clipc {
namespace {

using ir::ExprId;
using ir::Scalar;
using ir::Type;
using ir::TypeId;
using ir::TypeKind;

// The components of a scalar, vector or matrix (row by row), as ir::Literal holds them.
struct Folded {
  Scalar kind = Scalar::kFloat;
  std::vector<std::uint64_t> bits;
};

// The arithmetic is the evaluator's, so a constant is what the shader would have computed; except
// that an integer divided by zero is no constant.
bool DividesByZero(ir::BinaryOp op, const Folded& right) {
  if ((op != ir::BinaryOp::kDiv && op != ir::BinaryOp::kMod) || ir::IsFloat(right.kind))
    return false;
  return std::find(right.bits.begin(), right.bits.end(), 0) != right.bits.end();
}

// Reinterpreted bits, and halves: what evaluate_math.h leaves out. Nothing for asdouble.
std::optional<std::uint64_t> CastBits(ir::Intrinsic op, std::uint64_t bits) {
  switch (op) {
    case ir::Intrinsic::kAsFloat:
    case ir::Intrinsic::kAsInt:
    case ir::Intrinsic::kAsUint: return bits;
    case ir::Intrinsic::kF16ToF32: return ir::BitsOf(ir::HalfToFloat(ir::UintOf(bits)));
    case ir::Intrinsic::kF32ToF16: return ir::FloatToHalf(ir::FloatOf(bits));
    default: return std::nullopt;
  }
}

// Folds one expression. The expression itself is walked once. A constant variable is folded once
// however often it is named, and the work inside variables is bounded: constant arrays that refer
// to constant arrays are a graph that a tree walk could take exponentially long for.
class Folder {
 public:
  explicit Folder(const ir::Program& program) : program_(program) {}

  // A scalar, vector or matrix.
  std::optional<Folded> Fold(ExprId id) {
    if (IsTooMuch()) return std::nullopt;
    const Type& type = program_.types[program_.exprs[id].type];
    if (!type.IsNumeric()) return std::nullopt;
    ++depth_;
    auto folded =
        std::visit([&](const auto& node) { return FoldNode(node, type); }, program_.exprs[id].node);
    --depth_;
    return folded;
  }

  // Any type: appends the leaves.
  bool FoldLeaves(ExprId id, Constant& constant) {
    const ir::Expr& expr = program_.exprs[id];
    if (program_.types[expr.type].IsNumeric()) {
      const auto folded = Fold(id);
      if (!folded) return false;
      if (constant.components.empty()) constant.kind = folded->kind;
      for (const std::uint64_t bits : folded->bits)
        constant.components.push_back(ir::NumberOf(bits, folded->kind));
      return true;
    }
    const ExprId source = Source(id);
    if (!source) return false;
    const auto& node = program_.exprs[source].node;
    if (std::holds_alternative<ir::Zero>(node)) {
      const auto leaves = Flatten(program_.types, program_.exprs[source].type);
      if (!leaves || leaves->empty()) return false;
      if (constant.components.empty()) constant.kind = leaves->front();
      constant.components.insert(constant.components.end(), leaves->size(), 0.0);
      return true;
    }
    const auto* construct = std::get_if<ir::Construct>(&node);
    if (construct == nullptr) return false;
    for (const ExprId argument : program_.expr_lists[construct->arguments]) {
      if (!FoldLeaves(argument, constant)) return false;
    }
    return true;
  }

 private:
  bool IsTooMuch() {
    constexpr int kMaxSteps = 1 << 14;
    constexpr int kMaxDepth = 600;
    if (variables_ > 0) ++steps_;
    return steps_ > kMaxSteps || depth_ > kMaxDepth;
  }

  // The Construct or Zero that a constant of struct or array type is, found through variables,
  // fields and indices.
  ExprId Source(ExprId id) {
    if (IsTooMuch()) return {};
    const auto& node = program_.exprs[id].node;
    if (std::holds_alternative<ir::Construct>(node) || std::holds_alternative<ir::Zero>(node))
      return id;
    if (const auto* ref = std::get_if<ir::VarRef>(&node)) {
      const ir::Var& var = program_.vars[ref->var];
      return var.storage == ir::Storage::kConstant && var.init ? Nested(var.init) : ExprId{};
    }
    if (const auto* field = std::get_if<ir::FieldRef>(&node))
      return Member(field->base, field->field);
    if (const auto* index = std::get_if<ir::Index>(&node)) {
      const auto at = Fold(index->index);
      if (!at) return {};
      const double position = ir::NumberOf(at->bits[0], at->kind);
      const Type& array = program_.types[program_.exprs[index->base].type];
      if (array.kind != TypeKind::kArray || position < 0 || position >= array.count) return {};
      return Member(index->base, static_cast<std::uint32_t>(position));
    }
    return {};
  }
  ExprId Nested(ExprId id) {
    ++depth_;
    const ExprId source = Source(id);
    --depth_;
    return source;
  }
  // The expression of one member of a struct or array; the Zero itself when all of it is zero.
  ExprId Member(ExprId base, std::uint32_t number) {
    const ExprId source = Nested(base);
    if (!source) return {};
    const auto* construct = std::get_if<ir::Construct>(&program_.exprs[source].node);
    if (construct == nullptr) return source;
    const auto arguments = program_.expr_lists[construct->arguments];
    if (number >= arguments.size()) return {};
    const ExprId member = arguments[number];
    return program_.types[program_.exprs[member].type].IsNumeric() ? member : Nested(member);
  }
  std::optional<Folded> FoldMember(ExprId base, std::uint32_t number, const Type& type) {
    const ExprId member = Member(base, number);
    if (!member) return std::nullopt;
    if (std::holds_alternative<ir::Zero>(program_.exprs[member].node))
      return FoldNode(ir::Zero{}, type);
    ++variables_;
    auto folded = Fold(member);
    --variables_;
    return folded;
  }

  std::optional<Folded> FoldNode(const ir::Literal& node, const Type& type) {
    return Folded{type.scalar, {node.bits}};
  }
  std::optional<Folded> FoldNode(const ir::Zero&, const Type& type) {
    return Folded{type.scalar, std::vector<std::uint64_t>(type.Components(), 0)};
  }
  std::optional<Folded> FoldNode(const ir::VarRef& node, const Type&) {
    const ir::Var& var = program_.vars[node.var];
    if (var.storage != ir::Storage::kConstant || !var.init) return std::nullopt;
    if (const auto known = known_.find(node.var.index); known != known_.end()) return known->second;
    ++variables_;
    auto folded = Fold(var.init);
    --variables_;
    known_.emplace(node.var.index, folded);
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::FieldRef& node, const Type& type) {
    return FoldMember(node.base, node.field, type);
  }

  std::optional<Folded> FoldNode(const ir::Index& node, const Type& type) {
    const auto index = Fold(node.index);
    if (!index) return std::nullopt;
    const double position = ir::NumberOf(index->bits[0], index->kind);
    const Type& base_type = program_.types[program_.exprs[node.base].type];
    const bool is_matrix = base_type.kind == TypeKind::kMatrix;
    const std::uint32_t count = base_type.kind == TypeKind::kArray ? base_type.count
                                : is_matrix                        ? base_type.rows
                                                                   : base_type.columns;
    if (position < 0 || position >= count) return std::nullopt;
    const auto number = static_cast<std::uint32_t>(position);
    if (base_type.kind == TypeKind::kArray) return FoldMember(node.base, number, type);
    const auto base = Fold(node.base);
    if (!base) return std::nullopt;
    const std::size_t width = is_matrix ? base_type.columns : 1;
    const auto begin = base->bits.begin() + static_cast<std::ptrdiff_t>(number * width);
    return Folded{base->kind, {begin, begin + static_cast<std::ptrdiff_t>(width)}};
  }
  std::optional<Folded> FoldNode(const ir::Swizzle& node, const Type& type) {
    const auto base = Fold(node.base);
    if (!base) return std::nullopt;
    Folded folded{type.scalar, {}};
    for (std::size_t i = 0; i < node.count; ++i)
      folded.bits.push_back(base->bits[node.components[i]]);
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::MatrixSwizzle& node, const Type& type) {
    const auto base = Fold(node.base);
    if (!base) return std::nullopt;
    const std::size_t columns = program_.types[program_.exprs[node.base].type].columns;
    Folded folded{type.scalar, {}};
    for (std::size_t i = 0; i < node.count; ++i)
      folded.bits.push_back(base->bits[node.rows[i] * columns + node.columns[i]]);
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::Unary& node, const Type&) {
    if (node.op >= ir::UnaryOp::kPreIncrement) return std::nullopt;
    auto operand = Fold(node.operand);
    if (!operand) return std::nullopt;
    for (std::uint64_t& bits : operand->bits)
      bits = ir::UnaryComponent(node.op, ir::BaseOf(operand->kind), bits);
    return operand;
  }
  std::optional<Folded> FoldNode(const ir::Binary& node, const Type& type) {
    auto left = Fold(node.left);
    if (!left) return std::nullopt;
    const auto right = Fold(node.right);
    if (!right || left->bits.size() != right->bits.size() || DividesByZero(node.op, *right))
      return std::nullopt;
    for (std::size_t i = 0; i < left->bits.size(); ++i) {
      left->bits[i] =
          ir::BinaryComponent(node.op, ir::BaseOf(left->kind), left->bits[i], right->bits[i]);
    }
    left->kind = type.scalar;
    return left;
  }
  std::optional<Folded> FoldNode(const ir::Conditional& node, const Type&) {
    const auto condition = Fold(node.condition);
    if (!condition) return std::nullopt;
    return Fold(condition->bits[0] != 0 ? node.when_true : node.when_false);
  }
  std::optional<Folded> FoldNode(const ir::Select& node, const Type& type) {
    const auto condition = Fold(node.condition);
    const auto when_true = condition ? Fold(node.when_true) : std::nullopt;
    const auto when_false = when_true ? Fold(node.when_false) : std::nullopt;
    if (!when_false) return std::nullopt;
    Folded folded{type.scalar, {}};
    for (std::size_t i = 0; i < condition->bits.size(); ++i) {
      folded.bits.push_back((condition->bits[i] != 0 ? when_true : when_false)->bits[i]);
    }
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::Convert& node, const Type& type) {
    auto folded = Fold(node.operand);
    if (!folded) return std::nullopt;
    for (std::uint64_t& bits : folded->bits)
      bits = ir::ConvertBits(bits, folded->kind, type.scalar);
    folded->kind = type.scalar;
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::Splat& node, const Type& type) {
    const auto scalar = Fold(node.operand);
    if (!scalar) return std::nullopt;
    return Folded{type.scalar, std::vector<std::uint64_t>(type.Components(), scalar->bits[0])};
  }
  std::optional<Folded> FoldNode(const ir::Construct& node, const Type& type) {
    Folded folded{type.scalar, {}};
    for (const ExprId argument : program_.expr_lists[node.arguments]) {
      const auto part = Fold(argument);
      if (!part) return std::nullopt;
      folded.bits.insert(folded.bits.end(), part->bits.begin(), part->bits.end());
    }
    return folded.bits.size() == type.Components() ? std::optional(std::move(folded))
                                                   : std::nullopt;
  }
  std::optional<Folded> FoldNode(const ir::MatrixTruncate& node, const Type& type) {
    const auto matrix = Fold(node.operand);
    if (!matrix) return std::nullopt;
    const std::size_t columns = program_.types[program_.exprs[node.operand].type].columns;
    Folded folded{type.scalar, {}};
    for (std::size_t row = 0; row < type.rows; ++row) {
      for (std::size_t column = 0; column < type.columns; ++column)
        folded.bits.push_back(matrix->bits[row * columns + column]);
    }
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::IntrinsicCall& node, const Type& type) {
    if (node.arguments.size > 1 && ir::WritesArgument(node.op, 1)) return std::nullopt;
    std::vector<Folded> arguments;
    std::vector<ir::EvalArgument> views;
    for (const ExprId argument : program_.expr_lists[node.arguments]) {
      auto folded = Fold(argument);
      if (!folded) return std::nullopt;
      arguments.push_back(std::move(*folded));
      views.push_back({nullptr, &program_.types[program_.exprs[argument].type]});
    }
    for (std::size_t i = 0; i < views.size(); ++i) views[i].words = arguments[i].bits.data();
    const Scalar base = ir::BaseOf(arguments[0].kind);
    Folded folded{type.scalar, std::vector<std::uint64_t>(type.Components(), 0)};
    if (ir::CategoryOf(node.op) == ir::IntrinsicCategory::kComponents) {
      const auto word = [&](std::size_t a, std::size_t i) {
        return a < arguments.size() ? arguments[a].bits[i] : 0;
      };
      for (std::size_t i = 0; i < folded.bits.size(); ++i) {
        folded.bits[i] = ir::ComponentFunction(node.op, base, word(0, i), word(1, i), word(2, i));
      }
    } else if (ir::CategoryOf(node.op) == ir::IntrinsicCategory::kBits) {
      for (std::size_t i = 0; i < folded.bits.size(); ++i) {
        const auto bits = CastBits(node.op, arguments[0].bits[i]);
        if (!bits) return std::nullopt;
        folded.bits[i] = *bits;
      }
    } else {
      ir::VectorFunction(node.op, base, views, folded.bits.data());
    }
    return folded;
  }
  std::optional<Folded> FoldNode(const ir::Assign&, const Type&) { return std::nullopt; }
  std::optional<Folded> FoldNode(const ir::Call&, const Type&) { return std::nullopt; }
  std::optional<Folded> FoldNode(const ir::ObjectCall&, const Type&) { return std::nullopt; }
  std::optional<Folded> FoldNode(const ir::Comma&, const Type&) { return std::nullopt; }

  const ir::Program& program_;
  std::unordered_map<std::uint32_t, std::optional<Folded>> known_;  // by VarId
  int steps_ = 0;                                                   // inside variables
  int depth_ = 0;                                                   // of recursion
  int variables_ = 0;                                               // whose values are being folded
};

}  // namespace

std::optional<Constant> EvaluateConstant(const ir::Program& program, ExprId expr) {
  Folder folder(program);
  Constant constant{Scalar::kFloat, {}};
  if (!folder.FoldLeaves(expr, constant)) return std::nullopt;
  return constant;
}

std::optional<std::int64_t> EvaluateInteger(const ir::Program& program, ExprId expr) {
  const Type& type = program.types[program.exprs[expr].type];
  if (type.Components() != 1 || ir::IsFloat(type.scalar)) return std::nullopt;
  const auto folded = Folder(program).Fold(expr);
  if (!folded) return std::nullopt;
  const std::uint64_t bits = folded->bits[0];
  return ir::BaseOf(folded->kind) == Scalar::kInt ? ir::IntOf(bits)
                                                  : static_cast<std::int64_t>(bits);
}

}  // namespace clipc
