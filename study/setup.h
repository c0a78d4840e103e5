// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <vector>

#include "runtime/matrix.h"
#include "study/numbers.h"

namespace clipc::study {

// The rows of the image that errors are given for; it has as many columns as the aspect says.
inline constexpr double kImageHeight = 1080;

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
  double least_sine = 0.05;     // 3 degrees
  double plane_scale = 1;       // the length of the world-space plane's normal
  bool mirrored = false;        // the view contains a mirror, as for a reflection
  double scale[3] = {1, 1, 1};  // of the object's axes
  // The length of the triangle edges, as a multiple of the depth (orthographic: of half_height).
  double edge_length = 0.05;
};

// The matrices and planes that an application has for such a draw. The world and view matrix, the
// projection and the world-space plane are exact doubles: methods are compared with their results.
struct Setup {
  Config config;
  Matrix world, view, projection;
  Matrix world_view, world_view_projection;     // multiplied in double
  Mat4<double> to_object;                       // from view space, only to make vertices
  Plane world_plane, view_plane, object_plane;  // in double
  // The part of the cut to measure, as VisibleCut returns it; if empty, `config` gives the part.
  std::vector<Vector> cut;

  double EdgeInHalfImages() const;  // config.edge_length at any depth
};

// Sets the matrices that follow from world, view and projection.
void Compose(Setup& setup);

// Makes the matrices and planes. Turns the camera a little, so that no element of a matrix is 0 or
// 1 by accident.
Setup Prepare(const Config& config);

// A random place of the visible cut in view space: a place of `setup.cut`, evenly over the image,
// or, if that is empty, a point of the frustum, at a depth of the surfaces, moved to the plane
// along its normal; none where the moved point is outside of the image.
std::optional<Vector> RandomCut(const Setup& setup, Random& random);

// At most `count` random places of the cut, the same in every call.
std::vector<Vector> RandomCuts(const Setup& setup, std::size_t count);

// The place in view space of the origin of the space that `to_view` transforms from.
Vector OriginInView(const Matrix& to_view);

// The plane through that point whose unit normal has that direction.
Plane PlaneThroughPoint(Vector direction, Vector point);
// Sets the plane through `point` across `direction`, and the surfaces from half to twice the depth
// of the point.
void CutThrough(Config& config, Vector direction, Vector point);

}  // namespace clipc::study
