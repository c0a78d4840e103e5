// Where rasterizer-ordered objects and `globallycoherent` mean nothing.
// RUN: not %clipc %s -T ps_5_1 --target=glsl430 -o - 2>&1 | FileCheck %s
// RUN: not %clipc %s -T vs_5_1 -E vertex -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc %s -T ps_5_1 -E read -o - 2>&1 | FileCheck %s --check-prefix=READ

// CHECK: [[#@LINE+1]]:36: error: `layers` is accessed in the order of the primitives; target `glsl430` has no such order [target-order]
RasterizerOrderedTexture2D<float4> layers : register(u1);
// CHECK: note: target `glsl450` can
float4 main(float4 p : SV_Position) : SV_Target { return layers[uint2(p.xy)] = p; }

float4 vertex() : SV_Position {
  // VERTEX: [[#@LINE+1]]:3: error: `[]` is used on an object that a vertex shader may declare but not use [object-unusable, X4532]
  layers[uint2(0, 0)] = 1;
  float2 size;
  // VERTEX: [[#@LINE+1]]:10: error: `GetDimensions` is used on an object that a vertex shader may declare but not use [object-unusable, X4532]
  layers.GetDimensions(size.x, size.y);
  return size.xyxy;
}

// READ: [[#@LINE+1]]:36: warning: `globallycoherent` has no effect on `Texture2D<float4>`, which the shader cannot write [-Wqualifier-without-effect]
globallycoherent Texture2D<float4> only_read;
float4 read() : SV_Target { return only_read[uint2(0, 0)]; }
