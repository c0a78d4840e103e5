// A copy of a struct, and an `inout` parameter, do not read the position either, which no target has as an input of a pixel shader.
// RUN: %clipc -T ps_3_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 %s -E changed --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_3_0
struct Input {
  float4 position : POSITION;
  float2 uv : TEXCOORD0;
  float4 color : COLOR0;
};
sampler2D image;

// CHECK-NOT: POSITION
float4 main(Input input) : COLOR {
  Input copy = input;
  copy.uv += 1;
  return copy.color * tex2D(image, copy.uv);
}

void Double(inout Input input) { input.uv *= 2; }
float4 changed(Input input) : COLOR {
  Double(input);
  return input.color * tex2D(image, input.uv);
}
