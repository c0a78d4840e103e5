// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/sweeps.h"

namespace clipc::study {
namespace {

class Sweeps {
 public:
  explicit Sweeps(bool quick) : quick_(quick) {}

  std::vector<SweepPoint> Run() {
    Ratios();
    Views();
    Grounds();
    Offsets();
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
    // Tiles of an image that is several times as large: the plane goes through the tile's middle.
    for (const double offset : Some({1, 2, 3, 5})) {
      Config config = ObliqueAt(30);
      config.camera.offset_x = offset, config.camera.offset_y = 0.7 * offset;
      const Matrix p = config.camera.Projection();
      config.view_plane = PlaneThroughPoint(
          {0.4, 0.5, 0.77}, {-offset / p.m[0][0] * 30, -0.7 * offset / p.m[1][1] * 30, 30});
      Add("tile, half images off the axis", offset, config);
    }
  }

  // A floor that is seen from one unit on.
  void Grounds() {
    for (const double far : Some({3, 30, 300, 1000})) {
      Config config = ObliqueAt(10);
      config.view_plane = PlaneThroughPoint({0.05, 1, 0.02}, {0, -1, 0});
      config.nearest = 1, config.farthest = far;
      Add("ground, seen from 1 to", far, config);
    }
  }

  void Offsets() {
    for (const double offset : Some({1, 10, 100, 1e3, 3e3, 1e4, 3e4})) {
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
