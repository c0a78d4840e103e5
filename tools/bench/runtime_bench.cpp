// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The runtime's cost as ratios taken in one run, each beside its limit.
//   clipc-runtime-bench
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

#include "runtime/box_planner.h"
#include "runtime/clip_plane.h"
#include "runtime/hidden_planes.h"
#include "runtime/level9_binder.h"
#include "tools/bench/report.h"
#include "tools/harness/timing.h"

namespace clipc::bench {
namespace {

using runtime::Float4;

volatile std::uint32_t g_sink;

double Nanoseconds() { return 1e9 * harness::ProcessSeconds(); }

// The median times of two functions that run in turn, without the time of `before`, which runs
// before each.
template <typename Before, typename One, typename Other>
std::pair<double, double> InTurn(int rounds, Before before, One one, Other other) {
  std::vector<double> ones, others;
  for (int i = 0; i < rounds; ++i) {
    before();
    double start = Nanoseconds();
    one();
    ones.push_back(Nanoseconds() - start);
    before();
    start = Nanoseconds();
    other();
    others.push_back(Nanoseconds() - start);
  }
  return {harness::Median(ones), harness::Median(others)};
}

constexpr std::size_t kObjects = 100'000, kPlanes = 6;

struct Boxes {
  std::vector<float> bounds[6];  // low x, y, z, high x, y, z
  runtime::BoxArrays arrays{};
};

// Boxes of a large scene and a box of six planes in it, most objects outside, as a section cut out
// of a model has them.
Boxes MakeBoxes() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-50, 50), size(0.1F, 2);
  Boxes boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kObjects; ++i) {
      const float center = place(random), half = size(random);
      boxes.bounds[axis].push_back(center - half);
      boxes.bounds[axis + 3].push_back(center + half);
    }
    boxes.arrays.low[axis] = boxes.bounds[axis].data();
    boxes.arrays.high[axis] = boxes.bounds[axis + 3].data();
  }
  boxes.arrays.count = kObjects;
  return boxes;
}

// Reads every bit of the bounds and does nothing else: the least that any use of them costs.
std::uint32_t ReadBounds(const runtime::BoxArrays& boxes) {
  std::uint32_t sum = 0;
  for (const float* array :
       {boxes.low[0], boxes.low[1], boxes.low[2], boxes.high[0], boxes.high[1], boxes.high[2]}) {
    for (std::size_t i = 0; i < boxes.count; ++i) {
      std::uint32_t bits;
      std::memcpy(&bits, array + i, 4);
      sum ^= bits;
    }
  }
  return sum;
}

void BenchHidden(const Boxes& boxes, const Float4 (&planes)[kPlanes],
                 const std::vector<runtime::BoxPlan>& plans) {
  std::vector<runtime::Box> several;
  std::vector<runtime::BoxPlan> theirs;
  for (std::size_t i = 0; i < kObjects; ++i) {
    if (plans[i] == runtime::kCulled || (plans[i] & (plans[i] - 1)) == 0) continue;
    const auto& b = boxes.bounds;
    several.push_back({{b[0][i], b[1][i], b[2][i]}, {b[3][i], b[4][i], b[5][i]}});
    theirs.push_back(plans[i]);
  }
  std::size_t before = 0, after = 0;
  const auto drop = [&] {
    before = after = 0;
    for (std::size_t i = 0; i < several.size(); ++i) {
      const auto plan = runtime::WithoutHiddenPlanes(several[i], planes, kPlanes, theirs[i]);
      before += static_cast<std::size_t>(std::popcount(theirs[i]));
      after += plan == runtime::kCulled ? 0 : static_cast<std::size_t>(std::popcount(plan));
    }
  };
  const auto [time, again] = InTurn(15, [] {}, drop, drop);
  g_sink = static_cast<std::uint32_t>(after);
  std::printf(
      "| hidden planes of %zu boxes with several: %.0f ns each, %zu planes of %zu stay | | | |\n",
      several.size(), std::min(time, again) / static_cast<double>(several.size()), after, before);
}

void BenchPlanner() {
  const Boxes boxes = MakeBoxes();
  const Float4 planes[kPlanes] = {{0.8F, 0.6F, 0, 25},  {-0.8F, -0.6F, 0, 25}, {-0.6F, 0.8F, 0, 20},
                                  {0.6F, -0.8F, 0, 20}, {0, 0, 1, 30},         {0, 0, -1, 30}};
  std::vector<runtime::BoxPlan> plans(kObjects);
  const auto plan = [&] {
    runtime::PlanBoxes(boxes.arrays, planes, kPlanes, plans.data());
    g_sink = plans[kObjects / 2];
  };
  const auto read = [&] { g_sink = ReadBounds(boxes.arrays); };
  // Memory that is larger than any cache, so that writing it evicts everything else.
  std::vector<unsigned char> other(std::size_t{256} << 20, 1);
  const auto evict = [&] {
    for (std::size_t i = 0; i < other.size(); i += 64)
      other[i] = static_cast<unsigned char>(other[i] + 1);
  };
  const auto [cold, cold_read] = InTurn(15, evict, plan, read);
  const auto [warm, warm_read] = InTurn(101, [] {}, plan, read);
  std::printf(
      "| 100,000 boxes and 6 planes: from memory %.0f us, reading alone %.0f us; in cache %.0f us "
      "and %.0f us | | | |\n",
      cold / 1e3, cold_read / 1e3, warm / 1e3, warm_read / 1e3);
  std::printf("| %.2f ns a box and plane | | | |\n", warm / (kObjects * kPlanes));
  Report("planning 100,000 boxes against 6 planes, to reading the boxes from memory",
         cold / cold_read, "x", 2.5);
  BenchHidden(boxes, planes, plans);
}

runtime::Matrix AnyMatrix(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> any(-1, 1);
  const double angle = 3 * any(random), c = scale * std::cos(angle), s = scale * std::sin(angle);
  return {{{c, s, 0, 0},
           {-s * 0.6, c * 0.6, 0.8 * scale, 0},
           {s * 0.8, -c * 0.8, 0.6 * scale, 0},
           {50 * any(random), 50 * any(random), 50 * any(random), 1}}};
}

// Planes of many objects in clip space, as a frame makes them.
void BenchPlanes() {
  constexpr std::size_t kCount = 1000;
  std::mt19937 random(2);
  const runtime::Matrix view = AnyMatrix(random, 1);
  const runtime::Matrix projection = {
      {{1, 0, 0, 0}, {0, 1.7, 0, 0}, {0, 0, 1.0001, 1}, {0, 0, -0.1, 0}}};
  std::vector<runtime::Matrix> worlds;
  for (std::size_t i = 0; i < kCount; ++i) worlds.push_back(AnyMatrix(random, 2));
  const runtime::Plane plane = {0.6, 0.8, 0, 1};
  const runtime::PreparedCamera camera = runtime::PrepareCamera(view, projection).value;
  float sum = 0;
  const auto inverses = [&] {
    for (const runtime::Matrix& world : worlds)
      sum += runtime::ClipPlaneFromObject(plane, world, camera).value.constant.x;
  };
  const auto products = [&] {
    for (const runtime::Matrix& world : worlds)
      sum += runtime::ObjectPlaneFromWorld(plane, world).value.constant.x;
  };
  const auto [ours, least] = InTurn(101, [] {}, inverses, products);
  g_sink = sum > 0 ? 1 : 0;
  std::printf(
      "| 1,000 objects: planes of a prepared camera %.0f us, of object space %.0f us | | | |\n",
      ours / 1e3, least / 1e3);
  Report("ClipPlaneFromObject of a prepared camera, to ObjectPlaneFromWorld, which inverts nothing",
         ours / least, "x", 2.5);
}

// A device as a program sees it: a pointer to a table of functions. The functions here copy the
// plane, which is less than any device does.
struct Functions {
  bool (*set_clip_plane)(Functions*, std::uint32_t, const float*);
  bool (*set_enable)(Functions*, std::uint32_t);
  float planes[6][4];
  std::uint32_t mask;
};

__attribute__((noinline)) bool CopyPlane(Functions* self, std::uint32_t index, const float* plane) {
  std::memcpy(self->planes[index], plane, 16);
  return true;
}
__attribute__((noinline)) bool CopyMask(Functions* self, std::uint32_t mask) {
  self->mask = mask;
  return true;
}

class PointerDevice final : public runtime::ClipDevice {
 public:
  explicit PointerDevice(Functions* volatile& functions) : functions_(functions) {}
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override {
    Functions* functions = functions_;
    return functions->set_clip_plane(functions, index, plane);
  }
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override {
    Functions* functions = functions_;
    return functions->set_enable(functions, mask);
  }

 private:
  Functions* volatile& functions_;
};

constexpr int kDraws = 20'000;

void BenchBinder(std::uint32_t plane_count) {
  runtime::Table table;
  table.lowering = runtime::Lowering::kLevel9;
  table.enable_mask = (1U << plane_count) - 1;
  for (std::uint32_t i = 0; i < plane_count; ++i) {
    table.planes.emplace_back();
    table.planes.back().cbuffer = "Clip";
    table.planes.back().register_number = 1;
    table.planes.back().byte_offset = 16 * i;
  }
  float constants[6][4] = {{1, 0, 0, 1},  {-1, 0, 0, 1}, {0, 1, 0, 1},
                           {0, -1, 0, 1}, {0, 0, 1, 0},  {0, 0, -1, 1}};
  const runtime::BoundBuffer buffers[] = {{0, 0, constants, sizeof constants},
                                          {1, 0, constants, sizeof constants}};
  static Functions functions{CopyPlane, CopyMask, {}, 0};
  static Functions* volatile pointer = &functions;
  PointerDevice device(pointer);
  runtime::ClipDevice* volatile blind = &device;  // volatile: the compiler must not see the type
  runtime::Level9Binder binder(device, 6);

  const auto bind = [&] {
    for (int draw = 0; draw < kDraws; ++draw) {
      if (!binder.Bind(table, buffers, 2).ok()) std::exit(1);
    }
  };
  const auto set_all = [&] {
    for (int draw = 0; draw < kDraws; ++draw) {
      for (std::uint32_t i = 0; i < plane_count; ++i) blind->SetClipPlane(i, constants[i]);
      blind->SetClipPlaneEnable(table.enable_mask);
    }
  };
  const auto [ours, blindly] = InTurn(51, [] {}, bind, set_all);
  std::printf(
      "| a draw with %u planes, nothing changed: Level9Binder %.1f ns, SetClipPlane blindly %.1f "
      "ns on a device "
      "that only copies: %.2f x | | | |\n",
      plane_count, ours / kDraws, blindly / kDraws, ours / blindly);
}

}  // namespace
}  // namespace clipc::bench

int main() {
  std::printf("| what | measured | limit | |\n|---|---|---|---|\n");
  clipc::bench::BenchPlanner();
  clipc::bench::BenchPlanes();
  for (const std::uint32_t plane_count : {1U, 3U, 6U}) clipc::bench::BenchBinder(plane_count);
  std::printf("\nlimits missed: %d\n", clipc::bench::g_missed);
  return clipc::bench::g_missed != 0;
}
