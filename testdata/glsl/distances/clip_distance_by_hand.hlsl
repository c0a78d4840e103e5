// SV_ClipDistance of any shape ends up in one array, packed by register as fxc packs; the comment says which are written.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate -DNO_CULL %s -o %t
// AUTOUPDATE
struct Output {
  float4 position : SV_Position;
  float3 first : SV_ClipDistance0;
  float2 second : SV_ClipDistance1;
#ifndef NO_CULL
  float culled[2] : SV_CullDistance;
#endif
};
Output main(float4 p : POSITION) {
  Output output;
  output.position = p;
  output.first = p.xyz;
  output.second = p.zw;
#ifndef NO_CULL
  output.culled[0] = p.x;
  output.culled[1] = p.y;
#endif
  return output;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: // clip distances written: 0x3f
// CHECK-NEXT: // cull distances written: 0x3
// CHECK-NEXT: out float gl_ClipDistance[6];
// CHECK-NEXT: out float gl_CullDistance[2];
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     float culled[2];
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT:     vec3 first = in_POSITION0.xyz;
// CHECK-NEXT:     vec2 second = in_POSITION0.zw;
// CHECK-NEXT:     culled[0] = in_POSITION0.x;
// CHECK-NEXT:     culled[1] = in_POSITION0.y;
// CHECK-NEXT:     gl_ClipDistance[0] = first.x;
// CHECK-NEXT:     gl_ClipDistance[1] = first.y;
// CHECK-NEXT:     gl_ClipDistance[2] = first.z;
// CHECK-NEXT:     gl_ClipDistance[3] = 0.0;
// CHECK-NEXT:     gl_ClipDistance[4] = second.x;
// CHECK-NEXT:     gl_ClipDistance[5] = second.y;
// CHECK-NEXT:     gl_CullDistance[0] = culled[0];
// CHECK-NEXT:     gl_CullDistance[1] = culled[1];
// CHECK-NEXT: }
