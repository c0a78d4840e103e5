// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/writer/context.h"

// Declarations of textures, samplers and buffers. OpenGL knows a texture only together with its
// sampler: each pair that is used becomes one sampler variable.
namespace clipc::glsl {

// The textures that are read and the samplers they are read with, with names for the pairs.
std::vector<TextureUse> FindTextureUses(WriterContext& context);

// Binds the objects that are reached. Returns them in the order of their declarations.
std::vector<GlslInfo::Object> LayObjects(WriterContext& context);
// The declarations of these objects.
std::string WriteObjects(WriterContext& context, std::span<const GlslInfo::Object> objects);

// The type of an object, or of the objects in an array.
const ir::Type& ObjectTypeOf(const WriterContext& context, ir::VarId object);
bool IsShadow(const WriterContext& context, ir::VarId sampler);

// The type of a texture with the stem "sampler": "isampler2DArray".
std::string TextureType(const WriterContext& context, ir::VarId texture, std::string_view stem);
// The name of the one variable for a texture and its sampler, or for a texture alone.
const std::string& CombinedName(const WriterContext& context, ir::VarId texture, ir::VarId sampler);

}  // namespace clipc::glsl
