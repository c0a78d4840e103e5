// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"
#include "tools/study/camera.h"
#include "tools/study/numbers.h"

namespace clipc::study {

inline constexpr double kPictureWidth = 1920, kPictureHeight = 1080;

// One thing to measure: a camera, a plane, and where the surfaces that it cuts are.
struct Config {
  Camera camera;
  runtime::Plane view_plane;          // unit normal; in the camera's space
  double nearest = 1, farthest = 10;  // view-space depth of the surfaces
  double world_offset =
      0;  // the camera stands so far from the world's origin, and everything with it
  double surface_angle =
      -1;                    // between surface and plane, radians; negative: any from least_sine on
  double least_sine = 0.05;  // 3 degrees
  double plane_scale = 1;    // the world-space plane is this many times the unit one
  double edge_length =
      0.05;  // of the triangle edges, times the depth (orthographic: times half_height)
};

// What an application has for such a draw. Object, world and view matrix, projection and the
// world-space plane are exact doubles: the truth that methods are held against.
struct Setup {
  Config config;
  runtime::Matrix world, view, projection;
  runtime::Matrix world_view, world_view_projection;     // multiplied in double
  runtime::Matrix to_object;                             // from view space, only to make vertices
  runtime::Plane world_plane, view_plane, object_plane;  // in double
};

// Turns the camera a little, so that no element of a matrix is 0 or 1 by accident.
Setup Prepare(const Config& config);

// The plane through a point of view space, with the unit vector along (nx, ny, nz) as normal.
runtime::Plane PlaneThroughPoint(double nx, double ny, double nz, double x, double y, double z);

}  // namespace clipc::study
