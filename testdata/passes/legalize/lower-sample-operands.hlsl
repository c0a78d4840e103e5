// SPIR-V has a texture with its sampler and the read of it in one block, so a choice is made before: glslang makes blocks of its sides.
// RUN: %clipc %s -T ps_6_0 --target=vulkan --verify --validate -o - | FileCheck %s
// RUN: %clipc %s -T ps_6_0 -spirv -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc %s -T ps_6_0 --target=glsl450 --validate -o - | FileCheck %s --check-prefix=OPENGL
// RUN: %draw compare %s -T ps_6_0 --target vulkan,glsl450
// OPENGL-NOT: operand
Texture2D t;
SamplerState s;
float2 Place(float2 p) { return p.x > 0 ? sin(p) : cos(p); }
float4 main(float4 p : P) : SV_Target {
  // CHECK: (operand = vs_P0.x > 0.0 ? Place(
  float4 c = t.Sample(s, p.x > 0 ? Place(p.yz) : p.xy);
  // CHECK: textureLodOffset(sampler2D(t, s), operand{{[_0-9]*}}, operand{{[_0-9]*}}, ivec2(1, -1))
  c += t.SampleLevel(s, p.xy, p.y > 0 && p.z > 0 ? 1 : Place(p.xz).x, int2(1, -1));
  // A constant place stays one.
  // CHECK: texture(sampler2D(t, s), vec2(1.0, 0.0), 0.5)
  c += t.SampleBias(s, false ? float2(0, 0) : float2(3, 4) % 2, 0.5);
  // CHECK: texture(sampler2D(t, s), {{.*}}xy)
  c += t.Sample(s, p.xy);
  for (int i = 0; i < 2 && t.SampleLevel(s, p.z > i ? Place(p.xw) : p.yz, 0).x < 8; i++) c.x += i;
  return c;
}
