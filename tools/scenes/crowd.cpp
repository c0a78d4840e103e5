// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/scenes/crowd.h"

#include <cmath>

#include "examples/shared/transform.h"
#include "runtime/mirror.h"

namespace clipc::scenes {
namespace {

using examples::Cross;
using examples::Dot;
using examples::LookAt;
using examples::Perspective;
using examples::Unit;
using examples::Vector;
using runtime::Matrix;
using runtime::Multiply;
using runtime::Plane;

constexpr int kObjects = 1000;
constexpr double kPi = 3.14159265358979323846;

// std::uniform_real_distribution differs between libraries.
double Uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }
double Between(std::mt19937& random, double low, double high) {
  return low + (high - low) * Uniform(random);
}
// Around 1, seldom far from it: as sizes of things are.
double Size(std::mt19937& random, double spread) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += Uniform(random);
  return std::exp(spread * sum);
}

Vector Direction(std::mt19937& random) {
  const double y = Between(random, -1, 1), angle = Between(random, 0, 2 * kPi),
               r = std::sqrt(1 - y * y);
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

Matrix Place(std::mt19937& random, double x, double y, double z, double size) {
  const Vector a = Direction(random), b = Unit(Cross(a, Direction(random))), c = Cross(a, b);
  return {{{size * a.x, size * a.y, size * a.z, 0},
           {size * b.x, size * b.y, size * b.z, 0},
           {size * c.x, size * c.y, size * c.z, 0},
           {x, y, z, 1}}};
}

void Add(Crowd& crowd, std::mt19937& random, double x, double y, double z, double size) {
  crowd.objects.push_back({static_cast<Shape>(random() % kShapes), Place(random, x, y, z, size)});
}

Plane Normalized(Plane plane) {
  const double length = runtime::NormalLength(plane);
  return {plane.x / length, plane.y / length, plane.z / length, plane.w / length};
}

// The plane of a cube's face, kept to one side or the other.
Plane FaceOf(std::mt19937& random, const Matrix& world) {
  const double(&row)[4] = world.m[random() % 3];
  const double side = random() % 2 == 0 ? 1 : -1, kept = random() % 2 == 0 ? 1 : -1;
  const Vector normal{row[0], row[1], row[2]};
  const Vector point{world.m[3][0] + side * row[0], world.m[3][1] + side * row[1],
                     world.m[3][2] + side * row[2]};
  return Normalized(
      {kept * normal.x, kept * normal.y, kept * normal.z, -kept * Dot(normal, point)});
}

Crowd Cloud(const char* name) {
  std::mt19937 random(3);
  Crowd crowd{name, {}, LookAt({0, 3, -14}, {0, 0, 0}), Perspective(1, 16.0 / 9, 0.5, 60), {}};
  for (int i = 0; i < kObjects; ++i) {
    const double r = 5 * std::sqrt(Uniform(random)), angle = Between(random, 0, 2 * kPi);
    Add(crowd, random, r * std::cos(angle), Between(random, -5, 5), r * std::sin(angle),
        0.1 * Size(random, 0.6));
  }
  return crowd;
}

}  // namespace

Crowd WaterCrowd() {
  std::mt19937 random(1);
  Crowd crowd{"water", {}, {}, Perspective(1, 16.0 / 9, 0.5, 500), {{0, 1, 0, 0}}};
  for (int i = 0; i < kObjects; ++i) {
    const double x = Between(random, -200, 200), z = Between(random, 0, 400),
                 size = Size(random, 0.7);
    const double ground = 6 * std::sin(0.03 * x) + 6 * std::cos(0.04 * z) + 3;
    Add(crowd, random, x, ground + 0.8 * size, z, size);
  }
  crowd.view =
      Multiply(runtime::MirrorMatrix(crowd.planes[0]).value, LookAt({0, 4, 0}, {0, 0, 30}));
  return crowd;
}

Crowd PortalCrowd() {
  std::mt19937 random(2);
  Crowd crowd{"portal", {}, {}, Perspective(1, 16.0 / 9, 0.5, 200), {}};
  for (int i = 0; i < kObjects; ++i) {
    const double x = Between(random, -30, 30), y = Between(random, -10, 10),
                 z = Between(random, 8, 88);
    Add(crowd, random, x, y, z, Between(random, 0.2, 1));
  }
  // 3 wide, 4.4 high, 8 in front of the eye.
  crowd.planes = {Normalized({8, 0, 1.5, 0}),
                  Normalized({-8, 0, 1.5, 0}),
                  Normalized({0, 8, 2.2, 0}),
                  Normalized({0, -8, 2.2, 0}),
                  {0, 0, 1, -8}};
  return crowd;
}

Crowd CutawayCrowd() {
  Crowd crowd = Cloud("cutaway");
  crowd.planes = {{1, 0, 0, 0.2}, {0, 0, 1, 1}, {0, -1, 0, 3}};
  return crowd;
}

Crowd BoxCrowd() {
  Crowd crowd = Cloud("box");
  for (const double side : {-1.0, 1.0}) {
    crowd.planes.push_back({side, 0, 0, 2.5});
    crowd.planes.push_back({0, side, 0, 2.5});
    crowd.planes.push_back({0, 0, side, 2.5});
  }
  return crowd;
}

Crowd RandomCrowd(std::mt19937& random) {
  Crowd crowd{"random", {}, {}, {}, {}};
  const int objects = 4 + static_cast<int>(random() % 9),
            planes = 1 + static_cast<int>(random() % 6);
  for (int i = 0; i < objects; ++i) {
    Add(crowd, random, Between(random, -4, 4), Between(random, -4, 4), Between(random, -4, 4),
        Between(random, 0.3, 1.2));
  }
  for (int i = 0; i < planes; ++i) {
    if (random() % 3 == 0) {
      CrowdObject& object = crowd.objects[random() % crowd.objects.size()];
      object.shape = Shape::kCube;
      crowd.planes.push_back(FaceOf(random, object.world));
    } else {
      const Vector normal = Direction(random);
      // Mostly kept, or nothing would be left of six.
      crowd.planes.push_back({normal.x, normal.y, normal.z, Between(random, -1, 5)});
    }
  }
  const Vector to_eye = Direction(random);
  const double distance = Between(random, 7, 16);
  crowd.view = LookAt({distance * to_eye.x, distance * to_eye.y, distance * to_eye.z}, {0, 0, 0});
  const double near_z = std::pow(10, Between(random, -2, 0));
  if (random() % 4 == 0) {
    crowd.projection = {{{0.2, 0, 0, 0}, {0, 0.2, 0, 0}, {0, 0, 1.0 / 40, 0}, {0, 0, 0, 1}}};
  } else {
    crowd.projection = Perspective(Between(random, 0.4, 1.4), 1, near_z, 100);
  }
  return crowd;
}

}  // namespace clipc::scenes
