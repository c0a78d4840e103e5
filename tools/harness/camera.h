// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"
#include "runtime/projection_shape.h"
#include "tools/harness/transform.h"

namespace clipc::harness {

// A camera that looks along +z of its own space, with w = z for a perspective, and depth from 0 to
// w or from -w to w. For row vectors; lengths are in units of the world.
struct Camera {
  bool orthographic = false;
  bool reversed = false;             // z/w is 1 at the near plane
  bool infinite = false;             // there is no far plane
  bool negative_one_to_one = false;  // z/w begins at -1, as OpenGL has it
  double near = 0.1, far = 1000;
  double fov = 60;          // degrees from bottom to top
  double half_height = 10;  // of an orthographic image
  double aspect = 16.0 / 9;
  double offset_x = 0, offset_y = 0;  // of the frustum's axis, in half images: stereo, jitter
  double eye[3] = {0, 0, 0};
  double yaw = 0, pitch = 0, roll = 0;  // radians

  Matrix Projection() const;
  Matrix View() const;                      // world to view
  Matrix ViewToWorld() const;               // its inverse, computed without inverting
  double HalfHeightAt(double depth) const;  // of the image, in the world
  runtime::DepthRange Range() const { return {negative_one_to_one, reversed}; }
};

// A rotation: yaw about y, pitch about x, roll about z. Rows are the rotated axes.
Matrix Rotation(double yaw, double pitch = 0, double roll = 0);

// The projection from view space to Direct3D's clip space, 0 <= z <= w. The field of view is in
// radians from bottom to top; `near` and `far` are distances.
Matrix Perspective(double field_of_view, double aspect, double near, double far);

}  // namespace clipc::harness
