// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cmath>

#include "runtime/matrix.h"

// Vectors and matrices for row vectors as in Direct3D: v * World * View * Projection. The world is
// left-handed with y up.
namespace clipc::harness {

using runtime::Matrix;
using runtime::Multiply;

struct Vector {
  double x, y, z;
};

inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator*(double s, Vector v) { return {s * v.x, s * v.y, s * v.z}; }
inline Vector operator/(Vector v, double s) { return {v.x / s, v.y / s, v.z / s}; }
inline double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector Cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector Unit(Vector v) { return v / std::sqrt(Dot(v, v)); }

inline Matrix Translation(double x, double y, double z) {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {x, y, z, 1}}};
}

inline Matrix Scaling(double s) {
  return {{{s, 0, 0, 0}, {0, s, 0, 0}, {0, 0, s, 0}, {0, 0, 0, 1}}};
}

// The matrix from world to view space: the viewer at `eye` looks at `target` along +z.
inline Matrix LookAt(Vector eye, Vector target) {
  const Vector z = Unit(target - eye), x = Unit(Cross({0, 1, 0}, z)), y = Cross(z, x);
  return {{{x.x, y.x, z.x, 0},
           {x.y, y.y, z.y, 0},
           {x.z, y.z, z.z, 0},
           {-Dot(x, eye), -Dot(y, eye), -Dot(z, eye), 1}}};
}

// The elements row after row, as glUniformMatrix4fv reads them without transposing, and as they lie
// in a constant buffer that was compiled with -Zpr.
inline std::array<float, 16> Floats(const Matrix& matrix) {
  std::array<float, 16> floats;
  for (int i = 0; i < 16; ++i) floats[i] = static_cast<float>(matrix.m[i / 4][i % 4]);
  return floats;
}

}  // namespace clipc::harness
