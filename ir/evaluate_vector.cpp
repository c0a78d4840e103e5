// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <cmath>
#include <type_traits>

#include "base/invariant.h"
#include "ir/evaluate_math.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::ir {
namespace {

// Words at a step from each other: a row or a column of a matrix.
struct Words {
  const Word* first;
  std::size_t step = 1;
  Word operator[](std::size_t i) const { return first[i * step]; }
};

// The sum of products from left to right, with each product and each sum rounded.
Word Dot(Scalar rep, const Words& a, const Words& b, std::size_t count) {
  Word sum = BinaryComponent(BinaryOp::kMul, rep, a[0], b[0]);
  for (std::size_t i = 1; i < count; ++i) {
    const Word product = BinaryComponent(BinaryOp::kMul, rep, a[i], b[i]);
    sum = BinaryComponent(BinaryOp::kAdd, rep, sum, product);
  }
  return sum;
}

void Scale(Scalar rep, std::span<const Word> values, Word factor, bool factor_first, Word* result) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    result[i] = factor_first ? BinaryComponent(BinaryOp::kMul, rep, factor, values[i])
                             : BinaryComponent(BinaryOp::kMul, rep, values[i], factor);
  }
}

// The product of mul(): a vector on the left is a row, on the right a column; two vectors give
// their dot product.
void Multiply(Scalar rep, const EvalArgument& left, const EvalArgument& right, Word* result) {
  const Type& a = *left.type;
  const Type& b = *right.type;
  if (a.kind == TypeKind::kScalar)
    return Scale(rep, {right.words, b.Components()}, left.words[0], true, result);
  if (b.kind == TypeKind::kScalar)
    return Scale(rep, {left.words, a.Components()}, right.words[0], false, result);
  const std::size_t rows = a.kind == TypeKind::kMatrix ? a.rows : 1;
  const std::size_t inner = a.columns;
  const std::size_t columns = b.kind == TypeKind::kMatrix ? b.columns : 1;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      result[r * columns + c] =
          Dot(rep, {left.words + r * inner}, {right.words + c, columns}, inner);
    }
  }
}

// Masked sums of absolute differences. Window i is bytes i to i + 3 of the eight in `source`; sum i
// grows by |reference byte - byte of the window| for each byte of the reference that is not 0.
// Source: Microsoft's "msad4 (DirectX HLSL)".
void MaskedSums(const Word* reference, const Word* source, const Word* sums, Word* result) {
  const std::uint64_t bytes = std::uint64_t{UintOf(source[1])} << 32 | UintOf(source[0]);
  for (unsigned window = 0; window < 4; ++window) {
    std::uint32_t sum = UintOf(sums[window]);
    for (unsigned i = 0; i < 4; ++i) {
      const int wanted = UintOf(reference[0]) >> 8 * i & 255;
      const int found = bytes >> 8 * (window + i) & 255;
      if (wanted != 0) sum += static_cast<std::uint32_t>(std::abs(wanted - found));
    }
    result[window] = sum;
  }
}

template <typename T>
class Vectors {
 public:
  explicit Vectors(std::span<const EvalArgument> arguments) : arguments_(arguments) {}

  void Run(Intrinsic op, Word* result) const {
    using enum Intrinsic;
    switch (op) {
      case kCross: return Cross(result);
      case kDot2Add: return Put(result, 0, DotOf(0, 1) + At(2, 0));
      case kD3dColorToUbyte4: return ColorToBytes(result);
      case kDeterminant: return Put(result, 0, Determinant());
      case kDistance: return Put(result, 0, Distance());
      case kDst: return Dst(result);
      case kFaceforward: return Faceforward(result);
      case kLength: return Put(result, 0, std::sqrt(DotOf(0, 0)));
      case kLit: return Lit(result);
      case kNormalize: return Normalize(result);
      case kReflect: return Reflect(result);
      default: CLIPC_CHECK(op == kRefract); return Refract(result);
    }
  }

 private:
  T At(std::size_t argument, std::size_t i) const {
    const Word word = arguments_[argument].words[i];
    if constexpr (std::is_same_v<T, float>) {
      return FloatOf(word);
    } else {
      return DoubleOf(word);
    }
  }
  static void Put(Word* result, std::size_t i, T value) { result[i] = BitsOf(value); }
  std::size_t Size(std::size_t argument) const { return arguments_[argument].type->Components(); }

  T DotOf(std::size_t a, std::size_t b) const {
    T sum = At(a, 0) * At(b, 0);
    for (std::size_t i = 1; i < Size(a); ++i) {
      const T product = At(a, i) * At(b, i);
      sum = sum + product;
    }
    return sum;
  }

  void Cross(Word* result) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const T plus = At(0, j) * At(1, k);
      const T minus = At(0, k) * At(1, j);
      Put(result, i, plus - minus);
    }
  }

  // fxc multiplies by 255.001953 and truncates: every n / 255 comes back as n. Red and blue change
  // places.
  void ColorToBytes(Word* result) const {
    static constexpr std::size_t kFrom[] = {2, 1, 0, 3};
    for (std::size_t i = 0; i < 4; ++i) {
      const T scaled = At(0, kFrom[i]) * static_cast<T>(255.001953f);
      result[i] = BitsOf(ToInt(scaled));
    }
  }

  T Determinant() const {
    const std::size_t size = arguments_[0].type->rows;
    std::array<std::size_t, 4> columns{0, 1, 2, 3};
    return Minor(0, columns, size);
  }
  // The determinant of the rows from `row` on and the first `size` of `columns`.
  T Minor(std::size_t row, const std::array<std::size_t, 4>& columns, std::size_t size) const {
    const std::size_t width = arguments_[0].type->columns;
    if (size == 1) return At(0, row * width + columns[0]);
    T sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
      std::array<std::size_t, 4> rest{};
      for (std::size_t j = 0, k = 0; j < size; ++j) {
        if (j != i) rest[k++] = columns[j];
      }
      const T product = At(0, row * width + columns[i]) * Minor(row + 1, rest, size - 1);
      sum = i == 0 ? product : i % 2 == 1 ? sum - product : sum + product;
    }
    return sum;
  }

  T Distance() const {
    T sum = 0;
    for (std::size_t i = 0; i < Size(0); ++i) {
      const T difference = At(0, i) - At(1, i);
      const T square = difference * difference;
      sum = i == 0 ? square : sum + square;
    }
    return std::sqrt(sum);
  }

  void Dst(Word* result) const {
    Put(result, 0, T{1});
    Put(result, 1, At(0, 1) * At(1, 1));
    Put(result, 2, At(0, 2));
    Put(result, 3, At(1, 3));
  }

  // n where dot(i, ng) < 0, else -n.
  void Faceforward(Word* result) const {
    const bool keep = DotOf(1, 2) < 0;
    for (std::size_t i = 0; i < Size(0); ++i) Put(result, i, keep ? At(0, i) : -At(0, i));
  }

  // (1, max(n_dot_l, 0), specular, 1), where specular is n_dot_h to the m, and 0 when either dot
  // product is negative.
  void Lit(Word* result) const {
    const T diffuse = At(0, 0);
    const T specular = At(1, 0);
    Put(result, 0, T{1});
    Put(result, 1, std::fmax(diffuse, T{0}));
    Put(result, 2, diffuse < 0 || specular < 0 ? T{0} : PowOf(specular, At(2, 0)));
    Put(result, 3, T{1});
  }

  void Normalize(Word* result) const {
    const T inverse = static_cast<T>(1 / std::sqrt(static_cast<double>(DotOf(0, 0))));
    for (std::size_t i = 0; i < Size(0); ++i) Put(result, i, At(0, i) * inverse);
  }

  void Reflect(Word* result) const {
    const T twice = 2 * DotOf(0, 1);
    for (std::size_t i = 0; i < Size(0); ++i) {
      const T product = twice * At(1, i);
      Put(result, i, At(0, i) - product);
    }
  }

  void Refract(Word* result) const {
    const T eta = At(2, 0);
    const T cosine = DotOf(1, 0);
    const T sine_squared = 1 - cosine * cosine;
    const T k = 1 - eta * eta * sine_squared;
    const T along = k < 0 ? T{0} : eta * cosine + std::sqrt(k);
    for (std::size_t i = 0; i < Size(0); ++i) {
      const T bent = eta * At(0, i) - along * At(1, i);
      Put(result, i, k < 0 ? T{0} : bent);
    }
  }

  std::span<const EvalArgument> arguments_;
};

}  // namespace

void VectorFunction(Intrinsic op, Scalar rep, std::span<const EvalArgument> arguments,
                    Word* result) {
  using enum Intrinsic;
  const EvalArgument& first = arguments[0];
  const std::size_t count = first.type->Components();
  const auto is_true = [&](std::size_t i) {
    return BinaryComponent(BinaryOp::kNotEqual, rep, first.words[i],
                           ConvertBits(0, Scalar::kInt, rep)) != 0;
  };
  switch (op) {
    case kAll:
      result[0] = 1;
      for (std::size_t i = 0; i < count; ++i) result[0] &= is_true(i) ? 1 : 0;
      return;
    case kAny:
    case kCheckAccessFullyMapped:  // a status is not 0 where the texels are in memory
      result[0] = 0;
      for (std::size_t i = 0; i < count; ++i) result[0] |= is_true(i) ? 1 : 0;
      return;
    case kDot: result[0] = Dot(rep, {first.words}, {arguments[1].words}, count); return;
    case kMsad4: return MaskedSums(first.words, arguments[1].words, arguments[2].words, result);
    case kMul: return Multiply(rep, first, arguments[1], result);
    case kTranspose:
      for (std::size_t r = 0; r < first.type->rows; ++r) {
        for (std::size_t c = 0; c < first.type->columns; ++c) {
          result[c * first.type->rows + r] = first.words[r * first.type->columns + c];
        }
      }
      return;
    default:
      if (PackedFunction(op, arguments, result)) return;
      if (rep == Scalar::kDouble) return Vectors<double>(arguments).Run(op, result);
      return Vectors<float>(arguments).Run(op, result);
  }
}

}  // namespace clipc::ir
