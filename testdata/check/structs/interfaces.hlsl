// Instances of interfaces whose class is known: arguments, and local variables declared with them.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
interface Light { float3 Shade(float3 n); float Weight(); };
class Ambient : Light {
  float3 color;
  float3 Shade(float3 n) { return color * Weight(); }
  float Weight() { return 2; }
};
class Sun : Light {
  float3 color, direction;
  float3 Shade(float3 n) { return color * saturate(dot(n, direction)); }
  float Weight() { return 0.5; }
};
cbuffer Lights { Ambient ambient; Sun sun; };
float3 Lit(Light light, float3 n) { return light.Shade(n) * light.Weight(); }
float3 Both(Light a, Light b, float3 n) { Light c = b; return Lit(a, n) + Lit(c, n); }
float4 main(float3 n : NORMAL) : SV_Position {
  Light i = sun;
  Sun local = sun;
  local.color = 1;
  Light j = local;
  return float4(Lit(ambient, n) + Lit(i, n) + Both(i, ambient, n) + j.Shade(n), 1);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Ambient {
// CHECK-NEXT:     vec3 color;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Sun {
// CHECK-NEXT:     vec3 color;
// CHECK-NEXT:     vec3 direction;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Lights {  // b0
// CHECK-NEXT:     Ambient ambient;
// CHECK-NEXT:     Sun sun;
// CHECK-NEXT: } lights;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec3 in_NORMAL0;  // n : NORMAL0
// CHECK-EMPTY:
// CHECK-NEXT: float saturate(float x) {
// CHECK-NEXT:     return min(max(0.0, x), 1.0);  // 0 for NaN
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float Weight(Ambient self) {
// CHECK-NEXT:     return 2.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 Shade(Ambient self, vec3 n) {
// CHECK-NEXT:     return self.color * Weight(self);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 Lit(Ambient light, vec3 n) {
// CHECK-NEXT:     return Shade(light, n) * Weight(light);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 Shade(Sun self, vec3 n) {
// CHECK-NEXT:     return self.color * saturate(dot(n, self.direction));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float Weight(Sun self) {
// CHECK-NEXT:     return 0.5;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 Lit(Sun light, vec3 n) {
// CHECK-NEXT:     return Shade(light, n) * Weight(light);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 Both(Sun a, Ambient b, vec3 n) {
// CHECK-NEXT:     Ambient c = b;
// CHECK-NEXT:     return Lit(a, n) + Lit(c, n);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     Sun i = lights.sun;
// CHECK-NEXT:     Sun local = lights.sun;
// CHECK-NEXT:     local.color = vec3(1.0);
// CHECK-NEXT:     Sun j = local;
// CHECK-NEXT:     gl_Position = vec4(Lit(lights.ambient, in_NORMAL0) + Lit(i, in_NORMAL0) + Both(i, lights.ambient, in_NORMAL0) + Shade(j, in_NORMAL0), 1.0);
// CHECK-NEXT: }
