// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/special.h"

#include <limits>
#include <optional>

#include "study/program/studio.h"
#include "study/sweeps.h"

namespace clipc::study {
namespace {

constexpr int kWidth = 320, kHeight = 180;

class Specials {
 public:
  std::vector<SpecialResult> Run() {
    for (const Way& way : kWays) {
      // Two ways take no plane as it is: one makes matrices of it, one clips in the
      // application.
      if (way.most_planes == 0 || way.kind == WayKind::kNearPlaneFloat || way.kind == WayKind::kCpu)
        continue;
      way_ = &way;
      Values();
      ThroughTheEye();
      Smooth();
    }
    return std::move(results_);
  }

 private:
  void Add(const char* sweep, std::string what, double got, double right) {
    results_.push_back({sweep, std::move(what), way_->name, got, right});
  }

  std::vector<float> Draw(Studio& studio, WayKind kind, const Mesh& mesh,
                          const WayConstants& constants) {
    const auto call = MakeCall(kind, kind == WayKind::kNone ? 0 : 1, true);
    call->SetMesh(mesh);
    call->SetConstants(constants);
    studio.Begin();
    call->Draw();
    return studio.Counts();
  }
  double Fragments(WayKind kind, const Mesh& mesh, const WayConstants& constants) {
    double sum = 0;
    for (const float count : Draw(studio_, kind, mesh, constants))
      sum += static_cast<double>(count);
    return sum;
  }

  // Draws the knot with special values in place of the plane's constants, as if somebody had
  // uploaded them.
  void Values() {
    const std::optional<WayConstants> made = ConstantsOf(way_->kind, setup_, {setup_.world_plane});
    if (!made) return;
    const double all = Fragments(WayKind::kNone, knot_, *made);
    const auto share = [&](const Vec4<float>& plane) {
      WayConstants constants = *made;
      constants.planes.front() = plane;
      return Fragments(way_->kind, knot_, constants) / all;
    };
    const char* const sweep = "special values";
    Add(sweep, "0 0 0 0", share({{0, 0, 0, 0}}), 1);
    Add(sweep, "-0 0 0 -0", share({{-0.0f, 0, 0, -0.0f}}), 1);
    Add(sweep, "0 0 0 -1", share({{0, 0, 0, -1}}), 0);
    Add(sweep, "NaN 0 0 1", share({{std::numeric_limits<float>::quiet_NaN(), 0, 0, 1}}), 0);
    const double right = share(made->planes.front());
    for (const auto& [text, scale] :
         {std::pair{"times 1e-42", 1e-42f}, std::pair{"times 1e-35", 1e-35f},
          std::pair{"times 1e30", 1e30f}, std::pair{"times 1e38", 1e38f}}) {
      Vec4<float> plane = made->planes.front();
      for (float& c : plane.c) c *= scale;
      Add(sweep, text, share(plane), right);
    }
  }

  // Draws a knot around the eye: the parts that a plane and its opposite keep are the whole knot.
  void ThroughTheEye() {
    const Plane& p = setup_.world_plane;
    const auto kept = ConstantsOf(way_->kind, setup_, {p});
    const auto opposite = ConstantsOf(way_->kind, setup_, {Plane{-p.x, -p.y, -p.z, -p.w}});
    if (!kept || !opposite) return;
    const double all = Fragments(WayKind::kNone, around_, *kept);
    const double one = Fragments(way_->kind, around_, *kept);
    const double other = Fragments(way_->kind, around_, *opposite);
    Add("triangles through w = 0", "one half", one / all, (all - other) / all);
    Add("triangles through w = 0", "both halves", (one + other) / all, 1);
  }

  // Draws a square that fills the image, so that the cut is its only edge.
  void Smooth() {
    Mesh square;
    square.vertices = {{{-2, -2, 0, 1}}, {{2, -2, 0, 1}}, {{2, 2, 0, 1}}, {{-2, 2, 0, 1}}};
    square.normals.resize(12);
    square.indices = {0, 1, 2, 0, 2, 3};
    Setup setup = setup_;
    setup.world = setup.view = Matrix{};
    setup.world.m[3][2] = 1;
    setup.world_view = setup.world;
    setup.world_view_projection = Multiply(setup.world, setup.projection);
    const auto constants = ConstantsOf(way_->kind, setup, {Plane{1, 1, 0, -0.013}});
    if (!constants) return;
    Studio smooth(kWidth, kHeight, true, 4);
    const std::vector<float> counts = Draw(smooth, way_->kind, square, *constants);
    int rows = 0;
    for (int y = 0; y < kHeight; ++y) {
      bool is_smooth = false;
      for (int x = 0; x < kWidth; ++x) {
        const float count = counts[y * kWidth + x];
        is_smooth = is_smooth || (count > 0 && count < 1);
      }
      rows += is_smooth;
    }
    Add("multisampling", "4 samples", static_cast<double>(rows) / kHeight, 1);
  }

  Studio studio_{kWidth, kHeight, true};
  const Setup setup_ = Prepare(ObliqueAt(4));
  const Mesh knot_ = TorusKnot(120, 12, 1.3), around_ = TorusKnot(120, 12, 6);
  const Way* way_ = nullptr;
  std::vector<SpecialResult> results_;
};

}  // namespace

std::vector<SpecialResult> MeasureSpecial() { return Specials().Run(); }

}  // namespace clipc::study
