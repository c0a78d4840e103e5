// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/image.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/opengl/program.h"
#include "tools/harness/framebuffer.h"

namespace clipc::draw {
namespace {

// Writes 1 to red and the depth to green: floats, so that every API can read the depth back.
std::string StandardFragmentFor(const Version& version) {
  if (version.number < 130) {
    return version.Line() + "void main() { gl_FragColor = vec4(1.0, gl_FragCoord.z, 0.0, 1.0); }\n";
  }
  return version.Line() + (version.es ? "precision highp float;\n" : "") +
         "out vec4 color;\nvoid main() { color = vec4(1.0, gl_FragCoord.z, 0.0, 1.0); }\n";
}

void SetClipping(const ImageOptions& options, harness::Api api) {
  for (int i = 0; i < 8; ++i) {
    (options.enable_mask >> i & 1 ? glEnable : glDisable)(GL_CLIP_DISTANCE0 + i);
  }
  for (const auto& [index, plane] : options.clip_planes) {
    if (api != harness::Api::kCompatibility) throw DrawError("this OpenGL has no glClipPlane");
    glClipPlane(GL_CLIP_DISTANCE0 + index, plane.data());
  }
  glClipControl(GL_LOWER_LEFT, options.zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

}  // namespace

DrawnImage Draw(const std::string& vertex, const Inputs& inputs, const ImageOptions& options) {
  GlProgram program(
      vertex, options.fragment.empty() ? StandardFragmentFor(VersionOf(vertex)) : options.fragment,
      {});
  const harness::Framebuffer framebuffer(options.size, options.size, {GL_RGBA32F});
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  program.Bind(inputs);
  const harness::Api api = VersionOf(vertex).api;
  SetClipping(options, api);
  glDrawArrays(GL_TRIANGLES, 0, inputs.vertices);
  const std::vector<float> rgba = framebuffer.ReadFloats(GL_RGBA);
  DrawnImage image{options.size, {}};
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    image.pixels.push_back({rgba[i] != 0, rgba[i + 1]});
  SetClipping({}, api);
  harness::CheckErrors("drawing");
  return image;
}

harness::Image ColorsOf(const DrawnImage& image) {
  harness::Image colors{image.size, image.size, {}};
  for (int y = image.size - 1; y >= 0; --y) {
    for (int x = 0; x < image.size; ++x) {
      const Pixel& pixel = image.At(x, y);
      const auto shade = static_cast<std::uint8_t>(255 - 160 * std::clamp(pixel.depth, 0.0f, 1.0f));
      const std::array<std::uint8_t, 4> drawn{static_cast<std::uint8_t>(shade / 2), shade, 255,
                                              255},
          background{24, 24, 32, 255};
      const auto& color = pixel.drawn ? drawn : background;
      colors.rgba.insert(colors.rgba.end(), color.begin(), color.end());
    }
  }
  return colors;
}

std::vector<std::array<float, 4>> FullTarget() {
  constexpr int kCells = 4;
  const auto corner = [](int column, int row) -> std::array<float, 4> {
    const float x = 2.0f * static_cast<float>(column) / kCells - 1;
    const float y = 2.0f * static_cast<float>(row) / kCells - 1;
    const float w = 1.5f + 0.5f * y;
    return {x * w, y * w, DepthAt(x) * w, w};
  };
  std::vector<std::array<float, 4>> vertices;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const auto a = corner(column, row), b = corner(column + 1, row);
      const auto c = corner(column, row + 1), d = corner(column + 1, row + 1);
      vertices.insert(vertices.end(), {a, b, c, c, b, d});
    }
  }
  return vertices;
}

Difference Compare(const DrawnImage& image, const Expectation& expectation) {
  Difference difference;
  const double pixel_width = 2.0 / image.size;
  for (int row = 0; row < image.size; ++row) {
    for (int column = 0; column < image.size; ++column) {
      const double x = (column + 0.5) * pixel_width - 1;
      const double y = ((row + 0.5) * pixel_width - 1) * (expectation.flipped ? -1 : 1);
      const double depth = 0.5 + 0.25 * x;
      bool expected = true, is_edge = false;
      for (const auto& [a, b, c, d] : expectation.planes) {
        const double distance = a * x + b * y + c * depth + d;
        const double change_per_pixel = std::hypot(a + 0.25 * c, b) * pixel_width;
        expected &= distance >= 0;
        is_edge |= change_per_pixel > 0 && std::abs(distance) < change_per_pixel / 20;
      }
      const Pixel& pixel = image.At(column, row);
      difference.drawn += pixel.drawn;
      if (is_edge) continue;
      difference.missing += expected && !pixel.drawn;
      difference.extra += !expected && pixel.drawn;
      if (expected && pixel.drawn) {
        difference.depth_error = std::max(difference.depth_error, std::abs(pixel.depth - depth));
      }
    }
  }
  return difference;
}

}  // namespace clipc::draw
