// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <bit>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"
#include "tools/study/program/commands.h"
#include "tools/study/program/csv.h"
#include "tools/study/program/scene_file.h"
#include "tools/study/program/speed.h"
#include "tools/study/way.h"

namespace clipc::study {
namespace {

using harness::DrawError;
using namespace harness::options;
// speed.csv as clipc-study wrote it.
CostTable ReadCosts(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) ||
      line != "setting,way,planes,median_ms,least_ms,ratio,paired_ratio") {
    throw DrawError("`" + path + "` is no speed.csv of clipc-study");
  }
  std::vector<Cost> costs;
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() != 7) throw DrawError("`" + path + "` has a row that is not of seven cells");
    Cost& cost = costs.emplace_back();
    cost.setting = cells[0], cost.way = cells[1], cost.planes = std::atoi(cells[2].c_str());
    cost.paired_ratio = std::strtod(cells[6].c_str(), nullptr);
  }
  return TableOf(costs);
}

CostTable MeasuredCosts() {
  const harness::OpenGl opengl(harness::Api::kCompatibility);
  Progress progress("cost");
  return TableOf(MeasureSpeed(5, 40, std::ref(progress)));
}

// A method with the most planes that an object drawn with it needs.
using Variants = std::map<std::string, int>;

std::string MaskText(std::uint8_t needed, const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) != 0) text += (text.empty() ? "" : "+") + scene.planes[i].name;
  }
  return text.empty() ? "none" : text;
}

void Report(const Scene& scene, const NamedCamera& camera, const CostTable& costs,
            Variants& variants) {
  std::printf("%s, camera %s: %zu planes, %zu objects\n", scene.name.c_str(), camera.name.c_str(),
              scene.planes.size(), scene.objects.size());
  std::printf("%-20s %-12s %-28s %-16s %12s %8s\n", "object", "drawn", "planes needed", "method",
              "pixels off", "cost");
  for (const SceneObject& object : scene.objects) {
    const ObjectPlan plan = PlanObject(object, camera.camera, scene.planes);
    const char* drawn = plan.outside_frustum ? "not in view" : plan.culled ? "clipped away" : "yes";
    if (plan.outside_frustum || plan.culled) {
      std::printf("%-20s %-12s\n", object.name.c_str(), drawn);
      continue;
    }
    if (plan.needed == 0) {
      std::printf("%-20s %-12s %-28s %-16s %12s %8.3f\n", object.name.c_str(), drawn, "none",
                  "any, 0 planes", "0", 1.0);
      continue;
    }
    const DrawFacts facts = FactsOf(object, camera.camera, scene, plan.needed);
    const Advice best = Advise(facts, costs, scene.tolerance).front();
    if (!best.possible) throw DrawError("no method can clip `" + object.name + "`");
    std::printf("%-20s %-12s %-28s %-16s %12.2g %8.3f\n", object.name.c_str(), drawn,
                MaskText(plan.needed, scene).c_str(), best.way.c_str(), best.bound, best.cost);
    int& most = variants[best.way];
    most = std::max(most, std::popcount(plan.needed));
  }
}

std::string VariantList(const Scene& scene, const Variants& variants) {
  std::string text = "# Written by `clipc-study scene` for " + scene.name +
                     ". For each method: clipc_add_shader(... LOWER VARIANTS OPTIONS).\n";
  std::string names;
  for (const auto& [way, planes] : variants) {
    const Way& known = WayNamed(way);
    if (!known.lowering) continue;
    names += (names.empty() ? "" : ";") + way;
    text += "set(CLIPC_SCENE_" + way + "_LOWER " + NameOf(*known.lowering) + ")\n";
    text += "set(CLIPC_SCENE_" + way + "_VARIANTS " + std::to_string(planes) + ")\n";
    text += "set(CLIPC_SCENE_" + way + "_OPTIONS --plane-space=" + NameOf(*known.space) + ")\n";
  }
  return text + "set(CLIPC_SCENE_METHODS \"" + names + "\")\n";
}

}  // namespace

int RunScene(const std::vector<std::string>& arguments) {
  std::string costs_path, variants_path;
  const std::string path =
      ParseOnlyPath(arguments, {{"costs", Text(costs_path)}, {"variants", Text(variants_path)}});
  const Scene scene = ReadScene(path);
  const CostTable costs = costs_path.empty() ? MeasuredCosts() : ReadCosts(costs_path);
  Variants variants;
  for (const NamedCamera& camera : scene.cameras) Report(scene, camera, costs, variants);
  for (const auto& [way, planes] : variants) {
    std::printf("build: %s with 0 to %d planes\n", way.c_str(), planes);
  }
  if (!variants_path.empty()) {
    std::ofstream file(variants_path);
    file << VariantList(scene, variants);
    if (!file.flush()) throw DrawError("cannot write `" + variants_path + "`");
  }
  return 0;
}

}  // namespace clipc::study
