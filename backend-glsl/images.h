// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/reach.h"
#include "backend-glsl/target.h"
#include "ir/access.h"

// Images: their formats, and what a target says of an image that a shader reads, writes or both.
namespace clipc::glsl {

// The format of an image: that of [[vk::image_format]], otherwise HLSL's number and kind of
// components, which have 32 bits each.
std::string ImageFormat(const ir::Program& program, const ir::Resource& resource);
// What a shader does with each image, by VarId; empty without images, and for a target that does
// not ask.
std::vector<ir::ObjectUse> UsesOfImages(const ir::Program& program, const Reached& reached,
                                        const Target& target);
// The word, with a space after it, that the declaration of an image needs for how the shader uses
// it: OpenGL ES lets a shader both read and write only formats of one component of 32 bits (ES 3.10
// specification of the language, 4.9). Empty where none is needed.
std::string_view ImageAccess(const ir::Program& program, std::span<const ir::ObjectUse> uses,
                             const Target& target, const ir::Resource& resource);
// What keeps the target from having the image, for a message; empty if nothing does.
std::string ImageProblem(const ir::Program& program, std::span<const ir::ObjectUse> uses,
                         const Target& target, const ir::Resource& resource);

}  // namespace clipc::glsl
