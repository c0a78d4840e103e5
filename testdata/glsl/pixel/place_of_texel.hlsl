// The place of a texel and its level need no conversion that saturates: what fits into no int lies in no texture.
// RUN: %clipc -T ps_5_0 %s -o - --validate | FileCheck %s
Texture2DArray<uint4> layers;
uint4 main(float2 uv : TEXCOORD) : SV_Target {
  uint3 size;
  layers.GetDimensions(size.x, size.y, size.z);
  // CHECK: ivec4 location = ivec4(ivec2(vec2(size.xy) * vs_TEXCOORD0), 0, 0);
  // CHECK-NEXT: SV_Target0 = texelFetch(layers, location.xyz, location.w);
  int4 location = int4(size.xy * uv, 0, 0);
  return layers.Load(location);
}
