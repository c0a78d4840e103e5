// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"
#include "runtime/projection_shape.h"

namespace clipc::study {

// A camera that looks along +z of its own space, with w = z for a perspective; row vectors; lengths
// in world units.
struct Camera {
  bool orthographic = false;
  bool reversed = false;  // z/w is 1 at the near plane
  bool infinite = false;  // no far plane
  double near = 0.1, far = 1000;
  double fov = 60;          // degrees from bottom to top
  double half_height = 10;  // of an orthographic picture
  double aspect = 16.0 / 9;
  double offset_x = 0, offset_y = 0;  // of the frustum's axis, in half pictures: stereo, jitter
  double eye[3] = {0, 0, 0};
  double yaw = 0, pitch = 0, roll = 0;  // radians

  runtime::Matrix Projection() const;
  runtime::Matrix View() const;         // world to view
  runtime::Matrix ViewToWorld() const;  // its inverse, computed without inverting
  runtime::DepthRange Range() const { return {false, reversed}; }
};

// A rotation: yaw about y, pitch about x, roll about z. Rows are the rotated axes.
runtime::Matrix Rotation(double yaw, double pitch, double roll);

}  // namespace clipc::study
