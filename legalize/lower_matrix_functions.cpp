// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <numeric>
#include <utility>
#include <vector>

#include "ir/intrinsic_list.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

using Parts = std::vector<ExprId>;

// parts[0] op parts[1] op ..
ExprId Chain(Builder b, BinaryOp op, const Parts& parts) {
  return std::accumulate(parts.begin() + 1, parts.end(), parts.front(),
                         [&](ExprId sum, ExprId part) { return b.BinaryOf(op, sum, part); });
}

// The lowering of one call of a function of matrices in rows, or of vectors of integers, or of one
// that GLSL lacks.
class MatrixFunctions {
 public:
  MatrixFunctions(Legalizer& legalizer, ExprId expr)
      : legalizer_(legalizer), expr_(expr), id_(legalizer.program.exprs[expr].type) {}

  void Lower(const IntrinsicCall& call) {
    const auto arguments = std::as_const(legalizer_.program).expr_lists[call.arguments];
    const ExprId first = arguments[0];
    if (!legalizer_.IsNumeric(first)) return;
    const Shape shape = legalizer_.ShapeAt(first);
    const bool is_reduction = call.op == Intrinsic::kAll || call.op == Intrinsic::kAny;
    if (is_reduction && shape.HasRows()) return Reduce(call.op, first);
    if (call.op == Intrinsic::kTranspose && IsTakenApart(shape)) return Transpose(first);
    if (call.op == Intrinsic::kDot && shape.IsVector() && !shape.IsFloating())
      return Dot(first, arguments[1]);
    if (call.op == Intrinsic::kMul) Multiply(first, arguments[1]);
  }

  void Truncate(ExprId operand) {
    const Shape from = legalizer_.ShapeAt(operand), to = legalizer_.ShapeAt(expr_);
    if (!IsTakenApart(from) || from == to) return;
    const Type type = legalizer_.program.types[id_];
    if (!to.HasRows() && type.rows == 1) {
      Builder b = legalizer_.At(expr_);
      const ExprId row = b.At(operand, 0u);
      legalizer_.Become(
          expr_, b.ConstructOf(id_, {to.size == from.size ? row : b.SwizzledRun(row, 0, to.size)}));
      return;
    }
    const bool has_unsigned = !legalizer_.needs.signed_integers;
    const Parameter parameter{"m", legalizer_.program.exprs[operand].type};
    legalizer_.BecomeCall(
        expr_, "truncate_" + NameOf(to, has_unsigned), {&parameter, 1}, {&operand, 1},
        [&](HelperBody& body) {
          Parts rows;
          for (std::uint32_t i = 0; i < type.rows; ++i) {
            rows.push_back(body.b.SwizzledRun(body.b.At(body[0], i), 0, type.columns));
          }
          body.Return(body.b.ConstructOf(id_, rows));
        });
  }

 private:
  // Whether GLSL has functions only for the rows of such a matrix.
  bool IsTakenApart(const Shape& shape) const {
    return shape.kind == Shape::kRows ||
           (shape.kind == Shape::kMatrix && legalizer_.needs.square_matrices);
  }

  void Reduce(Intrinsic op, ExprId operand) {
    const Parameter parameter{"m", legalizer_.program.exprs[operand].type};
    const std::uint32_t count = legalizer_.TypeOf(operand).rows;
    legalizer_.BecomeCall(expr_, NameOf(op), {&parameter, 1}, {&operand, 1}, [&](HelperBody& body) {
      Parts rows;
      for (std::uint32_t i = 0; i < count; ++i) {
        rows.push_back(body.b.IntrinsicOf(op, id_, {body.b.At(body[0], i)}));
      }
      const bool is_all = op == Intrinsic::kAll;
      body.Return(
          Chain(body.b, is_all ? BinaryOp::kShortCircuitAnd : BinaryOp::kShortCircuitOr, rows));
    });
  }

  void Transpose(ExprId operand) {
    const Parameter parameter{"m", legalizer_.program.exprs[operand].type};
    const Type result = legalizer_.program.types[id_];
    legalizer_.BecomeCall(
        expr_, "transpose", {&parameter, 1}, {&operand, 1}, [&](HelperBody& body) {
          const TypeId row = legalizer_.program.types.Vector(result.scalar, result.columns);
          Parts rows;
          for (int r = 0; r < result.rows; ++r) {
            Parts components;
            for (std::uint32_t c = 0; c < result.columns; ++c) {
              components.push_back(body.b.Swizzled(body.b.At(body[0], c), {r}));
            }
            rows.push_back(body.b.ConstructOf(row, components));
          }
          body.Return(body.b.ConstructOf(id_, rows));
        });
  }

  // Makes the expression the sum of the products of components; it is a scalar or a matrix of one
  // component.
  void Dot(ExprId left, ExprId right) {
    const ExprId arguments[] = {left, right};
    const int size = legalizer_.ShapeAt(left).size;
    legalizer_.BecomeCall(expr_, "dot", arguments, [&](HelperBody& body) {
      Parts products;
      for (int i = 0; i < size; ++i) {
        products.push_back(body.b.BinaryOf(BinaryOp::kMul, legalizer_.Component(body.b, body[0], i),
                                           legalizer_.Component(body.b, body[1], i)));
      }
      ReturnAs(body, Chain(body.b, BinaryOp::kAdd, products));
    });
  }

  void ReturnAs(HelperBody& body, ExprId value) {
    const bool is_whole = legalizer_.program.exprs[value].type == id_;
    body.Return(is_whole ? value : body.b.ConstructOf(id_, {value}));
  }

  // Lowers products with a matrix in rows, and products of vectors of integers. A vector is a row
  // on the left and a column on the right.
  void Multiply(ExprId left, ExprId right) {
    const Shape l = legalizer_.ShapeAt(left), r = legalizer_.ShapeAt(right);
    const Type& type = legalizer_.TypeOf(left);
    const bool left_is_column = type.kind == TypeKind::kMatrix && type.columns == 1;
    if (l.IsScalar() || r.IsScalar()) return;
    const bool is_outer =
        left_is_column && l.IsVector() && r.IsVector() && legalizer_.needs.square_matrices;
    const bool has_rows = l.kind == Shape::kRows || r.kind == Shape::kRows || is_outer;
    if (l.IsFloating() && !has_rows) return;
    if (l.IsVector() && r.IsVector() && !left_is_column) return Dot(left, right);
    const ExprId arguments[] = {left, right};
    legalizer_.BecomeCall(expr_, "mul", arguments, [&](HelperBody& body) {
      if (l.IsVector() && r.HasRows()) return ReturnAs(body, Combination(body, r.rows, -1));
      Parts rows;
      for (int i = 0; i < (l.IsVector() ? l.size : l.rows); ++i) {
        rows.push_back(l.IsVector()  ? Scaled(body, legalizer_.Component(body.b, body[0], i), 0)
                       : r.HasRows() ? Combination(body, r.rows, i)
                                     : DotOfRow(body, i));
      }
      body.Return(body.b.ConstructOf(id_, rows));
    });
  }

  // Row `row` of the right side times a scalar.
  ExprId Scaled(HelperBody& body, ExprId scalar, int row) {
    const ExprId vector = body.b.At(body[1], static_cast<std::uint32_t>(row));
    return body.b.BinaryOf(BinaryOp::kMul, body.b.SplatTo(body.b.TypeOf(vector), scalar), vector);
  }
  // The sum of the right side's rows, each times a component of the left side, or of its row.
  ExprId Combination(HelperBody& body, int count, int left_row) {
    Parts products;
    for (int i = 0; i < count; ++i) {
      const ExprId left =
          left_row < 0 ? body[0] : body.b.At(body[0], static_cast<std::uint32_t>(left_row));
      products.push_back(Scaled(body, legalizer_.Component(body.b, left, i), i));
    }
    return Chain(body.b, BinaryOp::kAdd, products);
  }
  ExprId DotOfRow(HelperBody& body, int row) {
    const ExprId left = body.b.At(body[0], static_cast<std::uint32_t>(row));
    const Scalar kind = legalizer_.TypeOf(left).scalar;
    const ExprId dot = body.b.ZeroOf(legalizer_.program.types.Make(kind));
    MatrixFunctions(legalizer_, dot).Dot(left, body[1]);
    return dot;
  }

  Legalizer& legalizer_;
  ExprId expr_;
  TypeId id_;
};

}  // namespace

void LowerMatrixFunctions(Legalizer& legalizer) {
  legalizer.ForEach([&](ExprId expr) {
    if (const auto* call = As<IntrinsicCall>(legalizer.program, expr)) {
      MatrixFunctions(legalizer, expr).Lower(IntrinsicCall(*call));
    } else if (const auto* truncate = As<MatrixTruncate>(legalizer.program, expr)) {
      MatrixFunctions(legalizer, expr).Truncate(truncate->operand);
    }
  });
}

}  // namespace clipc::legalize
