// Layers, viewports and shading rates that nothing writes are not outputs, so that targets without them can express the shader.
// RUN: not %clipc -T vs_6_4 --target=glsl330 %s -E written 2>&1 | FileCheck %s --check-prefix=WRITTEN
// RUN: %clipc -T vs_6_4 --target=glsl330 --validate %s -o - --reflect=%t.json | FileCheck %s --implicit-check-not=gl_Layer
// RUN: FileCheck %s --input-file=%t.json --check-prefix=JSON --implicit-check-not=RenderTargetArrayIndex
// RUN: %clipc -T vs_6_4 --target=vulkan --validate %s -o - | FileCheck %s --implicit-check-not=gl_ --implicit-check-not=extension
// RUN: %draw compare %s -T vs_6_4
// RUN: %clipc -T vs_6_4 --target=glsl450 --validate %s -E written -o - | FileCheck %s --check-prefix=LAYER
// RUN: %clipc -T vs_6_4 --target=vulkan --validate %s -E zero -o - | FileCheck %s --check-prefix=ZERO
struct Varyings {
  float4 position : SV_Position;
  uint layer : SV_RenderTargetArrayIndex;
  uint viewport : SV_ViewportArrayIndex;
  uint rate : SV_ShadingRate;
};
bool is_on;

// CHECK: gl_Position = in_POSITION0;
// JSON: "semantic": "SV_Position"
Varyings main(float4 p : POSITION) {
  Varyings v;
  v.position = p;
  return v;
}

// WRITTEN: error: the shader writes `SV_RenderTargetArrayIndex`; vertex and domain shaders of target `glsl330` cannot
// LAYER: gl_Layer = int(
// LAYER-NOT: gl_ViewportIndex
Varyings written(float4 p : POSITION) {
  Varyings v;
  v.position = p;
  if (is_on) v.layer = 1;
  return v;
}

// ZERO: gl_Layer = int(
// ZERO: gl_ViewportIndex = int(
Varyings zero(float4 p : POSITION) {
  Varyings v = (Varyings)0;
  v.position = p;
  return v;
}
