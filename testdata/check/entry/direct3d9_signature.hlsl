// Direct3D 9 has one register for a semantic: inputs of one semantic are one attribute, without a warning, and each reads the components
// that it declares. Oracle: "D3DVERTEXELEMENT9" of the Direct3D 9 reference, whose elements are known by usage and usage index, and
// vkd3d's tests of shared input semantics in shader model 1 to 3.
// Colours and fog of vs_1_1 and vs_2_0 lie in 0..1: "Output Registers" and "Input Color Register" of the reference. vs_3_0 clamps none.
// RUN: %clipc -T vs_2_0 %s --validate -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_1_1 %s --validate -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_3_0 %s --validate -o - 2>&1 | FileCheck %s --check-prefix=LATER
// RUN: %clipc -T vs_4_0 %s -o - 2>&1 | FileCheck %s --check-prefix=FOUR
// RUN: %clipc -T vs_2_0 %s --reflect=%t.json -o %t.vert && FileCheck %s --check-prefix=REFLECT --input-file %t.json
// RUN: %draw compare %s -T vs_2_0
// RUN: %draw compare %s -T vs_3_0
// CHECK-NOT: warning
// CHECK: in vec4 in_POSITION0;
// CHECK-NEXT: {{.*}} in vec4 in_TANGENT0;
// CHECK-NEXT: {{.*}} in float in_WEIGHT0;
// CHECK-NOT: ) in vec
// CHECK: vec3 tangent = in_TANGENT0.xyz;
// CHECK-NEXT: float first = in_TANGENT0.x;
// CHECK-NEXT: gl_Position = in_POSITION0 + vec4(tangent, first) * in_WEIGHT0 + in_TANGENT0
// CHECK: vs_TEXCOORD0 = vec4(1.0, 2.0, -1.0, 0.5) * in_WEIGHT0;
// CHECK: vs_COLOR0 = saturate(c);
// CHECK-NEXT: vs_COLOR1 = saturate(d);
// CHECK-NEXT: vs_FOG0 = saturate(f);
// LATER-NOT: saturate
// FOUR: warning: semantic `TANGENT0` is used twice among the inputs
// FOUR: in vec4 in_TANGENT0_2;
// FOUR-NOT: saturate
// REFLECT-COUNT-1: "semantic": "TANGENT"
// REFLECT-NOT: "semantic": "TANGENT"
struct In {
  float4 p : POSITION;
  float3 tangent : TANGENT;
  float weight : WEIGHT;
};
struct Out {
  float4 p : POSITION;
  float4 c : COLOR0;
  float3 d : COLOR1;
  float4 t : TEXCOORD0;
  float f : FOG;
};
Out main(In i, float4 basis : TANGENT0, float first : tangent) {
  Out o;
  o.p = i.p + float4(i.tangent, first) * i.weight + basis;
  o.c = float4(1, 2, -1, .5) * i.weight;
  o.d = i.tangent;
  o.t = float4(1, 2, -1, .5) * i.weight;
  o.f = first + 2;
  return o;
}
