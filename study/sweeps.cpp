// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/sweeps.h"

#include <cmath>
#include <numbers>

namespace clipc::study {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class Sweeps {
 public:
  explicit Sweeps(bool quick) : quick_(quick) {}

  std::vector<SweepPoint> Run() {
    Ratios();
    Views();
    Planes();
    Offsets();
    Sizes();
    return std::move(points_);
  }

 private:
  void Add(const char* sweep, double parameter, const Config& config) {
    points_.push_back({sweep, parameter, config});
  }
  // The values to take: all, or in a quick run each second one from the last on.
  std::vector<double> Some(std::vector<double> values) const {
    std::vector<double> some;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!quick_ || (values.size() - 1 - i) % 3 == 0) some.push_back(values[i]);
    }
    return some;
  }

  void Ratios() {
    for (const double ratio : Some({1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8})) {
      const double far = 0.1 * ratio, depth = 0.3 * far;
      Config config = ObliqueAt(depth, 0.1, far);
      Add("far/near", ratio, config);
      config.camera.infinite = true;
      Add("far/near, infinite", ratio, config);
      config.camera.reversed = true;
      Add("far/near, reversed infinite", ratio, config);
      config.camera.infinite = false;
      Add("far/near, reversed", ratio, config);
    }
    for (const double ratio : Some({3, 30, 100, 300, 1000, 3000, 3e4})) {
      Add("eye to plane / near", ratio, ObliqueAt(0.1 * ratio / 0.77, 0.1, 1e6));
    }
  }

  void Views() {
    for (const double fov : Some({1, 2, 5, 10, 20, 60, 90, 120, 150, 170})) {
      Config config = ObliqueAt(30);
      config.camera.fov = fov;
      Add("field of view", fov, config);
    }
    for (const double size : Some({1, 100, 1e4, 1e6})) {
      Config config = ObliqueAt(0.4 * size, 0.001 * size, size);
      config.camera.orthographic = true, config.camera.half_height = 0.2 * size;
      config.nearest = 0.2 * size, config.farthest = 0.9 * size;
      config.view_plane = PlaneThroughPoint({0.4, 0.5, 0.77}, {0, 0, 0.4 * size});
      Add("orthographic, size", size, config);
    }
    for (const double offset : Some({0, 1e-4, 1.0 / 1920, 1e-3, 1e-2, 0.1, 1})) {
      Config config = ObliqueAt(30);
      config.camera.offset_x = offset, config.camera.offset_y = 0.7 * offset;
      Add("off centre", offset, config);
    }
    // Tiles of a picture that is several times as large: the plane goes through the tile's middle.
    for (const double offset : Some({1, 2, 3, 5})) {
      Config config = ObliqueAt(30);
      config.camera.offset_x = offset, config.camera.offset_y = 0.7 * offset;
      const Matrix p = config.camera.Projection();
      config.view_plane = PlaneThroughPoint(
          {0.4, 0.5, 0.77}, {-offset / p.m[0][0] * 30, -0.7 * offset / p.m[1][1] * 30, 30});
      Add("tile, half pictures off the axis", offset, config);
    }
    for (const double ratio : Some({10, 100, 1000, 1e4})) {
      Config config = ObliqueAt(0.1 * ratio / 0.77, 0.1, 1e6);
      config.camera.negative_one_to_one = true, config.camera.reversed = true;
      Add("eye to plane / near, reversed from 1 to -1", ratio, config);
    }
  }

  void Planes() {
    for (const double angle : Some({90, 30, 10, 5, 1, 0.1, 0.01})) {
      Config config = ObliqueAt(30);
      config.surface_angle = angle * kDegree;
      Add("surface to plane, degrees", angle, config);
    }
    for (const double angle : Some({90, 45, 10, 1, 0.1, 0.01})) {
      Config config = ObliqueAt(30);
      config.view_plane =
          PlaneThroughPoint({0, std::cos(angle * kDegree), std::sin(angle * kDegree)}, {0, 0, 30});
      config.nearest = 10, config.farthest = 100;
      Add("view to plane, degrees", angle, config);
    }
    for (const double eye : Some({-10, -1, -0.1, -0.01, -1e-4, 0, 1e-4, 0.01, 0.1, 1, 10})) {
      Config config = ObliqueAt(20);
      config.view_plane = PlaneThroughPoint({0.1, 0.9, 0.3}, {0, 0, 0});
      config.view_plane.w = eye, config.nearest = 5, config.farthest = 100;
      Add("eye above plane", eye, config);
    }
    for (const double scale : Some({1e-30, 1e-20, 1e-6, 1, 1e6, 1e20, 1e30})) {
      Config config = ObliqueAt(30);
      config.plane_scale = scale;
      Add("plane scale", scale, config);
    }
  }

  // Triangles much larger than the picture: a ground that reaches to the horizon.
  void Sizes() {
    for (const double length : Some({0.05, 0.5, 5, 50, 500, 5000, 5e4})) {
      Config config = ObliqueAt(10);
      config.edge_length = length;
      Add("edge length / depth", length, config);
    }
    // A floor that is seen from one unit on.
    for (const double far : Some({3, 30, 300, 1000})) {
      Config config = ObliqueAt(10);
      config.view_plane = PlaneThroughPoint({0.05, 1, 0.02}, {0, -1, 0});
      config.nearest = 1, config.farthest = far;
      Add("ground, seen from 1 to", far, config);
    }
  }

  void Offsets() {
    for (const double offset : Some({1, 10, 100, 1e3, 1e4})) {
      Config config = ObliqueAt(10);
      config.mesh_offset = 10 * offset;
      Add("mesh offset / depth", offset, config);
    }
    for (const double depth : Some({3, 30, 300, 3000})) {
      Config config = ObliqueAt(depth, depth / 100, 4 * depth);
      config.camera.orthographic = true, config.camera.half_height = 1;
      Add("orthographic, depth / half height", depth, config);
    }
    for (const double offset : Some({1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7})) {
      Config config = ObliqueAt(10);
      config.world_offset = offset;
      Add("world offset", offset, config);
    }
  }

  bool quick_;
  std::vector<SweepPoint> points_;
};

}  // namespace

Config ObliqueAt(double depth, double near, double far) {
  Config config;
  config.camera.near = near, config.camera.far = far;
  CutThrough(config, {0.4, 0.5, 0.77}, {0, 0, depth});
  return config;
}

std::vector<SweepPoint> AllSweeps(bool quick) { return Sweeps(quick).Run(); }

}  // namespace clipc::study
