// The Length of textures and buffers, which fxc has from 4.0 on: what GetDimensions gives, in uints. Oracle: vkd3d's
// length-property.shader_test, checked against fxc and dxc.
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
Texture2D map;
Texture2DArray layers;
Texture2DMS<float4, 4> samples;
Buffer<float> texels;
StructuredBuffer<float4> elements;
RWTexture2D<float> image : register(u1);
float4 main() : SV_Target {
  // CHECK: uvec2 a = uvec2(textureSize(map, 0));
  uint2 a = map.Length;
  // CHECK-NEXT: uvec3 b = uvec3(textureSize(layers, 0));
  uint3 b = layers.Length;
  // CHECK-NEXT: uvec2 c = uvec2(textureSize(samples));
  uint2 c = samples.Length;
  // CHECK-NEXT: uint d = uint(textureSize(texels));
  uint d = texels.Length;
  // CHECK-NEXT: uint e = uint(elements.{{.*}}length());
  uint e = elements.Length;
  // CHECK-NEXT: uvec2 f = uvec2(imageSize(image));
  uint2 f = image.Length;
  return a.xyxy + b.xyzz + c.xyxy + d + e + f.xyxy;
}
