// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Gives any bytes as the neighbour of one vertex shader: either there is an error, or GLSL.
#include <cstdint>
#include <cstdlib>

#include "compiler/compile/compile.h"

namespace {

constexpr char kVertexShader[] = R"(
cbuffer Frame : register(b0) { float4x4 view; float4 tint; };
struct Varyings {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
  float3x3 tangents : TANGENT;
  uint material : MATERIAL;
  float4 colors[2] : COLOR;
};
Varyings main(float4 p : POSITION) {
  Varyings o;
  o.position = mul(view, p);
  o.uv = p.xy;
  o.tangents = (float3x3)view;
  o.material = 1;
  o.colors[0] = o.colors[1] = tint;
  return o;
}
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clipc::ProgramRequest request;
  request.first().path = "vertex.hlsl";
  request.first().text = kVertexShader;
  request.neighbour = {.path = "pixel",
                       .text = std::string(reinterpret_cast<const char*>(data), size)};
  for (const char* target : {"glsl450", "vulkan", "essl300"}) {
    request.target = *clipc::glsl::Target::Parse(target);
    const clipc::CompileResult result = clipc::Compile(request);
    if (result.ok() != result.outputs.has_value()) std::abort();
    if (!result.ok() && result.messages.empty()) std::abort();
  }
  return 0;
}
