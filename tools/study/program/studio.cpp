// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/program/studio.h"

#include <algorithm>
#include <cstring>

namespace clipc::study {

using draw::DrawError;

namespace {

// Of the compatibility profile: GL_CLIP_PLANE0 and GL_CLIP_DISTANCE0 are the same number.
constexpr GLenum kClip0 = GL_CLIP_DISTANCE0;

// As method.hlsl's cbuffer lies in memory: matrices column by column, then the planes.
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

Studio::Studio(draw::Device& device, int width, int height, bool coverage, int samples)
    : gl_(device.Use(draw::Api::kCompatibility)),
      width_(width),
      height_(height),
      coverage_(coverage),
      samples_(samples) {
  if (!gl_.ClipControl || !gl_.ClipPlane || !gl_.DrawElementsInstancedBaseVertexBaseInstance) {
    throw DrawError("OpenGL lacks glClipControl or glClipPlane");
  }
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.GenRenderbuffers(1, &color_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, color_);
  const GLenum format = coverage ? GL_R32F : GL_RGBA8;
  if (samples > 1) {
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  } else {
    gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  }
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  if (!coverage) {
    gl_.GenRenderbuffers(1, &depth_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw DrawError("no framebuffer");
  if (samples == 1) return;
  gl_.GenFramebuffers(1, &resolved_framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer_);
  gl_.GenRenderbuffers(1, &resolved_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, resolved_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved_);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw DrawError("no framebuffer to resolve into");
}

Studio::~Studio() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &color_);
  if (depth_ != 0) gl_.DeleteRenderbuffers(1, &depth_);
  if (resolved_ == 0) return;
  gl_.DeleteFramebuffers(1, &resolved_framebuffer_);
  gl_.DeleteRenderbuffers(1, &resolved_);
}

void Studio::Begin() {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, width_, height_);
  gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl_.ClearColor(0, 0, 0, 0);
  if (coverage_) {
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE);
  } else {
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
  }
  gl_.Clear(GL_COLOR_BUFFER_BIT | (coverage_ ? 0 : GL_DEPTH_BUFFER_BIT));
}

std::vector<float> Studio::Counts() {
  std::vector<float> counts(static_cast<std::size_t>(width_) * height_);
  if (samples_ > 1) {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_framebuffer_);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer_);
  }
  gl_.ReadPixels(0, 0, width_, height_, GL_RED, GL_FLOAT, counts.data());
  draw::CheckErrors(gl_, "reading the coverage");
  return counts;
}

std::vector<std::uint8_t> Studio::Rgba() {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width_) * height_ * 4);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  draw::CheckErrors(gl_, "reading the picture");
  return bytes;
}

DrawCall::DrawCall(const draw::Gl& gl, const WaySource& source, int planes, bool uses_clip_planes)
    : gl_(gl),
      program_(gl, source.vertex, source.fragment, {}),
      planes_(planes),
      fixed_planes_(draw::VersionOf(source.vertex).number < 130),
      distances_(uses_clip_planes) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(3, buffers_);
  gl_.GenBuffers(2, uniforms_);
}

DrawCall::~DrawCall() {
  gl_.BindVertexArray(0);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(3, buffers_);
  gl_.DeleteBuffers(2, uniforms_);
}

void DrawCall::SetMesh(const Mesh& mesh) {
  const auto bytes = [](const auto& list) {
    return static_cast<GLsizeiptr>(list.size() * sizeof list[0]);
  };
  gl_.BindVertexArray(vertex_array_);
  for (const draw::Active& attribute : program_.Attributes()) {
    const bool is_normal = attribute.name.find("NORMAL") != attribute.name.npos;
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[is_normal ? 1 : 0]);
    if (is_normal) {
      gl_.BufferData(GL_ARRAY_BUFFER, bytes(mesh.normals), mesh.normals.data(), GL_STATIC_DRAW);
    } else {
      gl_.BufferData(GL_ARRAY_BUFFER, bytes(mesh.vertices), mesh.vertices.data(), GL_STATIC_DRAW);
    }
    const auto index = static_cast<GLuint>(attribute.location);
    gl_.VertexAttribPointer(index, is_normal ? 3 : 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_.EnableVertexAttribArray(index);
  }
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(mesh.indices), mesh.indices.data(), GL_STATIC_DRAW);
  count_ = static_cast<GLsizei>(mesh.indices.size());
}

void DrawCall::SetConstants(const WayConstants& constants) {
  constants_ = constants;
  const std::vector<float> words = BufferOf(constants);
  gl_.BindBuffer(GL_UNIFORM_BUFFER, uniforms_[0]);
  gl_.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(4 * words.size()), words.data(),
                 GL_STATIC_DRAW);
  gl_.BindBuffer(GL_UNIFORM_BUFFER, uniforms_[1]);
  gl_.BufferData(GL_UNIFORM_BUFFER, 4 * 24, words.data() + 32, GL_STATIC_DRAW);
  GLuint index = 0;
  for (const draw::ActiveBlock& block : program_.Blocks()) {
    gl_.UniformBlockBinding(program_.id(), index++, block.name == "Clip" ? 1 : 0);
  }
  gl_.UseProgram(program_.id());
  for (const auto& [name, matrix] :
       {std::pair{"world_view_projection", &constants.world_view_projection},
        std::pair{"world", &constants.world}}) {
    const GLint location = gl_.GetUniformLocation(program_.id(), name);
    if (location >= 0) gl_.UniformMatrix4fv(location, 1, GL_FALSE, &matrix->m[0][0]);
  }
}

void DrawCall::Draw() {
  gl_.UseProgram(program_.id());
  gl_.BindVertexArray(vertex_array_);
  for (GLuint i = 0; i < 2; ++i) gl_.BindBufferBase(GL_UNIFORM_BUFFER, i, uniforms_[i]);
  for (int i = 0; i < 6; ++i) {
    const bool enabled = distances_ && i < planes_;
    enabled ? gl_.Enable(kClip0 + i) : gl_.Disable(kClip0 + i);
    if (!enabled || !fixed_planes_) continue;
    const Vec4<double> plane = ConvertTo<double>(constants_.planes[i]);
    gl_.ClipPlane(kClip0 + i, plane.c);
  }
  gl_.DrawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr, 1,
                                                  0, 0);
}

std::unique_ptr<DrawCall> MakeCall(const draw::Gl& gl, WayKind kind, int planes, bool coverage) {
  const bool distances = kind == WayKind::kClip || kind == WayKind::kXyw1 ||
                         kind == WayKind::kObject || kind == WayKind::kLevel9 ||
                         kind == WayKind::kWorld;
  return std::make_unique<DrawCall>(gl, SourceOf(kind, planes, coverage), planes, distances);
}

}  // namespace clipc::study
