// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cmath>

#include "runtime/matrix.h"

// The few matrices that the examples need, for row vectors as in Direct3D: v * World * View *
// Projection. The world is left-handed with y up; angles are in radians.
namespace clipc::examples {

using runtime::Matrix;
using runtime::Multiply;

struct Vector {
  double x, y, z;
};

inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector Cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector Unit(Vector v) {
  const double length = std::sqrt(Dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

inline Matrix Translation(double x, double y, double z) {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {x, y, z, 1}}};
}

inline Matrix Scaling(double s) {
  return {{{s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}}};
}

inline Matrix RotationY(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}}};
}

// World to view space: the viewer at `eye` looks at `target` along +z.
inline Matrix LookAt(Vector eye, Vector target) {
  const Vector z = Unit(target - eye), x = Unit(Cross({0, 1, 0}, z)), y = Cross(z, x);
  return {{{x.x, y.x, z.x, 0},
           {x.y, y.y, z.y, 0},
           {x.z, y.z, z.z, 0},
           {-Dot(x, eye), -Dot(y, eye), -Dot(z, eye), 1}}};
}

// View to Direct3D's clip space, 0 <= z <= w. `near_z` and `far_z` are distances.
inline Matrix Perspective(double vertical_field_of_view, double aspect, double near_z,
                          double far_z) {
  const double py = 1 / std::tan(vertical_field_of_view / 2), a = far_z / (far_z - near_z);
  return {{{py / aspect, 0, 0, 0}, {0, py, 0, 0}, {0, 0, a, 1}, {0, 0, -near_z * a, 0}}};
}

// Row after row: what glUniformMatrix4fv takes without transposing, and what lies in a constant
// buffer that was compiled with -Zpr.
inline std::array<float, 16> Floats(const Matrix& matrix) {
  std::array<float, 16> floats;
  for (int i = 0; i < 16; ++i) floats[i] = static_cast<float>(matrix.m[i / 4][i % 4]);
  return floats;
}

}  // namespace clipc::examples
