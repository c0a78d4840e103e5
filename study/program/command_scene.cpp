// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>

#include <nlohmann/json.hpp>

#include "study/program/commands.h"
#include "study/program/csv.h"
#include "study/program/scene_file.h"
#include "study/program/speed.h"
#include "study/way.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"

namespace clipc::study {
namespace {

using harness::DrawError;
using OrderedJson = nlohmann::ordered_json;
using namespace harness::options;
CostTable MeasuredCosts() {
  const harness::OpenGl opengl(harness::Api::kCompatibility);
  Progress progress("cost");
  return TableOf(MeasureSpeed(5, 40, std::ref(progress)));
}

// The methods, each with the most planes that an object drawn with it needs.
using Variants = std::map<std::string, int>;

OrderedJson NamesOf(std::uint8_t needed, const Scene& scene) {
  OrderedJson names = OrderedJson::array();
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    if ((needed >> i & 1) != 0) names.push_back(scene.planes[i].name);
  }
  return names;
}

// The command that compiles an object's shader, with a variant for each number of planes up to that
// many; empty where clipc has no part in the way.
std::string CommandOf(const SceneObject& object, const Way& way, int planes) {
  if (!way.lowering) return "";
  std::string name = object.name;
  for (char& letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  }
  std::string command = "clipc " + name + ".hlsl --plane-space=" + NameOf(*way.space);
  if (*way.lowering != Lowering::kClipDistance)
    command += std::string(" --lower=") + NameOf(*way.lowering);
  if (*way.lowering == Lowering::kDiscard) command += " --fragment=" + name + ".frag";
  return command + " --variants=" + std::to_string(planes);
}

// The advice on an object, as docs/scene.md describes it.
OrderedJson JsonOf(const SceneObject& object, const ObjectAdvice& advice, const Scene& scene) {
  const ObjectPlan& plan = advice.plan;
  OrderedJson json = {{"object", object.name},
                      {"drawn", plan.outside_frustum ? "not in view"
                                : plan.culled        ? "clipped away"
                                                     : "yes"},
                      {"meets", !advice.fails()}};
  if (!plan.refused.empty()) json["refused"] = plan.refused;
  if (!advice.cure.empty()) json["cure"] = advice.cure;
  if (!plan.drawn() || !plan.refused.empty()) return json;
  json["planes"] = NamesOf(plan.needed, scene);
  if (advice.best && !advice.best->possible) {
    json["method"] = nullptr;
    return json;
  }
  json["method"] = advice.best ? advice.best->way : "any";
  json["pixels_off"] = advice.best ? advice.best->bound : 0;
  json["pixels_along_object"] = advice.best ? kBound * advice.best->along_surface : 0;
  json["pixels_in_image"] = advice.best ? kBound * advice.best->in_image : 0;
  json["cost"] = advice.best ? advice.best->cost : 1;
  if (!advice.best) return json;
  if (!advice.best->has_cost()) json["cost"] = nullptr;
  const std::string command =
      CommandOf(object, WayNamed(advice.best->way), std::popcount(plan.needed));
  if (!command.empty()) json["command"] = command;
  return json;
}

// The text of a table's cell. A name that has a space is in quotation marks, so that columns stay
// columns.
std::string Cell(const OrderedJson& value) {
  std::string text;
  if (value.is_array()) {
    for (const OrderedJson& name : value)
      text += (text.empty() ? "" : "+") + name.get<std::string>();
    if (text.empty()) text = "none";
  } else {
    text = value.get<std::string>();
  }
  return text.find(' ') == text.npos ? text : "\"" + text + "\"";
}

// "1 plane", "2 planes".
std::string Counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void Print(const OrderedJson& image) {
  std::printf("%s, camera %s: %s, %s, tolerance %g pixels %s\n", Cell(image["scene"]).c_str(),
              Cell(image["camera"]).c_str(),
              Counted(image["planes"].get<std::size_t>(), "plane").c_str(),
              Counted(image["objects"].size(), "object").c_str(), image["tolerance"].get<double>(),
              image["judged_in"] == "image" ? "in the image" : "along the object");
  std::printf("%-20s %-14s %-20s %-14s %12s %12s %6s %13s\n", "object", "drawn", "planes needed",
              "method", "along object", "in image", "meets", "cost, times 1");
  for (const OrderedJson& object : image["objects"]) {
    std::printf("%-20s %-14s", Cell(object["object"]).c_str(),
                object["drawn"].get<std::string>().c_str());
    if (object.contains("refused")) {
      std::printf(" refused: %s", object["refused"].get<std::string>().c_str());
    } else if (object.contains("planes") && object["method"].is_null()) {
      std::printf(" %-20s %-14s %12s %12s %6s", Cell(object["planes"]).c_str(), "none", "-", "-",
                  "no");
    } else if (object.contains("planes")) {
      std::printf(" %-20s %-14s %12.2g %12.2g %6s", Cell(object["planes"]).c_str(),
                  Cell(object["method"]).c_str(), object["pixels_along_object"].get<double>(),
                  object["pixels_in_image"].get<double>(), object["meets"] ? "yes" : "no");
      if (object["cost"].is_null())
        std::printf(" %13s\n  the table of costs does not have `%s`", "unknown",
                    object["method"].get<std::string>().c_str());
      else
        std::printf(" %13.3f", object["cost"].get<double>());
    }
    if (object.contains("command"))
      std::printf("\n  %s", object["command"].get<std::string>().c_str());
    if (object.contains("cure")) std::printf("\n  %s", object["cure"].get<std::string>().c_str());
    std::printf("\n");
  }
}

void WriteFile(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw DrawError("cannot write `" + path + "`");
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
  std::string costs_path, variants_path, json_path;
  bool help = false;
  const std::vector<std::string> paths = Parse(arguments, {{"costs", Text(costs_path)},
                                                           {"variants", Text(variants_path)},
                                                           {"json", Text(json_path)},
                                                           {"help", On(help)}});
  if (help) return std::fputs(kUsage, stdout) < 0;
  if (paths.size() != 1) throw DrawError(std::string("one scene is expected\n") + kUsage);
  const Scene scene = ReadScene(paths[0]);
  const CostTable costs = costs_path.empty() ? MeasuredCosts() : ReadCosts(costs_path);
  Variants variants;
  OrderedJson images = OrderedJson::array();
  int failures = 0;
  for (const NamedCamera& camera : scene.cameras) {
    OrderedJson objects = OrderedJson::array();
    const std::vector<ObjectAdvice> advice = [&] {
      Progress progress("objects");
      return AdviseScene(scene, camera.camera, costs, std::ref(progress));
    }();
    for (std::size_t i = 0; i < advice.size(); ++i) {
      objects.push_back(JsonOf(scene.objects[i], advice[i], scene));
      failures += advice[i].fails();
      if (!advice[i].best || !advice[i].best->possible) continue;
      int& most = variants[advice[i].best->way];
      most = std::max(most, std::popcount(advice[i].plan.needed));
    }
    images.push_back(
        {{"scene", scene.name},
         {"camera", camera.name},
         {"planes", scene.planes.size()},
         {"tolerance", scene.tolerance},
         {"judged_in", scene.judged_in == runtime::JudgedIn::kImage ? "image" : "surface"},
         {"objects", std::move(objects)}});
    Print(images.back());
  }
  for (const auto& [way, planes] : variants) {
    std::printf("build: %s with up to %s\n", way.c_str(),
                Counted(static_cast<std::size_t>(planes), "plane").c_str());
  }
  if (failures > 0) {
    std::printf(
        "%s without a method that keeps the tolerance: see `meets`, `refused` and method `none`\n",
        Counted(static_cast<std::size_t>(failures), "object").c_str());
  }
  if (!variants_path.empty()) WriteFile(variants_path, VariantList(scene, variants));
  if (!json_path.empty()) WriteFile(json_path, images.dump(2) + "\n");
  return failures > 0 ? 1 : 0;
}

}  // namespace clipc::study
