// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/known_shader.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "compiler/compile/compile.h"
#include "compiler/compile/facts_json.h"

namespace clipc {
namespace {

// Shaders that differ in what they read, declare and warn about.
constexpr const char* kEffect = R"(
float4x4 World; float4 Tint, gl_Tint; float2 Scale; float4 Plane;
texture Map; sampler Texels = sampler_state { Texture = <Map>; };
struct V { float4 p : POSITION; float4 c : COLOR0; float2 uv : TEXCOORD0; float3 n : TEXCOORD1; };
V VS0(float4 p : POSITION) {
  V o; o.p = mul(p, World); o.c = Tint; o.uv = p.xy * Scale; o.n = p.xyz; return o;
}
V VS1(float4 p : POSITION) {
  V o; o.p = mul(p, World); o.c = gl_Tint; o.uv = p.yx; o.n = tex2Dlod(Texels, p).xyz; return o;
}
[clipplanes(Plane)] float4 VS2(float4 p : POSITION, out float4 c : COLOR0) : POSITION {
  c = float4(p.xy, 0, 1) * float3x3(1, 2, 3, 4, 5, 6, 7, 8, 9)[0].xyzz; return mul(p, World);
}
V VS3(float4 p : POSITION) { V o; o.p = p; o.c = p.x; o.uv = p; o.n = 0; return o; }
float4 PS0(V v) : COLOR0 { return v.c * Tint; }
float4 PS1(V v) : COLOR0 { return tex2D(Texels, v.uv) + v.n.x; }
float4 PS2(float4 c : COLOR0) : COLOR0 { float3 d = c; return d.xyzz * gl_Tint; }
float4 PS3(float4 c : COLOR0, float4 place : VPOS) : COLOR0 { return c + place.x; }
float4 PS4() : COLOR0 { return Scale.xyxy; }
)";

// The request for a pass with these two shaders, or with one alone.
ProgramRequest PassOf(const std::string& vertex, const std::string& pixel, std::uint64_t effect) {
  ProgramRequest request;
  request.shaders.clear();
  if (!vertex.empty()) request.shaders.push_back({.entry = vertex, .profile = "vs_3_0"});
  if (!pixel.empty()) request.shaders.push_back({.entry = pixel, .profile = "ps_3_0"});
  request.first().path = "effect.fx";
  request.first().text = kEffect;
  request.language.effect = effect;
  request.outputs.facts = true;
  request.planes.lowering = Lowering::kClipDistance;
  if (vertex.empty()) request.planes.lowering.reset();
  return request;
}

void ExpectSame(const CompileResult& known, const CompileResult& alone) {
  EXPECT_EQ(known.text, alone.text);
  EXPECT_EQ(known.status, alone.status);
  ASSERT_EQ(known.outputs.has_value(), alone.outputs.has_value());
  if (!known.outputs) return;
  EXPECT_EQ(known.outputs->shaders, alone.outputs->shaders);
  EXPECT_EQ(FactsJson(*known.outputs->facts), FactsJson(*alone.outputs->facts));
}

TEST(KnownShader, ChangesNoResult) {
  Compiler compiler;
  const std::vector<std::string> vertex = {"VS0", "VS1", "VS2", "VS3", ""};
  const std::vector<std::string> pixel = {"PS0", "PS1", "PS2", "PS3", "PS4", ""};
  int compiled = 0;
  // The second time, everything is known.
  for (int time = 0; time < 2; ++time) {
    for (const std::string& v : vertex) {
      for (const std::string& p : pixel) {
        if (v.empty() && p.empty()) continue;
        SCOPED_TRACE(v + " " + p);
        const CompileResult known = compiler.Compile(PassOf(v, p, 1));
        ExpectSame(known, Compile(PassOf(v, p, 2)));
        compiled += known.ok();
      }
    }
  }
  EXPECT_GE(compiled, 40);
}

TEST(KnownShader, IsOfOneEffect) {
  Compiler compiler;
  ProgramRequest request = PassOf("VS0", "PS0", 1);
  const CompileResult first = compiler.Compile(request);
  ASSERT_TRUE(first.ok()) << first.text;
  request.language.effect = 2;
  request.style.clip_space.flip_y = true;
  const CompileResult second = compiler.Compile(request);
  ASSERT_TRUE(second.ok()) << second.text;
  EXPECT_NE(first.outputs->shaders, second.outputs->shaders);
}

}  // namespace
}  // namespace clipc
