// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>

// Names of GLSL in a shader that should be HLSL.
namespace clipc::check {

// HLSL's name of GLSL's type or function `name`: "float4" for "vec4"; empty if HLSL does not have
// one name for it.
std::string_view HlslNameOf(std::string_view name);

}  // namespace clipc::check
