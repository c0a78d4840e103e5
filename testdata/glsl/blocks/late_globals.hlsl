// A global variable gets its value in `main` where an initialiser cannot say it: it calls a function, which GLSL has after the
// globals; it takes several steps; it reads such a variable. `const` is only what glslang takes for a constant.
// RUN: %clipc -T vs_5_0 -E main --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E main
// RUN: %draw compare %s -T vs_5_0 -E main --target=vulkan
// RUN: %draw compare %s -T vs_5_0 -E main --target=essl300
// RUN: %clipc -T vs_5_0 -E constants --validate %s -o - | FileCheck %s --check-prefix=CONST
// RUN: %draw compare %s -T vs_5_0 -E constants --target=vulkan
// RUN: %clipc -T vs_5_0 -E constants --target=essl300 --validate %s -o %t
float4 u;
float2x2 n;

float three_times(float x) {
  float y = x;
  for (int i = 0; i < 3; i++) y *= 2;
  return y;
}
// CHECK: float called = 0.0;
static float called = three_times(1);
// CHECK-NEXT: float after_it = 0.0;
static float after_it = called + 1;
// CHECK-NEXT: vec2 cut[2] = vec2[2](vec2(0.0), vec2(0.0));
static float2 cut[2] = {u * 2};
// CONST: float infinity_ = uintBitsToFloat(2139095040u);
static const float infinity_ = asfloat(0x7f800000u);
// CONST-NEXT: float huge_ = uintBitsToFloat(0x7f800000u);
static const float huge_ = 1.#INF;
// CONST-NEXT: mat2 turned = transpose(mat2(1.0, 2.0, 3.0, 4.0));
static const float2x2 turned = transpose(float2x2(1, 2, 3, 4));
// CONST-NEXT: mat2 product = matrixCompMult(mat2(1.0, 2.0, 3.0, 4.0), mat2(2.0, 2.0, 2.0, 2.0));
static const float2x2 product = float2x2(1, 2, 3, 4) * float2x2(2, 2, 2, 2);
// CONST-NEXT: const float square = length(vec2(3.0, 4.0));
static const float square = length(float2(3, 4));
// CONST-NEXT: {{^}}uvec2 chosen = mix(uvec2(5u, 8u), uvec2(2u, 7u), bvec2(true));
static const uint2 chosen = (bool2)true ? uint2(2, 7) : uint2(5, 8);

// CHECK: void main() {
// CHECK-NEXT: called = three_times(1.0);
// CHECK-NEXT: after_it = called + 1.0;
// CHECK-NEXT: temporary = globals.u * 2.0;
// CHECK-NEXT: cut = vec2[2](vec2(temporary.x, temporary.y), vec2(temporary.z, temporary.w));
float4 main(float4 p : POSITION) : SV_Position { return float4(cut[0], cut[1]) * called + after_it + three_times(p.x); }

float4 constants(float4 p : POSITION) : SV_Position { return p.x < infinity_ && p.y < huge_ ? turned[0].xyxy * product[1].xxyy * p * square + chosen.xyxy : p; }
