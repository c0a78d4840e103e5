// The only element of an array is written by index 0: Mesa 22.3's OpenGL writes all components for `a[i].y = 1`.
// RUN: %clipc -T ps_4_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_4_0 --target=glsl450,glsl150,essl300,vulkan
// RUN: %clipc -T ps_4_0 %s --target=vulkan -o - | FileCheck %s --check-prefix=VULKAN
struct Light {
  float4 color;
};
float places[4];
float4 main(float4 p : A) : SV_Target {
  float4 a[1] = {p};
  // CHECK: a[0].y = -2.0;
  // VULKAN: a[to_int(globals.places[0]) & 0].y = -2.0;
  a[(int)places[0] & 0].y = -2;
  Light lights[1] = {p};
  // CHECK: lights[0].color.xz *= a[0].y;
  lights[(int)places[1] & 0].color.xz *= a[0].y;
  int next = 0;
  // CHECK: next++, a[0].w = 4.0;
  a[next++].w = 4;
  return a[0] + lights[0].color * next;
}
