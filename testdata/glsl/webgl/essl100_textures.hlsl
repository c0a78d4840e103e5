// Vertex shaders of GLSL ES 1.00 read textures of two dimensions and cubes, where the context has units for them.
// RUN: %clipc -T vs_3_0 --target=essl100 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_3_0 --target essl100,glsl450 --lower none
// CHECK: #version 100
// CHECK-NOT: #extension
// CHECK-DAG: uniform highp sampler2D height;
// CHECK-DAG: uniform highp samplerCube sky;
// CHECK-DAG: texture2DLod(height, in_POSITION0.xy, in_POSITION0.w)
// CHECK-DAG: textureCubeLod(sky, in_POSITION0.xyz, in_POSITION0.w)
sampler2D height;
samplerCUBE sky;
float4 main(float4 p : POSITION, out float4 color : COLOR) : POSITION {
  color = texCUBElod(sky, p);
  return tex2Dlod(height, p);
}
