// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"
#include "runtime/status.h"

// Planes for shaders and devices: from the space in which an application knows a plane to the
// constants that dot with what a vertex shader has. Computed in double, rounded to float once. Pure
// functions: any thread, no allocation.
//
// Every function reports kNotFinite for NaN or infinity in what it is given. The zero plane gives
// the zero constant.
namespace clipc::runtime {

// A plane in another space.
struct PlaneConstant {
  Float4 constant;       // rounded: for the constant buffer or SetClipPlane
  Plane plane;           // the same before rounding: to compute on with
  double condition = 0;  // `plane` may be off by about condition * 2^-53 of its largest component
};

// The largest condition at which the rounded constant can be trusted to about one unit in the last
// place of its largest component; above it the functions report kIllConditioned.
inline constexpr double kMaxCondition = 1 << 25;

// The largest component of a constant lies between these, or is 0; outside the functions report
// kNotRepresentable. Below, its small components would be denormal, which devices flush to 0;
// above, the clipper's interpolation overflows.
inline constexpr float kMinPlaneScale = 0x1p-100f;
inline constexpr float kMaxPlaneScale = 0x1p112f;

// Rounds `plane`. Errors: kNotFinite, kNotRepresentable.
Result<Float4> RoundPlane(const Plane& plane) noexcept;

// C_P with dot(v * projection, C_P) == dot(v, view_plane) for every v: what [clipplanes] and
// SetClipPlane want. Solves projection * C_P = view_plane for any invertible projection:
// perspective and orthographic, either handedness, either depth range, reversed, infinite,
// off-centre, jittered. Where ShapeOf holds, by that shape's closed form; else by elimination.
// Errors: kSingular, kIllConditioned, kNotRepresentable.
Result<PlaneConstant> ClipPlaneFromView(const Plane& view_plane, const Matrix& projection) noexcept;

// The same from a plane in world space. Never inverts view * projection, whose translation would
// cost digits.
Result<PlaneConstant> ClipPlaneFromWorld(const Plane& world_plane, const Matrix& view,
                                         const Matrix& projection) noexcept;

// The same from a plane in the object's own space.
Result<PlaneConstant> ClipPlaneFromObject(const Plane& object_plane, const Matrix& world,
                                          const Matrix& view, const Matrix& projection) noexcept;

// A world-space plane in view space; `view` may be a mirrored one. Errors as above.
Result<PlaneConstant> ViewPlaneFromWorld(const Plane& world_plane, const Matrix& view) noexcept;

// The closed form that "User clip planes on feature level 9 hardware" (section "Clip space clip
// plane") derives: C_P = (Cx/Px, Cy/Py, Cw/B, Cz - Cw A/B). Only for the matrix that the section
// shows: [Px 0 0 0; 0 Py 0 0; 0 0 A 1; 0 0 B 0], a left-handed, centred perspective with either
// depth range, reversed or infinite or not. Errors: kWrongProjection for any other.
Result<PlaneConstant> DocumentClipPlane(const Plane& view_plane, const Matrix& projection) noexcept;

// K with dot(float4(pos.xy, pos.w, 1), K) == dot(v, view_plane) for pos = v * projection: the
// constant for plane space `xyw1`. Leaving z out makes it a thousand times more accurate than C_P
// where depth is not reversed. K = (Cx/Px, Cy/Py, (Cz - ox Cx/Px - oy Cy/Py)/e, Cw). Errors:
// kWrongProjection unless ShapeOf finds a perspective with tx = ty = 0; for orthographic
// projections C_P is as good.
Result<PlaneConstant> Xyw1PlaneFromView(const Plane& view_plane, const Matrix& projection) noexcept;

// C_obj with dot(v, C_obj) == dot(v * world, world_plane): the constant for plane space `object`,
// the most accurate of all. C_obj = world * world_plane; `world` need not be invertible. From a
// view-space plane, give it world * view.
Result<PlaneConstant> ObjectPlaneFromWorld(const Plane& world_plane, const Matrix& world) noexcept;

// What of PredictEdgeError (plane_space.h) is the price of plane space `clip`, for surfaces of
// every direction: 20 u |Cw| |A/B| Py H / (2 |N|) with u = 2^-24 for a perspective and a picture of
// H rows, 20 u Py |Nz| |B/A| H / (2 |N|) for an orthographic projection. |A/B| is 1/n for standard
// depth and 0 or 1/f for reversed, |B/A| is n and f; `xyw1` and `object` do not pay that. Errors:
// kWrongProjection unless ShapeOf holds; kSingular where the plane has no normal or the projection
// no inverse.
Result<double> ClipSpaceEdgeError(const Plane& view_plane, const Matrix& projection,
                                  double picture_height) noexcept;

}  // namespace clipc::runtime
