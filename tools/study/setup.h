// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "runtime/matrix.h"
#include "tools/study/numbers.h"

namespace clipc::study {

inline constexpr double kPictureWidth = 1920, kPictureHeight = 1080;

// One case to measure: a camera, a plane, and the place of the surfaces that it cuts.
struct Config {
  Camera camera;
  Plane view_plane;                   // unit normal; in the camera's space
  double nearest = 1, farthest = 10;  // view-space depth of the surfaces
  // The distance of the camera, and of everything with it, from the world's origin.
  double world_offset = 0;
  // The distance of the surfaces from their own mesh's origin: a level or a terrain whose vertices
  // are in world coordinates has a large one.
  double mesh_offset = 0;
  // The angle between surface and plane in radians. Negative: any whose sine is least_sine or more.
  double surface_angle = -1;
  double least_sine = 0.05;  // 3 degrees
  double plane_scale = 1;    // the length of the world-space plane's normal
  // The length of the triangle edges, as a multiple of the depth (orthographic: of half_height).
  double edge_length = 0.05;
};

// The matrices and planes that an application has for such a draw. The world and view matrix, the
// projection and the world-space plane are exact doubles: methods are compared with their results.
struct Setup {
  Config config;
  Matrix world, view, projection;
  Matrix world_view, world_view_projection;     // multiplied in double
  Matrix to_object;                             // from view space, only to make vertices
  Plane world_plane, view_plane, object_plane;  // in double
};

// Makes the matrices and planes. Turns the camera a little, so that no element of a matrix is 0 or
// 1 by accident.
Setup Prepare(const Config& config);

// The plane through that point whose unit normal has that direction.
Plane PlaneThroughPoint(Vector direction, Vector point);

}  // namespace clipc::study
