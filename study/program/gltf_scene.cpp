// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include "study/program/scene_file.h"
#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

using harness::DrawError;

constexpr int kDeepestJson = 64;
constexpr std::size_t kMostObjects = 1'000'000;

[[noreturn]] void Fail(const std::string& where, const std::string& what) {
  throw DrawError("`" + where + "` " + what);
}

void Require(bool holds, const std::string& where, const std::string& what) {
  if (!holds) Fail(where, what);
}

std::string At(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

// The element of a list that an index of the file names.
template <typename T>
const T& ElementOf(const std::vector<T>& list, int index, const std::string& where) {
  if (index < 0 || static_cast<std::size_t>(index) >= list.size()) {
    Fail(where, "is " + std::to_string(index) + ", of " + std::to_string(list.size()));
  }
  return list[index];
}

// The JSON of a .glb file is its first chunk, after twenty bytes.
std::string_view JsonOf(const std::string& bytes, bool is_binary) {
  if (!is_binary) return bytes;
  if (bytes.size() < 20) throw DrawError("the file ends within the header of a .glb");
  std::uint32_t length = 0;
  for (int i = 3; i >= 0; --i) length = length << 8 | static_cast<unsigned char>(bytes[12 + i]);
  if (length > bytes.size() - 20) throw DrawError("the file ends within the JSON of a .glb");
  return std::string_view(bytes).substr(20, length);
}

// The loader goes through extras and extensions by recursion: a depth that no real file has is
// refused before.
void CheckDepth(std::string_view json) {
  bool is_deep = false;
  const auto visit = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    is_deep |= depth > kDeepestJson;
    return !is_deep;
  };
  if (nlohmann::json::parse(json, visit, false).is_discarded() && !is_deep) {
    throw DrawError("the file is not JSON");
  }
  if (is_deep) throw DrawError("the JSON is nested deeper than 64 levels");
}

tinygltf::Model Load(const std::string& bytes, const std::string& folder) {
  const bool is_binary = bytes.starts_with("glTF");
  CheckDepth(JsonOf(bytes, is_binary));
  tinygltf::TinyGLTF loader;
  // Images are not decoded.
  loader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int,
                           const unsigned char*, int, void*) { return true; },
                        nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const auto size = static_cast<unsigned>(bytes.size());
  bool ok = false;
  try {
    ok = is_binary
             ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(bytes.data()),
                                           size, folder)
             : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder);
  } catch (const std::exception& problem) {
    error = problem.what();
  }
  if (!ok) throw DrawError("no glTF: " + error.substr(0, error.find('\n')));
  return model;
}

class Converter {
 public:
  explicit Converter(const tinygltf::Model& model) : model_(model) {}

  Scene Run() {
    if (!model_.asset.version.starts_with("2.")) {
      Fail("asset.version", "is \"" + model_.asset.version + "\"; only 2.0 is read");
    }
    const tinygltf::Scene& root =
        ElementOf(model_.scenes, std::max(model_.defaultScene, 0), "scene");
    scene_.name = root.name.empty() ? "scene" : root.name;
    Extras(root.extras);
    PlaceNodes(root);
    for (std::size_t i : placed_) Take(i);
    if (scene_.cameras.empty()) throw DrawError("the scene has no camera");
    if (scene_.planes.empty()) {
      throw DrawError(
          "no node of the scene has `extras` with `clip_plane`: there is no plane to clip by");
    }
    if (scene_.planes.size() > 6)
      throw DrawError("more than 6 nodes have `extras` with `clip_plane`");
    if (scene_.objects.empty()) throw DrawError("the scene has no mesh");
    return std::move(scene_);
  }

 private:
  // ---- extras

  static bool Flag(const tinygltf::Value& extras, const char* key, bool standard,
                   const std::string& where) {
    if (!extras.IsObject() || !extras.Has(key)) return standard;
    Require(extras.Get(key).IsBool(), where + ".extras." + key, "is neither true nor false");
    return extras.Get(key).Get<bool>();
  }
  static double Positive(const tinygltf::Value& extras, const char* key, double standard) {
    if (!extras.IsObject() || !extras.Has(key)) return standard;
    const tinygltf::Value& value = extras.Get(key);
    const double number = value.IsNumber() ? value.GetNumberAsDouble() : 0;
    Require(number > 0, std::string("scene.extras.") + key, "is not a positive number");
    return number;
  }

  void Extras(const tinygltf::Value& extras) {
    scene_.image_height = Positive(extras, "picture_height", scene_.image_height);
    scene_.tolerance = Positive(extras, "tolerance", scene_.tolerance);
    Means& means = scene_.means;
    means.clip_distances = Flag(extras, "clip_distances", means.clip_distances, "scene");
    means.user_planes = Flag(extras, "user_planes", means.user_planes, "scene");
    means.can_discard = Flag(extras, "can_discard", means.can_discard, "scene");
    if (extras.IsObject() && extras.Has("judged_in")) {
      const auto& value = extras.Get("judged_in");
      const std::string judged_in = value.IsString() ? value.Get<std::string>() : "";
      Require(judged_in == "image" || judged_in == "surface", "scene.extras.judged_in",
              "is neither \"image\" nor \"surface\"");
      if (judged_in == "surface") scene_.judged_in = runtime::JudgedIn::kSurface;
    }
    if (extras.IsObject() && extras.Has("one_matrix") && extras.Get("one_matrix").IsString()) {
      const auto order = OrderNamed(extras.Get("one_matrix").Get<std::string>());
      Require(order.has_value(), "scene.extras.one_matrix", kUnknownOrder);
      means.order = *order;
    } else if (!Flag(extras, "one_matrix", true, "scene")) {
      means.order = runtime::MatrixOrder::kWorldFirst;
    }
  }

  // ---- where the nodes are

  // Lists the nodes, parents before children. A node that is reached twice, or through itself, is
  // refused.
  void PlaceNodes(const tinygltf::Scene& root) {
    to_world_.resize(model_.nodes.size());
    struct Visit {
      int node;
      Matrix parent;
      std::string where;
    };
    std::vector<Visit> steps;
    const auto add = [&](const std::vector<int>& nodes, const Matrix& parent,
                         const std::string& list) {
      for (std::size_t i = nodes.size(); i-- > 0;)
        steps.push_back({nodes[i], parent, At(list.c_str(), i)});
    };
    add(root.nodes, Matrix(), "scene.nodes");
    while (!steps.empty()) {
      const Visit step = std::move(steps.back());
      steps.pop_back();
      const tinygltf::Node& node = ElementOf(model_.nodes, step.node, step.where);
      const std::size_t index = step.node;
      const std::string name = At("nodes", index);
      Require(!to_world_[index], name, "is reached twice; the nodes of a scene are trees");
      const Matrix world = Multiply(LocalOf(node, name), step.parent);
      for (const auto& row : world.m) {
        for (const double x : row) {
          if (!std::isfinite(x)) Fail(name, "is moved beyond all numbers");
        }
      }
      to_world_[index] = world;
      placed_.push_back(index);
      add(node.children, world, name + ".children");
    }
  }

  static void CheckSize(const std::vector<double>& list, std::size_t size,
                        const std::string& where) {
    Require(list.size() == size, where, "is not an array of " + std::to_string(size) + " numbers");
  }

  // The matrix is for row vectors, as all matrices here.
  static Matrix LocalOf(const tinygltf::Node& node, const std::string& name) {
    if (!node.matrix.empty()) {
      CheckSize(node.matrix, 16, name + ".matrix");
      double elements[16];
      std::ranges::copy(node.matrix, elements);
      return runtime::RowVectorMatrix(elements);
    }
    Matrix local;
    if (!node.rotation.empty()) {
      CheckSize(node.rotation, 4, name + ".rotation");
      const double length = std::hypot(std::hypot(node.rotation[0], node.rotation[1]),
                                       std::hypot(node.rotation[2], node.rotation[3]));
      Require(std::fabs(length - 1) < 1e-2, name + ".rotation", "is not a unit quaternion");
      const double x = node.rotation[0] / length, y = node.rotation[1] / length;
      const double z = node.rotation[2] / length, w = node.rotation[3] / length;
      local = {{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0},
                {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0},
                {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0},
                {0, 0, 0, 1}}};
    }
    if (!node.scale.empty()) {
      CheckSize(node.scale, 3, name + ".scale");
      for (std::size_t i = 0; i < 3; ++i) {
        for (double& x : local.m[i]) x *= node.scale[i];
      }
    }
    if (!node.translation.empty()) {
      CheckSize(node.translation, 3, name + ".translation");
      std::ranges::copy(node.translation, local.m[3]);
    }
    return local;
  }

  // Returns `matrix`, followed by the mirroring from glTF's world to the scene's.
  static Matrix Mirrored(Matrix matrix) {
    for (auto& row : matrix.m) row[2] = -row[2];
    return matrix;
  }

  // Returns false where the vector has no direction.
  static bool Normalize(Vector& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    v = v / length;
    return length > 0 && std::isfinite(length);
  }

  // ---- what the nodes carry

  void Take(std::size_t index) {
    const tinygltf::Node& node = model_.nodes[index];
    const std::string where = At("nodes", index);
    const Matrix& world = *to_world_[index];
    if (Flag(node.extras, "clip_plane", false, where)) TakePlane(node, world, where);
    if (node.camera >= 0) TakeCamera(node, world, where);
    if (node.mesh < 0) return;
    if (node.extensions.contains("EXT_mesh_gpu_instancing")) {
      Fail(where + ".extensions.EXT_mesh_gpu_instancing",
           "draws the mesh in places that are not looked at");
    }
    TakeMesh(node, world, where);
  }

  static std::string NameOf(const std::string& name, const std::string& other,
                            const std::string& where) {
    return !name.empty() ? name : !other.empty() ? other : where;
  }

  // Adds the plane of a node, which keeps y >= 0 in the node's own space.
  void TakePlane(const tinygltf::Node& node, const Matrix& world, const std::string& where) {
    const Matrix axes = Mirrored(world);
    Vector normal = Cross(RowOf(axes, 2), RowOf(axes, 0));
    Require(Normalize(normal), where, "has no plane: its scale is 0");
    if (Dot(normal, RowOf(axes, 1)) < 0) normal = -1 * normal;
    scene_.planes.push_back({NameOf(node.name, "", where),
                             {normal.x, normal.y, normal.z, -Dot(normal, RowOf(axes, 3))}});
  }

  // Adds the camera of a node, whose scale does not count.
  void TakeCamera(const tinygltf::Node& node, const Matrix& world, const std::string& where) {
    const tinygltf::Camera& from = ElementOf(model_.cameras, node.camera, where + ".camera");
    const std::string place = At("cameras", node.camera);
    Camera camera;
    if (from.type == "orthographic") {
      Lens(from.orthographic, place + ".orthographic", camera);
    } else {
      Lens(from.perspective, place + ".perspective", camera);
    }
    // The camera looks along -z in its own space, which is mirrored as the world is.
    const Matrix to_world = Mirrored(world);
    Vector x = RowOf(to_world, 0), y = RowOf(to_world, 1), z = -1 * RowOf(to_world, 2);
    Require(Normalize(x) && Normalize(y) && Normalize(z), where, "is a camera of scale 0");
    if (std::fabs(Dot(x, y)) > 1e-6 || std::fabs(Dot(Cross(y, z), x) - 1) > 1e-6) {
      Fail(where, "is a camera whose space is skewed or mirrored");
    }
    std::copy(to_world.m[3], to_world.m[3] + 3, camera.eye);
    // The rows of Rotation(yaw, pitch, roll), read backwards.
    const double level = std::hypot(z.x, z.z);
    camera.pitch = std::atan2(-z.y, level);
    const bool is_upright = level > 1e-9;
    camera.yaw = is_upright ? std::atan2(z.x, z.z) : std::atan2(-x.z, x.x);
    camera.roll = is_upright ? std::atan2(x.y, y.y) : 0;
    scene_.cameras.push_back({NameOf(node.name, from.name, where), camera});
  }

  static void Lens(const tinygltf::PerspectiveCamera& from, const std::string& where, Camera& to) {
    Require(from.yfov > 0 && from.yfov < std::numbers::pi, where + ".yfov",
            "is not between 0 and pi");
    Require(from.znear > 0, where + ".znear", "is not positive");
    Require(from.aspectRatio >= 0, where + ".aspectRatio", "is not positive");
    to.infinite = from.zfar == 0;  // absent
    if (!to.infinite && !(from.zfar > from.znear))
      Fail(where + ".zfar", "is not farther than `znear`");
    to.fov = from.yfov * 180 / std::numbers::pi;
    if (from.aspectRatio > 0) to.aspect = from.aspectRatio;
    to.near = from.znear;
    if (!to.infinite) to.far = from.zfar;
  }

  static void Lens(const tinygltf::OrthographicCamera& from, const std::string& where, Camera& to) {
    Require(from.xmag > 0, where + ".xmag", "is not positive");
    Require(from.ymag > 0, where + ".ymag", "is not positive");
    Require(from.znear >= 0, where + ".znear", "is negative");
    Require(from.zfar > from.znear, where + ".zfar", "is not farther than `znear`");
    to.orthographic = true;
    to.half_height = from.ymag, to.aspect = from.xmag / from.ymag;
    to.near = from.znear, to.far = from.zfar;
  }

  // ---- meshes: one object for each primitive, as each is one draw

  struct Bounds {
    double low[3], high[3];
    void Add(const double (&point)[3]) {
      for (int i = 0; i < 3; ++i)
        low[i] = std::min(low[i], point[i]), high[i] = std::max(high[i], point[i]);
    }
  };
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr Bounds kNothing = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};

  void TakeMesh(const tinygltf::Node& node, const Matrix& world, const std::string& where) {
    const tinygltf::Mesh& mesh = ElementOf(model_.meshes, node.mesh, where + ".mesh");
    const std::string place = At("meshes", node.mesh);
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
      if (scene_.objects.size() >= kMostObjects)
        throw DrawError("the scene draws more than a million objects");
      const tinygltf::Primitive& primitive = mesh.primitives[i];
      const std::string part = place + "." + At("primitives", i);
      SceneObject object;
      object.name = NameOf(node.name, mesh.name, where);
      if (mesh.primitives.size() > 1) object.name += "/" + std::to_string(i);
      Bounds bounds = PositionBounds(primitive.attributes, part + ".attributes");
      // Vertices whose morph targets have weights between 0 and 1 stay within these bounds.
      for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
        if (!primitive.targets[t].contains("POSITION")) continue;
        const Bounds moved = PositionBounds(primitive.targets[t], part + "." + At("targets", t));
        for (int c = 0; c < 3; ++c)
          bounds.low[c] += std::min(moved.low[c], 0.0),
              bounds.high[c] += std::max(moved.high[c], 0.0);
      }
      object.rigid =
          node.skin < 0 && primitive.targets.empty() && Flag(node.extras, "rigid", true, where);
      object.world = Mirrored(world);
      if (node.skin >= 0) {
        bounds = SkinnedBounds(node.skin, bounds, where + ".skin");
        object.world = Mirrored(Matrix());
      }
      for (int c = 0; c < 3; ++c) {
        // The bounds are rounded outwards, so that the box still holds everything.
        object.box.low[c] = std::nextafter(static_cast<float>(bounds.low[c]), -INFINITY);
        object.box.high[c] = std::nextafter(static_cast<float>(bounds.high[c]), INFINITY);
      }
      scene_.objects.push_back(std::move(object));
    }
  }

  Bounds PositionBounds(const std::map<std::string, int>& attributes,
                        const std::string& where) const {
    const auto found = attributes.find("POSITION");
    if (found == attributes.end()) Fail(where, "has no POSITION");
    const tinygltf::Accessor& accessor =
        ElementOf(model_.accessors, found->second, where + ".POSITION");
    const std::string place = At("accessors", found->second);
    if (accessor.type != TINYGLTF_TYPE_VEC3 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      Fail(place, "holds positions and is not of float VEC3");
    }
    Bounds bounds = kNothing;
    for (const auto& [list, key] :
         {std::pair{&accessor.minValues, ".min"}, std::pair{&accessor.maxValues, ".max"}}) {
      CheckSize(*list, 3, place + key);
      bounds.Add({(*list)[0], (*list)[1], (*list)[2]});
    }
    for (std::size_t i = 0; i < 3; ++i) {
      Require(accessor.minValues[i] <= accessor.maxValues[i], place + ".min", "lies above `max`");
    }
    return bounds;
  }

  // The bounds, in the world, of the places where the joints would put the corners of `box`: a
  // skinned vertex lies between the places that its joints would put it.
  Bounds SkinnedBounds(int index, const Bounds& box, const std::string& where) const {
    const tinygltf::Skin& skin = ElementOf(model_.skins, index, where);
    const std::string place = At("skins", index);
    Require(!skin.joints.empty(), place + ".joints", "is empty");
    Bounds bounds = kNothing;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const std::string joint = place + "." + At("joints", j);
      const auto& to_world = ElementOf(to_world_, skin.joints[j], joint);
      Require(to_world.has_value(), joint, "is not a node of the scene");
      const Matrix bind = skin.inverseBindMatrices < 0 ? Matrix() : BindMatrix(skin, j, place);
      const Matrix m = Multiply(bind, *to_world);
      for (int corner = 0; corner < 8; ++corner) {
        double point[3];
        for (int c = 0; c < 3; ++c) {
          point[c] = m.m[3][c];
          for (int r = 0; r < 3; ++r)
            point[c] += (corner >> r & 1 ? box.high : box.low)[r] * m.m[r][c];
          if (!std::isfinite(point[c])) Fail(joint, "moves the mesh beyond all numbers");
        }
        bounds.Add(point);
      }
    }
    return bounds;
  }

  Matrix BindMatrix(const tinygltf::Skin& skin, std::size_t number,
                    const std::string& place) const {
    const std::string where = place + ".inverseBindMatrices";
    const tinygltf::Accessor& accessor =
        ElementOf(model_.accessors, skin.inverseBindMatrices, where);
    if (accessor.type != TINYGLTF_TYPE_MAT4 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || accessor.sparse.isSparse) {
      Fail(where, "is not of float MAT4 in one piece");
    }
    const tinygltf::BufferView& view =
        ElementOf(model_.bufferViews, accessor.bufferView, where + ".bufferView");
    const std::vector<unsigned char>& data =
        ElementOf(model_.buffers, view.buffer, where + ".bufferView.buffer").data;
    float matrix[16];
    const std::size_t stride = view.byteStride == 0 ? sizeof matrix : view.byteStride;
    const auto within = [](std::size_t from, std::size_t size, std::size_t whole) {
      return from <= whole && size <= whole - from;
    };
    const bool has_room =
        number < accessor.count && number < data.size() && stride <= data.size() &&
        within(view.byteOffset, view.byteLength, data.size()) &&
        within(accessor.byteOffset, number * stride, view.byteLength) &&
        within(accessor.byteOffset + number * stride, sizeof matrix, view.byteLength);
    Require(has_room, where, "ends before the matrix of joint " + std::to_string(number));
    std::memcpy(matrix, data.data() + view.byteOffset + accessor.byteOffset + number * stride,
                sizeof matrix);
    return runtime::RowVectorMatrix(matrix);
  }

  const tinygltf::Model& model_;
  Scene scene_;
  std::vector<std::optional<Matrix>> to_world_;  // by node; glTF's world; none: not in the scene
  std::vector<std::size_t> placed_;              // nodes, parents before children
};

}  // namespace

Scene GltfScene(const std::string& bytes, const std::string& folder) {
  const tinygltf::Model model = Load(bytes, folder);
  return Converter(model).Run();
}

}  // namespace clipc::study
