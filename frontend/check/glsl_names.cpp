// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/glsl_names.h"

#include <algorithm>
#include <iterator>

namespace clipc::check {
namespace {

struct Pair {
  std::string_view glsl, hlsl;
};

constexpr Pair kPairs[] = {
    {"vec2", "float2"},
    {"vec3", "float3"},
    {"vec4", "float4"},
    {"ivec2", "int2"},
    {"ivec3", "int3"},
    {"ivec4", "int4"},
    {"uvec2", "uint2"},
    {"uvec3", "uint3"},
    {"uvec4", "uint4"},
    {"bvec2", "bool2"},
    {"bvec3", "bool3"},
    {"bvec4", "bool4"},
    {"mat2", "float2x2"},
    {"mat3", "float3x3"},
    {"mat4", "float4x4"},
    {"fract", "frac"},
    {"mix", "lerp"},
    {"inversesqrt", "rsqrt"},
    {"dFdx", "ddx"},
    {"dFdy", "ddy"},
    {"floatBitsToInt", "asint"},
    {"intBitsToFloat", "asfloat"},
    {"floatBitsToUint", "asuint"},
    {"uintBitsToFloat", "asfloat"},
    {"texelFetch", "map.Load(int3(place, level))"},
    {"textureGather", "map.Gather(sampler, uv)"},
    {"textureGrad", "map.SampleGrad(sampler, uv, ddx(uv), ddy(uv))"},
    {"textureLod", "map.SampleLevel(sampler, uv, level)"},
    {"textureOffset", "map.Sample(sampler, uv, offset)"},
    {"textureProj", "map.Sample(sampler, uv.xy / uv.w)"},
    {"textureSize", "map.GetDimensions(width, height)"},
    {"imageLoad", "image[place]"},
    {"imageStore", "image[place] = value"},
};

}  // namespace

std::string_view HlslNameOf(std::string_view name) {
  const Pair* const found = std::ranges::find(kPairs, name, &Pair::glsl);
  return found == std::end(kPairs) ? std::string_view() : found->hlsl;
}

}  // namespace clipc::check
