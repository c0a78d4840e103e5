// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/speed.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

#include "study/program/studio.h"
#include "study/repeats.h"
#include "study/sweeps.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/timing.h"

namespace clipc::study {
namespace {

struct Workload {
  const char* name;
  int width, height;
  bool cuts;
};
constexpr Workload kWorkloads[] = {
    {"image", 1280, 720, false}, {"vertices", 64, 64, false}, {"cut", 1280, 720, true}};

// The first `count` of six sides of a box around the object, in world space; far outside it, or, if
// `cuts`, through it.
std::vector<Plane> Sides(const Setup& setup, int count, bool cuts) {
  std::vector<Plane> planes;
  // The first looks along the view and lies behind every part of the object as the eye sees it, so
  // that the near plane can be sheared.
  const Vector normals[6] = {{0.1, 0.2, 0.97}, {-1, 0, 0.1}, {1, 0, 0.1},
                             {0, -1, 0.1},     {0, 1, 0.1},  {0.3, 0, 1}};
  const double depth = std::sqrt(setup.config.nearest * setup.config.farthest),
               radius = 0.3 * depth;
  for (int i = 0; i < count; ++i) {
    const Vector n = normals[i];
    // The way from the object's middle to the plane, against the normal.
    const Vector away = (cuts ? 0 : -2 * radius) * n / std::sqrt(Dot(n, n));
    const Plane view = PlaneThroughPoint(n, Vector{0, 0, depth} + away);
    planes.push_back(PlaneBefore(setup.view, view));
  }
  return planes;
}

struct Entry {
  Cost cost;
  WayKind kind;
  std::unique_ptr<DrawCall> call;
  std::vector<Vec4<double>> object_planes;  // kCpu
  std::vector<double> times;
  std::vector<double> shares;  // of the mean of the frames without planes before and after
};

std::vector<Entry> EntriesFor(const Workload& workload, const Setup& setup, const Mesh& mesh) {
  std::vector<Entry> entries;
  for (const Way& way : kWays) {
    for (const int planes : {0, 1, 3, 6}) {
      if ((planes == 0) != (way.kind == WayKind::kNone) || planes > way.most_planes) continue;
      const std::vector<Plane> world = Sides(setup, planes, workload.cuts);
      const auto constants = ConstantsOf(way.kind, setup, world);
      if (!constants) continue;
      Entry entry;
      entry.cost.workload = workload.name, entry.cost.way = way.name, entry.cost.planes = planes;
      entry.kind = way.kind;
      entry.call = MakeCall(way.kind, planes, false);
      entry.call->SetMesh(mesh);
      entry.call->SetConstants(*constants);
      for (const Plane& plane : world) {
        entry.object_planes.push_back(ConvertTo<double>(PlaneBefore(setup.world, plane)));
      }
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

double TimeOf(Studio& studio, Entry& entry, const Mesh& mesh) {
  studio.Begin();
  glFinish();
  const double start = harness::ProcessSeconds();
  if (entry.kind == WayKind::kCpu) entry.call->SetMesh(ClipMesh(mesh, entry.object_planes));
  entry.call->Draw();
  glFinish();
  return 1e3 * (harness::ProcessSeconds() - start);
}

constexpr std::size_t kBetween = 3;  // entries between two frames without planes

// Draws each entry but the first once, in an order of its own, and the first, which has no planes,
// in between.
void Round(Studio& studio, const Mesh& mesh, std::vector<Entry>& entries, Random& random,
           bool counts) {
  std::vector<std::size_t> order(entries.size() - 1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t other = random.Below(i + 1);
    order[i] = order[other], order[other] = i + 1;
  }
  Entry& none = entries.front();
  std::vector<double> without = {TimeOf(studio, none, mesh)};
  for (std::size_t first = 0; first < order.size(); first += kBetween) {
    const std::size_t end = std::min(first + kBetween, order.size());
    std::vector<double> times;
    for (std::size_t i = first; i < end; ++i)
      times.push_back(TimeOf(studio, entries[order[i]], mesh));
    const double before = without.back(), after = TimeOf(studio, none, mesh);
    for (std::size_t i = first; counts && i < end; ++i) {
      entries[order[i]].times.push_back(times[i - first]);
      entries[order[i]].shares.push_back(2 * times[i - first] / (before + after));
    }
    without.push_back(after);
  }
  for (std::size_t i = 1; counts && i + 1 < without.size(); ++i) {
    none.times.push_back(without[i]);
    none.shares.push_back(2 * without[i] / (without[i - 1] + without[i + 1]));
  }
}

}  // namespace

std::vector<Cost> MeasureSpeed(int rounds, int detail,
                               const std::function<void(double)>& progress) {
  const Setup setup = Prepare(ObliqueAt(4, 0.1, 100));
  const Mesh mesh = TorusKnot(10 * detail, detail, 4 * 0.577 / 1.75);
  std::vector<Cost> costs;
  Random random(8);
  int done = 0;
  for (const Workload& workload : kWorkloads) {
    Studio studio(workload.width, workload.height, false);
    std::vector<Entry> entries = EntriesFor(workload, setup, mesh);
    for (int round = -1; round < rounds;
         ++round) {  // the first is thrown away: shaders are compiled in it
      Round(studio, mesh, entries, random, round >= 0);
      progress((done + static_cast<double>(round + 2) / (rounds + 1)) /
               static_cast<double>(std::size(kWorkloads)));
    }
    ++done;
    for (Entry& entry : entries) {
      entry.cost.median_ms = harness::Median(entry.times);
      entry.cost.least_ms = *std::ranges::min_element(entry.times);
      const Repeated repeated = MedianOf(entry.shares);
      entry.cost.paired_ratio = repeated.median;
      entry.cost.paired_low = repeated.low, entry.cost.paired_high = repeated.high;
    }
    const Cost none = entries.front().cost;
    for (Entry& entry : entries) {
      entry.cost.ratio = entry.cost.median_ms / none.median_ms;
      // Noise lifts all of these ratios alike.
      entry.cost.paired_ratio /= none.paired_ratio;
      entry.cost.paired_low /= none.paired_ratio, entry.cost.paired_high /= none.paired_ratio;
      costs.push_back(entry.cost);
    }
  }
  return costs;
}

CostTable TableOf(const std::vector<Cost>& costs) {
  CostTable table;
  for (const Cost& cost : costs) {
    if (cost.workload == "image" && cost.planes > 0)
      table[{cost.way, cost.planes}] = cost.paired_ratio;
  }
  return table;
}

CostTable ReadCosts(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) ||
      !line.starts_with("workload,way,planes,median_ms,least_ms,ratio,paired_ratio")) {
    throw harness::DrawError("`" + path + "` is not a speed.csv of clipc-study");
  }
  std::vector<Cost> costs;
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() < 7)
      throw harness::DrawError("`" + path + "` has a row of less than seven cells");
    Cost& cost = costs.emplace_back();
    cost.workload = cells[0], cost.way = cells[1], cost.planes = std::atoi(cells[2].c_str());
    cost.paired_ratio = std::strtod(cells[6].c_str(), nullptr);
  }
  return TableOf(costs);
}

}  // namespace clipc::study
