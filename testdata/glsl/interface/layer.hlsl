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
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint vs_SV_RENDERTARGETARRAYINDEX0;
// CHECK-NEXT:     uint vs_SV_VIEWPORTARRAYINDEX0;
// CHECK-NEXT:     vs_SV_RENDERTARGETARRAYINDEX0 = in_INDEX0;
// CHECK-NEXT:     vs_SV_VIEWPORTARRAYINDEX0 = in_INDEX0 / 2u;
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT:     gl_Layer = int(vs_SV_RENDERTARGETARRAYINDEX0);
// CHECK-NEXT:     gl_ViewportIndex = int(vs_SV_VIEWPORTARRAYINDEX0);
// CHECK-NEXT: }
