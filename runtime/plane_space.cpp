// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/plane_space.h"

#include <cmath>

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

}  // namespace

Result<double> PredictEdgeError(PlaneSpace space, const Plane& view_plane, const Matrix& projection,
                                double picture_height, double sine, double reach) noexcept {
  const double unit = 2 * 0x1p-24 * picture_height / 2 / sine;
  const Plane& c = view_plane;
  if (!(picture_height > 0 && sine > 0 && reach >= 0) ||
      !std::isfinite(unit + reach + c.x + c.y + c.z + c.w))
    return Status::Failure(Error::kNotFinite,
                           "the plane, the picture's height, the sine or the reach is not a number "
                           "that an error can be told for");
  if (const Status status = CheckProjection(projection); !status.ok()) return status;
  const ProjectionShape s = ShapeOf(projection);
  const double length = NormalLength(view_plane);
  const bool wrong = !s.holds || (space == PlaneSpace::kXyw1 && !s.is_perspective());
  if (wrong)
    return Status::Failure(Error::kWrongProjection,
                           "the projection does not have the shape that the space needs");
  if (!(length > 0) || (s.is_perspective() ? s.b : s.a) == 0)
    return Status::Failure(Error::kSingular,
                           "the plane has no normal, or the projection no inverse");
  const double py = s.is_perspective() ? std::fabs(s.py) : 1;
  if (space == PlaneSpace::kObject) return unit * (1 + reach);
  const double floor = unit * (py + reach);
  if (space == PlaneSpace::kXyw1) return floor;
  const double price =
      ClipSpaceEdgeError(view_plane, projection, picture_height).value * kAnySurface / sine;
  // A perspective divides what the position loses by what is left of z.
  return floor + price * (s.is_perspective() ? 1 + reach / py : 1);
}

Result<SpaceConstant> PlaneConstantFor(PlaneSpace space, const Plane& plane, KnownIn known_in,
                                       const DrawMatrices& draw, const Picture& picture) noexcept {
  // Space `object` does not need the view, but the prediction does.
  const Step in_view = InView(plane, known_in, draw);
  const Result<PlaneConstant> constant = Finish(ConstantOf(space, plane, known_in, draw, in_view));
  if (!constant.ok()) return constant.status;
  SpaceConstant result;
  result.plane = constant.value;
  if (!in_view.ok()) return result;
  const Plane seen = Rounded(in_view.value);
  const Result<double> error = PredictEdgeError(space, seen, draw.projection, picture.height);
  if (!error.ok()) return result;
  result.edge_error = error.value;
  if (error.value > picture.most_pixels) {
    result.warning =
        Status::Failure(Error::kIllConditioned,
                        "plane space %s displaces the cut by about %.2g pixels of %g rows%s",
                        NameOf(space), error.value, picture.height,
                        space != PlaneSpace::kClip ? ""
                        : ShapeOf(draw.projection).is_perspective()
                            ? "; use --plane-space=xyw1 or object, or reversed depth"
                            : "; use --plane-space=object");
  }
  return result;
}

}  // namespace clipc::runtime
