// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/plane_space.h"
#include "study/setup.h"

namespace clipc::study {

// The arithmetic of a vertex shader in float32: returns the signed distance that the clipper gets
// for a vertex of object space, times any positive number. The constants come from clipc::runtime
// where clipc has the method.
using Distance = std::function<double(const Vec4<float>& vertex)>;

// A way to clip.
struct Method {
  std::string name;
  // Returns none where the method cannot be used: xyw1 without a perspective, the near plane with
  // the eye on the kept side.
  std::function<std::optional<Distance>(const Setup&)> prepare;
  // Whether the cut becomes a float vertex of object space, instead of a place that the clipper
  // finds.
  bool makes_vertices = false;
  // How float multiplies the matrices that make the positions of vertices.
  runtime::MatrixOrder order = runtime::MatrixOrder::kOneMatrix;
};

// The clip-space position of a vertex by matrices that float multiplies in that order.
using Position = std::function<Vec4<float>(const Vec4<float>& vertex)>;
Position PositionBy(runtime::MatrixOrder order, const Setup& setup);

// The same distances, for positions by matrices that float multiplies in that order.
Method InOrder(Method method, runtime::MatrixOrder order);

Method ClipSpace();    // [clipplanes] as fxc compiles it: dot(SV_Position, C_P); also SetClipPlane
Method Xyw1Space();    // --plane-space=xyw1
Method ObjectSpace();  // --plane-space=object
// `clip` and `xyw1` whose matrices float multiplies in that order; `clip-steps` is kWorldFirst,
// `clip-product` kFloatWorldView.
Method ClipSpaceBy(runtime::MatrixOrder order);
Method Xyw1SpaceBy(runtime::MatrixOrder order);
Method WorldSpace();  // SV_ClipDistance from a float world-space vertex
Method ViewSpace();   // SV_ClipDistance from a float view-space vertex
// C_P by its published closed form, C_P = (Cx/Px, Cy/Py, Cw/B, Cz - Cw A/B), each operation in
// float32.
Method DocumentFormula();
// C_P by a float32 inverse of the float32 view * projection.
Method FloatInverse();
// The near plane sheared with Lengyel's scale: runtime::SetDepthColumn in double, rounded once.
Method NearPlane();
Method NearPlaneFloat();  // the near plane by a product of float32 matrices
// The product of NearPlaneFloat, from object to clip space.
Mat4<float> FloatNearPlane(const Setup& setup, const Plane& world_plane);
Method CpuDouble();  // vertices clipped by the application in double

// All methods above.
std::vector<Method> AllMethods();

}  // namespace clipc::study
