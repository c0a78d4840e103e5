// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/draw/gl.h"
#include "tools/draw/program.h"
#include "tools/study/program/mesh.h"
#include "tools/study/program/way.h"

namespace clipc::study {

// A place to draw: Mesa's software OpenGL with Direct3D's depth range, one size.
class Studio {
 public:
  // `coverage`: each fragment adds 1, nothing hides anything; otherwise colours with a depth
  // buffer. `samples`: of each pixel, 1 for none; only with `coverage`, where Counts then averages
  // them.
  Studio(draw::Device& device, int width, int height, bool coverage, int samples = 1);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  const draw::Gl& gl() const { return gl_; }
  int width() const { return width_; }
  int height() const { return height_; }

  void Begin();                      // makes it current and clears it
  std::vector<float> Counts();       // of each pixel; only with `coverage`
  std::vector<std::uint8_t> Rgba();  // otherwise; from the bottom row up

 private:
  const draw::Gl& gl_;
  int width_, height_;
  bool coverage_;
  int samples_;
  GLuint framebuffer_ = 0, color_ = 0, depth_ = 0;
  GLuint resolved_framebuffer_ = 0, resolved_ = 0;  // with samples
};

// One mesh with one way of clipping, ready to be drawn again and again.
class DrawCall {
 public:
  DrawCall(const draw::Gl& gl, const WaySource& source, int planes, bool uses_clip_planes);
  ~DrawCall();
  DrawCall(const DrawCall&) = delete;
  DrawCall& operator=(const DrawCall&) = delete;

  void SetMesh(const Mesh& mesh);
  void SetConstants(const WayConstants& constants);
  void Draw();  // into the studio that is current

 private:
  const draw::Gl& gl_;
  draw::Program program_;
  int planes_;
  bool fixed_planes_;  // glClipPlane; otherwise planes_ clip distances when `uses_clip_planes`
  bool distances_;
  WayConstants constants_;
  GLuint vertex_array_ = 0, buffers_[3] = {}, uniforms_[2] = {};
  GLsizei count_ = 0;
};

// The call for that way, with its mesh and constants.
std::unique_ptr<DrawCall> MakeCall(const draw::Gl& gl, WayKind kind, int planes, bool coverage);

}  // namespace clipc::study
