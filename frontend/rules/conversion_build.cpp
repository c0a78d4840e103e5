// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "base/invariant.h"
#include "frontend/rules/conversion.h"
#include "frontend/rules/reread.h"
#include "ir/scalar.h"

namespace clipc {
namespace {

using ir::Builder;
using ir::ExprId;
using ir::Scalar;
using ir::Type;
using ir::TypeId;
using ir::TypeKind;

const ir::Literal* LiteralOf(const ir::Program& program, ExprId expr) {
  return std::get_if<ir::Literal>(&program.exprs[expr].node);
}

// Literals convert here rather than at run time, so that `float x = 1` reads as `1.0` in the
// output.
ExprId ConvertKind(ir::Program& program, ExprId value, Scalar kind);

bool IsLiteralList(const ir::Program& program, ExprId value) {
  const auto* construct = std::get_if<ir::Construct>(&program.exprs[value].node);
  if (construct == nullptr) return false;
  for (const ExprId argument : program.expr_lists[construct->arguments]) {
    if (LiteralOf(program, argument) == nullptr) return false;
  }
  return true;
}

// The value of `-1`, a negated literal, in a kind of float; none when the conversion would not be
// exact on both sides, as for -0 and the least int.
ExprId ConvertNegatedLiteral(ir::Program& program, ExprId value, Scalar kind) {
  const auto* unary = std::get_if<ir::Unary>(&program.exprs[value].node);
  if (unary == nullptr || unary->op != ir::UnaryOp::kNegate || !ir::IsFloat(kind)) return {};
  const ExprId operand = unary->operand;
  const ir::Literal* literal = LiteralOf(program, operand);
  if (literal == nullptr || program.types[program.exprs[operand].type].scalar != Scalar::kInt)
    return {};
  if (ir::IntOf(literal->bits) <= 0) return {};
  Builder builder(program, program.exprs[value].span);
  return builder.UnaryOf(ir::UnaryOp::kNegate, ConvertKind(program, operand, kind));
}

ExprId ConvertKind(ir::Program& program, ExprId value, Scalar kind) {
  const TypeId from = program.exprs[value].type;
  const TypeId to = program.types.WithScalar(from, kind);
  if (from == to) return value;
  const Scalar old_kind = program.types[from].scalar;
  Builder builder(program, program.exprs[value].span);
  if (const ir::Literal* literal = LiteralOf(program, value)) {
    return builder.Add(to, ir::Literal{ir::ConvertBits(literal->bits, old_kind, kind)});
  }
  if (std::holds_alternative<ir::Zero>(program.exprs[value].node)) return builder.ZeroOf(to);
  if (const auto* splat = std::get_if<ir::Splat>(&program.exprs[value].node)) {
    return builder.SplatTo(to, ConvertKind(program, splat->operand, kind));
  }
  if (IsLiteralList(program, value)) {
    const auto list = std::get<ir::Construct>(program.exprs[value].node).arguments;
    std::vector<ExprId> arguments;
    arguments.reserve(list.size);
    for (std::uint32_t i = 0; i < list.size; ++i) {
      arguments.push_back(ConvertKind(program, program.expr_lists[list][i], kind));
    }
    return builder.ConstructOf(to, arguments);
  }
  if (const ExprId negated = ConvertNegatedLiteral(program, value, kind)) return negated;
  return builder.ConvertTo(kind, value);
}

bool IsZeroLiteral(const ir::Program& program, ExprId value) {
  const ir::Literal* literal = LiteralOf(program, value);
  return literal != nullptr && literal->bits == 0;
}

struct Step {
  bool is_field;
  std::uint32_t number;
};
// A scalar or vector inside the source.
struct Piece {
  std::vector<Step> path;
  std::uint8_t size;
  bool is_vector;
};

// Writes a value of one type as a value of another with no more leaves, leaf by leaf in order.
class Reshaper {
 public:
  Reshaper(ir::Program& program, Reread& source, Span span)
      : program_(program), source_(source), builder_(program, span) {}

  // Whether both types are the same tree of structs and arrays over the same shapes. Their values
  // convert member by member, and members of equal types as a whole.
  bool IsParallel(TypeId from_id, TypeId to_id, int depth = 0) const {
    constexpr int kMaxDepth = 64;
    if (from_id == to_id) return true;
    const Type& from = program_.types[from_id];
    const Type& to = program_.types[to_id];
    if (depth > kMaxDepth || from.kind != to.kind) return false;
    if (from.IsNumeric()) return from.rows == to.rows && from.columns == to.columns;
    if (from.kind == TypeKind::kArray) {
      return from.count == to.count && from.count <= kMaxLeaves &&
             IsParallel(from.element, to.element, depth + 1);
    }
    if (from.kind != TypeKind::kStruct) return false;
    const auto& have = program_.types[from.structure].fields;
    const auto& want = program_.types[to.structure].fields;
    // A struct may be cut short only as a whole: inside another one the members after it would move
    // up.
    if (depth == 0 ? have.size() < want.size() : have.size() != want.size()) return false;
    for (std::size_t i = 0; i < want.size(); ++i) {
      if (!IsParallel(have[i].type, want[i].type, depth + 1)) return false;
    }
    return true;
  }

  ExprId BuildParallel(TypeId from_id, TypeId to_id) {
    if (from_id == to_id) return ReadAt(path_);
    const Type to = program_.types[to_id];
    if (to.IsNumeric()) return ConvertKind(program_, ReadAt(path_), to.scalar);
    const Type from = program_.types[from_id];
    const bool is_field = to.kind == TypeKind::kStruct;
    const std::size_t count = is_field ? program_.types[to.structure].fields.size() : to.count;
    std::vector<ExprId> parts;
    for (std::uint32_t i = 0; i < count; ++i) {
      path_.push_back({is_field, i});
      parts.push_back(is_field ? BuildParallel(program_.types[from.structure].fields[i].type,
                                               program_.types[to.structure].fields[i].type)
                               : BuildParallel(from.element, to.element));
      path_.pop_back();
    }
    return builder_.ConstructOf(to_id, parts);
  }

  ExprId BuildLeaves(TypeId from, TypeId to) {
    Collect(from);
    return Build(to);
  }

 private:
  void Collect(TypeId id) {
    const Type type = program_.types[id];
    const auto each = [&](bool is_field, std::uint32_t count, auto&& type_of) {
      for (std::uint32_t i = 0; i < count; ++i) {
        path_.push_back({is_field, i});
        Collect(type_of(i));
        path_.pop_back();
      }
    };
    switch (type.kind) {
      case TypeKind::kScalar: pieces_.push_back({path_, 1, false}); break;
      case TypeKind::kVector: pieces_.push_back({path_, type.columns, true}); break;
      case TypeKind::kMatrix: {
        const TypeId row = program_.types.Vector(type.scalar, type.columns);
        each(false, type.rows, [row](std::uint32_t) { return row; });
        break;
      }
      case TypeKind::kArray:
        each(false, type.count, [&](std::uint32_t) { return type.element; });
        break;
      case TypeKind::kStruct: {
        const auto& fields = program_.types[type.structure].fields;
        each(true, static_cast<std::uint32_t>(fields.size()),
             [&](std::uint32_t i) { return fields[i].type; });
        break;
      }
      default: CLIPC_CHECK(false);
    }
  }

  ExprId ReadAt(const std::vector<Step>& path) {
    ExprId expr = source_.Read();
    for (const Step step : path) {
      expr = step.is_field ? builder_.Field(expr, step.number) : builder_.At(expr, step.number);
    }
    return expr;
  }

  // At most `count` components of the current piece, from the first that was not taken yet.
  ExprId TakePart(std::uint8_t count, std::uint8_t& taken) {
    CLIPC_CHECK(next_ < pieces_.size());
    const Piece& piece = pieces_[next_];
    taken = std::min<std::uint8_t>(count, static_cast<std::uint8_t>(piece.size - offset_));
    ExprId part = ReadAt(piece.path);
    if (piece.is_vector && (taken != piece.size || piece.size == 1)) {
      constexpr std::array<std::uint8_t, 4> kInOrder = {0, 1, 2, 3};
      part = builder_.Swizzled(part, std::span(kInOrder).subspan(offset_, taken));
    }
    offset_ = static_cast<std::uint8_t>(offset_ + taken);
    if (offset_ == piece.size) {
      offset_ = 0;
      ++next_;
    }
    return part;
  }

  std::vector<ExprId> TakeParts(std::uint8_t count, Scalar kind) {
    std::vector<ExprId> parts;
    while (count > 0) {
      std::uint8_t taken = 0;
      parts.push_back(ConvertKind(program_, TakePart(count, taken), kind));
      count = static_cast<std::uint8_t>(count - taken);
    }
    return parts;
  }

  ExprId Build(TypeId id) {
    const Type type = program_.types[id];
    std::vector<ExprId> parts;
    switch (type.kind) {
      case TypeKind::kScalar: return TakeParts(1, type.scalar).front();
      case TypeKind::kVector:
        parts = TakeParts(type.columns, type.scalar);
        if (type.columns == 1) return builder_.SplatTo(id, parts.front());
        if (parts.size() == 1) return parts.front();
        break;
      case TypeKind::kMatrix:
        for (int row = 0; row < type.rows; ++row) {
          parts.push_back(type.columns == 1
                              ? Build(program_.types.Make(type.scalar))
                              : Build(program_.types.Vector(type.scalar, type.columns)));
        }
        break;
      case TypeKind::kArray:
        for (std::uint32_t i = 0; i < type.count; ++i) parts.push_back(Build(type.element));
        break;
      case TypeKind::kStruct: {
        const std::size_t count = program_.types[type.structure].fields.size();
        for (std::size_t i = 0; i < count; ++i)
          parts.push_back(Build(program_.types[type.structure].fields[i].type));
        break;
      }
      default: CLIPC_CHECK(false);
    }
    return builder_.ConstructOf(id, parts);
  }

  ir::Program& program_;
  Reread& source_;
  Builder builder_;
  std::vector<Step> path_;
  std::vector<Piece> pieces_;
  std::size_t next_ = 0;
  std::uint8_t offset_ = 0;
};

// (S)x: the scalar in every leaf. An array's element that is not a number is made once and
// repeated.
ExprId FillAggregate(ir::Program& program, Reread& scalar, TypeId id, Span span,
                     TemporaryMaker& temporaries) {
  const Type type = program.types[id];
  Builder builder(program, span);
  if (type.IsNumeric())
    return builder.SplatTo(id, ConvertKind(program, scalar.Read(), type.scalar));
  std::vector<ExprId> parts;
  if (type.kind == TypeKind::kStruct) {
    const std::size_t count = program.types[type.structure].fields.size();
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(FillAggregate(program, scalar, program.types[type.structure].fields[i].type,
                                    span, temporaries));
    }
    return builder.ConstructOf(id, parts);
  }
  if (program.types[type.element].IsNumeric() || type.count <= 1) {
    for (std::uint32_t i = 0; i < type.count; ++i) {
      parts.push_back(FillAggregate(program, scalar, type.element, span, temporaries));
    }
    return builder.ConstructOf(id, parts);
  }
  Reread element(program, FillAggregate(program, scalar, type.element, span, temporaries),
                 &temporaries);
  for (std::uint32_t i = 0; i < type.count; ++i) parts.push_back(element.Read());
  return element.Finish(builder.ConstructOf(id, parts));
}

// The first component as a scalar.
ExprId FirstComponent(ir::Program& program, ExprId value) {
  const Type type = program.types[program.exprs[value].type];
  Builder builder(program, program.exprs[value].span);
  if (type.kind == TypeKind::kScalar) return value;
  if (type.kind == TypeKind::kMatrix) value = builder.At(value, 0u);
  return builder.Swizzled(value, {0});
}

ExprId FirstComponents(ir::Program& program, ExprId vector, std::uint8_t count) {
  if (program.types[program.exprs[vector].type].columns == count) return vector;
  constexpr std::array<std::uint8_t, 4> kInOrder = {0, 1, 2, 3};
  return Builder(program, program.exprs[vector].span)
      .Swizzled(vector, std::span(kInOrder).first(count));
}

// The value in another numeric shape, as RankImplicit allows; none when `value` would have to be
// read several times and `temporaries` is null.
ExprId ConvertNumeric(ir::Program& program, ExprId value, TypeId to_id,
                      TemporaryMaker* temporaries) {
  const Type from = program.types[program.exprs[value].type];
  const Type to = program.types[to_id];
  const Span span = program.exprs[value].span;
  Builder builder(program, span);
  const bool to_matrix = to.kind == TypeKind::kMatrix;
  const bool from_matrix = from.kind == TypeKind::kMatrix;
  if (from.kind == to.kind && from.rows == to.rows && from.columns == to.columns) {
    return ConvertKind(program, value, to.scalar);
  }
  if (from.Components() == 1 || to.Components() == 1) {
    return builder.SplatTo(to_id, ConvertKind(program, FirstComponent(program, value), to.scalar));
  }
  if (from_matrix && to_matrix) {
    const TypeId smaller = program.types.WithScalar(to_id, from.scalar);
    return ConvertKind(program, builder.Add(smaller, ir::MatrixTruncate{value}), to.scalar);
  }
  if (!from_matrix && !to_matrix)
    return ConvertKind(program, FirstComponents(program, value, to.columns), to.scalar);
  if (from_matrix && from.rows == 1) {
    return ConvertKind(program, FirstComponents(program, builder.At(value, 0u), to.columns),
                       to.scalar);
  }
  if (to_matrix && to.rows == 1) {
    return builder.ConstructOf(
        to_id, {ConvertKind(program, FirstComponents(program, value, to.columns), to.scalar)});
  }
  Reread source(program, ConvertKind(program, value, to.scalar), temporaries);
  if (!source.usable()) return {};
  Reshaper reshaper(program, source, span);
  return source.Finish(reshaper.BuildLeaves(source.type(), to_id));
}

ExprId ConvertAggregate(ir::Program& program, ExprId value, TypeId to,
                        TemporaryMaker* temporaries) {
  const Span span = program.exprs[value].span;
  Reread source(program, value, temporaries);
  if (!source.usable()) return {};
  const TypeId from = source.type();
  Reshaper reshaper(program, source, span);
  return source.Finish(reshaper.IsParallel(from, to) ? reshaper.BuildParallel(from, to)
                                                     : reshaper.BuildLeaves(from, to));
}

void WarnOfLoss(ir::Program& program, ExprId value, TypeId to_id, Diagnostics& diagnostics) {
  const ir::Expr& expr = program.exprs[value];
  const Type& from = program.types[expr.type];
  const Type& to = program.types[to_id];
  if (to.Components() < from.Components()) {
    diagnostics.Report(expr.span, diag::ImplicitTruncation, program.types.Name(expr.type),
                       program.types.Name(to_id));
  }
  const auto is_wide = [](Scalar kind) {
    return kind == Scalar::kDouble || kind == Scalar::kInt64 || kind == Scalar::kUint64;
  };
  if (is_wide(from.scalar) && !is_wide(to.scalar) && to.scalar != Scalar::kBool &&
      LiteralOf(program, value) == nullptr) {
    diagnostics.Report(expr.span, diag::ImplicitNarrowing, program.types.Name(expr.type),
                       program.types.Name(to_id));
  }
}

}  // namespace

void SetSamplerKind(ir::Program& program, ExprId object, ir::ObjectKind kind) {
  auto& expr = program.exprs[object];
  if (const auto* index = std::get_if<ir::Index>(&expr.node)) {
    SetSamplerKind(program, index->base, kind);
    expr.type = program.types.Object(kind);
    return;
  }
  const auto retype = [&](auto&& self, TypeId id) -> TypeId {
    const Type type = program.types[id];
    if (type.kind == TypeKind::kArray)
      return program.types.Array(self(self, type.element), type.count);
    return type.kind == TypeKind::kObject && type.object == ir::ObjectKind::kSampler
               ? program.types.Object(kind)
               : id;
  };
  if (const auto* ref = std::get_if<ir::VarRef>(&expr.node)) {
    ir::Var& var = program.vars[ref->var];
    var.type = retype(retype, var.type);
    expr.type = var.type;
  }
}

ExprId ConvertImplicit(ir::Program& program, ExprId value, TypeId to, Diagnostics& diagnostics,
                       TemporaryMaker* temporaries) {
  const TypeId from = program.exprs[value].type;
  if (from == to || from == program.types.Error() || to == program.types.Error()) return value;
  const Type target = program.types[to];
  if (target.kind == TypeKind::kObject) {
    SetSamplerKind(program, value, target.object);
    return value;
  }
  ExprId converted;
  if (target.IsNumeric()) {
    WarnOfLoss(program, value, to, diagnostics);
    converted = ConvertNumeric(program, value, to, temporaries);
  } else {
    converted = ConvertAggregate(program, value, to, temporaries);
  }
  if (converted) return converted;
  const Span span = program.exprs[value].span;
  diagnostics.Report(span, diag::ConversionReadsTwice, program.types.Name(from),
                     program.types.Name(to));
  return Builder(program, span).ZeroOf(program.types.Error());
}

ExprId ConvertExplicit(ir::Program& program, ExprId value, TypeId to, TemporaryMaker& temporaries) {
  const TypeId from = program.exprs[value].type;
  if (from == to || from == program.types.Error() || to == program.types.Error() ||
      to == program.types.Void())
    return value;
  const Type source_type = program.types[from];
  const Type target = program.types[to];
  if (target.kind == TypeKind::kObject) {
    SetSamplerKind(program, value, target.object);
    return value;
  }
  const Span span = program.exprs[value].span;
  if (source_type.IsNumeric() && target.IsNumeric())
    return ConvertNumeric(program, value, to, &temporaries);
  if (source_type.Components() == 1) {
    const ExprId scalar = FirstComponent(program, value);
    if (IsZeroLiteral(program, scalar)) return Builder(program, span).ZeroOf(to);
    Reread source(program, scalar, &temporaries);
    return source.Finish(FillAggregate(program, source, to, span, temporaries));
  }
  return ConvertAggregate(program, value, to, &temporaries);
}

}  // namespace clipc
