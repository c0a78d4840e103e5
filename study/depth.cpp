// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/depth.h"

#include <algorithm>
#include <cmath>

#include "runtime/near_plane.h"
#include "study/numbers.h"

namespace clipc::study {
namespace {

struct Candidate {
  DepthLeft result;
  Mat4<float> projection;
  bool reversed = false, fixed_point = true;
};

Candidate Sheared(const char* name, const Camera& camera, const Plane& plane,
                  runtime::NearPlaneScale scale) {
  Candidate candidate;
  candidate.result.method = name;
  const auto sheared = ShearNearPlane(plane, camera.Projection(), camera.Range(), scale);
  candidate.result.refused = !sheared.ok();
  if (sheared.ok()) {
    candidate.projection = ConvertTo<float>(sheared.value.projection);
    candidate.result.effective_near = sheared.value.effective_near;
    return candidate;
  }
  // The projection that it would make: the same column, with the scale that Lengyel's formula
  // gives.
  const Matrix p = camera.Projection();
  double a = 0;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      a = std::max(
          a, plane.x * x / p.m[0][0] + plane.y * y / p.m[1][1] + plane.z + plane.w / camera.far);
    }
  }
  a = scale == runtime::NearPlaneScale::kAsGiven || a <= 0 ? 1 : 1 / a;
  Matrix column = p;
  SetDepthColumn(column, plane, a, camera.Range());
  candidate.projection = ConvertTo<float>(column);
  candidate.result.effective_near = a * std::fabs(plane.w);
  return candidate;
}

std::vector<Candidate> Candidates(const Camera& camera, const Plane& plane) {
  Candidate standard, reversed;
  standard.result.method = "standard", standard.result.effective_near = camera.near;
  standard.projection = ConvertTo<float>(camera.Projection());
  Camera turned = camera;
  turned.reversed = true;
  reversed.result.method = "reversed", reversed.result.effective_near = camera.near;
  reversed.projection = ConvertTo<float>(turned.Projection());
  reversed.reversed = true, reversed.fixed_point = false;
  return {standard, reversed,
          Sheared("near-plane", camera, plane, runtime::NearPlaneScale::kKeepFar),
          Sheared("near-plane-unit", camera, plane, runtime::NearPlaneScale::kAsGiven)};
}

float DepthOf(const Candidate& candidate, const Vec4<float>& clip) {
  float depth = std::clamp(clip[2] / clip[3], 0.0f, 1.0f);
  if (candidate.fixed_point)
    depth = static_cast<float>(std::floor(static_cast<double>(depth) * 16777215 + 0.5));
  return candidate.reversed ? -depth : depth;
}

}  // namespace

std::vector<DepthLeft> MeasureDepth(const Camera& camera, const Plane& plane, long pairs,
                                    std::uint64_t seed) {
  const Matrix p = camera.Projection();
  std::vector<DepthLeft> results;
  for (Candidate& candidate : Candidates(camera, plane)) {
    Random random(seed);
    long visible = 0, kept = 0, ordered = 0, tied = 0;
    for (long tries = 0; kept < pairs && tries < 100 * pairs; ++tries) {
      const double x = random.Between(-1, 1) / p.m[0][0], y = random.Between(-1, 1) / p.m[1][1];
      const double z = random.Magnitude(camera.near, 0.999 * camera.far);
      if (plane.x * x * z + plane.y * y * z + plane.z * z + plane.w < 1e-6 * z) continue;
      ++visible;
      Vec4<float> clip[2];
      for (int k = 0; k < 2; ++k) {
        const double s = k == 0 ? z : 1.001 * z;
        clip[k] =
            Transform(ConvertTo<float>(Vec4<double>{{x * s, y * s, s, 1}}), candidate.projection);
      }
      if (clip[0][2] > clip[0][3]) continue;
      ++kept;
      const float first = DepthOf(candidate, clip[0]), second = DepthOf(candidate, clip[1]);
      ordered += first < second, tied += first == second;
    }
    DepthLeft& result = candidate.result;
    const auto share = [](long part, long whole) {
      return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    result.ordered = share(ordered, kept), result.tied = share(tied, kept);
    result.inverted = share(kept - ordered - tied, kept),
    result.lost = share(visible - kept, visible);
    results.push_back(result);
  }
  return results;
}

}  // namespace clipc::study
