// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "backend-glsl/writer.h"
#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/program.h"
#include "tools/draw/random_values.h"

// Textures with random texels: what the evaluator reads, and the same for OpenGL.
namespace clipc::draw {

// One texture; of an array of textures one element. All texels differ, but for what random
// coordinates would not decide: the last texel of an axis is the first again, so that whole
// numbers, where textures repeat, give one value; the faces of a cube are all the same; and where
// the shader gives gradients, which choose a level as the driver likes, there is one texel. So
// there is with RandomOptions::constant_textures: less is seen then, but nothing is open.
struct Texture {
  std::array<std::uint32_t, 3> size{
      1, 1, 1};  // of level 0 as GetDimensions tells it, elements of an array last
  std::vector<std::vector<std::uint32_t>> levels;  // four words a texel; along x, then y, then z
  bool is_constant = false;
};
using Textures = std::map<std::uint32_t, std::vector<Texture>>;  // by VarId

// Those that `program` declares. Throws DrawError for multisampled ones.
Textures MakeTextures(const ir::Program& program, const RandomOptions& options,
                      RandomValues& values);

// Answers a request for one of `textures`: the nearest texel of the nearest level of a texture that
// repeats. Comparison samplers pass what is less or equal. What GLSL leaves open (loads and levels
// outside of the texture), and coordinates that lie too near to the border between texels, are
// `undefined`.
void ReadTexture(const ir::Program& program, const Textures& textures,
                 const ir::ObjectRequest& request, double undefined,
                 std::span<std::uint64_t> result);

// The textures for every sampler variable of the written shader.
void GiveTextures(const ir::Program& program, const glsl::GlslInfo& info, const Textures& textures,
                  Inputs& inputs);

// ---- for objects of every kind
// The type of the object, or of the elements of an array of them.
const ir::Type& ObjectTypeOf(const ir::Program& program, ir::VarId var);
Shape::Kind KindOfTexels(ir::Scalar kind);
// "[1][0]" for each element of an array of objects in the order of the evaluator's numbers; "" for
// a single one.
std::vector<std::string> ElementIndices(const ir::Program& program, ir::VarId var);

}  // namespace clipc::draw
