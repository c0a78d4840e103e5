// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/buffers.h"

// Images with random texels: RWTexture1D to RWTexture3D and RWBuffer. An image lies in a Buffer,
// four words for each texel; along x, then y, then z or the elements of an array. The sizes are
// always the same.
namespace clipc::draw {

Buffer MakeImage(const ir::Program& program, ir::VarId image, RandomValues& values);

// Answers a request for an image, which a store or an atomic operation changes. Outside of the
// image a load is `undefined` and a store is lost.
void UseImage(const ir::Program& program, Buffer& texels, const ir::ObjectRequest& request,
              double undefined, std::span<std::uint64_t> result);

// The image as a driver is given it. Throws DrawError for a format of fewer than 32 bits a
// component, which rounds what is stored.
Inputs::Texture UploadedImage(const ir::Program& program, const ir::Resource& resource,
                              const Buffer& texels);

}  // namespace clipc::draw
