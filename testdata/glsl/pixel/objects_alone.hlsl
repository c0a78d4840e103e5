// The name of an object is not a statement or an operand in GLSL, so one that stands alone or before a comma is left out (glslang's
// hlsl.automap.frag has such shaders).
// RUN: %clipc -T ps_5_0 %s -o - --validate | FileCheck %s --match-full-lines
Texture2D map;
SamplerState linearly;
RWTexture2D<float4> image : register(u1);
VertexFragment fragments[2];
float4 main() : SV_Target {
  map;
  linearly;
  image;
  return (fragments[1], map, 1.0);
}
// CHECK:      void main() {
// CHECK-NEXT:     SV_Target0 = vec4(1.0);
// CHECK-NEXT: }
