// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/vulkan/image.h"

namespace clipc::draw::vulkan {

// Makes a multisampled texture, or an array of them: the texels of sample 0 come first, layer after
// layer. Vulkan has no command that writes a sample, so they are drawn from a plain texture.
Image UploadSamples(const Device& device, const Inputs::Texture& texture);

}  // namespace clipc::draw::vulkan
