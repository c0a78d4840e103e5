// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/build.h"
#include "tools/draw/inputs.h"
#include "tools/draw/random_values.h"

// The surface that a pixel shader is drawn on. It fills a small image with cells of two triangles
// each. Over a cell, every component of an input changes by steps of which floats hold all
// multiples, and w is a power of two, so that drivers interpolate without any error, unless
// RandomOptions::perspective asks for another w. The triangles of a cell turn to the viewer or away
// from it.
namespace clipc::draw {

// The size of the image, in pixels: even, so that it consists of whole quads.
inline constexpr int kSurfaceWidth = 16, kSurfaceHeight = 4;

struct Surface {
  struct Vertex {
    std::array<float, 4> position;   // in Direct3D's clip space
    std::vector<ir::IoBits> values;  // by index into Program::inputs
  };
  std::vector<Vertex> vertices;  // three for each triangle
  // The inputs of each pixel, by index into Program::inputs: the four of a quad follow each other
  // in the order of ir::RunQuad.
  std::vector<std::vector<ir::IoBits>> pixels;
};

Surface MakeSurface(const ir::Program& program, const RandomOptions& options, RandomValues& values);

// The place of pixel number `index`, from the upper left corner on.
struct PixelPlace {
  int x, y;
};
PixelPlace PlaceOf(std::size_t index);

// The values that a pixel keeps in its render target, as float or as integer, and in the depth
// buffer when nothing is drawn there.
inline constexpr float kClearColor = -77, kClearDepth = 0.8125f;
inline constexpr std::uint32_t kClearInteger = 77;

// The image's place in the API that draws it.
struct SurfaceSpace {
  bool is_vulkan = false;  // the depth begins at 0, and locations are written
  bool flips_y = false;    // clip space has y the other way than Direct3D
};
// The attribute of the position, at location 0, and that of an input, at the location after its
// index.
std::string NameOfFeed(std::optional<std::size_t> input);

// A vertex shader in the GLSL of the pixel shader, which passes each input on that the shader
// declares, in the same words.
std::string SurfaceVertexShader(const Shader& shader, const std::string& glsl,
                                const SurfaceSpace& space);

// Adds the attributes of SurfaceVertexShader to `inputs`.
void GiveSurface(const ir::Program& program, const Surface& surface, Inputs& inputs);

// A part of the image that the shader writes.
struct SurfaceTarget {
  std::string name;  // of the output in the GLSL
  bool is_depth = false;
  std::uint32_t number = 0;  // of a render target
  WordKind kind = WordKind::kFloat;
  int components = 4;
};
// The targets of the outputs of `program`; coverage and the like have none.
std::vector<SurfaceTarget> TargetsOf(const ir::Program& program, const GlslInfo& info);

// The values of the pixels, in their order, from the rows of an image, which has four words a
// pixel of a render target and one of the depth. The first row is Direct3D's, or its last.
Captured PixelsOf(const Words& image, const SurfaceTarget& target, bool last_row_first);

}  // namespace clipc::draw
