// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstdint>
#include <variant>
#include <vector>

#include "base/invariant.h"
#include "frontend/typing/constant.h"
#include "frontend/typing/conversion.h"
#include "frontend/typing/reread.h"
#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::typing {
namespace {

// Converts the component kind of a value. Literals convert here rather than at run time, so that
// `float x = 1` reads as `1.0` in the output.
ExprId ConvertKind(Program& program, ExprId value, Scalar kind);

// The value of `-1`, a negated literal, in a kind of float; none if the conversion would not be
// exact on both sides, as for -0 and the least int.
ExprId ConvertNegatedLiteral(Program& program, ExprId value, Scalar kind) {
  const auto* unary = As<Unary>(program, value);
  if (unary == nullptr || unary->op != UnaryOp::kNegate || !IsFloat(kind)) return {};
  const ExprId operand = unary->operand;
  const auto* literal = As<Literal>(program, operand);
  if (literal == nullptr || TypeOf(program, operand).scalar != Scalar::kInt) return {};
  if (IntOf(literal->bits) <= 0) return {};
  Builder builder(program, program.exprs[value].span);
  return builder.UnaryOf(UnaryOp::kNegate, ConvertKind(program, operand, kind));
}

ExprId ConvertKind(Program& program, ExprId value, Scalar kind) {
  const TypeId from = TypeIdOf(program, value);
  const TypeId to = program.types.WithScalar(from, kind);
  if (from == to) return value;
  const Scalar old_kind = program.types[from].scalar;
  Builder builder(program, program.exprs[value].span);
  if (const auto* literal = As<Literal>(program, value)) {
    return builder.Add(to, Literal{ConvertBits(literal->bits, old_kind, kind)});
  }
  if (As<Zero>(program, value)) return builder.ZeroOf(to);
  if (const auto* splat = As<Splat>(program, value)) {
    return builder.SplatTo(to, ConvertKind(program, splat->operand, kind));
  }
  if (IsLiteralList(program, value)) {
    const auto list = As<Construct>(program, value)->arguments;
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

bool IsZeroLiteral(const Program& program, ExprId value) {
  const auto* literal = As<Literal>(program, value);
  return literal != nullptr && literal->bits == 0;
}

// A scalar, vector or object inside the source.
struct Piece {
  std::vector<std::uint32_t> path;  // the numbers of the parts on the way to it
  std::uint8_t size;
  bool is_vector;
};

// A writer of a value of one type as a value of another with no more leaves, leaf by leaf in order.
class Reshaper {
 public:
  Reshaper(Program& program, Reread& source, Span span)
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

  ExprId BuildParallel(TypeId from, TypeId to) {
    if (from == to) return ReadAt(path_);
    const Type type = program_.types[to];
    if (type.IsNumeric()) return ConvertKind(program_, ReadAt(path_), type.scalar);
    std::vector<ExprId> parts;
    for (std::uint32_t i = 0; i < program_.types.PartCount(to); ++i) {
      path_.push_back(i);
      parts.push_back(
          BuildParallel(program_.types.PartType(from, i), program_.types.PartType(to, i)));
      path_.pop_back();
    }
    return builder_.ConstructOf(to, parts);
  }

  ExprId BuildLeaves(TypeId from, TypeId to) {
    Collect(from);
    return Build(to);
  }

 private:
  void Collect(TypeId id) {
    const Type type = program_.types[id];
    if (type.IsScalarOrVector())
      pieces_.push_back({path_, type.columns, type.kind == TypeKind::kVector});
    if (type.kind == TypeKind::kObject) pieces_.push_back({path_, 1, false});
    for (std::uint32_t i = 0; i < program_.types.PartCount(id); ++i) {
      path_.push_back(i);
      Collect(program_.types.PartType(id, i));
      path_.pop_back();
    }
  }

  ExprId ReadAt(const std::vector<std::uint32_t>& path) {
    ExprId expr = source_.Read();
    for (const std::uint32_t part : path) expr = builder_.Part(expr, part);
    return expr;
  }

  // Takes at most `count` components of the current piece, from the first that was not taken yet.
  ExprId TakePart(std::uint8_t count, std::uint8_t& taken) {
    CLIPC_CHECK(next_ < pieces_.size());
    const Piece& piece = pieces_[next_];
    taken = std::min<std::uint8_t>(count, static_cast<std::uint8_t>(piece.size - offset_));
    ExprId part = ReadAt(piece.path);
    if (piece.is_vector && (taken != piece.size || piece.size == 1))
      part = builder_.SwizzledRun(part, offset_, taken);
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
    if (type.kind == TypeKind::kScalar) return TakeParts(1, type.scalar).front();
    if (std::uint8_t taken = 0; type.kind == TypeKind::kObject) return TakePart(1, taken);
    std::vector<ExprId> parts;
    if (type.kind == TypeKind::kVector) {
      parts = TakeParts(type.columns, type.scalar);
      if (type.columns == 1) return builder_.SplatTo(id, parts.front());
      if (parts.size() == 1) return parts.front();
    }
    const bool is_column = type.kind == TypeKind::kMatrix && type.columns == 1;
    for (std::uint32_t i = 0; i < program_.types.PartCount(id); ++i) {
      parts.push_back(
          Build(is_column ? program_.types.Make(type.scalar) : program_.types.PartType(id, i)));
    }
    return builder_.ConstructOf(id, parts);
  }

  Program& program_;
  Reread& source_;
  Builder builder_;
  std::vector<std::uint32_t> path_;
  std::vector<Piece> pieces_;
  std::size_t next_ = 0;
  std::uint8_t offset_ = 0;
};

// The value (S)x, with the scalar in every leaf. An array's element that is not a number is made
// once and repeated.
ExprId FillAggregate(Program& program, Reread& scalar, TypeId id, Span span,
                     TemporaryMaker& temporaries) {
  const Type type = program.types[id];
  Builder builder(program, span);
  if (type.IsNumeric())
    return builder.SplatTo(id, ConvertKind(program, scalar.Read(), type.scalar));
  std::vector<ExprId> parts;
  if (type.kind == TypeKind::kArray && type.count > 1 && !program.types[type.element].IsNumeric()) {
    Reread element(program, FillAggregate(program, scalar, type.element, span, temporaries),
                   &temporaries);
    for (std::uint32_t i = 0; i < type.count; ++i) parts.push_back(element.Read());
    return element.Finish(builder.ConstructOf(id, parts));
  }
  for (std::uint32_t i = 0; i < program.types.PartCount(id); ++i) {
    parts.push_back(
        FillAggregate(program, scalar, program.types.PartType(id, i), span, temporaries));
  }
  return builder.ConstructOf(id, parts);
}

// The first component of a numeric value, as a scalar.
ExprId FirstComponent(Program& program, ExprId value) {
  const Type type = TypeOf(program, value);
  Builder builder(program, program.exprs[value].span);
  if (type.kind == TypeKind::kScalar) return value;
  if (type.kind == TypeKind::kMatrix) value = builder.At(value, 0u);
  return builder.Swizzled(value, {0});
}

ExprId FirstComponents(Program& program, ExprId vector, std::uint8_t count) {
  if (TypeOf(program, vector).columns == count) return vector;
  return Builder(program, program.exprs[vector].span).SwizzledRun(vector, 0, count);
}

// The value in another numeric shape, as RankImplicit allows; none if `value` would have to be
// read several times and `temporaries` is null.
ExprId ConvertNumeric(Program& program, ExprId value, TypeId to_id, TemporaryMaker* temporaries) {
  const Type from = TypeOf(program, value);
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
    return ConvertKind(program, builder.Add(smaller, MatrixTruncate{value}), to.scalar);
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

ExprId ConvertAggregate(Program& program, ExprId value, TypeId to, TemporaryMaker* temporaries) {
  const Span span = program.exprs[value].span;
  Reread source(program, value, temporaries);
  if (!source.usable()) return {};
  const TypeId from = source.type();
  Reshaper reshaper(program, source, span);
  return source.Finish(reshaper.IsParallel(from, to) ? reshaper.BuildParallel(from, to)
                                                     : reshaper.BuildLeaves(from, to));
}

void WarnOfLoss(Program& program, ExprId value, TypeId to_id, Diagnostics& diagnostics) {
  const Expr& expr = program.exprs[value];
  const Type& from = program.types[expr.type];
  const Type& to = program.types[to_id];
  if (to.Components() < from.Components()) {
    diagnostics.Report(expr.span, diag::ImplicitTruncation, program.types.Name(expr.type),
                       program.types.Name(to_id));
  }
  if (IsWide(from.scalar) && !IsWide(to.scalar) && to.scalar != Scalar::kBool &&
      As<Literal>(program, value) == nullptr) {
    diagnostics.Report(expr.span, diag::ImplicitNarrowing, program.types.Name(expr.type),
                       program.types.Name(to_id));
  }
}

}  // namespace

void SetSamplerKind(Program& program, ExprId object, ObjectKind kind) {
  auto& expr = program.exprs[object];
  if (const auto* index = std::get_if<Index>(&expr.node)) {
    SetSamplerKind(program, index->base, kind);
    expr.type = program.types.Object(kind);
    return;
  }
  const auto retype = [&](auto&& self, TypeId id) -> TypeId {
    const Type type = program.types[id];
    if (type.kind == TypeKind::kArray)
      return program.types.Array(self(self, type.element), type.count);
    return type.kind == TypeKind::kObject && type.object == ObjectKind::kSampler
               ? program.types.Object(kind)
               : id;
  };
  expr.type = retype(retype, expr.type);
}

ExprId ConvertImplicit(Program& program, ExprId value, TypeId to, Diagnostics& diagnostics,
                       TemporaryMaker* temporaries) {
  const TypeId from = TypeIdOf(program, value);
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

ExprId ConvertExplicit(Program& program, ExprId value, TypeId to, TemporaryMaker& temporaries) {
  const TypeId from = TypeIdOf(program, value);
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

}  // namespace clipc::typing
