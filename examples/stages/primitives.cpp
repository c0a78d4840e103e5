// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <clipc/runtime/clip_plane.h>

#include "examples/stages/images.h"
#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/mesh.h"
#include "tools/harness/offscreen.h"

// What geometry shaders and tessellation make.
namespace stages {
namespace {

namespace runtime = clipc::runtime;

// What the constant buffers of the shaders begin with.
struct ViewConstants {
  std::array<float, 16> view_projection;
  runtime::Float4 plane;  // or a position
};

struct View {
  Matrix view, projection;

  View(Vector eye, Vector target)
      : view(LookAt(eye, target)),
        projection(Perspective(0.75, double{kWidth} / kHeight, 0.1, 100)) {}
  // The constants with a plane of the world in clip space.
  ViewConstants With(const runtime::Plane& plane) const {
    return {Columns(Multiply(view, projection)),
            Check(runtime::ClipPlaneFromWorld(plane, view, projection)).constant};
  }
};

// Passes on what the shaders after it read, in the world.
constexpr char kPassOn[] = R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 first;
layout(location = 1) out vec3 second;
void main() {
  gl_Position = vec4(position, 1.0);
  first = position;
  second = normal;
})";
constexpr char kPassNormalOn[] = R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 vs_normal;
layout(location = 1) out vec2 vs_uv;
void main() {
  gl_Position = vec4(position, 1.0);
  vs_normal = normal;
  vs_uv = position.xz;
})";
// Draws a mesh of the world, cut by a plane in clip space.
constexpr char kDraw[] = R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(std140, binding = 0) uniform View { layout(row_major) mat4 view_projection; vec4 plane; };
layout(location = 0) out vec3 color;
out float gl_ClipDistance[1];
void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  gl_ClipDistance[0] = dot(gl_Position, plane);
  color = normal;
})";
constexpr char kNormalFragment[] = R"(#version 450
layout(location = 0) in vec3 normal;
layout(location = 0) out vec4 target;
void main() { target = vec4(0.5 + 0.5 * normalize(normal), 1.0); })";

void Clear(float red, float green, float blue) {
  glClearColor(red, green, blue, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Add(Mesh& all, const Mesh& mesh, float x, float y, float z, float size = 1) {
  const auto first = static_cast<std::uint32_t>(all.vertices.size());
  for (Vertex vertex : mesh.vertices) {
    const float place[3] = {x, y, z};
    for (int i = 0; i < 3; ++i) vertex.position[i] = size * vertex.position[i] + place[i];
    all.vertices.push_back(vertex);
  }
  for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
}

}  // namespace

// The six faces, unfolded.
Image DrawCubeMap(const Folder& examples) {
  constexpr int kSide = 64;
  constexpr double kQuarter = std::numbers::pi / 2;
  // Where a face lies, and where its camera looks.
  constexpr struct {
    int x, y;
    double yaw, pitch;
  } kFaces[6] = {{2, 1, kQuarter, 0}, {0, 1, -kQuarter, 0}, {1, 0, 0, -kQuarter},
                 {1, 2, 0, kQuarter}, {1, 1, 0, 0},         {3, 1, 2 * kQuarter, 0}};
  std::vector<std::array<float, 16>> constants;
  for (const auto& face : kFaces) {
    const Matrix view = runtime::Transpose(Rotation(face.yaw, face.pitch));
    constants.push_back(Columns(Multiply(view, Perspective(kQuarter, 1, 0.1, 100))));
  }
  BindBuffer(GL_UNIFORM_BUFFER, 0, constants.data(), constants.size() * sizeof constants[0]);
  Mesh world;
  Add(world, Teapot(8), 0, -0.3F, 3, 1.2F);
  Add(world, Torus(24, 1.2, 0.5), 3, -0.4F, 0);
  Add(world, Cube(), -3, -0.2F, 0.8F, 0.9F);
  Add(world, Torus(24, 0.8, 0.2), 0, 2.5F, 0);
  Add(world, Teapot(8), 0, 0, -2.5F);
  Add(world, Ground(6, 1), 0, -1.5F, 0);

  GLuint textures[2], framebuffer = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 2, textures);
  glTextureStorage3D(textures[0], 1, GL_RGBA8, kSide, kSide, 6);
  glTextureStorage3D(textures[1], 1, GL_DEPTH_COMPONENT24, kSide, kSide, 6);
  glCreateFramebuffers(1, &framebuffer);
  glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, textures[0], 0);
  glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, textures[1], 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, kSide, kSide);
  glEnable(GL_DEPTH_TEST);
  Clear(0.8F, 0.9F, 1);
  UseProgram(kPassNormalOn, {{GL_GEOMETRY_SHADER, examples + "/geometry/cube_map.geom"}},
             kNormalFragment);
  MeshBuffers(world).Draw();

  // The layers lie below each other, the last one at the top.
  const Image layers = ImageOf(textures[0], kSide, 6 * kSide);
  Image image{4 * kSide, 3 * kSide, {}};
  image.rgba.resize(std::size_t{4 * 4 * 3} * kSide * kSide, 255);
  for (int i = 0; i < 6; ++i) {
    for (int y = 0; y < kSide; ++y)
      std::copy_n(layers.rgba.begin() + ByteAt(layers, 0, (5 - i) * kSide + y), 4 * kSide,
                  image.rgba.begin() + ByteAt(image, kFaces[i].x * kSide, kFaces[i].y * kSide + y));
  }
  return image;
}

namespace {

// The cube, whose triangles all turn the same way, as a shadow volume needs them.
Mesh OutwardCube() {
  Mesh cube = Cube();
  for (std::size_t i = 0; i < cube.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      const float* position = cube.vertices[cube.indices[i + k]].position;
      return Vector{position[0], position[1], position[2]};
    };
    if (Dot(Cross(at(1) - at(0), at(2) - at(0)), at(0)) < 0)
      std::swap(cube.indices[i + 1], cube.indices[i + 2]);
  }
  return cube;
}

// The triangles with the vertices of their neighbours between their own.
Mesh WithNeighbours(const Mesh& mesh) {
  using Place = std::tuple<long, long, long>;
  const auto place = [&](std::uint32_t index) {
    const float* at = mesh.vertices[index].position;
    return Place(std::lround(1000 * at[0]), std::lround(1000 * at[1]), std::lround(1000 * at[2]));
  };
  std::map<std::pair<Place, Place>, std::uint32_t> opposite;  // of an edge: the third vertex
  const auto corner = [&](std::size_t triangle, std::size_t i) {
    return mesh.indices[3 * triangle + i % 3];
  };
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    for (std::size_t i = 0; i < 3; ++i)
      opposite[{place(corner(t, i)), place(corner(t, i + 1))}] = corner(t, i + 2);
  }
  Mesh made{mesh.vertices, {}};
  for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = opposite.find({place(corner(t, i + 1)), place(corner(t, i))});
      made.indices.push_back(corner(t, i));
      made.indices.push_back(found == opposite.end() ? corner(t, i + 2) : found->second);
    }
  }
  return made;
}

constexpr char kLitFragment[] = R"(#version 450
layout(location = 0) in vec3 normal;
layout(location = 0) uniform float light;
layout(location = 1) uniform vec3 color;
layout(location = 0) out vec4 target;
void main() {
  const float sun = abs(dot(normalize(normal), normalize(vec3(-0.5, 1.0, -0.4))));
  target = vec4((0.35 + 0.65 * light * sun) * color, 1.0);
})";

// Draws the world, with or without the light of the sun.
void DrawLit(const Mesh& casters, const ViewConstants& constants, bool is_lit) {
  BindBuffer(GL_UNIFORM_BUFFER, 0, &constants, sizeof constants);
  UseProgram(kDraw, {}, kLitFragment);
  glUniform1f(0, is_lit ? 1.0F : 0.0F);
  glUniform3f(1, 0.9F, 0.45F, 0.25F);
  MeshBuffers(casters).Draw();
  Mesh ground;
  Add(ground, Ground(8, 1), 0, 0, 8);
  glUniform3f(1, 0.85F, 0.85F, 0.75F);
  MeshBuffers(ground).Draw();
}

}  // namespace

// The shadows are where a ray to the eye enters more volumes than it leaves.
Image DrawShadowVolume(const Folder& examples) {
  const Canvas canvas(2 * kWidth, 2 * kHeight);
  GLuint stencil = 0;
  glGenRenderbuffers(1, &stencil);
  glBindRenderbuffer(GL_RENDERBUFFER, stencil);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 2 * kWidth, 2 * kHeight);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, stencil);
  Clear(0.6F, 0.75F, 0.9F);

  Mesh casters;
  Add(casters, Torus(24, 1, 0.35), 1.3F, 1.2F, 6);
  Add(casters, OutwardCube(), -1.6F, 0.8F, 6.5F, 0.7F);
  const View view({0, 3.5, 0}, {0, 0.6, 6});
  ViewConstants constants = view.With({0, 0, 0, 1});
  DrawLit(casters, constants, false);

  constants.plane = {-3, 7, 4, 0};  // the light
  BindBuffer(GL_UNIFORM_BUFFER, 0, &constants, sizeof constants);
  UseProgram(kPassOn, {{GL_GEOMETRY_SHADER, examples + "/geometry/shadow_volume.geom"}},
             "#version 450\nvoid main() {}\n");
  glEnable(GL_STENCIL_TEST);
  glEnable(GL_DEPTH_CLAMP);  // the volume has no end
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  MeshBuffers(WithNeighbours(casters)).Draw(GL_TRIANGLES_ADJACENCY);

  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glStencilFunc(GL_EQUAL, 0, 0xff);
  glDepthFunc(GL_EQUAL);
  constants = view.With({0, 0, 0, 1});
  DrawLit(casters, constants, true);
  return Half(canvas.Read());
}

namespace {

constexpr char kHairFragment[] = R"(#version 450
layout(location = 0) in float along;
layout(location = 0) out vec4 target;
void main() { target = vec4(mix(vec3(0.3, 0.15, 0.05), vec3(1.0, 0.8, 0.4), along), 1.0); })";
constexpr char kSkinFragment[] = R"(#version 450
layout(location = 0) out vec4 target;
void main() { target = vec4(0.25, 0.12, 0.05, 1.0); })";

}  // namespace

// The plane of the water cuts the skin and the hairs, which are open there.
Image DrawFur(const Folder& examples) {
  const Canvas canvas(2 * kWidth, 2 * kHeight);
  Clear(0.25F, 0.45F, 0.6F);
  Mesh world;
  Add(world, Torus(40, 1.2, 0.55), 0, 0, 5);
  const struct {
    ViewConstants view;
    float wind[3], length;
  } constants = {View({0, 2.6, 0.5}, {0, -0.1, 5}).With({0, 1, 0, 0.1}), {0.5F, -0.4F, 0}, 0.5F};
  BindBuffer(GL_UNIFORM_BUFFER, 0, &constants, sizeof constants);
  glEnable(GL_CLIP_DISTANCE0);
  UseProgram(kDraw, {}, kSkinFragment);
  MeshBuffers(world).Draw();
  UseProgram(kPassOn, {{GL_GEOMETRY_SHADER, examples + "/geometry/fur.geom"}}, kHairFragment);
  MeshBuffers(world).Draw();
  return Half(canvas.Read());
}

namespace {

// Hills, whose heights are from 0 to 1.
void BindHeights(GLuint unit) {
  constexpr int kSide = 128;
  std::vector<float> heights;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const float u = static_cast<float>(x) / kSide, v = static_cast<float>(y) / kSide;
      heights.push_back(0.5F + 0.25F * std::sin(9 * u) * std::cos(8 * v + 1) +
                        0.25F * std::sin(21 * u + 13 * v));
    }
  }
  GLuint texture = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &texture);
  glTextureStorage2D(texture, 1, GL_R32F, kSide, kSide);
  glTextureSubImage2D(texture, 0, 0, 0, kSide, kSide, GL_RED, GL_FLOAT, heights.data());
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTextureUnit(unit, texture);
}

constexpr char kLandFragment[] = R"(#version 450
layout(location = 0) in vec3 normal;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 target;
void main() {
  const vec3 n = normalize(normal * vec3(1.0, 8.0, 1.0));
  const float sun = max(dot(n, normalize(vec3(-0.6, 0.8, -0.3))), 0.0);
  target = vec4(mix(vec3(0.4, 0.35, 0.3), vec3(0.35, 0.55, 0.2), n.y) * (0.3 + 0.9 * sun), 1.0);
})";

}  // namespace

// The land ends at the water, the colour behind it.
Image DrawTerrain(const Folder& examples) {
  constexpr GLuint kHeights = 64;  // the binding of t0 with s0
  const Canvas canvas(2 * kWidth, 2 * kHeight);
  Clear(0.2F, 0.4F, 0.6F);
  const Vector eye{0, 2.6, -0.5};
  const struct {
    ViewConstants view;
    float eye[3], height, cuts_at_one_unit, unused[3];
  } constants = {View(eye, {0, 0.2, 5}).With({0, 1, 0, -0.35}),
                 {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)},
                 1,
                 60,
                 {}};
  BindBuffer(GL_UNIFORM_BUFFER, 0, &constants, sizeof constants);
  BindHeights(kHeights);
  const Mesh patch{{{{-4, 0, 1}, {}}, {{4, 0, 1}, {}}, {{-4, 0, 9}, {}}, {{4, 0, 9}, {}}},
                   {0, 1, 2, 3}};
  glEnable(GL_CLIP_DISTANCE0);
  UseProgram(kPassOn,
             {{GL_TESS_CONTROL_SHADER, examples + "/tessellation/terrain.tesc"},
              {GL_TESS_EVALUATION_SHADER, examples + "/tessellation/terrain.tese"}},
             kLandFragment);
  glPatchParameteri(GL_PATCH_VERTICES, 4);
  MeshBuffers(patch).Draw(GL_PATCHES);
  return Half(canvas.Read());
}

}  // namespace stages
