// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "tools/harness/drawing.h"
#include "tools/harness/framebuffer.h"
#include "tools/harness/transform.h"

// Images of what the shaders of examples/compute, geometry and tessellation make, on
// OpenGL 4.5.
namespace stages {

using namespace clipc::harness;

// Edges are smooth because images are drawn twice as large.
constexpr int kWidth = 240, kHeight = 160;

// The folder of the examples, in which the GLSL of each shader lies beside its HLSL.
using Folder = std::string;

Image DrawBlur(const Folder& examples);
Image DrawHistogram(const Folder& examples);
Image DrawPrefixSums(const Folder& examples);
Image DrawParticles(const Folder& examples);
Image DrawCubeMap(const Folder& examples);
Image DrawShadowVolume(const Folder& examples);
Image DrawFur(const Folder& examples);
Image DrawTerrain(const Folder& examples);

// A matrix as a cbuffer of HLSL has it, column by column.
inline std::array<float, 16> Columns(const Matrix& matrix) {
  return Floats(clipc::runtime::Transpose(matrix));
}

// Uses a program of a vertex shader, shaders in files of their own, and a fragment shader.
struct StageFile {
  GLenum stage;
  std::string path;
};
void UseProgram(const std::string& vertex, std::initializer_list<StageFile> files,
                const std::string& fragment);
// Uses the compute shader in a file.
void UseCompute(const std::string& path);

// A buffer, or a uniform buffer, at a binding.
GLuint BindBuffer(GLenum target, GLuint binding, const void* bytes, std::size_t size);

// The place of a pixel's bytes.
inline std::ptrdiff_t ByteAt(const Image& image, int x, int y) {
  return 4 * (std::ptrdiff_t{y} * image.width + x);
}

// The bytes of a texture, the top row first.
Image ImageOf(GLuint texture, int width, int height);

}  // namespace stages
