// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

#include <spirv/unified1/spirv.hpp11>

namespace clipc::spirv {

// The format of an image by its name in GLSL, "rgba8_snorm"; Unknown for another name.
spv::ImageFormat FormatOf(std::string_view name);
// Whether the capability Shader alone has the format; StorageImageExtendedFormats has the others.
bool IsBasic(spv::ImageFormat format);

}  // namespace clipc::spirv
