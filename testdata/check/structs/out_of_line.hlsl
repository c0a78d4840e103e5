// Methods are defined outside their struct too, static ones among them.
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
struct Light {
  float4 color;
  float4 At(float k);
  void Dim();
  static float Half(float k);
};
float4 Light::At(float k) { return color * k + Half(k); }
void Light::Dim() { color *= 0.5; }
float Light::Half(float k) { return k / 2; }

// CHECK: float Half(float k) {
// CHECK: vec4 At(Light self, float k) {
float4 main(float4 p : POSITION) : SV_Position {
  Light light;
  light.color = p;
  light.Dim();
  return light.At(2) + Light::Half(3);
}
