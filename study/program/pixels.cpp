// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/pixels.h"

#include <algorithm>
#include <cmath>

namespace clipc::study {
namespace {

// The mesh cut by the world-space plane, as clip-space polygons.
Mesh ExactlyClipped(const Mesh& mesh, const Setup& setup) {
  const Mat4<Wide> world = ConvertTo<Wide>(setup.world);
  const Mat4<long double> view = ConvertTo<long double>(setup.view),
                          projection = ConvertTo<long double>(setup.projection);
  const Vec4<Wide> plane = ConvertTo<Wide>(setup.world_plane);
  std::vector<Wide> distances;
  std::vector<Vec4<long double>> clip;
  for (const Vec4<float>& vertex : mesh.vertices) {
    const Vec4<Wide> placed = Transform(ConvertTo<Wide>(vertex), world);
    distances.push_back(Dot(placed, plane));
    clip.push_back(Transform(Transform(ConvertTo<long double>(placed), view), projection));
  }
  Mesh exact;
  std::vector<Vec4<float>> polygon;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    polygon.clear();
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.indices[i + k], b = mesh.indices[i + (k + 1) % 3];
      const bool a_in = distances[a] >= 0, b_in = distances[b] >= 0;
      if (a_in) polygon.push_back(ConvertTo<float>(clip[a]));
      if (a_in == b_in) continue;
      const std::uint32_t kept = a_in ? a : b, dropped = a_in ? b : a;
      const auto t =
          static_cast<long double>(distances[kept] / (distances[kept] - distances[dropped]));
      Vec4<long double> cut;
      for (int c = 0; c < 4; ++c) cut[c] = clip[kept][c] + t * (clip[dropped][c] - clip[kept][c]);
      polygon.push_back(ConvertTo<float>(cut));
    }
    const std::uint32_t first = exact.vertices.size();
    exact.vertices.insert(exact.vertices.end(), polygon.begin(), polygon.end());
    for (std::uint32_t k = 2; k < polygon.size(); ++k) {
      for (const std::uint32_t index : {first, first + k - 1, first + k})
        exact.indices.push_back(index);
    }
  }
  exact.normals.resize(3 * exact.vertices.size());
  return exact;
}

Mesh MeshFor(const Setup& setup, int detail) {
  const Camera& camera = setup.config.camera;
  const double depth = std::sqrt(setup.config.nearest * setup.config.farthest);
  // The knot does not reach beyond the eye, whatever the field of view.
  return TorusKnot(10 * detail, detail, std::min(camera.HalfHeightAt(depth), depth) / 1.75);
}

}  // namespace

PixelMeter::PixelMeter(int width, int height, int detail)
    : studio_(width, height, true), detail_(detail) {
  for (const Way& way : kWays) calls_.push_back(MakeCall(way.kind, 1, true));
}

std::vector<PixelErrors> PixelMeter::Measure(const Config& config) {
  const Setup setup = Prepare(config);
  const Mesh mesh = MeshFor(setup, detail_), exact = ExactlyClipped(mesh, setup);
  const Mat4<float> identity = ConvertTo<float>(Matrix{});
  studio_.Begin();
  calls_[0]->SetMesh(exact);
  calls_[0]->SetConstants({identity, identity, {}});
  calls_[0]->Draw();
  const std::vector<float> reference = studio_.Counts();
  std::vector<PixelErrors> all;
  for (std::size_t i = 1; i < std::size(kWays); ++i) {
    const Way& way = kWays[i];
    PixelErrors& errors = all.emplace_back();
    errors.way = way.name;
    const auto constants = ConstantsOf(way.kind, setup, {setup.world_plane});
    if (!constants) continue;
    errors.applies = true;
    const bool by_cpu = way.kind == WayKind::kCpu;
    calls_[i]->SetMesh(by_cpu ? ClipMesh(mesh, {ConvertTo<double>(setup.object_plane)}) : mesh);
    calls_[i]->SetConstants(*constants);
    studio_.Begin();
    calls_[i]->Draw();
    const std::vector<float> counts = studio_.Counts();
    for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
      const long difference = std::lround(counts[pixel]) - std::lround(reference[pixel]);
      (difference > 0 ? errors.extra : errors.lost) += std::abs(difference);
      errors.reference += std::lround(reference[pixel]);
    }
  }
  return all;
}

std::optional<harness::Image> DrawOnce(const Config& config, WayKind kind, int detail, int width,
                                       int height) {
  const Setup setup = Prepare(config);
  const auto constants = ConstantsOf(kind, setup, {setup.world_plane});
  if (!constants) return std::nullopt;
  Studio studio(width, height, false);
  const auto call = MakeCall(kind, 1, false);
  call->SetMesh(MeshFor(setup, detail));
  call->SetConstants(*constants);
  studio.Begin();
  call->Draw();
  harness::Image image = studio.Read();
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] == 0) std::fill_n(&image.rgba[i], 3, 255);
  }
  return image;
}

}  // namespace clipc::study
