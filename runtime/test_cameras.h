// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "runtime/matrix.h"
#include "runtime/projection_shape.h"

// Cameras and random geometry for tests; equal seeds give equal numbers on every machine.
namespace clipc::runtime {

// A type of twice double's precision, where there is one, for numbers that tests take for exact.
#if defined(__SIZEOF_FLOAT128__)
using Wide = __float128;
#else
using Wide = long double;
#endif

class Random {
 public:
  explicit Random(std::uint32_t seed) : bits_(seed) {}
  // A random number in [low, high).
  double Between(double low, double high) {
    const double unit =
        (static_cast<double>(bits_() >> 5) * 0x1p26 + static_cast<double>(bits_() >> 6)) * 0x1p-53;
    return low + (high - low) * unit;
  }
  // A random number from low to high with an even logarithm: for sizes and distances.
  double Magnitude(double low, double high) {
    return std::exp(Between(std::log(low), std::log(high)));
  }
  std::uint32_t Below(std::uint32_t limit) { return static_cast<std::uint32_t>(bits_() % limit); }
  // A plane with a unit normal of any direction.
  Plane PlaneAt(double offset) {
    double x, y, z, length;
    do {
      x = Between(-1, 1), y = Between(-1, 1), z = Between(-1, 1);
      length = std::sqrt(x * x + y * y + z * z);
    } while (length < 0.1 || length > 1);
    return {x / length, y / length, z / length, offset};
  }
  // A rotation about a random axis, then a translation by up to `offset` in each direction.
  Matrix Rigid(double offset) {
    const Plane axis = PlaneAt(0);
    const double angle = Between(-3, 3), c = std::cos(angle), s = std::sin(angle), t = 1 - c;
    const double x = axis.x, y = axis.y, z = axis.z;
    const auto shift = [&] { return offset == 0 ? 0 : Between(-offset, offset); };
    return {{{t * x * x + c, t * x * y + s * z, t * x * z - s * y, 0},
             {t * x * y - s * z, t * y * y + c, t * y * z + s * x, 0},
             {t * x * z + s * y, t * y * z - s * x, t * z * z + c, 0},
             {shift(), shift(), shift(), 1}}};
  }
  // A matrix with elements of all sizes, of which one row is, but for `away` of it, a combination
  // of the first two.
  Matrix NearlySingular(int row, double away) {
    Matrix matrix;
    for (auto& each : matrix.m) {
      for (double& element : each) element = Between(-1, 1) * Magnitude(1e-3, 1e3);
    }
    for (int j = 0; j < 4; ++j)
      matrix.m[row][j] = matrix.m[0][j] * 2 - matrix.m[1][j] + away * matrix.m[row][j];
    return matrix;
  }

 private:
  std::mt19937 bits_;
};

struct Camera {
  std::string name;
  Matrix projection;
  DepthRange range;
  bool perspective = true;
  double forward = 1;  // the view looks along forward * z
  double near = 0.1;
  double far = 100;  // infinity for an infinite perspective
};

// The view-space point at depth `s` (forward is positive) whose position on the image is (x, y)
// in [-1, 1].
inline std::vector<double> ViewPoint(const Camera& camera, double x, double y, double s) {
  const auto& m = camera.projection.m;
  const double z = camera.forward * s;
  const double w = z * m[2][3] + m[3][3];
  return {(x * w - z * m[2][0] - m[3][0]) / m[0][0], (y * w - z * m[2][1] - m[3][1]) / m[1][1], z,
          1};
}

inline Camera PerspectiveCamera(double near, double far, DepthRange range = {}, double forward = 1,
                                double ox = 0, double oy = 0, double fov_degrees = 60) {
  Camera camera{"perspective", {}, range, true, forward, near, far};
  const double py = 1 / std::tan(fov_degrees * 3.14159265358979323846 / 360);
  // z/w is `at_near` at n and `at_far` at f; with w = s: z = a s + b.
  const double low = range.negative_one_to_one ? -1 : 0;
  const double at_near = range.reversed ? 1 : low, at_far = range.reversed ? low : 1;
  const double a = std::isinf(far) ? at_far : (at_far * far - at_near * near) / (far - near);
  const double b =
      std::isinf(far) ? (at_near - at_far) * near : (at_near - at_far) * near * far / (far - near);
  camera.projection = {
      {{py * 9 / 16, 0, 0, 0}, {0, py, 0, 0}, {ox, oy, forward * a, forward}, {0, 0, b, 0}}};
  return camera;
}

inline Camera OrthographicCamera(double near, double far, DepthRange range = {}, double forward = 1,
                                 double tx = 0, double ty = 0) {
  Camera camera{"orthographic", {}, range, false, forward, near, far};
  const double low = range.negative_one_to_one ? -1 : 0;
  const double at_near = range.reversed ? 1 : low, at_far = range.reversed ? low : 1;
  const double a = (at_far - at_near) / (far - near);
  camera.projection = {
      {{0.05, 0, 0, 0}, {0, 0.1, 0, 0}, {0, 0, forward * a, 0}, {tx, ty, at_near - a * near, 1}}};
  return camera;
}

// Cameras of every convention: handedness, depth range, reversed, infinite, centred or not,
// orthographic.
inline std::vector<Camera> AllCameras() {
  std::vector<Camera> cameras;
  for (const double forward : {1.0, -1.0}) {
    for (const bool negative : {false, true}) {
      for (const bool reversed : {false, true}) {
        const DepthRange range{negative, reversed};
        const auto add = [&](Camera camera, const char* what) {
          camera.name += std::string(" ") + what +
                         (forward > 0 ? " left-handed" : " right-handed") +
                         (negative ? " [-1,1]" : " [0,1]") + (reversed ? " reversed" : "");
          cameras.push_back(camera);
        };
        add(PerspectiveCamera(0.1, 100, range, forward), "centred");
        add(PerspectiveCamera(0.01, 1e6, range, forward), "deep");
        add(PerspectiveCamera(0.1, INFINITY, range, forward), "infinite");
        add(PerspectiveCamera(0.1, 100, range, forward, 0.3, -0.2), "off-centre");
        add(PerspectiveCamera(0.1, 100, range, forward, 1.0 / 1920, 1.0 / 1080), "jittered");
        add(OrthographicCamera(0.1, 100, range, forward), "centred");
        add(OrthographicCamera(0, 50, range, forward, 0.25, -0.5), "off-centre");
      }
    }
  }
  return cameras;
}

}  // namespace clipc::runtime
