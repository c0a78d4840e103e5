// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/plane_space.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/edge_error.h"
#include "runtime/finite.h"
#include "runtime/plane_chain.h"
#include "runtime/projection_shape.h"

namespace clipc::runtime {
namespace {

// The plane in view space.
Step InView(const Plane& plane, KnownIn known_in, const DrawMatrices& draw) {
  const Step begin = Begin(plane);
  switch (known_in) {
    case KnownIn::kObject: return Through(Through(begin, draw.world, "world"), draw.view, "view");
    case KnownIn::kWorld: return Through(begin, draw.view, "view");
    default: return begin;
  }
}

Step InObject(const Plane& plane, KnownIn known_in, const DrawMatrices& draw) {
  const Step begin = Begin(plane);
  switch (known_in) {
    case KnownIn::kObject: return begin;
    case KnownIn::kWorld: return Before(begin, draw.world, "world");
    default: return Before(Before(begin, draw.view, "view"), draw.world, "world");
  }
}

Step ConstantOf(PlaneSpace space, const Plane& plane, KnownIn known_in, const DrawMatrices& draw,
                const Step& in_view) {
  switch (space) {
    case PlaneSpace::kXyw1: return ToXyw1(in_view, draw.projection);
    case PlaneSpace::kObject: return InObject(plane, known_in, draw);
    default: return ThroughProjection(in_view, draw.projection);
  }
}

// The plane with a unit normal, of which no length overflows; none for a plane without one.
std::optional<Plane> Unit(const Plane& plane) {
  const double largest = std::max({std::fabs(plane.x), std::fabs(plane.y), std::fabs(plane.z)});
  if (!(largest > 0)) return std::nullopt;
  const int exponent = -std::ilogb(largest);
  const Plane scaled = {std::scalbn(plane.x, exponent), std::scalbn(plane.y, exponent),
                        std::scalbn(plane.z, exponent), std::scalbn(plane.w, exponent)};
  const double length = NormalLength(scaled);
  return Plane{scaled.x / length, scaled.y / length, scaled.z / length, scaled.w / length};
}

// The displacement of vertices, in roundings of half an image, by the reach.
constexpr double kVertexFactor = 4.5;

// The factors of e in the header's table.
double PerspectiveLaw(PlaneSpace space, const Plane& n, const ProjectionShape& s, double reach) {
  const double py = std::fabs(s.py), off_centre = std::hypot(s.ox / s.e, s.oy / s.e);
  const double k = std::fabs(n.z - (s.ox * n.x / s.px + s.oy * n.y / s.py));
  const double law = 1 + 2 * off_centre + k * py + 2 * reach;
  if (space == PlaneSpace::kXyw1) return law;
  return law + 1.4 * std::fabs(n.w * s.a / s.b) * (py + 2 * reach);
}

double OrthographicLaw(const Plane& n, const ProjectionShape& s, double reach) {
  // z is as large as the depth, and the plane's w as the eye is far: both are rounded before they
  // cancel.
  const double depth = std::max(std::fabs(n.w), std::fabs(n.z * s.b / s.a));
  return 1 + 2 * std::hypot(s.tx, s.ty) + 2 * reach + std::fabs(s.py) * depth;
}

// The reach of the world's origin for an object where the world matrix puts it; 0 where it is not
// before the eye.
double ReachOfWorld(const DrawMatrices& draw) {
  const ProjectionShape s = ShapeOf(draw.projection);
  const double(&at)[4] = draw.world.m[3];
  double z = 0;
  for (int i = 0; i < 4; ++i) z += at[i] * draw.view.m[i][2];
  const double w = s.is_perspective() ? s.e * z : s.g;
  return w > 0 ? std::hypot(at[0], at[1], at[2]) * std::fabs(s.py) / (2 * w) : 0;
}

// PredictEdgeError of a draw whose cut is not known: of an object around its own origin, which lies
// where the world matrix puts it; 0 where there is no prediction.
double PredictOf(PlaneSpace space, const Plane& view_plane, const DrawMatrices& draw,
                 double image_height) {
  const auto law = [&](PlaneSpace of, double reach) {
    return PredictEdgeError(of, view_plane, draw.projection, image_height, kAnySurface, reach)
        .value;
  };
  const double own = law(space, kAroundOrigin);
  if (space == PlaneSpace::kObject) return own;
  const double world = std::max(kAroundOrigin, ReachOfWorld(draw));
  switch (draw.order) {
    case MatrixOrder::kWorldFirst:
    case MatrixOrder::kFloatViewProjection: return law(space, world);
    case MatrixOrder::kThreeMatrices:
    case MatrixOrder::kFloatWorldView: {
      const bool is_perspective = ShapeOf(draw.projection).is_perspective();
      return std::max(own, law(is_perspective ? PlaneSpace::kXyw1 : PlaneSpace::kClip, world));
    }
    default: return own;
  }
}

// The displacement of the vertices of such an object in the image; 0 where there is no prediction.
double VerticesOf(const DrawMatrices& draw, double image_height) {
  using enum MatrixOrder;
  const bool is_of_world = draw.order != kOneMatrix && draw.order != kWorldViewFirst;
  const double reach = is_of_world ? std::max(kAroundOrigin, ReachOfWorld(draw)) : kAroundOrigin;
  return 0x1p-24 * image_height / 2 * kVertexFactor * reach;
}

}  // namespace

Result<double> PredictEdgeError(PlaneSpace space, const Plane& view_plane, const Matrix& projection,
                                double image_height, double sine, double reach) noexcept {
  const double unit = 0x1p-24 * image_height / 2 / sine;
  const bool is_finite =
      std::isfinite(unit) && std::isfinite(sine) && std::isfinite(reach) && IsFinite(view_plane);
  if (!(image_height > 0 && sine > 0 && reach >= 0) || !is_finite)
    return Status::Failure(Error::kNotFinite,
                           "the plane, the image's height, the sine or the reach is not a number "
                           "that an error can be told for");
  if (const Status status = CheckProjection(projection); !status.ok()) return status;
  const ProjectionShape s = ShapeOf(projection);
  if (!s.holds || (space == PlaneSpace::kXyw1 && !s.is_perspective()))
    return Status::Failure(Error::kWrongProjection,
                           "the projection does not have the shape that the space needs");
  const std::optional<Plane> plane = Unit(view_plane);
  if (!plane || (s.is_perspective() ? s.b : s.a) == 0)
    return Status::Failure(Error::kSingular,
                           "the plane has no normal, or the projection no inverse");
  const double pixels = unit * (space == PlaneSpace::kObject ? 1.5 * std::max(reach, 0.1)
                                : s.is_perspective() ? PerspectiveLaw(space, *plane, s, reach)
                                                     : OrthographicLaw(*plane, s, reach));
  if (!std::isfinite(pixels))
    return Status::Failure(Error::kNotFinite, "the error is too large for a double");
  return pixels;
}

namespace {

// The cut of a draw to follow.
struct Followed {
  const Plane& plane;
  KnownIn known_in;
  const SeenCut& cut;
  double image_height, sine;
  bool with_vertices;
};

// The displacement of a draw's edges; without that of its vertices, where it is not wanted.
Result<EdgeDisplacement> Follow(PlaneSpace space, const DrawMatrices& draw,
                                const Followed& followed) {
  const auto& [plane, known_in, cut, image_height, sine, with_vertices] = followed;
  const Step in_view = InView(plane, known_in, draw);
  const Result<PlaneConstant> constant = Finish(ConstantOf(space, plane, known_in, draw, in_view));
  if (!constant.ok()) return constant.status;
  if (!in_view.ok()) return in_view.status;
  const Plane seen = Rounded(in_view.value);
  if (const auto law = PredictEdgeError(space, seen, draw.projection, image_height, sine);
      !law.ok())
    return law.status;
  const SeenDraw seen_draw = {*Unit(seen), Multiply(draw.world, draw.view), draw.projection,
                              PositionArithmetic(draw), with_vertices};
  DistanceArithmetic arithmetic;
  if (space != PlaneSpace::kObject) static_cast<VertexArithmetic&>(arithmetic) = seen_draw.position;
  arithmetic.constant = constant.value.plane;
  arithmetic.is_xyw1 = space == PlaneSpace::kXyw1;
  const EdgeDisplacement pixels = EdgeErrorOf(arithmetic, seen_draw, cut, image_height, sine);
  if (!std::isfinite(pixels.in_image) || !(cut.edge > 0))
    return Status::Failure(Error::kInvalidArgument,
                           "no place of the cut lies before the eye, or its edges have no length");
  return pixels;
}

}  // namespace

Result<double> PredictEdgeError(PlaneSpace space, const Plane& plane, KnownIn known_in,
                                const DrawMatrices& draw, const SeenCut& cut, double image_height,
                                double sine) noexcept {
  const auto all = Follow(space, draw, {plane, known_in, cut, image_height, sine, false});
  if (!all.ok()) return all.status;
  return all.value.along_surface;
}

Result<EdgeDisplacement> PredictEdgeDisplacement(PlaneSpace space, const Plane& plane,
                                                 KnownIn known_in, const DrawMatrices& draw,
                                                 const SeenCut& cut, double image_height,
                                                 double sine) noexcept {
  return Follow(space, draw, {plane, known_in, cut, image_height, sine, true});
}

Result<SpaceConstant> PlaneConstantFor(PlaneSpace space, const Plane& plane, KnownIn known_in,
                                       const DrawMatrices& draw, const Image& image) noexcept {
  // Space `object` does not need the view, but the prediction does: without one the plane is zero.
  const Step in_view = InView(plane, known_in, draw);
  const Result<PlaneConstant> constant = Finish(ConstantOf(space, plane, known_in, draw, in_view));
  if (!constant.ok()) return constant.status;
  SpaceConstant result;
  result.plane = constant.value;
  const Plane seen = Rounded(in_view.value);
  result.edge_error = PredictOf(space, seen, draw, image.height);
  if (result.edge_error > 0) result.vertex_error = VerticesOf(draw, image.height);
  const double off = image.judged_in == JudgedIn::kImage
                         ? std::hypot(result.edge_error, result.vertex_error)
                         : result.edge_error;
  if (off > image.most_pixels) {
    const Result<double> of_one_step = PredictEdgeError(space, seen, draw.projection, image.height);
    const char* const cure =
        of_one_step.value < off / 2
            ? "; multiply its matrices in double, or let the world begin at the camera"
        : space != PlaneSpace::kClip ? ""
        : ShapeOf(draw.projection).is_perspective()
            ? "; use --plane-space=xyw1 or object, or reversed depth"
            : "; use --plane-space=object";
    result.warning =
        Status::Failure(Error::kIllConditioned,
                        "plane space %s displaces the cut by about %.2g pixels of %g rows%s",
                        NameOf(space), off, image.height, cure);
  }
  return result;
}

}  // namespace clipc::runtime
