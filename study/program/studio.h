// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "study/program/mesh.h"
#include "study/program/source.h"
#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/offscreen.h"

namespace clipc::study {

// A place to draw, of one size and with Direct3D's depth range. An OpenGL context of the
// compatibility profile must be current.
class Studio {
 public:
  // If `coverage`, each fragment adds 1 to its pixel, and nothing hides anything; otherwise colors
  // are drawn with a depth buffer. Each pixel has `samples` samples, more than 1 only with
  // `coverage`.
  Studio(int width, int height, bool coverage, int samples = 1);

  void Begin();  // makes the studio current and clears it
  // The sum that was added to each pixel, as the mean of its samples; only with `coverage`.
  std::vector<float> Counts();
  harness::Image Read() { return framebuffer_.Read(); }  // only without `coverage`

 private:
  bool coverage_;
  harness::Framebuffer framebuffer_;
  std::optional<harness::Framebuffer> resolved_;  // with samples
};

// One mesh with one way of clipping, ready to be drawn again and again.
class DrawCall {
 public:
  DrawCall(const WaySource& source, int planes, Needs needs);
  ~DrawCall();

  void SetMesh(const Mesh& mesh);
  void SetConstants(const WayConstants& constants);
  void Draw();  // into the studio that is current

 private:
  harness::Program program_;
  int planes_;
  bool fixed_planes_;  // the planes are set by glClipPlane
  bool distances_;     // glClipPlane's planes or the shader's clip distances are enabled
  WayConstants constants_;
  GLuint vertex_array_ = 0, buffers_[3] = {}, uniforms_[2] = {};
  GLsizei count_ = 0;
};

// The call for that way, on the current context; its mesh and constants are still to be set.
std::unique_ptr<DrawCall> MakeCall(WayKind kind, int planes, bool coverage);

}  // namespace clipc::study
