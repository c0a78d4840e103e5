// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/picture.h"

#include <algorithm>
#include <cmath>

#include <png.h>

#include "tools/draw/target.h"

namespace clipc::draw {
namespace {

// Red: drawn. Green: depth. Floats, so that every API can read the depth back.
std::string FragmentFor(const Version& version) {
  if (version.number < 130) {
    return version.Line() + "void main() { gl_FragColor = vec4(1.0, gl_FragCoord.z, 0.0, 1.0); }\n";
  }
  return version.Line() + (version.es ? "precision highp float;\n" : "") +
         "out vec4 color;\nvoid main() { color = vec4(1.0, gl_FragCoord.z, 0.0, 1.0); }\n";
}

void SetClipping(const Gl& gl, const PictureOptions& options) {
  for (int i = 0; i < 8; ++i) {
    (options.enable_mask >> i & 1 ? gl.Enable : gl.Disable)(GL_CLIP_DISTANCE0 + i);
  }
  for (const auto& [index, plane] : options.clip_planes) {
    if (!gl.ClipPlane) throw DrawError("this OpenGL has no glClipPlane");
    gl.ClipPlane(GL_CLIP_DISTANCE0 + index, plane.data());
  }
  if (gl.ClipControl) {
    gl.ClipControl(GL_LOWER_LEFT, options.zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  } else if (options.zero_to_one) {
    throw DrawError("this OpenGL has no glClipControl");
  }
}

}  // namespace

Picture Draw(const Gl& gl, const std::string& vertex, const Inputs& inputs,
             const PictureOptions& options) {
  Program program(gl, vertex,
                  options.fragment.empty() ? FragmentFor(VersionOf(vertex)) : options.fragment, {});
  const Target target(gl, options.size);
  program.Bind(inputs);
  SetClipping(gl, options);
  gl.DrawArrays(GL_TRIANGLES, 0, inputs.vertices);
  const std::vector<float> rgba = target.Read();
  Picture picture{options.size, {}};
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    picture.pixels.push_back({rgba[i] != 0, rgba[i + 1]});
  SetClipping(gl, {});
  CheckErrors(gl, "drawing");
  return picture;
}

void WritePng(const Picture& picture, const std::string& path) {
  std::vector<std::uint8_t> rgb;
  for (int y = picture.size - 1; y >= 0; --y) {
    for (int x = 0; x < picture.size; ++x) {
      const Pixel& pixel = picture.At(x, y);
      const auto shade = static_cast<std::uint8_t>(255 - 160 * std::clamp(pixel.depth, 0.0f, 1.0f));
      const std::uint8_t drawn[] = {static_cast<std::uint8_t>(shade / 2), shade, 255};
      const std::uint8_t background[] = {24, 24, 32};
      rgb.insert(rgb.end(), pixel.drawn ? drawn : background,
                 (pixel.drawn ? drawn : background) + 3);
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = static_cast<png_uint_32>(picture.size);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr)) {
    throw DrawError("cannot write " + path + ": " + image.message);
  }
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

Difference Compare(const Picture& picture, const Expectation& expectation) {
  Difference difference;
  const double pixel_width = 2.0 / picture.size;
  for (int row = 0; row < picture.size; ++row) {
    for (int column = 0; column < picture.size; ++column) {
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
      const Pixel& pixel = picture.At(column, row);
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
