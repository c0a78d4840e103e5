// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "backend-glsl/write.h"
#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/inputs.h"
#include "tools/draw/random_values.h"

// Textures with random texels, for the evaluator and for OpenGL.
namespace clipc::draw {

// One texture, or one element of an array of textures. Its texels differ, except where random
// coordinates would not decide between them: the last texel of an axis equals the first, so that
// coordinates that are whole numbers, where textures repeat, give one value; the faces of a cube
// are equal; and where the shader gives gradients, from which drivers choose a level freely, all
// texels are equal; likewise with RandomOptions::constant_textures, which tests less but leaves no
// result undefined.
struct Texture {
  // The size of level 0 as GetDimensions returns it, elements of an array or samples last; a
  // multisampled array has kSamples besides.
  std::array<std::uint32_t, 3> size{1, 1, 1};
  std::vector<Words> levels;  // four words a texel; along x, then y, then z
  bool is_constant = false;
};
using Textures = std::map<std::uint32_t, std::vector<Texture>>;  // by VarId

// Makes the textures that `program` declares.
Textures MakeTextures(const ir::Program& program, const RandomOptions& options,
                      RandomValues& values);

// Answers a request for one of `textures`: the nearest texel of the nearest level of a texture that
// repeats. With a comparison sampler, a reference passes that is less or equal. The result is
// `undefined` where GLSL leaves it open (loads and levels outside of the texture), and for
// coordinates that lie too near to the border between texels.
void ReadTexture(const ir::Program& program, const Textures& textures,
                 const ir::ObjectRequest& request, double undefined,
                 std::span<std::uint64_t> result);

// Adds a texture for every sampler variable of the written shader to `inputs`.
void GiveTextures(const ir::Program& program, const GlslInfo& info, const Textures& textures,
                  Inputs& inputs);

// ---- Objects of every kind

// The type of the object, or of the elements of an array of objects.
const ir::Type& ObjectTypeOf(const ir::Program& program, ir::VarId var);
// The kind of the components of the object's elements; kFloat where the object has no elements.
ir::Scalar ElementKind(const ir::Program& program, ir::VarId var);
// OpenGL's target of textures of this form.
GLenum TargetOf(const ir::ObjectInfo& form);
// The kind of the words that texels of that type have.
WordKind KindOfTexels(ir::Scalar kind);
// "[1][0]" for each element of an array of objects, in the order of the evaluator's numbers; "" for
// a single object.
std::vector<std::string> ElementIndices(const ir::Program& program, ir::VarId var);

}  // namespace clipc::draw
