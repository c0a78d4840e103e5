// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/surface.h"

#include <algorithm>
#include <optional>

#include "tools/draw/opengl/program.h"

namespace clipc::draw {
namespace {

struct TargetFormat {
  GLenum internal, components, type;
};

TargetFormat TargetFormatOf(const SurfaceTarget& target) {
  if (target.is_depth) return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  switch (target.kind) {
    case WordKind::kInt: return {GL_RGBA32I, GL_RGBA_INTEGER, GL_INT};
    case WordKind::kUint: return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    case WordKind::kFloat: break;
  }
  return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
}

GLenum AttachmentOf(const SurfaceTarget& target) {
  return target.is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0 + target.number;
}

// A framebuffer of those targets, which is bound while it lives. Nothing is drawn in it.
class SurfaceFramebuffer : NotCopied {
 public:
  SurfaceFramebuffer(const std::vector<SurfaceTarget>& targets, int samples) : samples_(samples) {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, kSurfaceWidth, kSurfaceHeight);
    std::vector<GLenum> places;
    for (const SurfaceTarget& target : targets) {
      Attach(target);
      if (target.is_depth) continue;
      places.resize(std::max<std::size_t>(places.size(), target.number + 1), GL_NONE);
      places[target.number] = AttachmentOf(target);
    }
    glDrawBuffers(static_cast<GLsizei>(places.size()), places.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw DrawError("OpenGL has no such framebuffer");
    for (const SurfaceTarget& target : targets) Clear(target);
  }
  ~SurfaceFramebuffer() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  }

  // Resolves the samples into those of `to`, which has one for each pixel, and binds that.
  void ResolveInto(const std::vector<SurfaceTarget>& targets, const SurfaceFramebuffer& to) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer_);
    for (const SurfaceTarget& target : targets) {
      if (!target.is_depth) {
        const std::vector<GLenum> only = PlacesTo(target);
        glReadBuffer(only.back());
        glDrawBuffers(static_cast<GLsizei>(only.size()), only.data());
      }
      glBlitFramebuffer(0, 0, kSurfaceWidth, kSurfaceHeight, 0, 0, kSurfaceWidth, kSurfaceHeight,
                        target.is_depth ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer_);
  }

  // The words of a target, with the bottom row first.
  static Words Read(const SurfaceTarget& target) {
    const TargetFormat format = TargetFormatOf(target);
    Words words(std::size_t{kSurfaceWidth} * kSurfaceHeight * (target.is_depth ? 1 : 4));
    if (!target.is_depth) glReadBuffer(AttachmentOf(target));
    glReadPixels(0, 0, kSurfaceWidth, kSurfaceHeight, format.components, format.type, words.data());
    return words;
  }

 private:
  void Attach(const SurfaceTarget& target) {
    glGenRenderbuffers(1, &buffers_.emplace_back());
    glBindRenderbuffer(GL_RENDERBUFFER, buffers_.back());
    const GLenum format = TargetFormatOf(target).internal;
    if (samples_ > 1) {
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, format, kSurfaceWidth,
                                       kSurfaceHeight);
    } else {
      glRenderbufferStorage(GL_RENDERBUFFER, format, kSurfaceWidth, kSurfaceHeight);
    }
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, AttachmentOf(target), GL_RENDERBUFFER,
                              buffers_.back());
  }

  // The places of colours up to the target's, which is the only one.
  static std::vector<GLenum> PlacesTo(const SurfaceTarget& target) {
    std::vector<GLenum> places(target.number + 1, GL_NONE);
    places.back() = AttachmentOf(target);
    return places;
  }

  static void Clear(const SurfaceTarget& target) {
    const auto number = static_cast<GLint>(target.number);
    const std::array<GLfloat, 4> color{kClearColor, kClearColor, kClearColor, kClearColor};
    const std::array<GLuint, 4> bits{kClearInteger, kClearInteger, kClearInteger, kClearInteger};
    const std::array<GLint, 4> ints{kClearInteger, kClearInteger, kClearInteger, kClearInteger};
    if (target.is_depth) return glClearBufferfv(GL_DEPTH, 0, &kClearDepth);
    switch (target.kind) {
      case WordKind::kFloat: return glClearBufferfv(GL_COLOR, number, color.data());
      case WordKind::kInt: return glClearBufferiv(GL_COLOR, number, ints.data());
      case WordKind::kUint: return glClearBufferuiv(GL_COLOR, number, bits.data());
    }
  }

  const int samples_;
  GLuint framebuffer_ = 0;
  std::vector<GLuint> buffers_;
};

}  // namespace

std::vector<Captured> DrawSurface(const std::string& vertex, const std::string& fragment,
                                  const std::vector<SurfaceTarget>& targets, const Inputs& inputs,
                                  const SurfaceSpace& space, int samples) {
  const Version version = VersionOf(fragment);
  GlProgram program(vertex, fragment, {}, [&](GLuint id) {
    if (version.es || version.number < 130) return;
    for (const SurfaceTarget& target : targets) {
      if (!target.is_depth) glBindFragDataLocation(id, target.number, target.name.c_str());
    }
  });
  const SurfaceFramebuffer plain(targets, 1);
  std::optional<SurfaceFramebuffer> multisampled;
  if (samples > 1) multisampled.emplace(targets, samples);
  program.Bind(inputs);
  glEnable(GL_DEPTH_TEST);  // without it nothing writes the depth
  glDepthFunc(GL_ALWAYS);
  // Clockwise is the front in Direct3D.
  glFrontFace(space.flips_y ? GL_CCW : GL_CW);
  glDrawArrays(GL_TRIANGLES, 0, inputs.vertices);
  glFrontFace(GL_CCW);
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_TEST);
  if (multisampled) multisampled->ResolveInto(targets, plain);
  std::vector<Captured> captured;
  for (const SurfaceTarget& target : targets)
    captured.push_back(PixelsOf(SurfaceFramebuffer::Read(target), target, !space.flips_y));
  harness::CheckErrors("drawing");
  return captured;
}

}  // namespace clipc::draw
