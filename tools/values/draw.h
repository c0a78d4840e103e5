// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tools/values/program.h"
#include "tools/values/resource.h"

// A draw with two compiled shaders, or a dispatch of one, on the current OpenGL context, as
// Direct3D would do it.
namespace clipc::values {

// The error of a test that needs what this tool does not do.
class NotDrawn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Element {  // of the input layout
  std::uint32_t slot = 0;
  Format format;
  std::string semantic;
  std::uint32_t index = 0;
};

// What a test has set up before it draws.
struct Scene {
  std::map<std::pair<Role, std::uint32_t>, std::unique_ptr<Resource>> resources;
  std::map<std::uint32_t, SamplerText> samplers;
  std::vector<Element> elements;
  std::vector<std::uint32_t> uniforms;  // words of b0, or of the registers of Direct3D 9
  GLenum depth_test = GL_ALWAYS;
  std::uint32_t sample_mask = ~0u;
  // x, y, width and height by index; empty: the whole of the targets.
  std::map<std::uint32_t, std::array<float, 4>> viewports;

  // Whether the targets are multisampled; the shaders are then compiled with --flip-y.
  bool IsMultisampled() const;
  Resource* Find(Role role, std::uint32_t slot) const {
    const auto found = resources.find({role, slot});
    return found == resources.end() ? nullptr : found->second.get();
  }
};

struct DrawCall {
  GLenum topology = GL_TRIANGLES;
  std::uint32_t vertices = 3, instances = 1;
  std::uint32_t control_points = 0;          // of a patch; 0: other primitives
  std::array<std::uint32_t, 3> groups = {};  // of a dispatch; 0: a draw
  // Direct3D 9's pixels: their centers are whole numbers, and constants are registers of floats.
  bool is_direct3d9 = false;
  // How far Direct3D 9's pixels are moved: a little less than half a pixel, so that the centers on
  // the edge of a triangle are inside of it.
  float half_pixel = 0.5f - 1.0f / 256;
};

// Draws into the scene's targets, or dispatches. Throws NotDrawn, or harness::DrawError where
// OpenGL refuses the shaders.
void Draw(const CompiledPair& pair, const Scene& scene, const DrawCall& call);

}  // namespace clipc::values
