// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/regimes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/edges.h"
#include "study/law.h"

namespace clipc::study {
namespace {

using runtime::MatrixOrder;

constexpr double kSaturates = 20;  // pixels

constexpr const char* kNames[kRegimes] = {"one matrix, multiplied in double",
                                          "world, then (view projection)",
                                          "(world view), then projection",
                                          "world, view, projection",
                                          "(world view) projection, in float",
                                          "world (view projection), in float",
                                          "mesh offset",
                                          "world space",
                                          "orthographic",
                                          "-1 to 1",
                                          "off centre",
                                          "ground",
                                          "mirrored",
                                          "uneven scale",
                                          "clipped by the application"};

// The orders of the regimes that begin with them.
constexpr MatrixOrder kOrders[] = {MatrixOrder::kOneMatrix,      MatrixOrder::kWorldFirst,
                                   MatrixOrder::kWorldViewFirst, MatrixOrder::kThreeMatrices,
                                   MatrixOrder::kFloatWorldView, MatrixOrder::kFloatViewProjection};

// A camera, a plane through the view's axis and an object there.
Config Ordinary(Random& random) {
  Config config;
  Camera& camera = config.camera;
  camera.near = random.Magnitude(1e-3, 1);
  const double depth = camera.near * random.Magnitude(4, 1e4);
  camera.far = depth * random.Magnitude(4, 1e4);
  camera.fov = random.Magnitude(5, 120);
  camera.aspect = random.Between(1, 2.4);
  camera.reversed = random.Below(4) == 0, camera.infinite = random.Below(4) == 0;
  camera.yaw = random.Between(-3, 3), camera.pitch = random.Between(-1, 1);
  CutThrough(config, random.Direction(), {0, 0, depth});
  return config;
}

void MakeOrthographic(Config& config, Random& random) {
  Camera& camera = config.camera;
  camera.orthographic = true, camera.infinite = false;
  camera.reversed = random.Below(3) == 0;
  const double depth = std::sqrt(config.nearest * config.farthest);
  camera.half_height = depth / random.Magnitude(0.3, 3000);
  camera.far = depth * random.Magnitude(4, 10);
}

// A floor below the eye, or a wall beside it, that is seen from 1 to as much as 1000 units.
void MakeGround(Config& config, Random& random) {
  const double away = random.Magnitude(0.3, 3);
  const double turn = random.Between(-3, 3), lean = random.Between(-0.2, 0.2);
  config.view_plane = {std::cos(turn), std::sin(turn), lean, away};
  const double length = NormalLength(config.view_plane);
  config.view_plane.x /= length, config.view_plane.y /= length, config.view_plane.z /= length;
  config.camera.near = random.Magnitude(0.01, 0.5);
  config.camera.fov = random.Between(40, 100);
  config.nearest = 1, config.farthest = random.Magnitude(30, 1000);
  config.camera.far = 3000;
}

// A tile of an image that is several times as large.
void MoveOffCentre(Config& config, Random& random) {
  Camera& camera = config.camera;
  camera.offset_x = random.Between(-3, 3), camera.offset_y = random.Between(-3, 3);
  const Matrix p = camera.Projection();
  const double depth = std::sqrt(config.nearest * config.farthest);
  const Vector middle = {-camera.offset_x / p.m[0][0] * depth, -camera.offset_y / p.m[1][1] * depth,
                         depth};
  config.view_plane = PlaneThroughPoint(random.Direction(), middle);
}

WayKind AnyWay(Random& random, bool is_orthographic) {
  switch (random.Below(is_orthographic ? 2 : 3)) {
    case 0: return WayKind::kObject;
    case 1: return WayKind::kClip;
    default: return WayKind::kXyw1;
  }
}

RegimeDraw OneDraw(Regime regime, Random& random) {
  Config config = Ordinary(random);
  const double depth = std::sqrt(config.nearest * config.farthest);
  WayKind way = AnyWay(random, regime == Regime::kOrthographic);
  const bool takes_clip = random.Below(2) == 0;
  MatrixOrder order = MatrixOrder::kOneMatrix;
  switch (regime) {
    case Regime::kOneMatrix:
      if (random.Below(2) == 0) config.world_offset = random.Magnitude(1, 1e5) * depth;
      break;
    case Regime::kWorldFirst:
    case Regime::kWorldViewFirst:
    case Regime::kThreeMatrices:
    case Regime::kFloatWorldView:
    case Regime::kFloatViewProjection:
      config.world_offset = random.Magnitude(1, 1e4) * depth;
      order = kOrders[static_cast<int>(regime)];
      break;
    case Regime::kMeshOffset: config.mesh_offset = random.Magnitude(1, 3e4) * depth; break;
    case Regime::kWorldSpace:
      config.world_offset = random.Magnitude(1, 1e5) * depth;
      way = WayKind::kWorld;
      break;
    case Regime::kOrthographic: MakeOrthographic(config, random); break;
    case Regime::kMinusOneToOne:
      config.camera.negative_one_to_one = true, config.camera.reversed = takes_clip;
      break;
    case Regime::kOffCentre: MoveOffCentre(config, random); break;
    case Regime::kGround: MakeGround(config, random); break;
    case Regime::kMirrored: config.mirrored = true; break;
    case Regime::kUnevenScale:
      for (double& scale : config.scale) scale = random.Magnitude(1e-3, 1e3);
      break;
    case Regime::kProcessor:
      config.camera.fov = random.Between(5, 160);
      if (random.Below(2) == 0) config.mesh_offset = random.Magnitude(1, 3e4) * depth;
      way = WayKind::kCpu;
      break;
  }
  if (order != MatrixOrder::kOneMatrix) way = takes_clip ? WayKind::kClip : WayKind::kXyw1;
  // The surfaces have this angle, or all angles.
  const double degrees = random.Magnitude(5, 90);
  double sine = runtime::kAnySurface;
  if (random.Below(2) == 0) {
    config.surface_angle = degrees * std::numbers::pi / 180;
    sine = std::sin(config.surface_angle);
  }
  return {regime, config, way, sine, order};
}

// What draws lose over what a law says of them.
class Shares {
 public:
  void Add(std::vector<double> pixels, double predicted) {
    for (double& each : pixels) each /= predicted;
    all_.insert(all_.end(), pixels.begin(), pixels.end());
    const double share = At(pixels, 0.99);
    of_draws_.push_back(share);
    held_.low += share < 0.2, held_.high += share > 3;
  }
  Held Summary() {
    held_.least = At(of_draws_, 0), held_.median = At(of_draws_, 0.5);
    held_.most = At(of_draws_, 1), held_.pooled = At(all_, 0.99);
    return held_;
  }

 private:
  static double At(std::vector<double>& values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  }

  std::vector<double> of_draws_, all_;
  Held held_;
};

}  // namespace

const char* NameOf(Regime regime) { return kNames[static_cast<int>(regime)]; }

DrawsOf::DrawsOf(Regime regime, std::uint64_t seed)
    : regime_(regime), random_(seed + static_cast<std::uint64_t>(regime)) {}

RegimeDraw DrawsOf::Next() { return OneDraw(regime_, random_); }

runtime::EdgeDisplacement LawOf(const RegimeDraw& draw) {
  return LawOf(Prepare(draw.config), WayOf(draw.way), draw.order, kImageHeight, draw.sine);
}

RegimeHeld HoldLaw(Regime regime, int count, long edges, std::uint64_t seed,
                   const std::function<runtime::EdgeDisplacement(const RegimeDraw&)>& law) {
  RegimeHeld held;
  held.regime = regime;
  Shares along_surface, in_image;
  DrawsOf draws(regime, seed);
  for (int tries = 0; held.draws < count && tries < 2 * count; ++tries) {
    const RegimeDraw draw = draws.Next();
    const runtime::EdgeDisplacement predicted = law(draw);
    if (!(predicted.along_surface > 0 && predicted.in_image <= kSaturates)) continue;
    Displacements pixels =
        DisplacementsOverViews(draw.config, MethodOf(WayOf(draw.way), draw.order), edges, ++seed);
    if (std::ssize(pixels.along_surface) < kViews * edges / 2) continue;
    along_surface.Add(std::move(pixels.along_surface), predicted.along_surface);
    in_image.Add(std::move(pixels.in_image), predicted.in_image);
    ++held.draws;
  }
  if (held.draws == 0) return held;
  held.along_surface = along_surface.Summary(), held.in_image = in_image.Summary();
  return held;
}

}  // namespace clipc::study
