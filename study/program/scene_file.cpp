// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/scene_file.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include <nlohmann/json.hpp>

#include "study/program/gltf_scene.h"
#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"

namespace clipc::study {
namespace {

using harness::DrawError;
using Json = nlohmann::json;

constexpr double kLongest = 1e12;  // of the lengths in a scene

std::string TooLong(double length) {
  char what[120];
  std::snprintf(
      what, sizeof what,
      "has %g; lengths are at most %g, since farther away matrices in double lose what an "
      "image shows",
      length, kLongest);
  return what;
}

// One JSON object; every key must be asked for, so that a misspelt one is an error.
class Reader {
 public:
  Reader(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
    if (!json_.is_object()) Fail("", "is not an object");
  }

  double Number(const char* key, double standard) {
    const Json* value = Find(key);
    if (!value) return standard;
    if (!value->is_number() || !std::isfinite(value->get<double>())) Fail(key, "is not a number");
    return value->get<double>();
  }
  double Positive(const char* key, double standard) {
    const double number = Number(key, standard);
    if (!(number > 0)) Fail(key, "is not positive");
    return number;
  }
  bool Flag(const char* key, bool standard) {
    const Json* value = Find(key);
    if (value && !value->is_boolean()) Fail(key, "is neither true nor false");
    return value ? value->get<bool>() : standard;
  }
  std::string Text(const char* key, const std::string& standard) {
    const Json* value = Find(key);
    if (value && !value->is_string()) Fail(key, "is not a string");
    return value ? value->get<std::string>() : standard;
  }
  bool IsText(const char* key) {
    const Json* value = Find(key);
    return value && value->is_string();
  }
  template <std::size_t N>
  void Numbers(const char* key, double (&to)[N], bool required = true) {
    const Json* value = Find(key);
    if (!value && !required) return;
    if (!value) Fail(key, "is missing");
    if (!value->is_array() || value->size() != N)
      Fail(key, "is not an array of " + std::to_string(N) + " numbers");
    for (std::size_t i = 0; i < N; ++i) {
      if (!(*value)[i].is_number())
        Fail(key, "is not an array of " + std::to_string(N) + " numbers");
      to[i] = (*value)[i].get<double>();
    }
  }
  // Fails where a number of `key` is longer than any length may be.
  template <std::size_t N>
  void CheckLengths(const char* key, const double (&lengths)[N]) const {
    for (const double length : lengths) {
      if (!(std::fabs(length) <= kLongest)) Fail(key, TooLong(length));
    }
  }
  // Calls read(element, where) for each element of the list `key`.
  template <typename Read>
  void List(const char* key, Read read) {
    const Json* value = Find(key);
    if (!value || !value->is_array() || value->empty()) Fail(key, "is not an array with elements");
    for (std::size_t i = 0; i < value->size(); ++i)
      read((*value)[i], where_ + key + "[" + std::to_string(i) + "].");
  }
  void NothingElse() const {
    for (const auto& [key, value] : json_.items()) {
      if (!known_.contains(key)) Fail(key, "is not known here");
    }
  }
  [[noreturn]] void Fail(const std::string& key, const std::string& what) const {
    throw DrawError("`" + where_ + key + "` " + what);
  }

 private:
  const Json* Find(const char* key) {
    known_.insert(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
  }

  const Json& json_;
  std::string where_;
  std::set<std::string> known_;
};

Camera CameraFrom(Reader& reader) {
  Camera camera;
  camera.orthographic = reader.Flag("orthographic", false);
  camera.reversed = reader.Flag("reversed", false);
  camera.infinite = reader.Flag("infinite", false);
  camera.near = reader.Positive("near", camera.near),
  camera.far = reader.Positive("far", camera.far);
  camera.fov = reader.Positive("fov", camera.fov),
  camera.half_height = reader.Positive("half_height", camera.half_height);
  camera.aspect = reader.Positive("aspect", camera.aspect);
  double offset[2] = {0, 0};
  reader.Numbers("offset", offset, false);
  camera.offset_x = offset[0], camera.offset_y = offset[1];
  reader.Numbers("eye", camera.eye, false);
  reader.CheckLengths("eye", camera.eye);
  camera.yaw = reader.Number("yaw", 0), camera.pitch = reader.Number("pitch", 0),
  camera.roll = reader.Number("roll", 0);
  if (camera.fov >= 180) reader.Fail("fov", "is 180 degrees or more");
  if (!camera.infinite && camera.far <= camera.near)
    reader.Fail("far", "is not farther than `near`");
  if (camera.infinite && camera.orthographic) reader.Fail("infinite", "is for perspectives");
  return camera;
}

runtime::MatrixOrder OrderFrom(Reader& reader) {
  if (!reader.IsText("one_matrix"))
    return reader.Flag("one_matrix", true) ? runtime::MatrixOrder::kOneMatrix
                                           : runtime::MatrixOrder::kWorldFirst;
  const auto order = OrderNamed(reader.Text("one_matrix", ""));
  if (!order) reader.Fail("one_matrix", kUnknownOrder);
  return *order;
}

SceneObject ObjectFrom(Reader& reader, std::size_t number) {
  SceneObject object;
  object.name = reader.Text("name", "object " + std::to_string(number));
  object.rigid = reader.Flag("rigid", true);
  double low[3], high[3], world[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  reader.Numbers("low", low), reader.Numbers("high", high), reader.Numbers("world", world, false);
  reader.CheckLengths("low", low), reader.CheckLengths("high", high);
  reader.CheckLengths("world", world);
  for (int i = 0; i < 4; ++i) {
    if (world[4 * i + 3] != (i == 3))
      reader.Fail("world", "is not a world matrix: elements 3, 7, 11 and 15 are 0, 0, 0 and 1");
  }
  for (int i = 0; i < 3; ++i) {
    if (!(low[i] <= high[i])) reader.Fail("low", "lies above `high`");
    // The bounds are rounded outwards, so that the box still holds everything.
    object.box.low[i] = std::nextafter(static_cast<float>(low[i]), -INFINITY);
    object.box.high[i] = std::nextafter(static_cast<float>(high[i]), INFINITY);
  }
  object.world = runtime::RowVectorMatrix(world);
  return object;
}

Scene SceneFrom(const Json& json) {
  Reader reader(json, "");
  if (reader.Text("schema", "") != "clipc.study-scene")
    reader.Fail("schema", "is not \"clipc.study-scene\"");
  if (reader.Number("version", 0) != 1) reader.Fail("version", "is not 1");
  Scene scene;
  scene.name = reader.Text("name", "scene");
  scene.image_height = reader.Positive("picture_height", 1080);
  scene.tolerance = reader.Positive("tolerance", 0.5);
  scene.means.clip_distances = reader.Flag("clip_distances", true);
  scene.means.user_planes = reader.Flag("user_planes", false);
  scene.means.can_discard = reader.Flag("can_discard", true);
  scene.means.order = OrderFrom(reader);
  const std::string judged_in = reader.Text("judged_in", "image");
  if (judged_in != "image" && judged_in != "surface")
    reader.Fail("judged_in", "is neither \"image\" nor \"surface\"");
  if (judged_in == "surface") scene.judged_in = runtime::JudgedIn::kSurface;
  reader.List("cameras", [&](const Json& element, const std::string& where) {
    Reader camera(element, where);
    scene.cameras.push_back({camera.Text("name", "camera " + std::to_string(scene.cameras.size())),
                             CameraFrom(camera)});
    camera.NothingElse();
  });
  reader.List("planes", [&](const Json& element, const std::string& where) {
    Reader plane(element, where);
    double c[4];
    plane.Numbers("plane", c);
    scene.planes.push_back({plane.Text("name", "plane " + std::to_string(scene.planes.size())),
                            {c[0], c[1], c[2], c[3]}});
    plane.NothingElse();
  });
  if (scene.planes.size() > 6) reader.Fail("planes", "has more than 6 elements");
  reader.List("objects", [&](const Json& element, const std::string& where) {
    Reader object(element, where);
    scene.objects.push_back(ObjectFrom(object, scene.objects.size()));
    object.NothingElse();
  });
  reader.NothingElse();
  return scene;
}

// The scene of a glTF file, whose lengths are checked as those of the other format are.
Scene CheckedGltf(const std::string& bytes, const std::string& folder) {
  Scene scene = GltfScene(bytes, folder);
  const auto check = [](const std::string& name, double length) {
    if (!(std::fabs(length) <= kLongest)) throw DrawError("`" + name + "` " + TooLong(length));
  };
  for (const NamedCamera& camera : scene.cameras) {
    for (const double length : camera.camera.eye) check(camera.name, length);
  }
  for (const SceneObject& object : scene.objects) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) check(object.name, object.world.m[i][j]);
      if (object.world.m[i][3] != (i == 3))
        throw DrawError("`" + object.name + "` has a matrix whose last row is not 0, 0, 0, 1");
    }
    for (int i = 0; i < 3; ++i) {
      check(object.name, static_cast<double>(object.box.low[i]));
      check(object.name, static_cast<double>(object.box.high[i]));
    }
  }
  return scene;
}

std::string FolderOf(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

}  // namespace

std::optional<runtime::MatrixOrder> OrderNamed(const std::string& name) {
  using enum runtime::MatrixOrder;
  if (name == "world-view") return kWorldViewFirst;
  if (name == "three") return kThreeMatrices;
  if (name == "float") return kFloatViewProjection;
  if (name == "float-world-view") return kFloatWorldView;
  return std::nullopt;
}

Scene ReadScene(const std::string& path) {
  const std::string bytes = harness::ReadFile(path);
  try {
    if (bytes.starts_with("glTF")) return CheckedGltf(bytes, FolderOf(path));
    const Json json = Json::parse(bytes, nullptr, false);
    if (json.is_discarded()) throw DrawError("the file is not JSON");
    if (json.is_object() && json.contains("asset")) return CheckedGltf(bytes, FolderOf(path));
    return SceneFrom(json);
  } catch (const DrawError& error) {
    throw DrawError(path + ": " + error.what());
  }
}

}  // namespace clipc::study
