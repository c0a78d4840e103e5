// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/studio.h"

#include <utility>

namespace clipc::study {

using harness::DrawError;

namespace {

// GL_CLIP_PLANE0 of the compatibility profile is the same number.
constexpr GLenum kClip0 = GL_CLIP_DISTANCE0;

// The constants as method.hlsl's cbuffer lies in memory: matrices column by column, then the
// planes.
std::vector<float> BufferOf(const WayConstants& constants) {
  std::vector<float> words;
  for (const Mat4<float>* m : {&constants.world_view_projection, &constants.world}) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) words.push_back(m->m[i][j]);
    }
  }
  for (const Vec4<float>& plane : constants.planes) words.insert(words.end(), plane.c, plane.c + 4);
  words.resize(32 + 24);
  return words;
}

}  // namespace

Studio::Studio(int width, int height, bool coverage, int samples)
    : coverage_(coverage),
      framebuffer_(width, height,
                   {coverage ? GLenum{GL_R32F} : GLenum{GL_RGBA8},
                    coverage ? GLenum{GL_NONE} : GLenum{GL_DEPTH_COMPONENT32F}, samples}) {
  if (samples > 1) resolved_.emplace(width, height, harness::FramebufferFormat{GL_R32F});
}

void Studio::Begin() {
  framebuffer_.Bind();
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glClearColor(0, 0, 0, 0);
  (coverage_ ? glDisable : glEnable)(GL_DEPTH_TEST);
  (coverage_ ? glEnable : glDisable)(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

std::vector<float> Studio::Counts() {
  if (resolved_) resolved_->Resolve(framebuffer_);
  return (resolved_ ? *resolved_ : framebuffer_).ReadFloats(GL_RED);
}

DrawCall::DrawCall(const WaySource& source, int planes, Needs needs)
    : program_(source.vertex, source.fragment),
      planes_(planes),
      fixed_planes_(needs == Needs::kUserPlanes),
      distances_(fixed_planes_ || needs == Needs::kDistances) {
  glGenVertexArrays(1, &vertex_array_);
  glGenBuffers(3, buffers_);
  glGenBuffers(2, uniforms_);
}

DrawCall::~DrawCall() {
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &vertex_array_);
  glDeleteBuffers(3, buffers_);
  glDeleteBuffers(2, uniforms_);
}

void DrawCall::SetMesh(const Mesh& mesh) {
  const auto bytes = [](const auto& list) {
    return static_cast<GLsizeiptr>(list.size() * sizeof list[0]);
  };
  glBindVertexArray(vertex_array_);
  const auto set = [&](const char* name, GLuint buffer, const auto& list, GLint components) {
    const GLint index = glGetAttribLocation(program_.id(), name);
    if (index < 0) return;  // nothing reads the input
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes(list), list.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(index);
  };
  set("in_POSITION0", buffers_[0], mesh.vertices, 4);
  set("in_NORMAL0", buffers_[1], mesh.normals, 3);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(mesh.indices), mesh.indices.data(), GL_STATIC_DRAW);
  count_ = static_cast<GLsizei>(mesh.indices.size());
}

void DrawCall::SetConstants(const WayConstants& constants) {
  constants_ = constants;
  const std::vector<float> words = BufferOf(constants);
  glBindBuffer(GL_UNIFORM_BUFFER, uniforms_[0]);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(4 * words.size()), words.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_UNIFORM_BUFFER, uniforms_[1]);
  glBufferData(GL_UNIFORM_BUFFER, 4 * 24, words.data() + 32, GL_STATIC_DRAW);
  for (const auto& [name, place] : {std::pair{"Draw", 0}, std::pair{"Clip", 1}}) {
    const GLuint block = glGetUniformBlockIndex(program_.id(), name);
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), block, place);
  }
  program_.Use();
  for (const auto& [name, matrix] :
       {std::pair{"world_view_projection", &constants.world_view_projection},
        std::pair{"world", &constants.world}}) {
    const GLint location = glGetUniformLocation(program_.id(), name);
    if (location >= 0) glUniformMatrix4fv(location, 1, GL_FALSE, &matrix->m[0][0]);
  }
}

void DrawCall::Draw() {
  program_.Use();
  glBindVertexArray(vertex_array_);
  for (GLuint i = 0; i < 2; ++i) glBindBufferBase(GL_UNIFORM_BUFFER, i, uniforms_[i]);
  for (int i = 0; i < 6; ++i) {
    const bool enabled = distances_ && i < planes_;
    (enabled ? glEnable : glDisable)(kClip0 + i);
    if (!enabled || !fixed_planes_) continue;
    const Vec4<double> plane = ConvertTo<double>(constants_.planes[i]);
    glClipPlane(kClip0 + i, plane.c);
  }
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

std::unique_ptr<DrawCall> MakeCall(WayKind kind, int planes, bool coverage) {
  return std::make_unique<DrawCall>(SourceOf(kind, planes, coverage), planes, WayOf(kind).needs);
}

}  // namespace clipc::study
