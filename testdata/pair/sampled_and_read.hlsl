// A texture that one stage reads without a sampler and the other with one is two uniforms, since each stage has a binding of its own
// for it: under one name they would not link.
// RUN: %clipc %s -E vs --pixel-entry=ps -o %t.vert --pixel-output=%t.frag --validate
// RUN: cat %t.vert %t.frag | FileCheck %s
// CHECK: layout(binding = 0) uniform sampler2D map;  // t0
// CHECK: #version
// CHECK: layout(binding = 1) uniform sampler2D map_bilinear;  // map : t0 with bilinear : s0
// RUN: %draw link %t.vert %t.frag
// RUN: %draw pair %t.vert %t.frag %t.vert %t.frag
Texture2D map : register(t0);
SamplerState bilinear : register(s0);
float4 vs(float4 p : POSITION, out float4 color : COLOR, out float2 uv : TEXCOORD) : SV_Position {
  color = map.Load(int3(0, 0, 0));
  uv = p.xy;
  return p;
}
float4 ps(float4 color : COLOR, float2 uv : TEXCOORD) : SV_Target { return color + map.Sample(bilinear, uv * 0.7) * (uv.x * 3 + uv.y * uv.y); }
