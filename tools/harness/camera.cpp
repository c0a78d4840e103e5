// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/camera.h"

#include <cmath>
#include <numbers>

namespace clipc::harness {

Matrix Rotation(double yaw, double pitch, double roll) {
  const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
  const double cr = std::cos(roll), sr = std::sin(roll);
  const Matrix about_y = {{{cy, 0, -sy, 0}, {0, 1, 0, 0}, {sy, 0, cy, 0}, {0, 0, 0, 1}}};
  const Matrix about_x = {{{1, 0, 0, 0}, {0, cp, sp, 0}, {0, -sp, cp, 0}, {0, 0, 0, 1}}};
  const Matrix about_z = {{{cr, sr, 0, 0}, {-sr, cr, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  return Multiply(Multiply(about_z, about_x), about_y);
}

Matrix Camera::Projection() const {
  const double low = negative_one_to_one ? -1 : 0;
  const double at_near = reversed ? 1 : low, at_far = reversed ? low : 1;
  if (orthographic) {
    const double a = (at_far - at_near) / (far - near);
    return {{{1 / (aspect * half_height), 0, 0, 0},
             {0, 1 / half_height, 0, 0},
             {0, 0, a, 0},
             {offset_x, offset_y, at_near - a * near, 1}}};
  }
  const double py = 1 / std::tan(fov * std::numbers::pi / 360);
  const double a = infinite ? at_far : (at_far * far - at_near * near) / (far - near);
  const double b =
      infinite ? (at_near - at_far) * near : (at_near - at_far) * near * far / (far - near);
  return {{{py / aspect, 0, 0, 0}, {0, py, 0, 0}, {offset_x, offset_y, a, 1}, {0, 0, b, 0}}};
}

Matrix Camera::ViewToWorld() const {
  Matrix to = Rotation(yaw, pitch, roll);
  for (int j = 0; j < 3; ++j) to.m[3][j] = eye[j];
  return to;
}

Matrix Camera::View() const {
  const Matrix axes = Rotation(yaw, pitch, roll);
  Matrix view = runtime::Transpose(axes);
  for (int j = 0; j < 3; ++j) {
    view.m[3][j] = 0;
    for (int i = 0; i < 3; ++i) view.m[3][j] -= eye[i] * view.m[i][j];
  }
  return view;
}

double Camera::HalfHeightAt(double depth) const {
  return orthographic ? half_height : depth * std::tan(fov * std::numbers::pi / 360);
}

Matrix Perspective(double field_of_view, double aspect, double near, double far) {
  Camera camera;
  camera.fov = field_of_view * 180 / std::numbers::pi;
  camera.aspect = aspect, camera.near = near, camera.far = far;
  return camera.Projection();
}

}  // namespace clipc::harness
