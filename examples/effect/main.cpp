// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A Direct3D 9 effect on OpenGL: teapots in a lake, whose reflection is clipped at the water. The
// states, the sampler and the default values are the effect's, which no code here repeats.
//   effect [FILE.png]
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <clipc/effect-runtime/effect.h>
#include <clipc/runtime/clip_plane.h>
#include <clipc/runtime/mirror.h>

#include "tools/harness/camera.h"
#include "tools/harness/check.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"
#include "water.effect.h"

namespace {

using namespace clipc::harness;
namespace runtime = clipc::runtime;

constexpr runtime::Plane kWater{0, 1, 0, 0};  // keeps the points above the water, y >= 0
constexpr Vector kEye{0, 2.0, -1.5}, kTarget{0, 0.2, 6};
constexpr int kWidth = 480, kHeight = 300;

// The effect, with the exceptions of C++.
class Effect {
 public:
  explicit Effect(const clipc_gl_effect_table& table) {
    Check(clipc_gl_effect_create(OpenGl::Load, &table, &effect_, message_));
  }
  ~Effect() { clipc_gl_effect_free(effect_); }
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;

  void Set(const char* name, const Matrix& matrix) {
    const auto floats = Floats(matrix);
    Check(clipc_gl_effect_set(effect_, name, floats.data(), sizeof floats, message_));
  }
  void Set(const char* name, const runtime::Float4& value) {
    Check(clipc_gl_effect_set(effect_, name, &value, sizeof value, message_));
  }
  void SetTexture(const char* name, unsigned texture) {
    Check(clipc_gl_effect_set_texture(effect_, name, texture, message_));
  }
  // The parameter with a semantic, by which an engine knows what to set.
  const char* By(const char* semantic) const {
    const char* name = clipc_gl_effect_by_semantic(effect_, semantic);
    if (name == nullptr) throw std::runtime_error("the effect lacks " + std::string(semantic));
    return name;
  }
  std::uint32_t Find(const char* pass) {
    std::uint32_t number = 0;
    Check(clipc_gl_effect_find(effect_, "Lake", pass, &number, message_));
    return number;
  }
  void Apply(std::uint32_t pass) { Check(clipc_gl_effect_apply(effect_, pass, message_)); }
  // Sets the planes that a pass clips with.
  void SetPlanes(std::uint32_t pass, const runtime::Float4& plane) {
    for (std::uint32_t i = 0; i < clipc_gl_effect_plane_count(effect_, pass); ++i)
      Set(clipc_gl_effect_plane_of(effect_, pass, i)->text, plane);
  }

 private:
  void Check(clipc_error error) const {
    if (error != CLIPC_OK) throw std::runtime_error(message_);
  }

  clipc_gl_effect* effect_ = nullptr;
  char message_[CLIPC_MESSAGE_SIZE] = "";
};

struct Object {
  const MeshBuffers* mesh;
  Matrix world;
  runtime::Float4 color;
};

void DrawObjects(Effect& effect, std::uint32_t pass, const std::vector<Object>& objects,
                 const Matrix& view_projection) {
  effect.Set(effect.By("VIEWPROJECTION"), view_projection);
  for (const Object& object : objects) {
    effect.Set(effect.By("WORLD"), object.world);
    effect.Set("Color", object.color);
    effect.Apply(pass);
    object.mesh->Draw();
  }
}

unsigned WaveTexture() {
  constexpr int kSize = 32;
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < kSize * kSize; ++i) {
    const double x = 6.2831853 * (i % kSize) / kSize, y = 6.2831853 * (i / kSize) / kSize;
    const double wave = 0.5 + 0.25 * std::sin(x + std::sin(y)) + 0.25 * std::sin(2 * y);
    for (const double c : {wave, wave, wave, 1.0})
      texels.push_back(static_cast<std::uint8_t>(255 * c));
  }
  unsigned texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

Image DrawLake() {
  const MeshBuffers teapot(Teapot(24)), torus(Torus(24, 1.3, 0.3)), ground(Ground(400, 1));
  const auto place = [](double x, double y, double z, double size, double angle) {
    return Multiply(Multiply(Scaling(size), Rotation(angle)), Translation(x, y, z));
  };
  const std::vector<Object> objects = {
      {&teapot, place(-1.4, 0.3, 5.5, 1.1, 0.5), {0.80F, 0.45F, 0.25F, 1}},
      {&teapot, place(2.2, 0.9, 8.5, 1.4, 2.6), {0.35F, 0.55F, 0.85F, 1}},
      {&torus, place(0.9, 0.0, 4.2, 0.5, 0.0), {0.85F, 0.75F, 0.30F, 1}}};
  const Matrix view = LookAt(kEye, kTarget);
  const Matrix projection = Perspective(0.75, static_cast<double>(kWidth) / kHeight, 0.5, 500);
  const Matrix mirrored = Multiply(Check(runtime::MirrorMatrix(kWater)), view);
  const runtime::Plane plane = Check(runtime::ViewPlaneFromWorld(kWater, mirrored)).plane;

  Effect effect(water_effect);
  effect.SetTexture("Map", WaveTexture());
  const Canvas canvas(2 * kWidth, 2 * kHeight);
  glClearColor(0.75F, 0.85F, 0.95F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const std::uint32_t reflection = effect.Find("Reflection");
  effect.SetPlanes(reflection, Check(runtime::ClipPlaneFromView(plane, projection)).constant);
  DrawObjects(effect, reflection, objects, Multiply(mirrored, projection));
  glClear(GL_DEPTH_BUFFER_BIT);
  const Matrix view_projection = Multiply(view, projection);
  DrawObjects(effect, effect.Find("Surface"), {{&ground, Matrix{}, {}}}, view_projection);
  DrawObjects(effect, effect.Find("Objects"), objects, view_projection);
  return Half(canvas.Read());
}

}  // namespace

int main(int argc, char** argv) try {
  const OpenGl opengl(Api::kCore);
  WritePng(argc > 1 ? argv[1] : "effect.png", DrawLake());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "effect: %s\n", error.what());
  return 1;
}
