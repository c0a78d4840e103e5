// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <functional>

#include <sys/wait.h>
#include <unistd.h>

#include "chart.text.h"
#include "report.text.h"
#include "study/edges.h"
#include "study/flicker.h"
#include "study/program/commands.h"
#include "study/program/csv.h"
#include "study/program/pixels.h"
#include "study/program/scene_cost.h"
#include "study/program/special.h"
#include "study/program/speed.h"
#include "study/regimes.h"
#include "study/scene.h"
#include "study/sweeps.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"

namespace clipc::study {
namespace {

using namespace harness::options;

struct StudyOptions {
  bool quick = false;
  std::string out = "study-report";
};

class Study {
 public:
  explicit Study(StudyOptions options) : options_(std::move(options)) {
    std::filesystem::create_directories(options_.out);
  }

  void Run() {
    Edges();
    Directions();
    Laws();
    Flickers();
    Pixels();
    Special();
    rule_costs_ = Speed("speed.csv", "cost");
    Scenes();
    SceneCosts();
  }

 private:
  int KnotDetail() const { return options_.quick ? 12 : 24; }
  std::string Path(const std::string& name) const { return options_.out + "/" + name; }

  void Edges() {
    Csv csv(Path("edges.csv"), {"sweep", "parameter", "method", "applies", "edges", "median_px",
                                "p99_px", "largest_px", "not_finite", "p99_in_image_px"});
    Progress progress("displaced edges");
    const std::vector<SweepPoint> points = AllSweeps(options_.quick);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const EdgeErrors& errors :
           MeasureViews(points[i].config, AllMethods(), options_.quick ? 50 : 300, 12345)) {
        csv.Row(points[i].sweep, points[i].parameter, errors.method, errors.applies, errors.edges,
                errors.median, errors.p99, errors.largest, errors.not_finite, errors.p99_in_image);
      }
      progress(static_cast<double>(i + 1) / static_cast<double>(points.size()));
    }
  }

  // Writes each way's error over plane directions that nobody chose, at some distances from the
  // eye.
  void Directions() {
    Csv csv(Path("directions.csv"), {"depth", "eye_to_plane", "method", "planes", "median_px",
                                     "p99_px", "largest_px", "p99_in_image_px"});
    const int planes = options_.quick ? 8 : 60;
    const auto measure = [&](double ratio, bool reversed, const Method& method) {
      const EdgeErrors errors = MeasureDirections(ratio, reversed, method, planes, 400, 12);
      if (errors.applies)
        csv.Row(reversed ? "reversed" : "standard", ratio, method.name, planes, errors.median,
                errors.p99, errors.largest, errors.p99_in_image);
    };
    for (const double ratio : {10.0, 400.0, 10000.0}) {
      for (const Method& method : AllMethods()) measure(ratio, false, method);
      for (const Method& method : {ClipSpace(), Xyw1Space(), ObjectSpace()})
        measure(ratio, true, method);
    }
  }

  // Writes the agreement of PredictEdgeError with the regimes that users are in.
  void Laws() {
    Csv csv(Path("laws.csv"), {"regime", "judged_in", "draws", "low", "high", "least", "median",
                               "most", "pooled_p99"});
    Progress progress("laws");
    for (int i = 0; i < kRegimes; ++i) {
      const RegimeHeld held = HoldLaw(static_cast<Regime>(i), options_.quick ? 100 : 10000, 40,
                                      424242, [](const RegimeDraw& draw) { return LawOf(draw); });
      for (const auto& [name, each] :
           {std::pair{"surface", held.along_surface}, std::pair{"image", held.in_image}}) {
        csv.Row(NameOf(held.regime), name, held.draws, each.low, each.high, each.least, each.median,
                each.most, each.pooled);
      }
      progress(static_cast<double>(i + 1) / kRegimes);
    }
  }

  // Writes the flicker of a camera that pans by a sixth of a degree a frame.
  void Flickers() {
    Csv csv(Path("flicker.csv"), {"world_offset", "eye_to_plane", "method", "median_px", "p99_px",
                                  "largest_px", "p99_in_image_px"});
    const auto measure = [&](double offset, double ratio) {
      Config config = ObliqueAt(0.1 * ratio / 0.77, 0.1, 1e6);
      config.world_offset = offset;
      for (const Flicker& flicker :
           MeasureFlicker(config, AllMethods(), options_.quick ? 6 : 20, 0.003, 500, 5)) {
        if (flicker.applies)
          csv.Row(offset, ratio, flicker.method, flicker.median, flicker.p99, flicker.largest,
                  flicker.p99_in_image);
      }
    };
    for (const double ratio : {10.0, 30.0, 100.0, 400.0, 1000.0, 3000.0}) measure(0, ratio);
    measure(1e4, 77);  // seen at 10, as the sweep of world offsets
  }

  void Pixels() {
    Csv csv(Path("pixels.csv"),
            {"sweep", "parameter", "way", "applies", "reference", "extra", "lost", "wrong"});
    Progress progress("wrong pixels");
    PixelMeter meter(options_.quick ? 960 : 1920, options_.quick ? 540 : 1080, KnotDetail());
    const std::vector<SweepPoint> points = AllSweeps(options_.quick);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // The knot is at its own origin and on the view's axis.
      const Config& config = points[i].config;
      if (config.mesh_offset == 0 && !points[i].sweep.starts_with("tile")) {
        for (const PixelErrors& errors : meter.Measure(config)) {
          csv.Row(points[i].sweep, points[i].parameter, errors.way, errors.applies,
                  errors.reference, errors.extra, errors.lost, errors.extra + errors.lost);
        }
      }
      progress(static_cast<double>(i + 1) / static_cast<double>(points.size()));
    }
    Images();
  }

  // Writes an image of each way at a cut so far away that the default is visibly wrong.
  void Images() {
    const Config far = ObliqueAt(3e4, 0.1, 1e6);
    for (const Way& way : kWays) {
      if (const auto image = DrawOnce(far, way.kind, KnotDetail(), 480, 270))
        harness::WritePng(Path("image-" + std::string(way.name) + ".png"), *image);
    }
  }

  void Special() {
    Csv csv(Path("special.csv"), {"sweep", "what", "way", "got", "right"});
    for (const SpecialResult& result : MeasureSpecial()) {
      csv.Row(result.sweep, result.what, result.way, result.got, result.right);
    }
  }

  // Measures the costs and writes them. Returns those in the rows "image".
  CostTable Speed(const std::string& name, const char* what) {
    Csv csv(Path(name), {"workload", "way", "planes", "median_ms", "least_ms", "ratio",
                         "paired_ratio", "paired_low", "paired_high"});
    Progress progress(what);
    const std::vector<Cost> costs =
        MeasureSpeed(options_.quick ? 3 : 25, options_.quick ? 40 : 100, std::ref(progress));
    for (const Cost& cost : costs) {
      csv.Row(cost.workload, cost.way, cost.planes, cost.median_ms, cost.least_ms, cost.ratio,
              cost.paired_ratio, cost.paired_low, cost.paired_high);
    }
    return TableOf(costs);
  }

  void Scenes() {
    Csv csv(Path("scenes.csv"),
            {"scene", "planes", "objects", "outside", "culled", "need0", "need1", "need2", "need3",
             "way", "predicted_px", "bound_px", "cost", "share"});
    for (const Scene& scene : BuiltInScenes()) {
      int outside = 0, culled = 0, need[4] = {};
      std::map<std::string, int> chosen;
      std::map<std::string, Advice> worst;
      for (const ObjectAdvice& object :
           AdviseScene(scene, scene.cameras.front().camera, rule_costs_)) {
        const ObjectPlan& plan = object.plan;
        outside += plan.outside_frustum, culled += !plan.outside_frustum && plan.culled;
        if (!plan.drawn()) continue;
        ++need[std::min(std::popcount(plan.needed), 3)];
        if (!object.best) continue;
        const Advice& best = *object.best;
        ++chosen[best.way];
        if (best.bound > worst[best.way].bound) worst[best.way] = best;
      }
      const auto most = std::ranges::max_element(
          chosen, [](const auto& a, const auto& b) { return a.second < b.second; });
      const Advice& advice = worst[most->first];
      csv.Row(scene.name, scene.planes.size(), scene.objects.size(), outside, culled, need[0],
              need[1], need[2], need[3], advice.way, advice.predicted, advice.bound, advice.cost,
              static_cast<double>(most->second) / (need[1] + need[2] + need[3]));
    }
  }

  // Measures frames of the scenes with no planes, all planes, and the planes that are needed.
  void SceneCosts() {
    Csv csv(Path("scene-costs.csv"),
            {"scene", "planes", "draws", "planes_drawn", "least_ms", "same_image"});
    SceneDrawer drawer(1280, 720);
    for (const Scene& scene : BuiltInScenes()) {
      const std::vector<std::uint8_t> all = drawer.Draw(scene, Planes::kAll).rgba;
      for (const auto& [planes, name] :
           {std::pair{Planes::kNone, "none"}, std::pair{Planes::kAll, "all"},
            std::pair{Planes::kNeeded, "needed"}}) {
        SceneDrawer::Drawn drawn = drawer.Draw(scene, planes);
        for (int round = 0; round < (options_.quick ? 1 : 6); ++round) {
          drawn.cpu_ms = std::min(drawn.cpu_ms, drawer.Draw(scene, planes).cpu_ms);
        }
        csv.Row(scene.name, name, drawn.draws, drawn.planes, drawn.cpu_ms, (drawn.rgba == all));
      }
    }
  }

  StudyOptions options_;
  const harness::OpenGl opengl_{harness::Api::kCompatibility};
  CostTable rule_costs_;
};

void MakeReport(const std::string& folder) {
  const pid_t child = fork();
  if (child == 0) {
    // The report's script imports the chart's.
    constexpr char kStart[] =
        "import sys, types; chart = sys.modules['chart'] = types.ModuleType('chart'); "
        "report = sys.argv.pop(); exec(sys.argv.pop(), chart.__dict__); exec(report)";
    execlp("/usr/bin/python3", "python3", "-c", kStart, folder.c_str(), chart_text, report_text,
           nullptr);
    std::_Exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) {
    throw harness::DrawError("the tables are in `" + folder +
                             "`, but the report failed; it needs Debian's python3-matplotlib");
  }
}

}  // namespace

int RunStudy(const std::vector<std::string>& arguments) {
  StudyOptions options;
  bool no_report = false, help = false;
  const Flags flags = {{"quick", On(options.quick)},
                       {"no-report", On(no_report)},
                       {"out", Text(options.out)},
                       {"help", On(help)}};
  const bool has_paths = !Parse(arguments, flags).empty();
  if (help) return std::fputs(kUsage, stdout) < 0;
  if (has_paths) throw harness::DrawError(kUsage);
  Study(options).Run();
  if (!no_report) MakeReport(options.out);
  return 0;
}

}  // namespace clipc::study
