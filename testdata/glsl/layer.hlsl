// gl_Layer and gl_ViewportIndex are ints; the shader's own uints are converted at the end.
// RUN: %clipc -T vs_5_0 --target=glsl410 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o %t
// AUTOUPDATE
float4 main(float4 p : POSITION, uint i : INDEX, out uint layer : SV_RenderTargetArrayIndex, out uint viewport : SV_ViewportArrayIndex)
    : SV_Position {
  layer = i;
  viewport = i / 2;
  return p;
}

// CHECK: #version 410
// CHECK-NEXT: #extension GL_ARB_shader_viewport_layer_array : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_INDEX0;  // INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: vec4 shader_main(vec4 p, uint i, out uint layer, out uint viewport) {
// CHECK-NEXT:     layer = i;
// CHECK-NEXT:     viewport = i / 2u;
// CHECK-NEXT:     return p;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint vs_SV_RENDERTARGETARRAYINDEX0;
// CHECK-NEXT:     uint vs_SV_VIEWPORTARRAYINDEX0;
// CHECK-NEXT:     uint layer;
// CHECK-NEXT:     uint viewport;
// CHECK-NEXT:     vec4 result = shader_main(in_POSITION0, in_INDEX0, layer, viewport);
// CHECK-NEXT:     vs_SV_RENDERTARGETARRAYINDEX0 = layer;
// CHECK-NEXT:     vs_SV_VIEWPORTARRAYINDEX0 = viewport;
// CHECK-NEXT:     gl_Position = result;
// CHECK-NEXT:     gl_Layer = int(vs_SV_RENDERTARGETARRAYINDEX0);
// CHECK-NEXT:     gl_ViewportIndex = int(vs_SV_VIEWPORTARRAYINDEX0);
// CHECK-NEXT: }
