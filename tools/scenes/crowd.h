// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "runtime/matrix.h"

// Scenes of many objects and a few planes, for the planner.
namespace clipc::scenes {

enum class Shape { kTeapot, kTorus, kCube };
inline constexpr int kShapes = 3;

struct CrowdObject {
  Shape shape;
  runtime::Matrix world;
};

struct Crowd {
  std::string name;
  std::vector<CrowdObject> objects;
  runtime::Matrix view;
  runtime::Matrix projection;          // 0 <= z <= w
  std::vector<runtime::Plane> planes;  // 1 to 6, in world space
};

// A thousand objects each: hills in a lake, reflected; a room behind a portal, which is four edges
// and itself; a cloud of parts cut away by three planes, and the same cloud inside of a box of six.
Crowd WaterCrowd();
Crowd PortalCrowd();
Crowd CutawayCrowd();
Crowd BoxCrowd();

// Some objects and one to six planes, of which some lie exactly in a face of a cube; perspective or
// orthographic.
Crowd RandomCrowd(std::mt19937& random);

}  // namespace clipc::scenes
