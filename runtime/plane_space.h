// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/clip_plane.h"
#include "runtime/matrix.h"
#include "runtime/status.h"
#include "runtime/table.h"

// From a plane as the application knows it to the constant that a shader's clip table asks for, in
// one call; and what the choice of the plane space costs in pixels. Pure functions: any thread, no
// allocation.
namespace clipc::runtime {

// The space in which the application knows a plane.
enum class KnownIn : std::uint8_t { kObject, kWorld, kView };

// The matrices of one draw: clip = v * world * view * projection. What a conversion does not need
// may stay the identity: xyw1 and clip from a world-space plane need view and projection, object
// from a world-space plane needs world alone.
struct DrawMatrices {
  Matrix world, view, projection;
};

// The picture, to say what an error is worth in it.
struct Picture {
  double height = 1080;      // rows of pixels
  double most_pixels = 0.5;  // an edge may be displaced by so much without a warning
};

struct SpaceConstant {
  PlaneConstant plane;  // what the shader's constant buffer gets
  double edge_error =
      0;  // PredictEdgeError of the space, in pixels; 0 when the plane has no normal
  // ok(), or kIllConditioned with a sentence when edge_error exceeds picture.most_pixels. The
  // constant is as good as that space allows; another space would be better.
  Status warning;
};

// The constant for plane space `space`: every float4 position p of that space (see PlaneSpace) has
// dot(p, constant) equal to the plane's value at the vertex. Computed in double and rounded once.
// Errors: those of ClipPlaneFromWorld, Xyw1PlaneFromView and ObjectPlaneFromWorld. In particular
// kWrongProjection for xyw1 under a projection that is no perspective: with w constant, (x, y, w,
// 1) does not say how deep a vertex lies. Compile such draws with --plane-space=clip, which loses
// nothing there, or with object.
Result<SpaceConstant> PlaneConstantFor(PlaneSpace space, const Plane& plane, KnownIn known_in,
                                       const DrawMatrices& draw,
                                       const Picture& picture = {}) noexcept;

// Surfaces that meet a plane at any angle from 3 degrees on lose, at the 99th percentile, what one
// loses whose sine is this.
inline constexpr double kAnySurface = 0.1;

// The 99th percentile of how far, in pixels, float arithmetic in the vertex shader displaces the
// edge that the plane cuts into a surface; `sine` is that of the angle between surface and plane, 1
// when upright. With u = 2^-24, H rows and the elements of ProjectionShape:
//
//   clip, perspective     2 u Py H/2 (1 + |Cw| |A/B| / |N|) / sine    |A/B| is 1/n for standard
//   depth, 0 or 1/f reversed clip, orthographic    2 u H/2 (1 + Py |Nz| |B/A| / |N|) / sine |B/A|
//   is n for standard depth, f reversed xyw1                  2 u Py H/2 / sine object 2 u H/2 /
//   sine
//
// Tests under tools/study/ hold these against __float128; measured values are between 0.1 and 2
// times the law up to some tens of pixels, where it saturates. It is for objects about as large as
// the picture or smaller; larger ones lose in proportion. Errors: kWrongProjection unless ShapeOf
// holds, and for xyw1 without a perspective; kSingular where the plane has no normal or the
// projection no inverse.
Result<double> PredictEdgeError(PlaneSpace space, const Plane& view_plane, const Matrix& projection,
                                double picture_height, double sine = kAnySurface) noexcept;

}  // namespace clipc::runtime
