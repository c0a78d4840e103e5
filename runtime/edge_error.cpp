// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/edge_error.h"

#include <algorithm>
#include <cmath>

#include "runtime/vertex_rounding.h"

namespace clipc::runtime {
namespace {

using namespace rounding;

// The most places. Up to kFewPlaces, each place has all directions; with more, each has a fourth of
// them, in turn.
constexpr std::size_t kFewPlaces = 16, kPlaces = 256;
constexpr int kDirections = 24, kTurns = 4;
constexpr std::size_t kEdges = std::max(kFewPlaces, kPlaces / kTurns) * kDirections;
constexpr double kGoldenAngle = 2.399963229728653;  // of a turn, in radians: fills circles evenly
constexpr double kLeastSine = 0.05;                 // 3 degrees

// The distance that a shader computes, and its errors as above.
class ShaderDistance {
 public:
  explicit ShaderDistance(const DistanceArithmetic& arithmetic)
      : arithmetic_(arithmetic), chain_(arithmetic) {
    const Plane& c = arithmetic.constant;
    last_ = arithmetic.is_xyw1 ? Vector4{{c.x, c.y, 0, c.z}} : Vector4{{c.x, c.y, c.z, c.w}};
    slopes_ = chain_.SlopesOf(last_);
    constant_[0] = c.x, constant_[1] = c.y, constant_[2] = c.z, constant_[3] = c.w;
  }

  // The distance, but for a part that is the same at every place.
  double ValueAt(const double (&place)[3]) const {
    const Vector4 v = chain_.Last(place);
    double sum = 0;
    for (int j = 0; j < 4; ++j) sum += v.c[j] * last_.c[j];
    return sum;
  }
  double SharedAt(const double (&place)[3]) const {
    const Vector4 operand = OperandAt(place);
    double sum = chain_.SharedAt(place, slopes_);
    for (int j = 0; j < 4; ++j)
      sum += operand.c[j] * operand.c[j] * RoundingOfConstant(constant_[j]);
    return sum;
  }
  double OwnAt(const double (&place)[3]) const {
    const Vector4 operand = OperandAt(place);
    double partial = 0, sum = chain_.OwnAt(place, slopes_);
    for (int j = 0; j < 4; ++j) {
      const double product = operand.c[j] * constant_[j], before = partial;
      partial += product;
      if (!IsExact(operand.c[j]) && !IsExact(constant_[j])) sum += Rounding(product);
      sum += RoundingOfSum(before, product);
    }
    return sum;
  }

 private:
  // The numbers that the constant is dotted with.
  Vector4 OperandAt(const double (&place)[3]) const {
    const Vector4 v = chain_.Last(place);
    return arithmetic_.is_xyw1 ? Vector4{{v.c[0], v.c[1], v.c[3], 1}} : v;
  }

  const DistanceArithmetic& arithmetic_;
  Chain chain_;
  Vector4 last_;
  Slopes slopes_;
  double constant_[4];
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
  // The slopes of a place's pixels, across and up, by the clip-space position that it has.
  void SlopesAt(const Vector3& place, Vector4 (&slopes)[2]) const {
    const double w = WAt(place), halves[2] = {half_width_, half_height_};
    for (int j = 0; j < 2; ++j) {
      slopes[j] = {};
      slopes[j].c[j] = halves[j] / w;
      slopes[j].c[3] = -halves[j] * At(place, j) / (w * w);
    }
  }
  // The number of pixels that a place moves by in the image when it moves by `direction`.
  double PixelsOf(const Vector3& place, const Vector3& direction) const {
    const double w = WAt(place), dw = projection_.m[2][3] * direction.c[2];
    double moved[2];
    for (int j = 0; j < 2; ++j) {
      const double by = direction.c[j] * projection_.m[j][j] + direction.c[2] * projection_.m[2][j];
      moved[j] = (by - At(place, j) / w * dw) / w;
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
  // The clip-space coordinate x or y of a place.
  double At(const Vector3& place, int j) const {
    return place.c[j] * projection_.m[j][j] + place.c[2] * projection_.m[2][j] +
           projection_.m[3][j];
  }

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

// The places of a cut that lie before the eye, as many as count.
class Places {
 public:
  Places(const SeenDraw& draw, const View& view, const SeenCut& cut)
      : draw_(draw), view_(view), cut_(cut), count_(std::min(cut.count, kPlaces)) {}

  // Calls use(number, place in the object's space, place in view space) for each.
  template <typename Use>
  void ForEach(Use use) const {
    for (std::size_t place = 0; place < count_; ++place) {
      double at[3];
      std::copy_n(cut_.places + 3 * (place * cut_.count / count_), 3, at);
      Vector3 seen = {};
      for (int j = 0; j < 3; ++j) {
        seen.c[j] = draw_.world_view.m[3][j];
        for (int i = 0; i < 3; ++i) seen.c[j] += at[i] * draw_.world_view.m[i][j];
      }
      if (view_.WAt(seen) > 0) use(place, at, seen);
    }
  }
  int Stride() const { return count_ > kFewPlaces ? kTurns : 1; }

 private:
  const SeenDraw& draw_;
  const View& view_;
  const SeenCut& cut_;
  std::size_t count_;
};

// The length of a place's displacement has the variance of this share of both coordinates'
// together, as a normal number of the same 99th percentile has it.
constexpr double kOfBoth = 0.69;
// A cut lies between two vertices, where it takes a part of each one's own error.
constexpr double kOfEach = 0.28;

// The variance of the displacement of the surface's places in the image, in pixels; a place takes
// this share of the error that a vertex there has of its own.
double OfPosition(const Chain& chain, const View& view, const double (&at)[3], const Vector3& seen,
                  double share) {
  Vector4 slopes[2];
  view.SlopesAt(seen, slopes);
  double sum = 0;
  for (const Vector4& each : slopes) {
    const Slopes before = chain.SlopesOf(each);
    sum += chain.SharedAt(at, before) + share * chain.OwnAt(at, before);
  }
  return kOfBoth * sum;
}

}  // namespace

VertexArithmetic PositionArithmetic(const DrawMatrices& draw) noexcept {
  VertexArithmetic arithmetic;
  const auto add = [&](const Matrix& matrix) { arithmetic.matrices[arithmetic.count++] = matrix; };
  switch (draw.order) {
    case MatrixOrder::kWorldFirst:
      add(draw.world), add(Multiply(draw.view, draw.projection));
      break;
    case MatrixOrder::kWorldViewFirst:
      add(Multiply(draw.world, draw.view)), add(draw.projection);
      break;
    case MatrixOrder::kThreeMatrices:
    case MatrixOrder::kFloatWorldView:
    case MatrixOrder::kFloatViewProjection:
      add(draw.world), add(draw.view), add(draw.projection);
      arithmetic.product = draw.order == MatrixOrder::kFloatWorldView ? FloatProduct::kFromLeft
                           : draw.order == MatrixOrder::kFloatViewProjection
                               ? FloatProduct::kFromRight
                               : FloatProduct::kNone;
      break;
    default: add(Multiply(Multiply(draw.world, draw.view), draw.projection));
  }
  return arithmetic;
}

EdgeDisplacement EdgeErrorOf(const DistanceArithmetic& arithmetic, const SeenDraw& draw,
                             const SeenCut& cut, double image_height, double sine) noexcept {
  const ShaderDistance shader(arithmetic);
  const Chain position(draw.position);
  const View view(draw.world_view, draw.projection, image_height);
  const Directions directions(draw.view_plane, sine);
  const Places places(draw, view, cut);
  double along_surface[kEdges], in_image[kEdges], of_vertices[kPlaces];
  std::size_t count = 0, seen_places = 0;
  places.ForEach([&](std::size_t place, const double(&at)[3], const Vector3& seen) {
    const double length = cut.edge * view.HalfImageAt(seen);
    const double shared = shader.SharedAt(at);
    const double vertices =
        draw.with_vertices ? OfPosition(position, view, at, seen, 2 * kOfEach) : 0;
    of_vertices[seen_places++] = std::sqrt(vertices);
    for (int number = static_cast<int>(place % static_cast<std::size_t>(places.Stride()));
         number < kDirections; number += places.Stride()) {
      const Vector3 along = directions.At(number, static_cast<double>(place));
      const Vector3 half_edge = view.InObject(along);
      double own = 0, values[2];
      for (int end = 0; end < 2; ++end) {
        double vertex[3];
        for (int i = 0; i < 3; ++i) vertex[i] = at[i] + (end - 0.5) * length * half_edge.c[i];
        own += shader.OwnAt(vertex);
        values[end] = shader.ValueAt(vertex);
      }
      const double slope = std::fabs(values[1] - values[0]) / length;
      const double moved = std::sqrt(shared + kOfEach * own) / slope * view.PixelsOf(seen, along);
      along_surface[count] = moved;
      in_image[count++] = std::sqrt(moved * moved + vertices);
    }
  });
  const double along = Percentile99(along_surface, count);
  if (!draw.with_vertices) return {along, 0, along};
  return {along, Percentile99(of_vertices, seen_places), Percentile99(in_image, count)};
}

EdgeDisplacement ClippedVertexErrorOf(const SeenDraw& draw, const SeenCut& cut,
                                      double image_height) noexcept {
  const Chain position(draw.position);
  const View view(draw.world_view, draw.projection, image_height);
  double along_surface[kPlaces], of_vertices[kPlaces], in_image[kPlaces];
  std::size_t count = 0;
  Places(draw, view, cut).ForEach([&](std::size_t, const double(&at)[3], const Vector3& seen) {
    const double vertices = OfPosition(position, view, at, seen, 1);
    double rounded = 0;
    for (int axis = 0; axis < 3; ++axis) {
      Vector3 step;
      for (int j = 0; j < 3; ++j) step.c[j] = draw.world_view.m[axis][j];
      const double pixels = view.PixelsOf(seen, step);
      rounded += kOfBoth * pixels * pixels * Rounding(at[axis]);
    }
    along_surface[count] = std::sqrt(rounded), of_vertices[count] = std::sqrt(vertices);
    in_image[count++] = std::sqrt(rounded + vertices);
  });
  return {Percentile99(along_surface, count), Percentile99(of_vertices, count),
          Percentile99(in_image, count)};
}

}  // namespace clipc::runtime
