// A component that an index chooses of components of a uniform is chosen by a table: Mesa 22.3's OpenGL reads another one.
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,essl300,vulkan
// RUN: %clipc -T vs_5_0 %s --target=vulkan | FileCheck %s --check-prefix=VULKAN
float4 v;
float4 rows[3];
float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  // CHECK: gl_Position = in_POSITION0 * globals.v[ivec4(3, 1, 0, 2)[in_INDEX0 & 3]];
  // VULKAN: gl_Position = in_POSITION0 * globals.v.wyxz[in_INDEX0 & 3];
  float4 position = p * v.wyxz[i & 3];
  // CHECK: gl_Position.x += globals.rows[in_INDEX0 & 1][ivec2(2, 1)[in_INDEX0 & 1]];
  position.x += rows[i & 1].zy[i & 1];
  return position;
}
