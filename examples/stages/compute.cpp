// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "examples/stages/images.h"
#include "tools/harness/mesh.h"
#include "tools/harness/offscreen.h"

// What compute shaders make.
namespace stages {
namespace {

constexpr char kVertex[] = R"(#version 450
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec3 color;
void main() {
  gl_Position = vec4(position.xy * vec2(0.45, 0.7), 0.5 - 0.2 * position.z, 1.0);
  color = 0.5 + 0.5 * normal;
})";
constexpr char kFragment[] = R"(#version 450
layout(location = 0) in vec3 color;
layout(location = 0) out vec4 target;
void main() { target = vec4(color, 1.0); })";

GLuint NewTexture() {
  GLuint texture = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &texture);
  glTextureStorage2D(texture, 1, GL_RGBA32F, kWidth, kHeight);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return texture;
}

// A texture with a teapot.
GLuint TeapotTexture() {
  const Canvas canvas(kWidth, kHeight);
  glClearColor(0.1F, 0.15F, 0.3F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  UseProgram(kVertex, {}, kFragment);
  MeshBuffers(Teapot(12)).Draw();
  const GLuint texture = NewTexture();
  glCopyTextureSubImage2D(texture, 0, 0, 0, 0, 0, kWidth, kHeight);
  return texture;
}

void DispatchTiles() {
  glDispatchCompute((kWidth + 7) / 8, (kHeight + 7) / 8, 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

// `count` numbers of a buffer.
std::vector<std::uint32_t> Numbers(GLuint buffer, std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  glGetNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(4 * count), numbers.data());
  CheckErrors("reading the buffer");
  return numbers;
}

Image WhiteImage() {
  return {kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{4} * kWidth * kHeight, 255)};
}

// A colour of the rainbow; `at` is between 0 and 1.
std::array<std::uint8_t, 3> Rainbow(double at) {
  std::array<std::uint8_t, 3> color;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * (at + static_cast<double>(i) / 3);
    color[i] = static_cast<std::uint8_t>(140 + 100 * std::cos(angle));
  }
  return color;
}

// Fills columns from x to `end`, from the row `top` to `bottom`.
void Fill(Image& image, int x, int end, int top, int bottom,
          const std::array<std::uint8_t, 3>& color) {
  for (int row = top; row < bottom; ++row) {
    for (int column = x; column < end; ++column)
      std::ranges::copy(color, image.rgba.begin() + ByteAt(image, column, row));
  }
}

}  // namespace

// The left half is the image that is blurred.
Image DrawBlur(const Folder& examples) {
  GLuint source = TeapotTexture(), blurred = NewTexture();
  const Image sharp = ImageOf(source, kWidth, kHeight);
  UseCompute(examples + "/compute/blur.comp");
  for (int i = 0; i < 8; ++i) {
    glBindTextureUnit(0, source);
    glBindImageTexture(0, blurred, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    DispatchTiles();
    std::swap(source, blurred);
  }
  Image image = ImageOf(source, kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    std::copy_n(sharp.rgba.begin() + ByteAt(sharp, 0, y), 2 * kWidth,
                image.rgba.begin() + ByteAt(image, 0, y));
  return image;
}

// A bar for each brightness, as high as the logarithm of its number of pixels.
Image DrawHistogram(const Folder& examples) {
  constexpr int kBins = 64;
  glBindTextureUnit(0, TeapotTexture());
  UseCompute(examples + "/compute/histogram.comp");
  const std::vector<std::uint32_t> zeros(kBins);
  const GLuint buffer =
      BindBuffer(GL_SHADER_STORAGE_BUFFER, 0, zeros.data(), std::size_t{4} * kBins);
  DispatchTiles();
  const std::vector<std::uint32_t> bins = Numbers(buffer, kBins);
  Image image = WhiteImage();
  for (int i = 0; i < kBins; ++i) {
    const double part =
        std::log1p(bins[static_cast<std::size_t>(i)]) / std::log1p(kWidth * kHeight);
    const auto gray = static_cast<std::uint8_t>(3 * i);
    Fill(image, i * kWidth / kBins, (i + 1) * kWidth / kBins,
         kHeight - static_cast<int>(part * kHeight), kHeight, {gray, gray, 128});
  }
  return image;
}

// Above, how many items each thread has; below, the items where the prefix sums place them.
Image DrawPrefixSums(const Folder& examples) {
  constexpr int kThreads = 64;
  std::vector<std::uint32_t> counts(kThreads);
  for (std::uint32_t i = 0; i < kThreads; ++i) counts[i] = (i * i + 5 * i) % 8;
  UseCompute(examples + "/compute/prefix_sums.comp");
  BindBuffer(GL_SHADER_STORAGE_BUFFER, 0, counts.data(), std::size_t{4} * kThreads);
  const GLuint buffer = BindBuffer(GL_SHADER_STORAGE_BUFFER, 1, nullptr, std::size_t{4} * kThreads);
  BindBuffer(GL_SHADER_STORAGE_BUFFER, 2, nullptr, 4);
  glDispatchCompute(1, 1, 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  const std::vector<std::uint32_t> offsets = Numbers(buffer, kThreads);
  Image image = WhiteImage();
  for (int i = 0; i < kThreads; ++i) {
    const auto count = static_cast<int>(counts[static_cast<std::size_t>(i)]);
    const auto offset = static_cast<int>(offsets[static_cast<std::size_t>(i)]);
    const auto color = Rainbow(static_cast<double>(i) / kThreads);
    Fill(image, i * kWidth / kThreads, (i + 1) * kWidth / kThreads, 80 - 10 * count, 80, color);
    Fill(image, std::min(offset, kWidth), std::min(offset + count, kWidth), 110, 150, color);
  }
  return image;
}

namespace {

struct Particle {
  float position[3] = {0, 0, 0};
  float age = 0;
  float velocity[3] = {0, 0, 0};
  float lifetime = 0;
};

constexpr std::uint32_t kParticles = 4000;
constexpr float kGravity[3] = {0, -9.8F, 0};

// Particles that left the ground at times up to their lifetimes ago.
std::vector<Particle> Fountain() {
  std::vector<Particle> particles(kParticles);
  for (std::uint32_t i = 0; i < kParticles; ++i) {
    const auto number = static_cast<float>(i);
    const float spread = 1.5F * std::sqrt(number / kParticles), turn = 2.4F * number;
    const float speeds[3] = {spread * std::cos(turn), 9 - spread * spread, spread * std::sin(turn)};
    Particle& particle = particles[i];
    particle.lifetime = 1 + std::fmod(0.618F * number, 1.0F);
    particle.age = particle.lifetime * std::fmod(0.755F * number, 1.0F);
    for (int axis = 0; axis < 3; ++axis) {
      particle.velocity[axis] = speeds[axis] + kGravity[axis] * particle.age;
      particle.position[axis] =
          (speeds[axis] + 0.5F * kGravity[axis] * particle.age) * particle.age;
    }
  }
  return particles;
}

constexpr char kParticleVertex[] = R"(#version 450
struct Particle { vec3 position; float age; vec3 velocity; float lifetime; };
layout(std430, binding = 1) readonly buffer Particles { Particle particles[]; };
layout(std430, binding = 2) readonly buffer Alive { uint alive[]; };
layout(location = 0) out vec3 color;
void main() {
  const Particle p = particles[alive[gl_VertexID]];
  gl_Position = vec4(0.4 * p.position.x, 0.4 * p.position.y - 0.9, 0.5, 1.0);
  color = mix(vec3(0.1, 0.25, 0.5), vec3(0.4, 0.1, 0.0), p.age / p.lifetime);
})";

}  // namespace

// The device alone knows how many particles are alive: their number becomes that of the draw call.
Image DrawParticles(const Folder& examples) {
  const std::vector<Particle> particles = Fountain();
  const std::size_t size = particles.size() * sizeof(Particle);
  UseCompute(examples + "/compute/particle_step.comp");
  const float step[8] = {kGravity[0], kGravity[1], kGravity[2], 0.025F, 0, 0.5F, 0, 0};
  BindBuffer(GL_UNIFORM_BUFFER, 0, step, sizeof step);
  GLuint before = BindBuffer(GL_SHADER_STORAGE_BUFFER, 0, particles.data(), size);
  GLuint after = BindBuffer(GL_SHADER_STORAGE_BUFFER, 1, nullptr, size);
  BindBuffer(GL_SHADER_STORAGE_BUFFER, 2, nullptr, std::size_t{4} * kParticles);
  const GLuint counter = BindBuffer(GL_SHADER_STORAGE_BUFFER, 3, nullptr, 4);
  for (int i = 0; i < 12; ++i) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, before);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, after);
    glClearNamedBufferData(counter, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    glDispatchCompute((kParticles + 63) / 64, 1, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::swap(before, after);
  }
  const GLuint arguments[] = {0, 1, 0, 0};
  const GLuint draw = NewBuffer(GL_DRAW_INDIRECT_BUFFER, arguments, sizeof arguments);
  glCopyNamedBufferSubData(counter, draw, 0, 0, 4);
  const Canvas canvas(2 * kWidth, 2 * kHeight);
  glDisable(GL_DEPTH_TEST);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  UseProgram(kParticleVertex, {}, kFragment);
  GLuint no_attributes = 0;
  glGenVertexArrays(1, &no_attributes);
  glBindVertexArray(no_attributes);
  glPointSize(4);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);  // a sum, whatever the order of the list is
  glDrawArraysIndirect(GL_POINTS, nullptr);
  return Half(canvas.Read());
}

}  // namespace stages
