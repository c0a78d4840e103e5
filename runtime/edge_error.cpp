// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/edge_error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace clipc::runtime {
namespace {

// The most places. Up to kFewPlaces, each place has all directions; with more, each has a fourth of
// them, in turn.
constexpr std::size_t kFewPlaces = 16, kPlaces = 256;
constexpr int kDirections = 24, kTurns = 4;
constexpr std::size_t kEdges = std::max(kFewPlaces, kPlaces / kTurns) * kDirections;
constexpr double kGoldenAngle = 2.399963229728653;  // of a turn, in radians: fills circles evenly
constexpr double kLeastSine = 0.05;                 // 3 degrees

constexpr std::uint64_t kExponent = 0x7ff0'0000'0000'0000, kMantissa = 0x000f'ffff'ffff'ffff;
// The largest power of two that is not above |x|, or that of float's least normal number. The
// functions of <cmath> for exponents take most of a prediction's time.
double PowerOf(double x) {
  return std::max(std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & kExponent), 0x1p-126);
}
// The variance of the error that rounding a number of this size to float adds, evenly over half a
// unit in the last place; none for 0.
double Rounding(double x) {
  if (x == 0) return 0;
  const double half_unit = PowerOf(x) * 0x1p-24;
  return half_unit * half_unit / 3;
}
// Whether `x` is a power of two, which float holds and multiplies without rounding.
bool IsExact(double x) {
  return x != 0 && std::isfinite(x) && (std::bit_cast<std::uint64_t>(x) & kMantissa) == 0;
}
// The variance that rounding adds to the sum of two floats; none where one of them is 0.
double RoundingOfSum(double a, double b) { return a == 0 || b == 0 ? 0 : Rounding(a + b); }
double RoundingOfConstant(double x) { return IsExact(x) ? 0 : Rounding(x); }

struct Vector4 {
  double c[4];
};
Vector4 Transform(const Vector4& v, const Matrix& m) {
  Vector4 to = {};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) to.c[j] += v.c[i] * m.m[i][j];
  }
  return to;
}
// The slopes of a number by the coordinates before `m`, from its slopes by those after it.
Vector4 Before(const Matrix& m, const Vector4& slopes) {
  Vector4 before = {};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) before.c[i] += m.m[i][j] * slopes.c[j];
  }
  return before;
}
Vector4 RowOf(const Matrix& m, int i) { return {{m.m[i][0], m.m[i][1], m.m[i][2], m.m[i][3]}}; }

bool IsSameInFloat(const Matrix& m, int row) {
  return static_cast<float>(m.m[row][2]) == static_cast<float>(m.m[row][3]);
}

// The variance of slopes.c[2] * z + slopes.c[3] * w where z and w are rounded. Two numbers of one
// binade differ after rounding by one of the two multiples of its unit that are next to what they
// differ by.
double OfPair(double z, double w, const Vector4& slopes) {
  const double of_z = slopes.c[2] * slopes.c[2], of_w = slopes.c[3] * slopes.c[3];
  if (z == 0 || w == 0 || PowerOf(z) != PowerOf(w)) return of_z * Rounding(z) + of_w * Rounding(w);
  const double unit = PowerOf(z) * 0x1p-23, units = std::fabs(z - w) / unit;
  const double part = units - std::floor(units), both = slopes.c[2] + slopes.c[3];
  return both * both * Rounding(w) + std::min(of_z, of_w) * part * (1 - part) * unit * unit;
}

// The variance that rounding the elements of `m` adds to a number that depends on v * m by
// `slopes`. Elements of z and w that are the same, as under an infinite projection, have one error.
double OfElements(const Vector4& v, const Matrix& m, const Vector4& slopes) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    const bool is_same = IsSameInFloat(m, i);
    // The difference of the z and w elements is lost.
    const double lost = is_same ? v.c[i] * slopes.c[2] * (m.m[i][2] - m.m[i][3]) : 0;
    sum += lost * lost;
    for (int j = 0; j < 2; ++j) {
      const double slope = v.c[i] * slopes.c[j];
      sum += slope * slope * RoundingOfConstant(m.m[i][j]);
    }
    const double z = m.m[i][2], w = m.m[i][3], both = slopes.c[2] + slopes.c[3];
    const Vector4 of_pair = {{0, 0, IsExact(z) ? 0 : slopes.c[2], IsExact(w) ? 0 : slopes.c[3]}};
    sum +=
        v.c[i] * v.c[i] * (is_same ? both * both * RoundingOfConstant(w) : OfPair(z, w, of_pair));
  }
  return sum;
}

// The variance that the operations of v * m add; `m` is in float.
double OfOperations(const Vector4& v, const Matrix& m, const Vector4& slopes) {
  double sum = 0;
  int alike = 0;  // the rows up to which z and w are sums of the same products
  while (alike < 4 && IsSameInFloat(m, alike)) ++alike;
  double partial[4] = {};
  for (int i = 0; i < 4; ++i) {
    double rounded[4], sums[4];
    bool is_rounded[4];
    for (int j = 0; j < 4; ++j) {
      const double product = v.c[i] * m.m[i][j];
      rounded[j] = IsExact(v.c[i]) || IsExact(m.m[i][j]) ? 0 : Rounding(product);
      sums[j] = partial[j] + product;
      is_rounded[j] = RoundingOfSum(partial[j], product) > 0;
      partial[j] = sums[j];
    }
    for (int j = 0; j < 2; ++j) {
      const double size = rounded[j] + (is_rounded[j] ? Rounding(sums[j]) : 0);
      sum += slopes.c[j] * slopes.c[j] * size;
    }
    const double both = slopes.c[2] + slopes.c[3];
    if (i < alike) {
      sum += both * both * (rounded[3] + (is_rounded[3] ? Rounding(sums[3]) : 0));
      continue;
    }
    sum += slopes.c[2] * slopes.c[2] * rounded[2] + slopes.c[3] * slopes.c[3] * rounded[3];
    sum += OfPair(is_rounded[2] ? sums[2] : 0, is_rounded[3] ? sums[3] : 0, slopes);
  }
  return sum;
}

// The matrix as the shader or the application has it in float.
Matrix InFloat(const Matrix& matrix) {
  Matrix rounded;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      rounded.m[i][j] = static_cast<double>(static_cast<float>(matrix.m[i][j]));
  }
  return rounded;
}

class Shader {
 public:
  explicit Shader(const DistanceArithmetic& arithmetic) : arithmetic_(arithmetic) {
    const Plane& c = arithmetic.constant;
    slopes_[arithmetic.count] =
        arithmetic.is_xyw1 ? Vector4{{c.x, c.y, 0, c.z}} : Vector4{{c.x, c.y, c.z, c.w}};
    constant_[0] = c.x, constant_[1] = c.y, constant_[2] = c.z, constant_[3] = c.w;
    for (int k = arithmetic.count; k > 0; --k)
      slopes_[k - 1] = Before(arithmetic.matrices[k - 1], slopes_[k]);
    for (int k = 0; k < arithmetic.count; ++k) {
      in_float_[k] = InFloat(arithmetic.matrices[k]);
      products_[k] = k == 0 ? in_float_[k] : Multiply(products_[k - 1], in_float_[k]);
    }
    for (int k = arithmetic.count; k-- > 0;)
      rests_[k] = k + 1 == arithmetic.count ? in_float_[k] : Multiply(in_float_[k], rests_[k + 1]);
  }

  // The distance, but for a part that is the same at every place.
  double ValueAt(const double (&place)[3]) const { return ValueOf(Last(place)); }
  // The variances of the error of the distance: of the part that all vertices share, from
  // constants, and of the part that each vertex has of its own, from the shader's operations.
  double SharedAt(const double (&place)[3]) const { return VarianceAt<true>(place); }
  double OwnAt(const double (&place)[3]) const { return VarianceAt<false>(place); }

 private:
  template <bool kShared>
  double VarianceAt(const double (&place)[3]) const {
    double sum = 0;
    const int count = arithmetic_.count;
    const bool is_product = arithmetic_.product != FloatProduct::kNone;
    const Vector4 vertex = {{place[0], place[1], place[2], 1}};
    Vector4 v = vertex;
    for (int k = 0; k < count; ++k) {
      const Matrix& matrix = arithmetic_.matrices[k];
      if (!kShared && !is_product) sum += OfOperations(v, in_float_[k], slopes_[k + 1]);
      if (kShared) {
        sum += OfElements(v, matrix, slopes_[k + 1]);
        if (arithmetic_.product == FloatProduct::kFromLeft && k > 0)
          sum += OfProduct(vertex, products_[k - 1], in_float_[k], slopes_[k + 1]);
        if (arithmetic_.product == FloatProduct::kFromRight && k + 1 < count)
          sum += OfProduct(v, in_float_[k], rests_[k + 1], slopes_[count]);
      }
      v = Transform(v, matrix);
    }
    if (!kShared && is_product && count > 0)
      sum += OfOperations(vertex, products_[count - 1], slopes_[count]);
    return sum + (kShared ? SharedOfDot(v) : OwnOfDot(v));
  }

  Vector4 Last(const double (&place)[3]) const {
    Vector4 v = {{place[0], place[1], place[2], 1}};
    for (int k = 0; k < arithmetic_.count; ++k) v = Transform(v, arithmetic_.matrices[k]);
    return v;
  }
  double ValueOf(const Vector4& v) const {
    double sum = 0;
    for (int j = 0; j < 4; ++j) sum += v.c[j] * slopes_[arithmetic_.count].c[j];
    return sum;
  }
  // The variance from multiplying two matrices, where `v` is multiplied by the first, and the
  // distance depends by `slopes` on the result.
  static double OfProduct(const Vector4& v, const Matrix& first, const Matrix& second,
                          const Vector4& slopes) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      Vector4 of_row = slopes;
      for (double& slope : of_row.c) slope *= v.c[i];
      sum += OfOperations(RowOf(first, i), second, of_row);
    }
    return sum;
  }
  // The numbers that the constant is dotted with.
  Vector4 Operand(const Vector4& v) const {
    return arithmetic_.is_xyw1 ? Vector4{{v.c[0], v.c[1], v.c[3], 1}} : v;
  }
  // The variances from the dot product with the constant.
  double SharedOfDot(const Vector4& v) const {
    const Vector4 operand = Operand(v);
    double sum = 0;
    for (int j = 0; j < 4; ++j)
      sum += operand.c[j] * operand.c[j] * RoundingOfConstant(constant_[j]);
    return sum;
  }
  double OwnOfDot(const Vector4& v) const {
    const Vector4 operand = Operand(v);
    double partial = 0, sum = 0;
    for (int j = 0; j < 4; ++j) {
      const double product = operand.c[j] * constant_[j], before = partial;
      partial += product;
      if (!IsExact(operand.c[j]) && !IsExact(constant_[j])) sum += Rounding(product);
      sum += RoundingOfSum(before, product);
    }
    return sum;
  }

  const DistanceArithmetic& arithmetic_;
  double constant_[4];
  Vector4 slopes_[4] = {};  // of the distance, by the vector before each matrix and after the last
  Matrix in_float_[3];      // each matrix
  Matrix products_[3];      // of the matrices up to each, in float
  Matrix rests_[3];         // of the matrices from each on, in float
};

struct Vector3 {
  double c[3];
};
double Dot(const Vector3& a, const Vector3& b) {
  return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2];
}
Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {{a.c[1] * b.c[2] - a.c[2] * b.c[1], a.c[2] * b.c[0] - a.c[0] * b.c[2],
           a.c[0] * b.c[1] - a.c[1] * b.c[0]}};
}
Vector3 Row(const Matrix& m, int i) { return {{m.m[i][0], m.m[i][1], m.m[i][2]}}; }

// The image that a camera makes of view space.
class View {
 public:
  View(const Matrix& world_view, const Matrix& projection, double image_height)
      : projection_(projection), half_height_(image_height / 2) {
    half_width_ = half_height_ * std::fabs(projection.m[1][1] / projection.m[0][0]);
    const Vector3 rows[3] = {Row(world_view, 0), Row(world_view, 1), Row(world_view, 2)};
    const Vector3 across = Cross(rows[1], rows[2]);
    const double determinant = Dot(rows[0], across);
    const Vector3 columns[3] = {across, Cross(rows[2], rows[0]), Cross(rows[0], rows[1])};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) to_object_[i].c[j] = columns[j].c[i] / determinant;
    }
  }

  double WAt(const Vector3& place) const {
    return projection_.m[2][3] * place.c[2] + projection_.m[3][3];
  }
  // The number of pixels that a place moves by in the image when it moves by `direction`.
  double PixelsOf(const Vector3& place, const Vector3& direction) const {
    const double w = WAt(place), dw = projection_.m[2][3] * direction.c[2];
    double moved[2];
    for (int j = 0; j < 2; ++j) {
      const double at =
          place.c[j] * projection_.m[j][j] + place.c[2] * projection_.m[2][j] + projection_.m[3][j];
      const double by = direction.c[j] * projection_.m[j][j] + direction.c[2] * projection_.m[2][j];
      moved[j] = (by - at / w * dw) / w;
    }
    return std::hypot(moved[0] * half_width_, moved[1] * half_height_);
  }
  // The length of a half image at that place.
  double HalfImageAt(const Vector3& place) const {
    return std::fabs(WAt(place) / projection_.m[1][1]);
  }
  // A direction of view space in the object's.
  Vector3 InObject(const Vector3& direction) const {
    Vector3 to = {};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) to.c[j] += direction.c[i] * to_object_[i].c[j];
    }
    return to;
  }

 private:
  Matrix projection_;
  double half_height_, half_width_;
  Vector3 to_object_[3] = {};
};

// Directions from 0 to kDirections - 1 around a normal, evenly.
class Directions {
 public:
  Directions(const Plane& plane, double sine) : normal_{{plane.x, plane.y, plane.z}}, sine_(sine) {
    const int least = std::fabs(plane.x) < 0.6 ? 0 : 1;
    Vector3 other = {};
    other.c[least] = 1;
    across_ = Cross(normal_, other);
    const double length = std::sqrt(Dot(across_, across_));
    for (double& each : across_.c) each /= length;
    along_ = Cross(normal_, across_);
  }
  double SineOf(int number) const {
    if (sine_ != kAnySurface) return sine_;
    return kLeastSine + (1 - kLeastSine) * (number + 0.5) / kDirections;
  }
  Vector3 At(int number, double turn) const {
    const double sine = SineOf(number), cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
    const double angle = kGoldenAngle * number + turn;
    Vector3 to;
    for (int i = 0; i < 3; ++i) {
      to.c[i] = sine * normal_.c[i] +
                cosine * (std::cos(angle) * across_.c[i] + std::sin(angle) * along_.c[i]);
    }
    return to;
  }

 private:
  Vector3 normal_, across_, along_;
  double sine_;
};

// The number that one in a hundred of normal numbers with these deviations exceeds, by false
// position on the logarithm of the share that exceeds a number.
double Percentile99(const double* deviations, std::size_t count) {
  if (count == 0) return INFINITY;
  const auto exceeding = [&](double number) {
    double share = 0;
    for (std::size_t i = 0; i < count; ++i) {
      // Beyond six deviations nothing counts.
      if (number < 6 * deviations[i]) share += std::erfc(number / (deviations[i] * std::sqrt(2.0)));
    }
    return std::log(share / (0.01 * static_cast<double>(count)));
  };
  double low = 0, high = 4 * *std::max_element(deviations, deviations + count);
  if (!(high > 0 && std::isfinite(high))) return high;
  double at_low = std::log(100.0), at_high = exceeding(high), number = high;
  if (at_high >= 0) return high;
  for (int step = 0; step < 30; ++step) {
    number = low + (high - low) * at_low / (at_low - at_high);
    const double at = exceeding(number);
    if (std::fabs(at) < 1e-4) break;
    // The end that stays weighs half, so that both move.
    if (at > 0) {
      low = number, at_low = at, at_high /= 2;
    } else {
      high = number, at_high = at, at_low /= 2;
    }
  }
  return number;
}

}  // namespace

double EdgeErrorOf(const DistanceArithmetic& arithmetic, const Plane& view_plane,
                   const Matrix& world_view, const Matrix& projection, const SeenCut& cut,
                   double image_height, double sine) noexcept {
  const Shader shader(arithmetic);
  const View view(world_view, projection, image_height);
  const Directions directions(view_plane, sine);
  double deviations[kEdges];
  std::size_t count = 0;
  const std::size_t places = std::min(cut.count, kPlaces);
  const int stride = places > kFewPlaces ? kTurns : 1;
  for (std::size_t place = 0; place < places; ++place) {
    double at[3];
    std::copy_n(cut.places + 3 * (place * cut.count / places), 3, at);
    Vector3 seen = {};
    for (int j = 0; j < 3; ++j) {
      seen.c[j] = world_view.m[3][j];
      for (int i = 0; i < 3; ++i) seen.c[j] += at[i] * world_view.m[i][j];
    }
    if (!(view.WAt(seen) > 0)) continue;
    const double length = cut.edge * view.HalfImageAt(seen);
    const double shared = shader.SharedAt(at);
    for (int number = static_cast<int>(place % static_cast<std::size_t>(stride));
         number < kDirections; number += stride) {
      const Vector3 along = directions.At(number, static_cast<double>(place));
      const Vector3 half_edge = view.InObject(along);
      double own = 0, values[2];
      for (int end = 0; end < 2; ++end) {
        double vertex[3];
        for (int i = 0; i < 3; ++i) vertex[i] = at[i] + (end - 0.5) * length * half_edge.c[i];
        own += shader.OwnAt(vertex);
        values[end] = shader.ValueAt(vertex);
      }
      // The cut lies between the ends, where it takes a part of each one's own error.
      const double variance = shared + 0.28 * own;
      const double slope = std::fabs(values[1] - values[0]) / length;
      deviations[count++] = std::sqrt(variance) / slope * view.PixelsOf(seen, along);
    }
  }
  return Percentile99(deviations, count);
}

}  // namespace clipc::runtime
