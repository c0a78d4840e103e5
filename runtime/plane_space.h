// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/clip_plane.h"
#include "runtime/matrix.h"
#include "runtime/status.h"
#include "runtime/table.h"

// From a plane as the application knows it to the constant that a shader's clip table asks for, in one call; and what the
// choice of the plane space costs in pixels. Pure functions: any thread, no allocation.
namespace clipc::runtime {

// The space in which the application knows a plane.
enum class KnownIn : std::uint8_t { kObject, kWorld, kView };

// The matrices of one draw: clip = v * world * view * projection. What a conversion does not need may stay the identity:
// xyw1 and clip from a world-space plane need view and projection, object from a world-space plane needs world alone.
struct DrawMatrices {
  Matrix world, view, projection;
};

// The picture, to say what an error is worth in it.
struct Picture {
  double height = 1080;     // rows of pixels
  double most_pixels = 0.5;  // an edge may be displaced by so much without a warning
};

struct SpaceConstant {
  PlaneConstant plane;    // what the shader's constant buffer gets
  double edge_error = 0;  // PredictEdgeError of the space, in pixels; 0 when the plane has no normal
  // ok(), or kIllConditioned with a sentence when edge_error exceeds picture.most_pixels. The constant is as good as that
  // space allows; another space would be better.
  Status warning;
};

// The constant for plane space `space`: every float4 position p of that space (see PlaneSpace) has dot(p, constant) equal
// to the plane's value at the vertex. Computed in double and rounded once.
// Errors: those of ClipPlaneFromWorld, Xyw1PlaneFromView and ObjectPlaneFromWorld. In particular kWrongProjection for xyw1
// under a projection that is no perspective: with w constant, (x, y, w, 1) does not say how deep a vertex lies. Compile
// such draws with --plane-space=clip, which loses nothing there, or with object.
Result<SpaceConstant> PlaneConstantFor(PlaneSpace space, const Plane& plane, KnownIn known_in, const DrawMatrices& draw,
                                       const Picture& picture = {}) noexcept;

// The 99th percentile of how far, in pixels, float arithmetic in the vertex shader displaces the edge that the plane cuts
// into a surface that meets it at `sine` (the sine of the angle between surface and plane; 1 is upright):
//
//   clip             20 u (1 + |Cw| |A/B|) Py H / (2 |N|) / sine     u = 2^-24; |A/B| is 1/n for standard depth
//   xyw1, object     20 u                  Py H / 2       / sine
//   orthographic     20 u                  H / 2          / sine     every space
//
// Tests under study/ hold these against __float128: the first is right within a factor of two where |Cw|/n is 30 or more, up
// to some tens of pixels; the others are what remains without depth. They hold for vertices whose coordinates are not large
// against their distance from the eye.
// Errors: kWrongProjection unless ShapeOf holds; kSingular where the plane has no normal or the projection no inverse.
Result<double> PredictEdgeError(PlaneSpace space, const Plane& view_plane, const Matrix& projection,
                                double picture_height, double sine = 1) noexcept;

}  // namespace clipc::runtime
